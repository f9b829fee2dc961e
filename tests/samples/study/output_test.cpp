#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "samples/app/emulator/pseudo_terminal.h"
#include "samples/app/text/text.h"
#include "samples/study/people/robustness.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

using Arguments = std::vector<std::string>;

Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(StudyOutput, EveryByteIsTheSameForAnyNumberOfThreads) {
  const Arguments robustness{"robustness", "--people", "2", "--durations", "0.8,1.2", "--format", "csv"};
  for (const Arguments& arguments :
       {Arguments{"table1", "--trials", "300"}, Arguments{"table1", "--trials", "300", "--format", "csv"},
        Arguments{"table1", "--trials", "300", "--format", "json"}, robustness}) {
    const StudyRun one = expect_exit(0, run_study(arguments + Arguments{"--threads", "1"}));
    EXPECT_EQ(one.err, "");
    EXPECT_FALSE(one.out.empty());
    EXPECT_EQ(one.out, run_study(arguments + Arguments{"--threads", "3"}).out) << arguments[0];
  }
  EXPECT_EQ(lines(run_study(robustness).out).size(), 1 + people_families().size() * 2 * all_controllers.size());
}

TEST(StudyOutput, TextSaysThatItIsSimulationInLinesThatFit) {
  for (const auto& [arguments, columns] : {std::pair<Arguments, std::size_t>{{"table1", "--trials", "200"}, 110},
                                           {{"robustness", "--people", "1"}, 120}}) {
    const StudyRun run = run_study(arguments);
    EXPECT_TRUE(has(run.out, "there was no human trial"));
    for (const std::string& line : lines(run.out)) EXPECT_LE(length_of(line), columns) << line;
  }
}

// Compares the first rows. A missing value is empty in CSV and null in JSON.
TEST(StudyOutput, CsvAndJsonHaveTheSameRows) {
  for (const Arguments& arguments :
       {Arguments{"table1", "--trials", "20"}, Arguments{"ridges"}, Arguments{"scene", HRT_SCENES "/desk.gltf"},
        Arguments{"coverage", "--kind", "steps", "--people", "1"},
        Arguments{"robustness", "--people", "1", "--family", "linear", "--durations", "1"}}) {
    const auto page = nlohmann::json::parse(run_study(arguments + Arguments{"--format", "json"}).out);
    const auto rows = lines(run_study(arguments + Arguments{"--format", "csv"}).out);
    EXPECT_TRUE(page["simulation"].get<bool>()) << arguments[0];
    ASSERT_EQ(rows.size(), page["rows"].size() + 1) << arguments[0];
    const auto names = fields(rows[0]);
    const auto values = fields(rows[1]);
    for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i) {
      const auto& value = page["rows"][0][names[i]];
      if (value.is_null()) {
        EXPECT_EQ(values[i], "") << names[i];
      } else if (value.is_number()) {
        EXPECT_EQ(std::strtod(values[i].c_str(), nullptr), value.get<double>()) << names[i];
      } else if (value.is_boolean()) {
        EXPECT_EQ(values[i], value.get<bool>() ? "1" : "0") << names[i];
      }
    }
  }
}

TEST(StudyOutput, WithoutMatplotlibNothingIsWritten) {
  const TemporaryFolder data, folder;
  std::ofstream(data / "matplotlib.py") << "raise ImportError";
  ASSERT_EQ(run_study({"participants", "--trials", "2", "--out", data / "me.csv"}).exit_code, 0);
  for (const Arguments& arguments :
       {Arguments{"calibrate", data / "me.csv", "--plot", folder / "p.svg", "--out", folder / "p.txt"},
        Arguments{"ridges", "--plot", folder / "r.svg"}, Arguments{"report", "--out", folder / "report"}}) {
    const StudyRun run = expect_exit(1, run_study(arguments, data.path.string()));
    EXPECT_TRUE(has(run.err, "apt-get install python3-matplotlib\n"));
    EXPECT_TRUE(entries(folder.path).empty()) << arguments[0];
  }
}

using Clock = std::chrono::steady_clock;

struct Watched {
  std::string text;           ///< output on standard error
  double first_text_s = 0.0;  ///< time of its first character
};

// Runs hrt-study with a terminal as standard error until it prints `until` there, or until `limit_s` has passed.
Watched watch(const std::vector<std::string>& arguments, const std::string& until, double limit_s) {
  const plate::Pty terminal(80);
  const auto started = Clock::now();
  const auto elapsed_s = [&] { return std::chrono::duration<double>(Clock::now() - started).count(); };
  const Process program = start_study(arguments, {}, terminal.descriptor());
  Watched watched;
  while (elapsed_s() < limit_s && watched.text.find(until) == std::string::npos) {
    watched.text += terminal.take(100);
    if (watched.text.empty()) watched.first_text_s = elapsed_s();
  }
  program.send_signal(SIGKILL);
  program.wait();
  return watched;
}

TEST(StudyProgress, ABarAppearsOnATerminalAfterOneSecond) {
  const Watched watched = watch({"table1", "--trials", "100000000"}, "s left", 60.0);
  EXPECT_TRUE(has(watched.text, {"[---", " %, "}));
  EXPECT_GE(watched.first_text_s, 0.9);
}

TEST(StudyProgress, NoneForShortWork) { EXPECT_EQ(watch({"table1", "--trials", "10"}, "never said", 3.0).text, ""); }

TEST(Text, ColumnsCountCharacters) {
  const std::string word = "\u00e4\u20ac\U0001f600";
  EXPECT_EQ(length_of(word), 3U);
  EXPECT_EQ(left(word, 5), word + "  ");
  EXPECT_EQ(right(word, 5), "  " + word);
  EXPECT_EQ(left(word, 2), word);
  EXPECT_EQ(cut_to(word, 2), "\u00e4\u20ac");
  EXPECT_EQ(cut_to(word, 3), word);
  EXPECT_EQ(cut_to(word, 0), "");
}

TEST(Text, MarkupIsEscaped) {
  EXPECT_EQ(escaped("<a href=\"x\">\u00fc & \x1b\n"), "&lt;a href=&quot;x&quot;&gt;\u00fc &amp; ?\n");
}

}  // namespace

}  // namespace hrt::study
