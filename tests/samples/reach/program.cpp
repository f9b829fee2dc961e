#include "tests/samples/reach/program.h"

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

namespace hrt::reach {
namespace {

std::vector<std::string> words_of(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {HRT_REACH_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

std::vector<std::string> variables_of(const std::map<std::string, std::string>& environment) {
  std::vector<std::string> variables = {"LSAN_OPTIONS=print_suppressions=0:suppressions=" HRT_LEAK_SUPPRESSIONS};
  for (const auto& [name, value] : environment) variables.push_back(name + "=" + value);
  for (const char* passed_on : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS", "HOME"})
    if (const char* value = std::getenv(passed_on)) variables.push_back(std::string(passed_on) + "=" + value);
  // A default: of two variables with the same name, the first one counts. It avoids a crash of AddressSanitizer's leak
  // search, which misinterprets thread-local storage that begins 16 bytes into a page.
  variables.emplace_back("ASAN_OPTIONS=intercept_tls_get_addr=0");
  return variables;
}

}  // namespace

std::string scratch_folder() {
  static const TemporaryFolder folder;
  static int count = 0;
  const std::filesystem::path own = folder.path / std::to_string(count++);
  std::filesystem::create_directory(own);
  return own.string();
}

std::map<std::string, std::string> mock_environment() { return {{"XR_RUNTIME_JSON", HRT_MOCK_MANIFEST}}; }

Program::Program(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment,
                 int err, int in)
    : Process(words_of(arguments), variables_of(environment), err, in) {}

Outcome run_program(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment) {
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

std::vector<std::string> person_and(const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {desk, "--person", "--plate", "servo", "--target", "bottle"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<Row> rows_of(const Outcome& outcome) {
  // Names may contain spaces and signs; decimals distinguish directions from names.
  static const std::regex pattern(
      R"((.*?) +[+-]\d+\.\d  .*? +[+-]\d+\.\d +([+-]\d+\.\d\d) +(\d+\.\d|-) +([+-]\d+\.\d\d) +(\d+\.\d) )"
      R"(+([0-9.]+|-) +(\d\.\d+) +[0-9.-]+ +(\d+) +(\d+) +(\d+)%  (reached|missed).*)");
  std::vector<Row> rows;
  std::istringstream lines(outcome.out);
  std::smatch match;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, match, pattern))
      rows.push_back({match[1], std::stod(match[2]), match[3] == "-" ? 0.0 : std::stod(match[3]), std::stod(match[4]),
                      std::stod(match[5]), match[6], std::stod(match[7]), std::stoi(match[8]), std::stoi(match[9]),
                      std::stoi(match[10]), match[11] == "reached"});
  return rows;
}

}  // namespace hrt::reach
