#include "tests/samples/reach_program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <thread>

namespace hrt::reach {
namespace {

using namespace std::chrono_literals;

std::string read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& string : strings) result.push_back(string.data());
  result.push_back(nullptr);
  return result;
}

// Never returns.
void become_program(std::vector<std::string> arguments, std::vector<std::string> environment,
                    const std::string& out_file, const std::string& err_file) {
  if (freopen(out_file.c_str(), "w", stdout) == nullptr || freopen(err_file.c_str(), "w", stderr) == nullptr)
    _exit(126);
  execve(arguments[0].c_str(), pointers(arguments).data(), pointers(environment).data());
  _exit(127);
}

struct ScratchFolder {
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "hrt_reach_test_XXXXXX").string();
    path = mkdtemp(pattern.data());
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::filesystem::path path;
};

}  // namespace

std::string scratch_folder() {
  static const ScratchFolder folder;
  static int count = 0;
  const std::filesystem::path own = folder.path / std::to_string(count++);
  std::filesystem::create_directory(own);
  return own.string();
}

std::map<std::string, std::string> mock_environment() {
  return {{"XR_RUNTIME_JSON", HRT_MOCK_MANIFEST}};
}

Outcome run_program(const std::vector<std::string>& arguments,
                    const std::map<std::string, std::string>& environment) {
  std::vector<std::string> argument_strings = {HRT_REACH_PROGRAM};
  argument_strings.insert(argument_strings.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment_strings;
  for (const auto& [name, value] : environment) environment_strings.push_back(name + "=" + value);
  for (const char* passed_on : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS", "HOME"})
    if (const char* value = std::getenv(passed_on))
      environment_strings.push_back(std::string(passed_on) + "=" + value);

  const std::string folder = scratch_folder();
  const pid_t child = fork();
  if (child == 0) become_program(argument_strings, environment_strings, folder + "/out", folder + "/err");

  int status = 0;
  const auto give_up = std::chrono::steady_clock::now() + 60s;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > give_up) kill(child, SIGKILL);
    std::this_thread::sleep_for(2ms);
  }
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(folder + "/out"), read(folder + "/err")};
  if (WIFSIGNALED(status)) outcome.err += "\nended by signal " + std::to_string(WTERMSIG(status));
  return outcome;
}

std::vector<Row> rows_of(const Outcome& outcome) {
  // Names may hold spaces and signs; directions are told from them by their decimals.
  static const std::regex pattern(
      R"((.*?) +([+-]\d+\.\d)  (.*?) +([+-]\d+\.\d) +([+-]\d+\.\d\d) +([+-]\d+\.\d\d) +([+-]\d+\.\d\d) +(\d+\.\d) )"
      R"(+(\d+) +(\d+) +(\d+)%  (reached|missed).*)");
  std::vector<Row> rows;
  std::istringstream lines(outcome.out);
  std::smatch match;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, match, pattern))
      rows.push_back({match[1], std::stod(match[2]), std::stod(match[4]), std::stod(match[5]),
                      std::stod(match[6]), std::stod(match[7]), std::stod(match[8]), std::stoi(match[9]),
                      std::stoi(match[10]), match[12] == "reached"});
  return rows;
}

}  // namespace hrt::reach
