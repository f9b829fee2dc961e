#include "samples/study/figures/workshop.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"

namespace hrt::study {

namespace fs = std::filesystem;

namespace {

std::string quoted(std::string path) {
  for (std::size_t at = 0; (at = path.find('\'', at)) != std::string::npos; at += 4) path.replace(at, 1, "'\\''");
  return "'" + path + "'";
}

void run_gnuplot(const std::string& script, const fs::path& folder) {
  replace_file(folder / "script", script);
  if (std::system(("cd " + quoted(folder) + " && gnuplot -d <script >errors 2>&1").c_str()) == 0) return;
  std::string line = "gnuplot failed:";
  std::istringstream words(read_file(folder / "errors"));
  for (std::string word; words >> word;) line += " " + word;
  throw std::runtime_error(line);
}

}  // namespace

Workshop::Workshop(const std::string& argument, const std::string& out) : out_(out), was_made_(!fs::exists(out)) {
  if (std::system("command -v gnuplot >/dev/null") != 0)
    throw std::runtime_error("gnuplot draws the figures and is not in PATH; on Debian: apt-get install gnuplot-nox");
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

}  // namespace hrt::study
