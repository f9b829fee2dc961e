#include "tests/samples/reach/program.h"

#include <fcntl.h>
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

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& string : strings) result.push_back(string.data());
  result.push_back(nullptr);
  return result;
}

// In the child of a process that may have threads: only calls that are safe in signal handlers. Never
// returns.
void become_program(char* const* arguments, char* const* environment, const char* out_file,
                    const char* err_file, int err_given) {
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  const int out = open(out_file, flags, 0600);
  const int err = err_given >= 0 ? err_given : open(err_file, flags, 0600);
  if (dup2(out, STDOUT_FILENO) < 0 || dup2(err, STDERR_FILENO) < 0) _exit(126);
  execve(arguments[0], arguments, environment);
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
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
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

std::string read_file(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::map<std::string, std::string> mock_environment() {
  return {{"XR_RUNTIME_JSON", HRT_MOCK_MANIFEST}};
}

Program::Program(const std::vector<std::string>& arguments,
                 const std::map<std::string, std::string>& environment, int err)
    : folder_(scratch_folder()) {
  std::vector<std::string> argument_strings = {HRT_REACH_PROGRAM};
  argument_strings.insert(argument_strings.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment_strings = {
      "LSAN_OPTIONS=print_suppressions=0:suppressions=" HRT_LEAK_SUPPRESSIONS};
  for (const auto& [name, value] : environment) environment_strings.push_back(name + "=" + value);
  for (const char* passed_on : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS", "HOME"})
    if (const char* value = std::getenv(passed_on))
      environment_strings.push_back(std::string(passed_on) + "=" + value);

  const std::string out_file = folder_ + "/out", err_file = folder_ + "/err";
  const std::vector<char*> argument_pointers = pointers(argument_strings);
  const std::vector<char*> environment_pointers = pointers(environment_strings);
  child_ = fork();
  if (child_ == 0)
    become_program(argument_pointers.data(), environment_pointers.data(), out_file.c_str(), err_file.c_str(),
                   err);
}

void Program::send_signal(int signal) const {
  kill(child_, signal);
}

std::string Program::out() const {
  return read_file(folder_ + "/out");
}

std::string Program::err() const {
  return read_file(folder_ + "/err");
}

Outcome Program::wait() {
  int status = 0;
  const auto give_up = std::chrono::steady_clock::now() + 60s;
  while (waitpid(child_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > give_up) kill(child_, SIGKILL);
    std::this_thread::sleep_for(2ms);
  }
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, out(), err()};
  if (WIFSIGNALED(status)) outcome.err += "\nended by signal " + std::to_string(WTERMSIG(status));
  return outcome;
}

Outcome run_program(const std::vector<std::string>& arguments,
                    const std::map<std::string, std::string>& environment) {
  return Program(arguments, environment).wait();
}

std::map<std::string, std::string> scripted_environment(const std::string& script) {
  const std::string file = scratch_folder() + "/script.json";
  std::ofstream(file) << script;
  auto environment = mock_environment();
  environment["HRT_MOCK_SCRIPT"] = file;
  return environment;
}

Outcome run_scripted(const std::string& script, const std::vector<std::string>& arguments) {
  return run_program(arguments, scripted_environment(script));
}

std::vector<Row> rows_of(const Outcome& outcome) {
  // Names may hold spaces and signs; directions differ from them by their decimals.
  static const std::regex pattern(
      R"((.*?) +([+-]\d+\.\d)  (.*?) +([+-]\d+\.\d) +([+-]\d+\.\d\d) +(\d+\.\d|-) +([+-]\d+\.\d\d) +(\d+\.\d) )"
      R"(+([0-9.]+|-) +(\d\.\d+) +([0-9.-]+) +(\d+) +(\d+) +(\d+)%  (reached|missed).*)");
  std::vector<Row> rows;
  std::istringstream lines(outcome.out);
  std::smatch match;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, match, pattern))
      rows.push_back({match[1], std::stod(match[2]), std::stod(match[4]), std::stod(match[5]),
                      match[6] == "-" ? 0.0 : std::stod(match[6]), std::stod(match[7]), std::stod(match[8]),
                      match[9], std::stod(match[10]), match[11], std::stoi(match[12]), std::stoi(match[13]),
                      std::stoi(match[14]), match[15] == "reached",
                      line.find("cannot be held") != std::string::npos});
  return rows;
}

}  // namespace hrt::reach
