#include "samples/study/paper/sweep_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/whole_file.h"

namespace hrt::study {
namespace {

struct Known {
  std::uint64_t rows;  ///< whole rows of the sweep, from the first on
  std::size_t bytes;   ///< that the header and they take
  bool foreign;        ///< something else follows
};

// How much of `text` is `content`. A last line without its end was being written when the run was stopped.
Known recognise(std::string_view text, const SweepFile::Content& content) {
  if (text.size() < content.header.size())
    return {.rows = 0, .bytes = 0, .foreign = !content.header.starts_with(text)};
  if (!text.starts_with(content.header)) return {.rows = 0, .bytes = 0, .foreign = true};
  Known known{.rows = 0, .bytes = content.header.size(), .foreign = false};
  for (;;) {
    const std::string_view rest = text.substr(known.bytes);
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return known;
    const std::string_view line = rest.substr(0, end);
    known.foreign = known.rows == content.rows || !line.starts_with(content.row_start(known.rows)) ||
                    std::count(line.begin(), line.end(), ',') != content.commas;
    if (known.foreign) return known;
    known.bytes += end + 1;
    ++known.rows;
  }
}

}  // namespace

SweepFile::SweepFile(const std::string& argument, const std::string& path, const Content& content) {
  const Output check(argument, path);
  path_ = std::filesystem::weakly_canonical(path);
  partial_ = path_.string() + ".partial";
  const auto refuse = [&](const std::filesystem::path& file, const std::string& why) {
    return UsageError(
        not_allowed(argument, path,
                    "a new file, or that of the same sweep (" + file.filename().string() + ' ' + why + ')'));
  };

  if (std::filesystem::exists(path_)) {
    const std::string text = read_file(path_);
    const Known known = recognise(text, content);
    if (known.rows != content.rows || known.bytes != text.size())
      throw refuse(path_, "holds something else; delete it to write it anew");
    return;
  }

  file_ = open(partial_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0)
    throw UsageError(not_allowed(argument, path, "a file that can be written with .partial added"));
  struct stat opened{};
  struct stat named{};
  // Another process may have given the file its final name since it was opened here.
  const bool is_ours = flock(file_, LOCK_EX | LOCK_NB) == 0 && fstat(file_, &opened) == 0 &&
                       stat(partial_.c_str(), &named) == 0 && opened.st_ino == named.st_ino;
  const std::string text = is_ours ? read_file(partial_) : "";
  const Known known = recognise(text, content);
  if (!is_ours || known.foreign) {
    close(file_);
    throw refuse(partial_, is_ours ? "holds something else; delete it to start again"
                                   : "is being written by another hrt-study");
  }
  rows_ = known.rows;
  if (ftruncate(file_, static_cast<off_t>(known.bytes)) != 0 || lseek(file_, 0, SEEK_END) < 0) {
    const int error = errno;
    close(file_);
    throw cannot_write(partial_, error);
  }
  try {
    if (known.bytes == 0) append(content.header);
  } catch (...) {
    close(file_);
    throw;
  }
}

SweepFile::~SweepFile() {
  if (file_ >= 0) close(file_);
}

void SweepFile::append(std::string_view text) {
  if (const int error = write_all(file_, text); error != 0) throw cannot_write(partial_, error);
}

void SweepFile::finish() {
  if (rename(partial_.c_str(), path_.c_str()) != 0) throw cannot_write(path_, errno);
}

}  // namespace hrt::study
