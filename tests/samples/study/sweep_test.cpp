#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "core/paper/authority.h"
#include "core/paper_simulation/batch.h"
#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

using Arguments = std::vector<std::string>;

Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Arguments small_grid{"sweep", "--gap",    "4,10", "--tactile-weight", "0.1:0.2:3", "--horizon",
                           "2,3",   "--trials", "50",   "--motor-variance", "0.5"};

void write_file(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string column(const std::string& csv, std::size_t row, const std::string& name) {
  const auto rows = lines(csv);
  const auto names = fields(rows.at(0));
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return fields(rows.at(row + 1)).at(i);
  ADD_FAILURE() << name;
  return {};
}

// The last list varies fastest: gap, tactile weight, horizon.
TEST(StudySweep, RowsAreEveryCombinationInOrder) {
  const StudyRun run = run_study(small_grid);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  ASSERT_EQ(lines(run.out).size(), 13U);
  std::size_t row = 0;
  for (const char* real : {"1", "-5"})
    for (const double tactile_weight : {0.1, 0.15, 0.2})
      for (const char* horizon : {"2", "3"}) {
        EXPECT_EQ(column(run.out, row, "index"), std::to_string(row));
        EXPECT_EQ(column(run.out, row, "real_direction_deg"), real);
        EXPECT_EQ(column(run.out, row, "virtual_direction_deg"), "5");
        EXPECT_NEAR(std::stod(column(run.out, row, "tactile_weight")), tactile_weight, 1e-15);
        EXPECT_EQ(column(run.out, row, "assumed_tactile_weight"), column(run.out, row, "tactile_weight"));
        EXPECT_EQ(column(run.out, row, "horizon"), horizon);
        EXPECT_EQ(column(run.out, row, "plate_rate_bound_deg"), "inf");
        ++row;
      }
}

TEST(StudySweep, ResultsAreTheLibrarysToTheBit) {
  const StudyRun run = run_study({"sweep", "--gap", "10", "--virtual", "0,10", "--assumed-tactile-weight",
                                  "0.12", "--plate-rate-bound", "40", "--trials", "70", "--seed", "5"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  Condition condition{.real_direction_deg = 0.0, .virtual_direction_deg = 10.0};
  condition.controller.participant.tactile_weight = 0.12;
  condition.controller.mpc.plate_rate_bound_deg = 40.0;
  const BatchJob job{.condition = condition, .condition_id = 1, .first_trial = 0, .last_trial = 70};
  const BatchResult result = run_batch({&job, 1}, 5)[0];
  const auto value = [&](const std::string& name) {
    return std::strtod(column(run.out, 1, name).c_str(), nullptr);
  };
  EXPECT_EQ(value("hits"), static_cast<double>(result.hits));
  EXPECT_EQ(value("hit_percent"), result.hit_percent());
  EXPECT_EQ(value("mean_miss_deg"), result.mean_miss_deg());
  EXPECT_EQ(value("rms_miss_deg"), result.rms_miss_deg());
  EXPECT_EQ(value("rms_perceived_error_deg"), result.rms_felt_error_deg());
  EXPECT_EQ(value("saturated_share"), result.saturated_share());
  EXPECT_EQ(value("max_gap_deg"), max_gap_deg(0.15, 84.5));
  EXPECT_EQ(value("reachable"), 1.0);
}

TEST(StudySweep, PartsConcatenateToTheWhole) {
  const TemporaryFolder folder;
  const std::string whole = run_study(small_grid).out;
  for (const int parts : {1, 2, 5, 12, 30}) {
    std::string joined;
    for (int part = 1; part <= parts; ++part) {
      const std::string name = "part" + std::to_string(part) + "of" + std::to_string(parts);
      const StudyRun run =
          run_study(small_grid + Arguments{"--part", std::to_string(part) + "/" + std::to_string(parts),
                                           "--out", folder / name});
      ASSERT_EQ(run.exit_code, 0) << run.err;
      joined += read_file(folder / name);
    }
    EXPECT_EQ(joined, whole) << parts << " parts";
  }
}

TEST(StudySweep, GoesOnAfterTheWholeRowsOfAStoppedRun) {
  const TemporaryFolder folder;
  const std::string out = folder / "sweep.csv";
  const auto rows = lines(run_study(small_grid).out);
  // A result that no simulation gives shows that the row was kept; the row after it was cut short.
  std::string marked = rows[1];
  marked.replace(marked.find(",50,") + 4, 2, "99");
  write_file(out + ".partial", rows[0] + '\n' + marked + '\n' + rows[2].substr(0, rows[2].size() / 2));
  const StudyRun run = run_study(small_grid + Arguments{"--out", out});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto written = lines(read_file(out));
  ASSERT_EQ(written.size(), rows.size());
  EXPECT_EQ(written[1], marked);
  for (std::size_t i = 2; i < rows.size(); ++i) EXPECT_EQ(written[i], rows[i]);
  EXPECT_EQ(entries(folder.path), Arguments{"sweep.csv"});
}

TEST(StudySweep, AStoppedRunResumesToTheSameBytes) {
  const TemporaryFolder folder;
  const Arguments grid{"sweep", "--gap", "-20:20:200", "--trials", "2000", "--threads", "1"};
  const std::string whole = run_study(grid).out;
  const std::string out = folder / "sweep.csv";
  const Process program = start_study(grid + Arguments{"--out", out});
  for (int i = 0; i < 5000 && lines(read_file(out + ".partial")).size() < 14; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  program.send_signal(SIGKILL);
  ASSERT_EQ(program.wait().exit_code, -SIGKILL) << "it was done before it could be stopped";
  EXPECT_EQ(entries(folder.path), Arguments{"sweep.csv.partial"});

  ASSERT_EQ(run_study(grid + Arguments{"--out", out}).exit_code, 0);
  EXPECT_EQ(read_file(out), whole);
  EXPECT_EQ(entries(folder.path), Arguments{"sweep.csv"});
}

TEST(StudySweep, ACompleteFileIsLeftAlone) {
  const TemporaryFolder folder;
  const std::string out = folder / "sweep.csv";
  ASSERT_EQ(run_study(small_grid + Arguments{"--out", out}).exit_code, 0);
  const auto written = std::filesystem::last_write_time(out);
  ASSERT_EQ(run_study(small_grid + Arguments{"--out", out}).exit_code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(out), written);
}

TEST(StudySweep, AFileOfAnotherSweepIsRefusedAndKept) {
  const TemporaryFolder folder;
  const std::string out = folder / "sweep.csv";
  const std::string whole = run_study(small_grid).out;
  for (const std::string& name : {out, out + ".partial"}) {
    for (const std::string& text : {whole, std::string("my thesis\n"), whole + "12,\n"}) {
      write_file(name, text);
      const StudyRun run = run_study(small_grid + Arguments{"--seed", "2", "--out", out});
      EXPECT_EQ(run.exit_code, 2);
      EXPECT_EQ(lines(run.err).size(), 1U);
      EXPECT_TRUE(run.err.starts_with("hrt-study: --out: ")) << run.err;
      EXPECT_EQ(read_file(name), text);
      EXPECT_EQ(entries(folder.path).size(), 1U);
    }
    std::filesystem::remove(name);
  }
}

TEST(StudySweep, TwoProcessesDoNotShareAFile) {
  const TemporaryFolder folder;
  const std::string out = folder / "sweep.csv";
  const Arguments grid{"sweep", "--gap", "-20:20:2000", "--trials", "20000", "--out", out};
  const Process first = start_study(grid);
  for (int i = 0; i < 5000 && read_file(out + ".partial").empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const StudyRun second = run_study(grid);
  first.send_signal(SIGKILL);
  first.wait();
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_TRUE(has(second.err, "being written by another hrt-study"));
}

}  // namespace
}  // namespace hrt::study
