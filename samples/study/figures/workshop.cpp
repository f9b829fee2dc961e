#include "samples/study/figures/workshop.h"

#include <unistd.h>

#include <stdexcept>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/figures/gnuplot.h"

namespace hrt::study {

namespace fs = std::filesystem;

Workshop::Workshop(const std::string& argument, const std::string& out)
    : out_(out), was_made_(!fs::exists(out)) {
  run_gnuplot("", ".");  // missing: said before the work, not after it
  std::error_code error;
  fs::create_directories(out_, error);
  folder_ = out_ / (".hrt-study." + std::to_string(getpid()) + ".tmp");
  if (!error) fs::create_directory(folder_, error);
  if (error)
    throw UsageError(not_allowed(argument, out, "a folder that can be written (" + error.message() + ")"));
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
