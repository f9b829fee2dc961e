// Reaches of a person: how they end, messages about those that do not end, keys and speech. The hand is scripted.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "samples/app/emulator/pty_device.h"
#include "tests/plugin/plate/eventually.h"
#include "tests/samples/reach/hand_path.h"
#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

using namespace std::chrono_literals;
using plate::eventually;

const Place start_of_desk{0.0, 0.05};

Outcome reach_along(const Path& path) { return run_scripted(path.script(), person_and({"--time-limit", "12"})); }

TEST(ReachPerson, EndsAtTheTargetHoweverSlowlyAndWithPauses) {
  const Outcome outcome = expect_exit(0, reach_along(Path(plate_of_desk)
                                                         .hold(start_of_desk, 2000)
                                                         .slide({0.0, 0.02}, 400)
                                                         .rest(700)
                                                         .slide({0.0, -0.02}, 3000)
                                                         .rest(700)
                                                         .slide({0.0, -0.05}, 1500)));
  expect_said(outcome, "Put your index finger on the start. Then slide it to \"bottle\", ");
  expect_said(outcome, "6 degrees to the left of straight ahead");
  EXPECT_FALSE(has(outcome.out, "SIMULATION"));
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_NEAR(rows_of(outcome)[0].final_direction_deg, 0.0, 1.0);
  EXPECT_LE(rows_of(outcome)[0].miss_mm, 5.1);  // ended when it touched the cylinder, whose radius is 5 mm
}

TEST(ReachPerson, EndsAtRestBesideTheTarget) {
  const std::string beside = Path(plate_of_desk).hold(start_of_desk).slide({0.02, -0.05}, 3000).rest(2000).script();
  for (const std::string controller : {"people", "paper"}) {
    const Outcome outcome = run_scripted(beside, person_and({"--controller", controller}));
    ASSERT_EQ(rows_of(outcome).size(), 1U);
    EXPECT_NEAR(rows_of(outcome)[0].miss_mm, 20.0, 0.2);
    EXPECT_TRUE(has(outcome.out, "missed"));
    // The controller for people may report the gap as infeasible, since this finger does not respond to the plate.
    EXPECT_EQ(outcome.exit_code, has(outcome.out, "(flag: gap infeasible)") ? 0 : 1) << outcome.out << outcome.err;
  }
}

TEST(ReachPerson, TakesTheFirstHandAtTheStart) {
  expect_exit(0, run_scripted(Path(plate_of_desk).reach().script("", "left"), person_and({"--hand", "either"})));
}

// The joint of a thick finger is 18 mm above the plate during a touch; this must count as a slide.
TEST(ReachPerson, TakesAThickFinger) {
  const auto rows = [](double skin_m) {
    return rows_of(run_scripted(Path(plate_of_desk).hold_hand({}, skin_m).reach().script(), person_and()));
  };
  EXPECT_EQ(rows(0.018)[0].peak_felt_deg, rows(0.008)[0].peak_felt_deg);
}

// Returns a script in which tracking of the right finger is lost half way. The left finger, `left_height_m` above the
// plate, continues from there to the cylinder.
std::string relay(double left_height_m) {
  PlatePose left_plate = plate_of_desk;
  left_plate.y_m += left_height_m;
  const Path left = Path(left_plate).wait_until(2600).hold({0.0, 0.0}, 400).slide({0.0, -0.06}, 2100);
  const Path right = Path(plate_of_desk).wait_until(200).hold(start_of_desk, 900).slide({0.0, -0.05}, 3000);
  return R"({"hands": {"left": )" + left.tracked() + R"(, "right": )" + right.tracked() + R"(}, "events": [
      {"time_ms": 0, "do": "lose_tracking", "hand": "left"},
      {"time_ms": 3000, "do": "lose_tracking", "hand": "right"},
      {"time_ms": 3200, "do": "regain_tracking", "hand": "left"}]})";
}

TEST(ReachPerson, ChangesHandsOnTheWay) {
  const Outcome outcome = expect_exit(0, run_scripted(relay(0.0), person_and({"--hand", "either"})));
  EXPECT_TRUE(has(outcome.out, "reached (hands changed)"));
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_NEAR(rows_of(outcome)[0].lost, 27, 2);  // frames in 0.3 s
}

// A hand above the plate does not take over, and a hand that is not selected does not either.
TEST(ReachPerson, DoesNotContinueWithAHandThatDoesNotTouch) {
  EXPECT_EQ(run_scripted(relay(0.0), person_and({"--time-limit", "8"})).exit_code, 8);
  expect_said(expect_exit(8, run_scripted(relay(0.093), person_and({"--time-limit", "8", "--hand", "either"}))),
              "did not end within 8 s");
}

TEST(ReachPerson, NeedsAPlate) {
  expect_said(expect_exit(9, run_scripted(R"({"withhold_extensions": ["XR_HRTX_ridged_plate"]})", {desk, "--person"})),
              "--plate");
}

TEST(ReachPerson, TurnsThePlateOfTheRuntime) {
  auto environment = scripted_environment(Path(plate_of_desk).reach().rest(2000).script());
  const std::string log = scratch_folder() + "/calls.txt";
  environment["HRT_MOCK_CALL_LOG"] = log;
  expect_exit(0, run_program({desk, "--person", "--target", "bottle"}, environment));
  const std::string calls = read_file(log);
  EXPECT_TRUE(has(calls, {"xrPlacePlateHRTX ", "xrSetPlateOrientationHRTX "}));
  EXPECT_FALSE(has(calls, "xrInstructReachHRTX "));
}

// The reach ends where the finger is lifted, 20 mm before the target.
TEST(ReachPerson, EndsWithALift) {
  const Outcome outcome =
      expect_exit(1, reach_along(Path(plate_of_desk).hold(start_of_desk, 2000).slide({0.0, -0.03}, 800).lift()));
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_NEAR(rows_of(outcome)[0].miss_mm, 20.0, 2.0);
}

struct Unfinished {
  Path path;
  std::vector<std::string> arguments;
  std::vector<std::string> said;
};

TEST(ReachPerson, UnfinishedReachesAreExplained) {
  PlatePose elsewhere = plate_of_desk;
  elsewhere.x_m += 2.0;
  PlatePose higher = plate_of_desk;
  higher.y_m += 0.1;
  const Unfinished all[] = {
      {Path(plate_of_desk).reach(),
       {"--hand", "left"},
       {"No index finger came to the start within 3 s", "The left hand was not tracked, but the right one was",
        "--hand right"}},
      {Path(elsewhere).reach(),
       {},
       {"tracked for 100 % of the time", "the assumed position of the plate is wrong", "--register"}},
      {Path(higher).hold(start_of_desk, 9000), {}, {"100 mm above the plate"}},
      {Path(plate_of_desk).hold({0.06, 0.05}, 9000), {}, {"60 mm right of the start", "within 15 mm"}},
      {Path(plate_of_desk).hold(start_of_desk, 9000),
       {},
       {"did not end within 3 s", "The finger stayed at the start: slide it", "100 mm from the target"}}};
  for (const Unfinished& unfinished : all) {
    std::vector<std::string> arguments = person_and({"--time-limit", "3"});
    arguments.insert(arguments.end(), unfinished.arguments.begin(), unfinished.arguments.end());
    const Outcome outcome = run_scripted(unfinished.path.script(), arguments);
    EXPECT_EQ(outcome.exit_code, 8) << unfinished.said[0] << outcome.err;
    for (const std::string& said : unfinished.said) expect_said(outcome, said);
    EXPECT_TRUE(has(outcome.out, "1 more did not begin or end in time"));
  }
  const Outcome untracked =
      expect_exit(8, run_scripted(R"({"hands": {"right": {"tracked": false}}})", person_and({"--time-limit", "3"})));
  expect_said(untracked, "The right hand was not tracked. Hold it where the headset's cameras see it.");
}

TEST(ReachPerson, AnUnfinishedReachDoesNotStopTheRun) {
  const Outcome outcome =
      expect_exit(8, run_scripted(Path(plate_of_desk).hold(start_of_desk, 4500).slide({0.0, -0.05}, 800).script(),
                                  person_and({"--target", "bottle", "--time-limit", "3.5"})));
  EXPECT_EQ(rows_of(outcome).size(), 1U) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.out, "not made"));
  const Outcome untracked = expect_exit(8, run_scripted(R"({"hands": {"right": {"tracked": false}}})",
                                                        person_and({"--repeat", "1000", "--time-limit", "1"})));
  expect_said(untracked, "3 reaches in a row did not begin or end in time");
}

TEST(ReachPerson, AnUnfinishedSimulatedReachDoesNotStopTheRun) {
  expect_said(expect_exit(8, run_program({desk, "--time-limit", "1"})), "The reach to \"pawn\" did not end within 1 s");
}

// A speech program that writes the texts into a file.
struct Voice {
  explicit Voice(const std::string& then = "") {
    std::ofstream(program) << "#!/bin/sh\ncat >> " << heard_file << "\n" << then << "\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }
  std::string heard() const { return read_file(heard_file); }

  std::string folder = scratch_folder();
  std::string program = folder + "/voice", heard_file = folder + "/heard";
};

TEST(ReachSpeech, SpeaksWhatAPersonIsAsked) {
  const Voice voice;
  expect_exit(
      0, run_scripted(R"({"clock": "real-time", )" +
                          Path(plate_of_desk).hold(start_of_desk, 1500).slide({0.0, -0.05}, 800).script().substr(1),
                      person_and({"--speak-with", voice.program})));
  const std::string heard = voice.heard();
  EXPECT_TRUE(has(heard, {"Put your index finger on the start. Then slide it to bottle, 100 millimetres away,", "Done.",
                          "1 of 1 reaches with a feasible gap ended at the target"}));
}

TEST(ReachSpeech, AVoiceThatHangsDelaysNothingAndEndsWithTheProgram) {
  const std::string file = scratch_folder() + "/pid";
  const Voice voice("echo $$ > " + file + "; exec sleep 60");
  const Program program(person_and({"--speak-with", voice.program, "--verbose"}),
                        scripted_environment(Path(plate_of_desk).script(R"("clock": "real-time", )")));
  ASSERT_TRUE(eventually([&] { return !read_file(file).empty(); }));
  program.send_signal(SIGTERM);
  const auto stopped = std::chrono::steady_clock::now();
  EXPECT_EQ(program.wait().exit_code, 130);
  EXPECT_LT(std::chrono::steady_clock::now() - stopped, 2s);
  EXPECT_NE(kill(std::stoi(read_file(file)), 0), 0);
}

TEST(ReachSpeech, AFailingVoiceIsNamed) {
  const Voice voice("exit 3");
  expect_said(expect_exit(8, run_scripted(R"({"clock": "real-time", )" + Path(plate_of_desk).script().substr(1),
                                          person_and({"--time-limit", "0.5", "--speak-with", voice.program}))),
              "the speech program failed (exit code 3)");
}

Outcome run_with_keys(const Path& path, const std::string& more_script, const std::string& keys,
                      const std::vector<std::string>& arguments) {
  const plate::Pty terminal(80);
  terminal.type(keys);
  const Program program(arguments, scripted_environment(path.script(more_script)), -1, terminal.descriptor());
  return program.wait();
}

TEST(ReachKeys, ListRepeatAndSayWhere) {
  const Outcome outcome = expect_exit(0, run_with_keys(Path(plate_of_desk).reach(), "", "hrw", person_and()));
  EXPECT_EQ(occurrences(outcome.err, "Put your index finger"), 2U) << outcome.err;
  expect_said(outcome, {"Keys: R repeats", "The right index finger is "});
}

TEST(ReachKeys, NextLeavesATargetOutAndStopEndsTheRun) {
  const Outcome next =
      expect_exit(0, run_with_keys(Path(plate_of_desk).reach(), "", "n", person_and({"--target", "goblet"})));
  ASSERT_EQ(rows_of(next).size(), 1U);
  EXPECT_EQ(rows_of(next)[0].virtual_name, "goblet");
  EXPECT_TRUE(has(next.out, "; 1 skipped."));
  expect_said(expect_exit(130, run_with_keys(Path(plate_of_desk).reach(), "", "q", person_and())), "interrupted");
}

TEST(ReachKeys, BackRepeatsTheLastTarget) {
  const plate::Pty terminal(80);
  const Program program(person_and({"--target", "goblet"}),
                        scripted_environment(Path(plate_of_desk)
                                                 .hold(start_of_desk, 1200)
                                                 .slide({0.0, -0.05}, 500)
                                                 .hold(start_of_desk, 30000)
                                                 .script(R"("clock": "real-time", )")),
                        -1, terminal.descriptor());
  EXPECT_TRUE(eventually([&] { return program.out().find("reached") != std::string::npos; }));
  terminal.type("b");
  EXPECT_TRUE(eventually([&] {
    const std::string said = program.err();
    const std::size_t goblet = said.find("\"goblet\"");
    return goblet != std::string::npos && said.find("\"bottle\"", goblet) != std::string::npos;
  })) << program.err();
  terminal.type("q");
  EXPECT_EQ(program.wait().exit_code, 130);
}

TEST(ReachKeys, AnswerTheHeightOfTheEyes) {
  expect_said(expect_exit(0, run_with_keys(Path(plate_of_desk).reach(),
                                           R"("stage": false, "withhold_extensions": ["XR_EXT_local_floor"], )",
                                           "tall\n1.3\x7f"
                                           "2\n",
                                           person_and())),
              {"How high are your eyes above the floor", "Please type a number from 0.3 to 2.5."});
}

TEST(ReachKeys, AWholeSessionWithoutSight) {
  const Voice voice;
  const std::string marks = voice.folder + "/marks.csv";
  std::ofstream(marks) << "\xEF\xBB\xBFname,x_m,y_m,z_m\r\n\"start\",0,-0.001,0.05\r\nright,\"0.07\",-0.001,0\r\n"
                          "far,0,-0.001,-0.07\r\n";
  Path path;
  for (const Place& mark : {start_of_desk, Place{0.07, 0.0}, Place{0.0, -0.07}}) path.hold(mark, 850).lift();
  path.hold(start_of_desk, 1000).slide({0.0, -0.05}, 800);
  const plate::Pty terminal(80);
  const Program program(
      person_and({"--register", voice.folder + "/plate.txt", "--marks", marks, "--speak-with", voice.program}),
      scripted_environment(path.script(R"("clock": "real-time", )")), -1, terminal.descriptor());
  EXPECT_TRUE(eventually([&] { return voice.heard().find("(1 of 3)") != std::string::npos; }));
  terminal.type("rwn");
  expect_exit(0, program.wait());
  const std::string heard = voice.heard();
  EXPECT_TRUE(has(heard, {"Keys: R repeats", "Mark 1 is start ", "This key has an effect during reaches only.",
                          "(3 of 3)", "The plate is registered", "Put your index finger on the start", "Done.",
                          "1 of 1 reaches with a feasible gap ended at the target"}));
}

// Runs a calibration to its end in a runtime without a floor space: all instructions are spoken, and keys are the
// answers. The simulated user feels the plate. A frame takes 2 ms, so that the voice keeps up with the manual clock.
TEST(ReachKeys, AWholeCalibrationWithoutSight) {
  const Voice voice;
  const std::string profile = voice.folder + "/profile.json";
  const plate::Pty terminal(80);
  const Program program(
      {desk, "--person", "--plate", "servo", "--calibrate", profile, "--speak-with", voice.program},
      scripted_environment(R"({"calls": [{"function": "xrWaitFrame", "count": 1000000, "delay_ms": 2}],
          "stage": false, "withhold_extensions": ["XR_EXT_local_floor"],
          "participants": [{"illusion": "linear", "tactile_weight": 0.2, "steering": "continuous", "gain_per_s": 9,
            "delay_ms": 50, "noise_deg2_per_s": 2, "start_direction_deg": 0, "habit_deg": 0, "pace": "minimum_jerk",
            "reaction_ms": 700, "duration_ms": 1200}],
          "hands": {"right": {"slides": {"start_m": [0, 0.008, 0.05], "rest_ms": 600}}}})"),
      -1, terminal.descriptor());
  const auto after = [&](const std::string& part, const std::string& keys) {
    EXPECT_TRUE(eventually([&] { return voice.heard().find(part) != std::string::npos; })) << part;
    terminal.type(keys);
  };
  after("How high are your eyes above the floor", "1.2\n");
  after("let it rest. (1 of 16)", "h");
  after("Keys: R repeats", "n");
  after("(3 of 16)", "w");
  after("The right index finger is ", "r");
  const Outcome outcome = expect_exit(0, program.wait());
  const std::string heard = voice.heard();
  EXPECT_TRUE(has(
      heard, {"Please slide one fingertip straight ahead many times.", "This key has an effect during reaches only.",
              "Slide evenly towards what feels straight ahead", "tactile weight"}));
  EXPECT_NEAR(value_of(outcome.out, "tactile weight, 60 deg off normal"), 0.2, 0.02) << outcome.out;
  EXPECT_TRUE(has(read_file(profile), "\"tactile_weight\":"));
}

TEST(ReachKeys, AStoppedCalibrationWritesNothing) {
  const Voice voice;
  const plate::Pty terminal(80);
  terminal.type("q");
  const Program program({desk, "--person", "--plate", "servo", "--calibrate", voice.folder + "/profile.json",
                         "--speak-with", voice.program},
                        scripted_environment("{}"), -1, terminal.descriptor());
  expect_exit(130, program.wait());
  EXPECT_TRUE(has(voice.heard(), "The calibration was interrupted; no profile was written."));
  EXPECT_FALSE(std::filesystem::exists(voice.folder + "/profile.json"));
}

}  // namespace
}  // namespace hrt::reach
