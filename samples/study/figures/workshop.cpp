#include "samples/study/figures/workshop.h"

#include <unistd.h>

#include <stdexcept>

#include "samples/study/arguments.h"
#include "samples/study/output.h"

namespace hrt::study {

namespace fs = std::filesystem;

Workshop::Workshop(const std::string& argument, const std::string& out)
    : out_(out), was_made_(!fs::exists(out)) {
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

std::string Workshop::read(const std::string& name) const {
  std::string text = read_file(folder_ / name);
  if (text.empty()) throw std::runtime_error("gnuplot did not write " + name);
  return text;
}

void Workshop::publish(const std::string& name) const {
  fs::rename(folder_ / name, out_ / name);
}

}  // namespace hrt::study
