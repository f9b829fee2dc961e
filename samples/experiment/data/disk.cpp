#include "samples/experiment/data/disk.h"

#include <fcntl.h>
#include <sha2.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "samples/app/text/json_file.h"
#include "samples/app/text/whole_file.h"

namespace hrt::experiment {

namespace fs = std::filesystem;

namespace {

void sync_folder(const fs::path& folder) {
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  fsync(file);
  close(file);
}

}  // namespace

void Disk::check(bool done, const std::string& what, const fs::path& file) const {
  const int error = errno;
  if (!done)
    throw Refusal(file.string() + ": cannot be " + what + ": " + std::strerror(error) +
                  "; free space, or select another folder (--data)");
}

int Disk::sync(int file) const { return syncs_ ? fdatasync(file) : 0; }

bool Disk::create(const fs::path& file, std::string_view content) const {
  if (fs::exists(file)) return false;
  static std::atomic<unsigned> number = 0;  // makes the names of this process's temporary files unique
  fs::path temporary = temporary_beside(file);
  temporary += std::to_string(++number);
  step("before write");
  const int opened = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  check(opened >= 0, "created", file);
  int error = write_all(opened, content);
  step("after write");
  if (error == 0 && sync(opened) != 0) error = errno;
  step("after sync");
  close(opened);
  // Unlike rename(), link() fails if the target exists.
  if (error == 0 && link(temporary.c_str(), file.c_str()) != 0) error = errno;
  step("after link");
  unlink(temporary.c_str());
  if (error == EEXIST) return false;
  errno = error;
  check(error == 0, "written", file);
  if (syncs_) sync_folder(file.parent_path());
  return true;
}

void Disk::append(int file, const fs::path& name, std::string_view content) const {
  step("before write");
  errno = write_all(file, content);
  check(errno == 0, "written", name);
}

void Disk::sync(int file, const fs::path& name) const {
  step("before sync");
  check(sync(file) == 0, "synced", name);
  step("after sync");
}

void Disk::sync(const fs::path& file) const {
  const int opened = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  check(opened >= 0, "opened", file);
  const int error = sync(opened) == 0 ? 0 : errno;
  close(opened);
  errno = error;
  check(error == 0, "synced", file);
  step("after sync");
}

void Disk::make_folder(const fs::path& folder) const {
  std::error_code error;
  fs::create_directories(folder, error);
  errno = error.value();
  check(!error, "created", folder);
  if (syncs_) sync_folder(folder.parent_path());
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || fs::is_directory(file))
    throw Refusal(file.string() + ": cannot be read: check the path and its permissions");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string sha256_of(std::string_view text) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};
  SHA256Data(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), digits.data());
  return digits.data();
}

}  // namespace hrt::experiment
