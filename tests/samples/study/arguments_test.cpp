// What a wrong argument gets: one line that names it and what is allowed, exit code 2, and no file.
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
  const StudyRun run = run_study(arguments);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  ASSERT_EQ(lines(run.err).size(), 1U) << run.err;
  EXPECT_TRUE(run.err.starts_with("hrt-study: " + GetParam().name + ": ")) << run.err;
  EXPECT_TRUE(has(run.err, GetParam().allowed));
  EXPECT_TRUE(entries(folder.path).empty());
}

const std::string from_1_to_50 = "a whole number from 1 to 50";
const std::string tactile_weight = "a number in (0, 0.5)";

INSTANTIATE_TEST_SUITE_P(
    Trial, StudyBadArgument,
    testing::Values(
        BadArgument{{"trial", "--tactile-weight", "nan"}, "--tactile-weight", tactile_weight},
        BadArgument{{"trial", "--tactile-weight", "0"}, "--tactile-weight", tactile_weight},
        BadArgument{{"trial", "--tactile-weight", "0.5"}, "--tactile-weight", tactile_weight},
        BadArgument{{"trial", "--tactile-weight", "0.1x"}, "--tactile-weight", tactile_weight},
        BadArgument{{"trial", "--tactile-weight", ""}, "--tactile-weight", tactile_weight},
        BadArgument{{"trial", "--tactile-weight"}, "--tactile-weight", tactile_weight},
        BadArgument{{"trial", "--assumed-tactile-weight", "0.7"}, "--assumed-tactile-weight", tactile_weight},
        BadArgument{{"trial", "--motor-variance", "-1"}, "--motor-variance", "a number in [0, 1e+06]"},
        BadArgument{{"trial", "--sensory-variance", "0"}, "--sensory-variance", "a number in (0, 1e+06]"},
        BadArgument{{"trial", "--horizon", "0"}, "--horizon", from_1_to_50},
        BadArgument{{"trial", "--horizon", "2.5"}, "--horizon", from_1_to_50},
        BadArgument{{"trial", "--actual-weight", "-1"}, "--actual-weight", "a number in [0, 1e+06]"},
        BadArgument{{"trial", "--plate-bound", "90.5"}, "--plate-bound", "a number in (0, 90]"},
        BadArgument{{"trial", "--plate-rate-bound", "-inf"}, "--plate-rate-bound", "(0, 360], or inf"},
        BadArgument{{"trial", "--steps", "0"}, "--steps", "a whole number from 1 to 10000"},
        BadArgument{{"trial", "--real", "181"}, "--real", "a number in [-180, 180]"},
        BadArgument{
            {"trial", "--real", "-50", "--virtual", "50"}, "--real", "less than 90 deg from --virtual"},
        BadArgument{{"trial", "--seed", "-1"}, "--seed", "a whole number from 0 to 18446744073709551615"},
        BadArgument{{"trial", "--trial", "4294967296"}, "--trial", "a whole number from 0 to 4294967295"}));

INSTANTIATE_TEST_SUITE_P(
    Table1, StudyBadArgument,
    testing::Values(
        BadArgument{{"table1", "--trials", "0"}, "--trials", "a whole number from 1 to 100000000"},
        BadArgument{{"table1", "--trials", "99999999999999999999"}, "--trials", "a whole number from 1"},
        BadArgument{{"table1", "--threads", "0"}, "--threads", "a whole number from 1 to 256"},
        BadArgument{{"table1", "--format", "xml"}, "--format", "one of text, csv, json"}));

INSTANTIATE_TEST_SUITE_P(
    Lists, StudyBadArgument,
    testing::Values(BadArgument{{"sweep", "--tactile-weight", "0.1,0.6"}, "--tactile-weight", tactile_weight},
                    BadArgument{{"sweep", "--tactile-weight", "0.1,"}, "--tactile-weight", "a list a,b,c"},
                    BadArgument{{"sweep", "--gap", "1:2:1"}, "--gap", "first:last:count"},
                    BadArgument{{"sweep", "--gap", "1:nan:3"}, "--gap", "first:last:count"},
                    BadArgument{{"sweep", "--gap", "0:90:10"}, "--gap", "a number in (-90, 90)"}));

INSTANTIATE_TEST_SUITE_P(
    Robustness, StudyBadArgument,
    testing::Values(
        BadArgument{{"robustness", "--people", "0"}, "--people", "a whole number from 1 to 100000"},
        BadArgument{{"robustness", "--durations", "0.1"}, "--durations", "a number in [0.3, 20]"},
        BadArgument{{"robustness", "--durations", "1,1.0"}, "--durations", "given once"},
        BadArgument{{"robustness", "--family", "linear,nobody"}, "--family", "--help shows"},
        BadArgument{{"robustness", "--family", ""}, "--family", "--help shows"}));

const std::string part = "i/n, whole numbers with 1 <= i <= n";
const std::string many = "1:40:100";

INSTANTIATE_TEST_SUITE_P(
    Sweep, StudyBadArgument,
    testing::Values(
        BadArgument{{"sweep", "--part", "0/3"}, "--part", part},
        BadArgument{{"sweep", "--part", "4/3"}, "--part", part},
        BadArgument{{"sweep", "--part", "1"}, "--part", part},
        BadArgument{{"sweep", "--part", "-1/3"}, "--part", part},
        BadArgument{{"sweep", "--part", "1/9999999"}, "--part", part},
        BadArgument{{"sweep", "--horizon", "3,51"}, "--horizon", from_1_to_50},
        BadArgument{{"sweep", "--motor-variance", "1,-1"}, "--motor-variance", "a number in [0, 1e+06]"},
        BadArgument{{"sweep", "--gap", "nan"}, "--gap", "a number in (-90, 90)"},
        BadArgument{
            {"sweep", "--gap", "89.99999999999999", "--virtual", "-180"}, "--gap", "a number in (-90, 90)"},
        BadArgument{{"sweep", "--gap", many, "--virtual", many, "--plate-bound", many, "--motor-variance",
                     many, "--sensory-variance", many},
                    "--gap and the other lists",
                    "at most 4294967295 combinations"}));

INSTANTIATE_TEST_SUITE_P(
    Output, StudyBadArgument,
    testing::Values(
        BadArgument{{"trial", "--out", "/nowhere/trial.csv"}, "--out", "a folder that can be written"},
        BadArgument{{"table1", "--out", "/proc/table.csv"}, "--out", "a folder that can be written"},
        BadArgument{{"ridges", "--out", "/"}, "--out", "not a regular file"},
        BadArgument{{"trial", "--out", "/dev/null"}, "--out", "not a regular file"},
        BadArgument{{"trial", "--out", ""}, "--out", "a folder that can be written"}));

INSTANTIATE_TEST_SUITE_P(Subcommand, StudyBadArgument,
                         testing::Values(BadArgument{{}, "SUBCOMMAND", "one of table1, ridges"},
                                         BadArgument{{"tabel1\n"}, "SUBCOMMAND", "one of table1, ridges"}));

TEST(StudyArguments, AnUnknownOptionIsNamed) {
  const StudyRun run = run_study({"trial", "--tactile", "0.1"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(lines(run.err).size(), 1U);
  EXPECT_TRUE(has(run.err, "--tactile"));
}

TEST(StudyArguments, HelpStatesRangesAndDefaultsOfEverySubcommand) {
  for (const std::string subcommand : {"table1", "ridges", "trial", "sweep", "report", "robustness"}) {
    const StudyRun run = run_study({subcommand, "--help"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_TRUE(has(run.out, "--out VALUE")) << subcommand;
    EXPECT_TRUE(has(run.out, "Must be a")) << subcommand;
    EXPECT_TRUE(has(run.out, "Examples:")) << subcommand;
    for (const std::string& line : lines(run.out)) EXPECT_LE(line.size(), 120U) << line;
  }
}

}  // namespace
}  // namespace hrt::study
