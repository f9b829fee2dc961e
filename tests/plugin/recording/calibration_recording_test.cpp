// Recordings with calibrations in them.
#include <algorithm>
#include <cmath>
#if !defined(__EMSCRIPTEN__)
#include <thread>
#endif

#include "core/paper_simulation/paper_slide.h"
#include "recording_fixture.h"

namespace hrt::test {
namespace {

class CalibrationRecordingTest : public RecordingTest {
 protected:
  hrt_calibration make() {
    hrt_calibration_config config = hrt_calibration_config_init();
    config.max_trials = 20;
    config.max_samples = 4000;
    config.enough_weight_width = 0.1;
    hrt_calibration calibration{};
    EXPECT_OK(hrt_calibration_create(session, &config, &calibration));
    return calibration;
  }

  /// A slide of a simulated person, at 30 Hz.
  static void slide(hrt_calibration calibration, double plate_deg) {
    static std::uint32_t trial = 0;
    CalibrationCondition condition;
    condition.tracker_rate_hz = 30.0;
    const CalibrationTrial made =
        simulate_calibration_trial(condition, plate_deg, {.seed = 1, .condition = 0, .trial = trial++});
    ASSERT_OK(hrt_calibration_begin_trial(calibration, plate_deg));
    for (const TimedPoint& at : made.samples) {
      const hrt_sample sample = position_sample(at.time_ns, at.position.right_m, at.position.away_m);
      ASSERT_OK(hrt_calibration_add_sample(calibration, &sample));
    }
  }

  /// Slides, the first ones guided, with a cancelled one, refusals, and a solution.
  static void calibrate(hrt_calibration calibration) {
    for (int i = 0; i < 12; ++i) {
      double plate_deg = i % 2 == 0 ? 60.0 - 5.0 * i : -60.0 + 5.0 * i;
      std::uint32_t enough = 0;
      if (i < 4) {  // each is a fit
        ASSERT_OK(hrt_calibration_next_angle(calibration, &plate_deg, &enough));
      }
      slide(calibration, plate_deg);
      EXPECT_EQ(hrt_calibration_begin_trial(calibration, 0.0), HRT_ERROR_WRONG_STATE);
      EXPECT_EQ(hrt_calibration_next_angle(calibration, &plate_deg, &enough), HRT_ERROR_WRONG_STATE);
      const hrt_sample late = position_sample(-1, 0.0, 0.0);
      EXPECT_EQ(hrt_calibration_add_sample(calibration, &late), HRT_ERROR_TIME_REVERSED);
      if (i == 4) {
        ASSERT_OK(hrt_calibration_end_trial(calibration, 0));
      } else {
        ASSERT_OK(hrt_calibration_end_trial(calibration, 1));
      }
      EXPECT_EQ(hrt_calibration_end_trial(calibration, 1), HRT_ERROR_WRONG_STATE);
      if (i > 0) continue;
      auto early = output<hrt_calibration_result>();
      EXPECT_EQ(hrt_calibration_solve(calibration, &early), HRT_ERROR_INSUFFICIENT_DATA);
    }
    auto result = output<hrt_calibration_result>();
    ASSERT_OK(hrt_calibration_solve(calibration, &result));
    EXPECT_EQ(result.tactile_weight.known, 1u);
  }

  /// A recording of a calibration, and of a reach of the person that it found.
  std::string recording_of_a_calibration() {
    EXPECT_OK(hrt_recording_start(session, path().c_str()));
    const hrt_calibration calibration = make();
    calibrate(calibration);
    auto result = output<hrt_calibration_result>();
    EXPECT_OK(hrt_calibration_solve(calibration, &result));
    EXPECT_OK(hrt_calibration_apply(session, &result));
    EXPECT_OK(hrt_calibration_destroy(calibration));
    reach_by_direction(add(HRT_TARGET_REAL, -5.0), add(HRT_TARGET_VIRTUAL, 5.0));
    EXPECT_EQ(stop().rows_lost, 0u);
    return read(path());
  }

  static std::string replaced(std::string text, const std::string& part, const std::string& by) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return at == std::string::npos ? text : text.replace(at, part.size(), by);
  }

  static void expect_refused(const std::string& text, const std::string& part) {
    auto report = output<hrt_replay_report>();
    report.rows = 77;
    expect_error(hrt_replay(nullptr, text.data(), text.size(), &report), HRT_ERROR_BAD_FORMAT, part);
    EXPECT_EQ(report.rows, 77u);
  }
};

TEST_F(CalibrationRecordingTest, ReplaysToTheSameBits) {
  const std::string text = recording_of_a_calibration();
  const hrt_replay_report report = replay(text);
  EXPECT_EQ(report.ending, HRT_ENDING_COMPLETE);
  EXPECT_EQ(report.first_different_line, 0u);
  for (const std::string call :
       {"begin_trial,0", "begin_trial,-5", "add_sample,0", "end_trial,0", "end_trial,-5", "cancel_trial,0",
        "next_angle,0", "next_angle,-5", "solve,0"}) {
    const std::string row = "\ncalibration_" + call + ",";
    const hrt_replay_report altered = replay(replaced(text, row, row.substr(0, row.find(',')) + ",-9,"));
    EXPECT_NE(altered.first_different_line, 0u) << call;
    EXPECT_EQ(altered.ending, HRT_ENDING_ALTERED) << call;
  }
}

// Its configuration and its solutions carry a rate and a delay of the steering.
TEST_F(CalibrationRecordingTest, TheSteeringOfVersion03IsIgnored) {
  std::string text = replaced(recording_of_a_calibration(), "# config {",
                              "# config {\"steering_rate_per_s\":0,\"steering_delay_s\":0.05,");
  text = replaced(text, " tactile_weight=", " steering_p=1 tactile_weight=");
  const std::size_t solved = text.find("calibration_solve,0");
  text.insert(text.find('\n', solved), " steering_rate_per_s=8:7:9.5:1 steering_delay_s=0.05:0:0.1:0");
  const hrt_replay_report report = replay(text);
  EXPECT_EQ(report.first_different_line, 0u);
  EXPECT_EQ(report.ending, HRT_ENDING_ALTERED);
}

// What went in and what came out, with another value in its place.
TEST_F(CalibrationRecordingTest, TamperedRowsAreFoundOrRefusedByName) {
  const std::string text = recording_of_a_calibration();
  for (const std::string value :
       {"tactile_weight=", "illusion=", "path_p=", "noise_correlation_s=", "enough="}) {
    const std::size_t at = text.find(value);
    ASSERT_NE(at, std::string::npos) << value;
    std::string other = text;
    other.insert(at + value.size(), "1");
    const hrt_replay_report report = replay(other);
    EXPECT_EQ(report.first_different_line,
              static_cast<uint64_t>(1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n')))
        << value;
    EXPECT_EQ(report.ending, HRT_ENDING_ALTERED);
  }
  // A slide less leads to another solution.
  const std::size_t first = text.find("\ncalibration_begin_trial,0");
  const std::size_t second = text.find("\ncalibration_begin_trial,0", first + 1);
  EXPECT_NE(replay(text.substr(0, first) + text.substr(second)).first_different_line, 0u);

  const std::string begins = "\ncalibration_begin_trial,0,,,,,,,-30,";
  expect_refused(replaced(text, begins, "\ncalibration_begin_trial,0,,,,,,,steep,"),
                 "measured_plate_deg is \"steep\"");
  expect_refused(replaced(text, "\ncalibration_end_trial,0", "\ncalibration_finish,0"),
                 "the row's call is \"calibration_finish\"; allowed: begin, update, retarget, cancel, end, "
                 "calibration_begin_trial");
  expect_refused(replaced(text, ",1,,\n", ",7,,\n"), "calibration 7 is not there");
  expect_refused(replaced(text, "# calibration added 1", "# calibration added 2"),
                 "calibration 1 is not there");
  expect_refused(replaced(text, "# calibration destroyed 1", "# calibration destroyed 2"),
                 "calibration 2 is not there");
  expect_refused(replaced(text, "# calibration added", "# calibration made"), "the calibration is \"made 1");
  expect_refused(replaced(text, "# calibration added 1", "# calibration added one"),
                 "the calibration's number is \"one\"");
  expect_refused(replaced(text, "\"max_trials\":20", "\"max_trials\":5"),
                 "max_trials is 5; allowed: 10 to 10000");
  expect_refused(replaced(text, "\"max_trials\":20", "\"trials_at_most\":20"),
                 "\"trials_at_most\" is not a field of a calibration");
  expect_refused(replaced(text, ",calibration,calibration_result", ",calibration"),
                 "the row has 72 columns; 71 are needed");
  const std::string added = "# calibration added 1";
  const std::string line =
      text.substr(text.find(added), text.find('\n', text.find(added)) + 1 - text.find(added));
  expect_refused(replaced(text, line, line + line), "calibration 1 is there already");
  std::string many;
  for (int i = 2; i < 19; ++i) many += replaced(line, added, "# calibration added " + std::to_string(i));
  expect_refused(replaced(text, line, line + many), "there are 16 calibrations already");
}

TEST_F(CalibrationRecordingTest, OnlyCalibrationsOfTheRecordingAreInIt) {
  const hrt_calibration before = make();
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  slide(before, 10.0);
  const hrt_calibration during = make(), other = make();
  slide(during, 20.0);
  slide(other, 30.0);
  stop();
  const std::string text = read(path());
  EXPECT_EQ(replay(text).first_different_line, 0u);
  EXPECT_EQ(text.find("calibration_begin_trial,0,,,,,,,10,"), std::string::npos);
  EXPECT_NE(text.find("calibration_begin_trial,0,,,,,,,20,"), std::string::npos);
  EXPECT_NE(text.find("calibration_begin_trial,0,,,,,,,30,"), std::string::npos);
  EXPECT_NE(text.find("# calibration added 2 "), std::string::npos);
  // Another recording has calibrations of its own, from 1; those of the first are not in it.
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  ASSERT_OK(hrt_calibration_end_trial(during, 1));
  const hrt_calibration again = make();
  slide(again, 40.0);
  for (const hrt_calibration made : {before, during, other, again}) EXPECT_OK(hrt_calibration_destroy(made));
  stop();
  const std::string second = read(path());
  EXPECT_EQ(replay(second).ending, HRT_ENDING_COMPLETE);
  EXPECT_EQ(replay(second).first_different_line, 0u);
  EXPECT_EQ(second.find("calibration_end_trial"), std::string::npos);
  EXPECT_NE(second.find("# calibration added 1 "), std::string::npos);
  EXPECT_EQ(second.find("# calibration added 2 "), std::string::npos);
  EXPECT_NE(second.find("# calibration destroyed 1\n"), std::string::npos);
}

// A calibration outlives its session; then it is recorded no more.
TEST_F(CalibrationRecordingTest, TheSessionMayEndFirst) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  const hrt_calibration calibration = make();
  slide(calibration, 20.0);
  ASSERT_OK(hrt_session_destroy(session));
  session.value = 0;
  EXPECT_OK(hrt_calibration_end_trial(calibration, 1));
  EXPECT_OK(hrt_calibration_destroy(calibration));
  EXPECT_EQ(replay(read(path())).ending, HRT_ENDING_COMPLETE);
}

#if !defined(__EMSCRIPTEN__)
// Session and calibrations are called by threads of their own, and the recording stops in between.
TEST_F(CalibrationRecordingTest, ThreadsShareARecording) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  const hrt_calibration first = make(), second = make();
  const auto slides = [](hrt_calibration calibration) {
    for (int i = 0; i < 20; ++i) {
      if (hrt_calibration_begin_trial(calibration, i) != HRT_OK) return;
      for (int k = 0; k < 100; ++k) {
        const hrt_sample sample = position_sample(k * 10 * ms, 0.0, 0.001 * k);
        if (hrt_calibration_add_sample(calibration, &sample) != HRT_OK) return;
      }
      if (hrt_calibration_end_trial(calibration, 1) != HRT_OK) return;
    }
  };
  std::thread a(slides, first), b(slides, second);
  reach_by_direction(add(HRT_TARGET_REAL, -5.0), add(HRT_TARGET_VIRTUAL, 5.0));
  a.join();
  const hrt_recording_status status = stop();
  b.join();
  EXPECT_EQ(status.rows_lost, 0u);
  const std::string text = read(path());
  const hrt_replay_report report = replay(text);
  EXPECT_EQ(report.ending, HRT_ENDING_COMPLETE);
  EXPECT_EQ(report.first_different_line, 0u);
  EXPECT_GE(report.rows, 20u * 102u + 60u);
  EXPECT_OK(hrt_calibration_destroy(first));
  EXPECT_OK(hrt_calibration_destroy(second));
}
#endif

}  // namespace
}  // namespace hrt::test
