#include "tests/samples/study/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hrt::study {
namespace {

pid_t spawn(const std::vector<std::string>& arguments, const std::string& out, const std::string& err,
            const std::string& search_path) {
  std::vector<std::string> words{HRT_STUDY_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  std::string path = "PATH=" + search_path;
  std::vector<char*> environment;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (search_path.empty() || !std::string(*variable).starts_with("PATH=")) environment.push_back(*variable);
  if (!search_path.empty()) environment.push_back(path.data());
  environment.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int error = posix_spawn(&child, HRT_STUDY_PROGRAM, &files, nullptr, argv.data(), environment.data());
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error("cannot start " HRT_STUDY_PROGRAM);
  return child;
}

}  // namespace

StudyRun run_study(const std::vector<std::string>& arguments, const std::string& search_path) {
  const TemporaryFolder folder;
  const pid_t child = spawn(arguments, folder / "out", folder / "err", search_path);
  int status = 0;
  if (waitpid(child, &status, 0) != child) throw std::runtime_error("waitpid");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_file(folder.path / "out"),
          read_file(folder.path / "err")};
}

pid_t start_study(const std::vector<std::string>& arguments) {
  return spawn(arguments, "/dev/null", "/dev/null", {});
}

std::vector<std::string> entries(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find(',', begin);
    result.push_back(line.substr(begin, end - begin));
    if (end == std::string::npos) return result;
    begin = end + 1;
  }
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "hrt-study-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp");
  path = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

}  // namespace hrt::study
