#include "samples/study/figures/workshop.h"

#include <unistd.h>

#include <spawn.h>
#include <sys/wait.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"

namespace hrt::study {

namespace fs = std::filesystem;

Workshop::Workshop(const std::string& argument, const std::string& out) : out_(out), was_made_(!fs::exists(out)) {
  run_gnuplot("", ".");  // missing: said before the work, not after it
  std::error_code error;
  fs::create_directories(out_, error);
  folder_ = out_ / (".hrt-study." + std::to_string(getpid()) + ".tmp");
  if (!error) fs::create_directory(folder_, error);
  if (error) throw UsageError(not_allowed(argument, out, "a folder that can be written (" + error.message() + ")"));
}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  if (was_made_) fs::remove(out_, ignored);  // only if it is empty
}

std::string Workshop::draw(const Figure& figure) {
  run_gnuplot(drawing(figure), folder_);
  const std::string name = figure.name + ".svg";
  std::string content = read_file(folder_ / name);
  if (content.empty()) throw std::runtime_error("gnuplot did not write " + name);
  files_.push_back(name);
  return content;
}

std::string draw_beside(const std::string& argument, const std::string& path, const Figure& figure) {
  return Workshop(argument, fs::absolute(path).parent_path().string()).draw(figure);
}

void Workshop::write(const std::string& name, std::string_view content) {
  replace_file(folder_ / name, content);
  files_.push_back(name);
}

void Workshop::publish() const {
  for (const std::string& name : files_) fs::rename(folder_ / name, out_ / name);
}

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// Unlike a pipe, a file neither fills up nor breaks.
File anonymous_file() {
  File file(std::tmpfile());
  if (!file) throw std::runtime_error(std::string("cannot make a temporary file: ") + std::strerror(errno));
  return file;
}

std::string in_one_line(std::FILE* file) {
  std::fseek(file, 0, SEEK_SET);
  std::string text;
  char buffer[4096];
  for (std::size_t size = 0; (size = std::fread(buffer, 1, sizeof buffer, file)) > 0;) text.append(buffer, size);
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

// Waits for `child`, through interrupting signals.
int status_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::runtime_error(std::string("waitpid: ") + std::strerror(errno));
  return status;
}

}  // namespace

void run_gnuplot(const std::string& script, const std::filesystem::path& folder) {
  const File input = anonymous_file();
  const File errors = anonymous_file();
  if (std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() || std::fflush(input.get()) != 0)
    throw std::runtime_error(std::string("cannot write a temporary file: ") + std::strerror(errno));
  std::fseek(input.get(), 0, SEEK_SET);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(errors.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(errors.get()), STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  char program[] = "gnuplot";
  char no_user_settings[] = "-d";
  char* const arguments[] = {program, no_user_settings, nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, program, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT)
    throw std::runtime_error("gnuplot draws the figures and is not in PATH; on Debian: apt-get install gnuplot-nox");
  if (error != 0) throw std::runtime_error(std::string("cannot start gnuplot: ") + std::strerror(error));
  if (status_of(child) != 0) throw std::runtime_error("gnuplot failed: " + in_one_line(errors.get()));
}

}  // namespace hrt::study
