// A wrong argument is answered by one line that names it and what is allowed, exit code 2, and no file.
#include <gtest/gtest.h>

#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

struct BadArgument {
  std::vector<std::string> arguments;
  std::string name;
  std::string allowed;
};

void PrintTo(const BadArgument& bad, std::ostream* out) {
  for (const std::string& argument : bad.arguments) *out << testing::PrintToString(argument) << ' ';
}

class StudyBadArgument : public testing::TestWithParam<BadArgument> {};

TEST_P(StudyBadArgument, IsOneLineAndExitCodeTwo) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = GetParam().arguments;
  if (GetParam().name != "--out" && GetParam().name != "SUBCOMMAND")
    arguments.insert(arguments.begin() + 1, {"--out", folder / "result"});
  const StudyRun run = expect_exit(2, run_study(arguments));
  EXPECT_EQ(run.out, "");
  ASSERT_EQ(lines(run.err).size(), 1U) << run.err;
  EXPECT_TRUE(run.err.starts_with("hrt-study: " + GetParam().name + ": ")) << run.err;
  EXPECT_TRUE(has(run.err, GetParam().allowed));
  EXPECT_TRUE(entries(folder.path).empty());
}

const std::string from_1_to_20 = "a whole number from 1 to 20";
const std::string tactile_weight = "a number in (0, 0.5)";
const std::string many = "1:40:100";

INSTANTIATE_TEST_SUITE_P(
    Each, StudyBadArgument,
    testing::ValuesIn(std::vector<BadArgument>{
        {{"trial", "--tactile-weight", "nan"}, "--tactile-weight", tactile_weight},
        {{"trial", "--tactile-weight", "0"}, "--tactile-weight", tactile_weight},
        {{"trial", "--tactile-weight", "0.5"}, "--tactile-weight", tactile_weight},
        {{"trial", "--tactile-weight", "0.1x"}, "--tactile-weight", tactile_weight},
        {{"trial", "--tactile-weight", ""}, "--tactile-weight", tactile_weight},
        {{"trial", "--tactile-weight"}, "--tactile-weight", tactile_weight},
        {{"trial", "--assumed-tactile-weight", "0.7"}, "--assumed-tactile-weight", tactile_weight},
        {{"trial", "--motor-variance", "-1"}, "--motor-variance", "a number in [0, 1e+06]"},
        {{"trial", "--sensory-variance", "0"}, "--sensory-variance", "a number in (0, 1e+06]"},
        {{"trial", "--horizon", "0"}, "--horizon", from_1_to_20},
        {{"trial", "--horizon", "2.5"}, "--horizon", from_1_to_20},
        {{"trial", "--actual-weight", "-1"}, "--actual-weight", "a number in [0, 1e+06]"},
        {{"trial", "--plate-bound", "90.5"}, "--plate-bound", "a number in (0, 90]"},
        {{"trial", "--plate-rate-bound", "-inf"}, "--plate-rate-bound", "(0, 360], or inf"},
        {{"trial", "--steps", "0"}, "--steps", "a whole number from 1 to 10000"},
        {{"trial", "--real", "181"}, "--real", "a number in [-180, 180]"},
        {{"trial", "--real", "-50", "--virtual", "50"}, "--real", "less than 90 deg from --virtual"},
        {{"trial", "--seed", "-1"}, "--seed", "a whole number from 0 to 18446744073709551615"},
        {{"trial", "--trial", "4294967296"}, "--trial", "a whole number from 0 to 4294967295"},
        {{"table1", "--trials", "0"}, "--trials", "a whole number from 1 to 100000000"},
        {{"table1", "--trials", "99999999999999999999"}, "--trials", "a whole number from 1"},
        {{"table1", "--threads", "0"}, "--threads", "a whole number from 1 to 256"},
        {{"table1", "--format", "xml"}, "--format", "one of text, csv, json"},
        {{"sweep", "--tactile-weight", "0.1,0.6"}, "--tactile-weight", tactile_weight},
        {{"sweep", "--tactile-weight", "0.1,"}, "--tactile-weight", "a list a,b,c"},
        {{"sweep", "--gap", "1:2:1"}, "--gap", "first:last:count"},
        {{"sweep", "--gap", "1:nan:3"}, "--gap", "first:last:count"},
        {{"sweep", "--gap", "0:90:10"}, "--gap", "a number in (-90, 90)"},
        {{"robustness", "--people", "0"}, "--people", "a whole number from 1 to 100000"},
        {{"robustness", "--durations", "0.1"}, "--durations", "a number in [0.3, 20]"},
        {{"robustness", "--durations", "1,1.0"}, "--durations", "given once"},
        {{"robustness", "--family", "linear,nobody"}, "--family", "--help shows"},
        {{"robustness", "--family", ""}, "--family", "--help shows"},
        {{"sweep", "--horizon", "3,21"}, "--horizon", from_1_to_20},
        {{"sweep", "--motor-variance", "1,-1"}, "--motor-variance", "a number in [0, 1e+06]"},
        {{"sweep", "--gap", "nan"}, "--gap", "a number in (-90, 90)"},
        {{"sweep", "--gap", "89.99999999999999", "--virtual", "-180"}, "--gap", "a number in (-90, 90)"},
        {{"sweep", "--gap", many, "--virtual", many, "--plate-bound", many, "--motor-variance", many,
          "--sensory-variance", many},
         "--gap and the other lists",
         "at most 4294967295 combinations"},
        {{"trial", "--out", "/nowhere/trial.csv"}, "--out", "a folder that can be written"},
        {{"table1", "--out", "/proc/table.csv"}, "--out", "a folder that can be written"},
        {{"ridges", "--out", "/"}, "--out", "not a regular file"},
        {{"trial", "--out", "/dev/null"}, "--out", "not a regular file"},
        {{"robustness", "--csv", "/tmp/hrt_twice.csv", "--out", "/tmp/hrt_twice.csv"},
         "--csv",
         "no other option names"},
        {{"trial", "--out", ""}, "--out", "a folder that can be written"},
        {{}, "SUBCOMMAND", "one of table1, ridges"},
        {{"tabel1\n"}, "SUBCOMMAND", "one of table1, ridges"}}));

TEST(StudyArguments, AnUnknownOptionIsNamed) {
  const StudyRun run = expect_exit(2, run_study({"trial", "--tactile", "0.1"}));
  EXPECT_EQ(lines(run.err).size(), 1U);
  EXPECT_TRUE(has(run.err, "--tactile"));
}

TEST(StudyArguments, WhatWouldBeIgnoredIsRefused) {
  const std::vector<std::string> ignored[] = {{"trial", "--trace", "q", "--out", "b.csv"}, {"trial", "--reach", "2"}};
  for (const auto& arguments : ignored) {
    const StudyRun run = expect_exit(2, run_study(arguments));
    EXPECT_TRUE(has(run.err, "--trace")) << run.err;
  }
}

TEST(StudyArguments, HelpStatesRangesAndDefaultsOfEverySubcommand) {
  for (const std::string subcommand : {"table1", "ridges", "trial", "sweep", "report", "robustness"}) {
    const StudyRun run = expect_exit(0, run_study({subcommand, "--help"}));
    EXPECT_EQ(run.err, "");
    EXPECT_TRUE(has(run.out, "--out VALUE")) << subcommand;
    EXPECT_TRUE(has(run.out, "Must be a")) << subcommand;
    EXPECT_TRUE(has(run.out, "Examples:")) << subcommand;
    for (const std::string& line : lines(run.out)) EXPECT_LE(line.size(), 120U) << line;
  }
}

}  // namespace
}  // namespace hrt::study
