// A temporary folder: results appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace hrt::study {

/// Collects the files of one result until all are made.
class Workshop {
 public:
  /// Makes `out` if it is missing. Throws UsageError naming `argument` if it can't be written.
  Workshop(const std::string& argument, const std::string& out);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// Where to make them; removed by the destructor.
  const std::filesystem::path& folder() const { return folder_; }

  /// The content of the file `name`. Throws std::runtime_error if there is none.
  std::string read(const std::string& name) const;

  /// Moves `name` to `out`.
  void publish(const std::string& name) const;

 private:
  std::filesystem::path out_;
  std::filesystem::path folder_;
  bool was_made_;
};

}  // namespace hrt::study
