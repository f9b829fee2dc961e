#include "samples/study/figures/gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace hrt::study {
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
  for (std::size_t size = 0; (size = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
    text.append(buffer, size);
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
  if (std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() ||
      std::fflush(input.get()) != 0)
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
    throw std::runtime_error(
        "gnuplot draws the figures and is not in PATH; on Debian: apt-get install gnuplot-nox");
  if (error != 0) throw std::runtime_error(std::string("cannot start gnuplot: ") + std::strerror(error));
  if (status_of(child) != 0) throw std::runtime_error("gnuplot failed: " + in_one_line(errors.get()));
}

}  // namespace hrt::study
