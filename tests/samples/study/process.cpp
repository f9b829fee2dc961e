#include "tests/samples/study/process.h"

#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "samples/study/cli/arguments.h"

namespace hrt::study {

Process start_study(const std::vector<std::string>& arguments, const std::string& modules, int err) {
  std::vector<std::string> words{HRT_STUDY_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment;
  for (char** variable = environ; *variable != nullptr; ++variable) environment.emplace_back(*variable);
  if (!modules.empty()) environment.push_back("PYTHONPATH=" + modules);
  return {words, environment, err};
}

StudyRun run_study(const std::vector<std::string>& arguments, const std::string& modules) {
  return start_study(arguments, modules).wait();
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
  const auto parts = split(line, ',');
  return {parts.begin(), parts.end()};
}

}  // namespace hrt::study
