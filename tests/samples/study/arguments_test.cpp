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
  if (GetParam().name != "--out") arguments.insert(arguments.begin() + 1, {"--out", folder / "result"});
  const StudyRun run = expect_exit(2, run_study(arguments));
  EXPECT_EQ(run.out, "");
  ASSERT_EQ(lines(run.err).size(), 1U) << run.err;
  EXPECT_TRUE(run.err.starts_with("hrt-study: " + GetParam().name + ": ")) << run.err;
  EXPECT_TRUE(has(run.err, GetParam().allowed));
  EXPECT_TRUE(entries(folder.path).empty());
}

INSTANTIATE_TEST_SUITE_P(
    Each, StudyBadArgument,
    testing::ValuesIn(std::vector<BadArgument>{
        {{"trial", "--tactile-weight", "nan"}, "--tactile-weight", "a number in (0, 0.5)"},
        {{"trial", "--tactile-weight", "0.5"}, "--tactile-weight", "a number in (0, 0.5)"},
        {{"trial", "--tactile-weight", "0.1x"}, "--tactile-weight", "a number in (0, 0.5)"},
        {{"trial", "--tactile-weight"}, "--tactile-weight", "a number in (0, 0.5)"},
        {{"trial", "--motor-variance", "-1"}, "--motor-variance", "a number in [0, 1000000]"},
        {{"trial", "--horizon", "2.5"}, "--horizon", "a whole number from 1 to 20"},
        {{"trial", "--plate-bound", "90.5"}, "--plate-bound", "a number in (0, 90]"},
        {{"trial", "--plate-rate-bound", "-inf"}, "--plate-rate-bound", "(0, 360], or inf"},
        {{"trial", "--fixed-plate", "181"}, "--fixed-plate", "a number in [-180, 180]"},
        {{"trial", "--real", "-50", "--virtual", "50"}, "--real", "less than 90 deg from --virtual"},
        {{"trial", "--seed", "-1"}, "--seed", "a whole number from 0 to 18446744073709551615"},
        {{"trial", "--trial", "4294967296"}, "--trial", "a whole number from 0 to 4294967295"},
        {{"table1", "--trials", "99999999999999999999"}, "--trials", "a whole number from 1"},
        {{"table1", "--format", "xml"}, "--format", "one of text, csv, json"},
        {{"ridges", "--angles", "10,90"}, "--angles", "a number in (-90, 90)"},
        {{"ridges", "--angles", "10,"}, "--angles", "a list a,b,c"},
        {{"ridges", "--angles", "1:2:1"}, "--angles", "first:last:count"},
        {{"ridges", "--angles", "1:nan:3"}, "--angles", "first:last:count"},
        {{"robustness", "--family", "linear,linear"}, "--family", "--help shows"},
        {{"robustness", "--family", "linear,nobody"}, "--family", "--help shows"},
        {{"robustness", "--informed-of", "weight,age"}, "--informed-of", "from weight,"},
        {{"trial", "--out", "/nowhere/trial.csv"}, "--out", "a folder that can be written"},
        {{"ridges", "--out", "/"}, "--out", "not a regular file"},
        {{"trial", "--out", ""}, "--out", "a path"},
        {{"robustness", "--csv", "/tmp/hrt_twice.csv", "--out", "/tmp/hrt_twice.csv"},
         "--csv",
         "no other option names"}}));

TEST(StudyArguments, UnknownMissingAndIgnoredArgumentsAreErrors) {
  struct Case {
    std::vector<std::string> arguments;
    const char* named;
  };
  for (const auto& [arguments, named] : {Case{{}, "subcommand"},
                                         {{"tabel1\n"}, "subcommand"},
                                         {{"trial", "--tactile", "0.1"}, "--tactile"},
                                         {{"trial", "--trace", "q", "--out", "b.csv"}, "--trace"},
                                         {{"trial", "--reach", "2"}, "--trace"},
                                         {{"calibrate"}, "FILE"}}) {
    const StudyRun run = expect_exit(2, run_study(arguments));
    EXPECT_EQ(lines(run.err).size(), 1U) << run.err;
    EXPECT_TRUE(has(run.err, named));
  }
}

TEST(StudyArguments, HelpStatesRangesAndDefaultsOfEverySubcommand) {
  for (const std::string subcommand : {"table1", "ridges", "trial", "report", "robustness"}) {
    const StudyRun run = expect_exit(0, run_study({subcommand, "--help"}));
    EXPECT_EQ(run.err, "");
    EXPECT_TRUE(has(run.out, "--out")) << subcommand;
    EXPECT_TRUE(has(run.out, ":a path")) << subcommand;
    EXPECT_TRUE(has(run.out, "Examples:")) << subcommand;
  }
}

}  // namespace
}  // namespace hrt::study
