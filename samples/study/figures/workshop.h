// A folder in which files are made before any of them gets its name.
#pragma once

#include <filesystem>
#include <string>

namespace hrt::study {

/// Files of one result, gnuplot's among them: they appear where they belong when all are made, or not at all.
class Workshop {
 public:
  /// Makes `out` if it is missing. Throws UsageError naming `argument` if it can't be written.
  Workshop(const std::string& argument, const std::string& out);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// Where to make them; removed at the end.
  const std::filesystem::path& folder() const { return folder_; }

  /// What was made under `name`. Throws std::runtime_error if nothing was.
  std::string read(const std::string& name) const;

  /// Moves `name` to `out`.
  void publish(const std::string& name) const;

 private:
  std::filesystem::path out_;
  std::filesystem::path folder_;
  bool was_made_;
};

}  // namespace hrt::study
