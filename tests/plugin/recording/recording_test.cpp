// Recordings, and replaying them.
#include "recording_fixture.h"

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "generated/fields.h"

namespace hrt::test {
namespace {

// Rows whose result is changed do not replay.
void expect_compared(const std::string& text, const std::vector<std::string>& calls) {
  for (const std::string& call : calls) {
    std::string other = text;
    const std::size_t at = other.find(call);
    ASSERT_NE(at, std::string::npos) << call;
    other.replace(at, call.size(), call.substr(0, call.find(',')) + ",-9,");
    EXPECT_NE(replay(other).first_different_line, 0u) << call;
  }
}

/// The cells of a row.
std::vector<std::string> split(const std::string& row) {
  std::istringstream line(row);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(line, cell, ',');) cells.push_back(cell);
  if (row.ends_with(",")) cells.emplace_back();
  return cells;
}

std::string join(const std::vector<std::string>& cells) {
  std::string row;
  for (const std::string& cell : cells) row += (&cell == cells.data() ? "" : ",") + cell;
  return row;
}

// Both controllers, with every kind of sample and errors among them, give the same bits in every build on
// every host.
TEST_F(RecordingTest, ReplaysToTheSameBits) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  play();
  const hrt_recording_status status = stop();
  EXPECT_EQ(status.rows_lost, 0u);
  EXPECT_EQ(status.system_error, 0);
  auto report = output<hrt_replay_report>();
  ASSERT_OK(hrt_recording_replay(path().c_str(), nullptr, 0, &report));
  expect_same(report);
  EXPECT_EQ(report.rows, 3u * 2u + 64u + 2u * 270u);
  EXPECT_EQ(report.hash, 0x8da5a09158320d23u) << "which is 0x" << std::hex << report.hash;
}

// Targets that move, reaches that are abandoned or start where the finger is, and refusals of both.
TEST_F(RecordingTest, RetargetsAndCancelledReachesReplayToTheSameBits) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  std::size_t rows = 0;
  for (const std::uint32_t guidance : {HRT_GUIDANCE_FIXED_DIRECTION, HRT_GUIDANCE_ARRIVAL}) {
    hrt_session_config config = session_config();
    config.guidance = guidance;
    ASSERT_OK(hrt_session_set(session, &config));
    const hrt_target real = add(HRT_TARGET_REAL, -5.0), cup = add(HRT_TARGET_VIRTUAL, 5.0);
    for (const bool cancels : {true, false}) {
      EXPECT_EQ(hrt_reach_retarget(session, real, cup), HRT_ERROR_WRONG_STATE);
      EXPECT_EQ(hrt_reach_cancel(session), HRT_ERROR_WRONG_STATE);
      ASSERT_OK(begin(real, cup, HRT_REACH_START_AT_FINGER));
      rows += 3;
      for (int i = 0; i < 200; ++i, ++rows) {
        update(position_sample(i * 10 * ms, 0.001 * noise(), -0.04 + 0.0006 * std::max(0, i - 40)));
        if (i % 7 != 0) continue;
        change(cup, target_config(HRT_TARGET_VIRTUAL, 5.0 + 0.1 * i));
        EXPECT_OK(hrt_reach_retarget(session, real, cup));
        EXPECT_EQ(hrt_reach_retarget(session, cup, cup), HRT_ERROR_OUT_OF_RANGE);
        EXPECT_EQ(hrt_reach_retarget(session, {0}, cup), HRT_ERROR_INVALID_HANDLE);
        rows += 3;
      }
      if (cancels) {
        ASSERT_OK(hrt_reach_cancel(session));
      } else {
        end();
      }
      ++rows;
    }
  }
  stop();
  const std::string text = read(path());
  // The first update of each reach says where it starts: at the finger, 4 cm towards the user.
  std::size_t starts = 0;
  for (std::size_t at = text.find("\nupdate,0,"); at != std::string::npos; at = text.find("\nupdate,0,", at + 1)) {
    const std::vector<std::string> cells = split(text.substr(at + 1, text.find('\n', at + 1) - at - 1));
    constexpr std::size_t real_distance_column = 28, start_away_column = 30;
    EXPECT_EQ(cells[real_distance_column].empty(), cells[2] != "0") << cells[2];
    if (cells[2] != "0") continue;
    ++starts;
    EXPECT_NEAR(std::stod(cells[start_away_column]), -0.04, 1e-12);
  }
  EXPECT_EQ(starts, 4u);
  const hrt_replay_report report = replay(text);
  expect_same(report);
  EXPECT_EQ(report.rows, rows);
  expect_compared(text, {"\nretarget,0,", "\nretarget,-4,", "\nretarget,-5,", "\ncancel,0,", "\ncancel,-5,"});
}

// In a reach and after it, refused ones and those that cannot be read too.
TEST_F(RecordingTest, ContactsReplayToTheSameBits) {
  hrt_session_config config = session_config();
  config.flags = HRT_SESSION_REGISTERED;
  create(config);
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), cup = add(HRT_TARGET_VIRTUAL, 5.0);
  auto contact = output<hrt_contact>();
  contact.flags = HRT_CONTACT_PLATE_POSITION;
  contact.position_m[0] = 0.012;
  contact.position_m[2] = -0.04;
  contact.sd_m = 0.001;
  hrt_contact bad = contact, small = contact;
  bad.position_m[1] = std::nan("");
  small.struct_size = 1;
  for (const bool within : {true, false}) {
    ASSERT_OK(begin(real, cup));
    for (int i = 0; i < 260; ++i)
      update(position_sample(i * 11 * ms, 0.001 * noise(), -0.05 + 0.0006 * std::clamp(i - 40, 0, 160)));
    if (!within) end();
    EXPECT_EQ(hrt_reach_touched(session, &bad), HRT_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(hrt_reach_touched(session, &small), HRT_ERROR_STRUCT_SIZE);
    ASSERT_OK(hrt_reach_touched(session, within ? &contact : nullptr));
    if (within) end();
  }
  ASSERT_OK(begin(real, cup));
  update(position_sample(0, 0.01, 0.02));
  end();
  stop();
  const std::string text = read(path());
  const hrt_replay_report report = replay(text);
  expect_same(report);
  std::string elsewhere = text;
  const std::size_t at = elsewhere.find(",0.012,", elsewhere.find("\ntouched,0,"));
  ASSERT_NE(at, std::string::npos);
  elsewhere.replace(at, 7, ",0.013,");
  EXPECT_GT(replay(elsewhere).first_different_line, 270u) << "what follows depends on it";
}

TEST_F(RecordingTest, RecordingOfAllHostsGivesItsHash) { expect_golden_bits(); }

// Releases differ in how they spell a number, not in its bits.
TEST_F(RecordingTest, OtherSpellingsOfANumberAreNoDifference) {
  std::string text = recording();
  const std::size_t update = text.find("\nupdate,0,");
  const std::size_t weight = text.find(",0.15,", update);
  ASSERT_NE(weight, std::string::npos);
  text.replace(weight, 6, ",1.50e-01,");
  EXPECT_EQ(replay(text).first_different_line, 0u);
}

// They are not read, so they may hold anything; -0 is not 0 in a row.
TEST_F(RecordingTest, UnreadFieldsAndNegativeZeroReplay) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  hrt_target_config config = target_config(HRT_TARGET_REAL, -5.0);
  for (double& coordinate_m : config.position_m) coordinate_m = std::nan("");
  const hrt_target real = add(config);
  config = target_config(HRT_TARGET_VIRTUAL, std::nan(""));
  config.place = HRT_PLACE_PLATE_POSITION;
  config.distance_m = std::numeric_limits<double>::infinity();
  config.position_m[2] = -0.1;
  const hrt_target virtual_target = add(config);
  ASSERT_OK(begin(real, virtual_target));
  ASSERT_OK(hrt_reach_cancel(session));
  change(virtual_target, target_config(HRT_TARGET_VIRTUAL, -0.0));
  ASSERT_OK(begin(real, virtual_target));
  ASSERT_OK(hrt_reach_cancel(session));
  stop();
  const hrt_replay_report report = replay(read(path()));
  expect_same(report);
  EXPECT_EQ(report.rows, 4u);
}

TEST_F(RecordingTest, TheServingTargetIsRecordedByItsNumber) {
  const hrt_target real = add(HRT_TARGET_REAL, -5.0);
  hrt_target_config config = target_config(HRT_TARGET_VIRTUAL, 5.0);
  config.served_by = real;
  const hrt_target cup = add(config);
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  change(cup, config);
  ASSERT_OK(begin(real, cup));
  ASSERT_OK(hrt_reach_cancel(session));
  stop();
  const std::string text = read(path());
  const std::size_t added = text.find(R"("served_by":1)");
  ASSERT_NE(added, std::string::npos) << text;
  EXPECT_NE(text.find(R"("served_by":1)", added + 1), std::string::npos) << text;
  expect_same(replay(text));
}

TEST_F(RecordingTest, LinesMayEndInCrLf) {
  std::string text;
  for (const char c : recording()) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_same(replay(text));
}

// The end line has a checksum of all before it, whatever the changed text is good for.
TEST_F(RecordingTest, AlteredOrCutIsNotComplete) {
  const std::string text = recording();
  EXPECT_EQ(ending(text), HRT_ENDING_COMPLETE);
  const auto changed = [&](const std::string& part, const std::string& by) {
    std::string other = text;
    const std::size_t at = other.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return other.replace(at, part.size(), by);
  };
  const std::size_t row = text.find("\nupdate,0,40000000,"), row_end = text.find('\n', row + 1);
  std::string other = text;
  EXPECT_EQ(ending(other.erase(row, row_end - row)), HRT_ENDING_ALTERED) << "a row less";
  other = text;
  EXPECT_EQ(ending(other.insert(row, text, row, row_end - row)), HRT_ENDING_ALTERED) << "a row twice";
  EXPECT_EQ(ending(changed("a \\\"cup\\\"", "a mug")), HRT_ENDING_ALTERED) << "a name";
  EXPECT_EQ(ending(changed("\n# target", "\n# a comment\n# target")), HRT_ENDING_ALTERED);
  const std::size_t end = text.rfind("# end ");
  for (const char* line : {"# end 1\n", "# end soon\n", "# end \n", "# end 99999999999999999999999\n"})
    EXPECT_EQ(ending(text.substr(0, end) + line), HRT_ENDING_ALTERED) << line;
  EXPECT_EQ(ending(text.substr(0, end)), HRT_ENDING_CUT);
  EXPECT_EQ(ending(text.substr(0, text.size() - 1)), HRT_ENDING_CUT);
  EXPECT_EQ(ending(text.substr(0, row + 1)), HRT_ENDING_CUT);
  EXPECT_EQ(ending(changed("\nupdate,", "\n# lost 3 calls here: the disk was too slow\nupdate,")),
            HRT_ENDING_LOST_ROWS);
}

TEST_F(RecordingTest, NothingFollowsTheEnd) {
  const std::string text = recording() + "update,0\n";
  auto report = output<hrt_replay_report>();
  expect_error(hrt_recording_replay(nullptr, text.data(), text.size(), &report), HRT_ERROR_BAD_FORMAT, "after the end");
}

// Whatever came out of a call is compared: each cell of a row in turn is made another.
TEST_F(RecordingTest, EveryNumberThatCameOutIsCompared) {
  const std::string text = recording();
  std::istringstream lines(text);
  std::vector<std::string> names;
  std::vector<std::string> seen;
  std::size_t at = 0, compared = 0;
  for (std::string line; std::getline(lines, line); at += line.size() + 1) {
    if (line.starts_with("#")) continue;
    const std::vector<std::string> cells = split(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    if (cells[1] != "0" || std::count(seen.begin(), seen.end(), cells[0]) > 0) continue;
    seen.push_back(cells[0]);  // the first row of each call
    const auto first_out = std::find(names.begin(), names.end(), "real_direction_deg") - names.begin();
    for (std::size_t i = 1; i < cells.size(); ++i) {
      if (cells[i].empty() || (i > 1 && i < static_cast<std::size_t>(first_out))) continue;
      std::vector<std::string> others = cells;
      others[i] = cells[i] == "1" ? "2" : "1";
      std::string other = text;
      other.replace(at, line.size(), join(others));
      const auto line_number =
          static_cast<uint64_t>(1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
      EXPECT_EQ(replay(other).first_different_line, line_number) << cells[0] << " " << names[i];
      ++compared;
    }
  }
  EXPECT_EQ(seen, (std::vector<std::string>{"begin", "update", "end"}));
  // Result, reach and plate; result and command; result and summary.
  EXPECT_EQ(compared, (1 + 5 + 1) + (1 + std::size(plugin::columns_of<hrt_command>)) +
                          (1 + std::size(plugin::columns_of<hrt_reach_summary>)));
}

// Calls that are refused for their arguments are calls too.
TEST_F(RecordingTest, RefusedCallsAreRecordedAndReplayed) {
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), cup = add(HRT_TARGET_VIRTUAL, 5.0),
                   behind = add(HRT_TARGET_REAL, 170.0);
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  std::vector<std::string> expected;
  const auto begins = [&](auto change, hrt_result result) {
    hrt_reach_config config = reach_config(real, cup);
    change(config);
    EXPECT_EQ(hrt_reach_begin(session, &config), result) << hrt_last_error();
    expected.push_back("begin," + std::to_string(result));
  };
  begins([](auto& c) { c.real_target.value = 0; }, HRT_ERROR_INVALID_HANDLE);
  begins([](auto& c) { c.virtual_target.value = ~0ull; }, HRT_ERROR_INVALID_HANDLE);
  begins([&](auto& c) { c.real_target = cup; }, HRT_ERROR_OUT_OF_RANGE);
  begins([&](auto& c) { c.real_target = behind; }, HRT_ERROR_OUT_OF_RANGE);
  begins([](auto& c) { c.flags = 6; }, HRT_ERROR_OUT_OF_RANGE);
  begins([](auto& c) { c.flags = 1, c.plate_orientation_deg = std::nan(""); }, HRT_ERROR_OUT_OF_RANGE);
  begins([](auto& c) { c.flags = 1, c.plate_orientation_deg = -1.1e6; }, HRT_ERROR_OUT_OF_RANGE);
  begins([](auto& c) { c.struct_size = 8; }, HRT_ERROR_STRUCT_SIZE);
  EXPECT_EQ(hrt_reach_begin(session, nullptr), HRT_ERROR_NULL_ARGUMENT);
  expected.emplace_back("begin,-1");
  begins([](auto& c) { c.flags = 1, c.plate_orientation_deg = 10.0; }, HRT_OK);

  auto command = output<hrt_command>();
  const auto updates = [&](const hrt_sample* sample, hrt_command* out, hrt_result result) {
    EXPECT_EQ(hrt_reach_update(session, sample, out), result);
    expected.push_back("update," + std::to_string(result));
  };
  hrt_sample sample = direction_sample(0, 1.0);
  updates(&sample, &command, HRT_OK);
  updates(nullptr, &command, HRT_ERROR_NULL_ARGUMENT);
  updates(&sample, nullptr, HRT_ERROR_NULL_ARGUMENT);
  command.struct_size = 80 - 16;
  updates(&sample, &command, HRT_ERROR_STRUCT_SIZE);
  command = output<hrt_command>();
  sample.struct_size = 88;  // enough for a command, not for a sample
  updates(&sample, &command, HRT_ERROR_STRUCT_SIZE);
  struct {
    hrt_sample sample;
    double further;
  } later{direction_sample(0, 1.0), 3.0};
  later.sample.struct_size = sizeof later;
  updates(&later.sample, &command, HRT_ERROR_STRUCT_SIZE);
  sample = direction_sample(0, 1.0);
  sample.flags = 3;
  updates(&sample, &command, HRT_ERROR_OUT_OF_RANGE);

  auto summary = output<hrt_reach_summary>();
  const auto ends = [&](hrt_reach_summary* out, hrt_result result) {
    EXPECT_EQ(hrt_reach_end(session, out), result);
    expected.push_back("end," + std::to_string(result));
  };
  ends(nullptr, HRT_ERROR_NULL_ARGUMENT);
  summary.struct_size = 0;
  ends(&summary, HRT_ERROR_STRUCT_SIZE);
  summary = output<hrt_reach_summary>();
  ends(&summary, HRT_OK);
  ends(&summary, HRT_ERROR_WRONG_STATE);
  EXPECT_EQ(stop().rows_written, expected.size());

  const std::string text = read(path());
  std::istringstream rows(rows_of(text));
  std::string row;
  std::getline(rows, row);
  for (const std::string& call : expected) {
    ASSERT_TRUE(std::getline(rows, row));
    EXPECT_TRUE(row.starts_with(call + ",")) << row;
  }
  EXPECT_FALSE(std::getline(rows, row));
  const hrt_replay_report report = replay(text);
  expect_same(report);
  EXPECT_EQ(report.rows, expected.size());

  // Had one of them been taken, the replay would say so.
  expect_compared(text, {"\nbegin,-2,", "\nbegin,-3,", "\nbegin,-4,", "\nupdate,-1,", "\nend,-3,"});
}

// A recording that starts late starts from where plate, targets and what was learnt are then.
TEST_F(RecordingTest, MayStartAnyTimeBetweenReaches) {
  hrt_session_config config = paper_config();
  config.plate.max_speed_deg_s = 100.0;
  config.adaptation = HRT_ADAPTATION_CARRIED;
  create(config);
  const hrt_target gone = add(HRT_TARGET_REAL, 1.0), real = add(HRT_TARGET_REAL, -5.0),
                   cup = add(HRT_TARGET_VIRTUAL, 5.0);
  ASSERT_OK(hrt_target_remove(session, gone));
  const auto reach = [&] {
    ASSERT_OK(begin(real, cup));
    for (int step = 0; step < 9; ++step) update(direction_sample(step * 100 * ms, 8.0 - 2.0 * step));
    end();
  };
  reach();
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  reach();
  change(real, target_config(HRT_TARGET_REAL, -6.0));
  reach();
  stop();
  const std::string text = read(path());
  EXPECT_NE(text.find("\n# target added 2 {"), std::string::npos);
  EXPECT_EQ(text.find("\n# plate 0\n"), std::string::npos);
  expect_same(replay(text));
  std::string other = text;
  other.replace(other.find("\n# plate "), 9, "\n# plate 1");
  EXPECT_NE(replay(other).first_different_line, 0u);
}

TEST_F(RecordingTest, CutOffAnywhereIsIncompleteOrRefused) {
  const std::string golden = recording();
  for (std::size_t size = 0; size + 1 < golden.size(); size += size < 4000 ? 1 : 997) {
    auto report = output<hrt_replay_report>();
    const hrt_result result = hrt_recording_replay(nullptr, golden.data(), size, &report);
    if (result == HRT_OK) {
      EXPECT_EQ(report.complete, 0u);
      EXPECT_EQ(report.first_different_line, 0u);
    } else {
      EXPECT_EQ(result, HRT_ERROR_BAD_FORMAT);
    }
  }
}

TEST_F(RecordingTest, WhatIsNotARecordingIsRefusedByLine) {
  const std::string golden = recording();
  const auto refused = [](const std::string& text, const char* part) {
    auto report = output<hrt_replay_report>();
    report.rows = 77;
    expect_error(hrt_recording_replay(nullptr, text.data(), text.size(), &report), HRT_ERROR_BAD_FORMAT, part);
    EXPECT_EQ(report.rows, 77u);
  };
  const std::string header = golden.substr(0, golden.find("# config"));
  const std::string config = golden.substr(header.size(), golden.find('\n', header.size()) + 1 - header.size());
  refused("", "does not begin");
  refused("time,x\n1,2\n", "does not begin");
  refused("# haptic retargeting recording, version 3\n", "version 3 is not supported; version 4 is");
  refused("# haptic retargeting recording, version 5\r\n", "version 5 is not supported");
  refused("# haptic retargeting recording, version 4\nupdate,0\n",
          "line 2: this comes before the names of the columns");
  refused("# haptic retargeting recording, version 4\ncall,result,time_ns\n", "line 2: the columns are not those");
  refused(header + "update,0\n", "line 9: this comes before the configuration");
  refused(header + "# config {\"horizons\":3}\n", "line 9: \"horizons\" is not a field of a configuration");
  const auto refused_after_config = [&](const std::string& line, const std::string& part) {
    refused(header + config + line + "\n", ("line 10: " + part).c_str());
  };
  const auto row = [](const std::string& call, std::string_view column, const std::string& cell) {
    std::string text = call + ",0";
    for (const std::string_view name : std::span(plugin::recording_columns).subspan(2))
      text += name == column ? "," + cell : ",";
    return text;
  };
  refused_after_config("update,0", "the row has 2 columns; ");
  refused_after_config(row("jump", "", ""), "the row's call is \"jump\"");
  refused_after_config(row("update", "time_ns", "soon"), "time_ns is \"soon\"");
  refused_after_config(row("begin", "reach_flags", "-1"), "reach_flags is \"-1\"");
  refused_after_config(row("begin", "refused_argument", "sample"),
                       "the refused argument is \"sample\", which \"begin\" does not have");
  refused_after_config(row("calibration_solve", "", ""), "the row's call is \"calibration_solve\"");
  refused_after_config("# plate ", "the plate's orientation is \"\"");
  refused_after_config("# plate nan", "the plate's orientation is NaN");
  refused_after_config("# plate 1 ", "the plate's orientation is \"1 \"");
  refused_after_config("# target lost 1", "the target is \"lost\"; allowed: added, set, removed");
  refused_after_config("# target added", "the target's number is \"\"");
  refused_after_config("# target added 1 {}", "role is 0; allowed: 1 to 2");
  refused_after_config("# target set 1", "the text is not a JSON object");
  refused_after_config("# target removed 1", "target 1 is not there");
  const auto target = [](const std::string& name, const std::string& place) {
    return "{\"name\":" + name + ",\"role\":1," + place +
           ",\"direction_deg\":-5,\"distance_m\":0.1,\"position_m\":[0,0,0]}";
  };
  refused_after_config("# target added 1 " + target("\"a\"", "\"place\":4"), "place is 4");
  refused_after_config("# target added 1 " + target("7", "\"place\":1"), "name is not a text");
  refused_after_config("# target added 1 " + target('"' + std::string(64, 'x') + '"', "\"place\":1"),
                       "name is not a text of up to 63 bytes");
  refused_after_config("# target added 1 " + target("\"a\"", "\"plaice\":1"), "\"plaice\" is not a field");
  const std::string added = "# target added 1 " + target("\"a\"", "\"place\":1");
  refused(header + config + added + "\n" + added + "\n", "line 11: target 1 is there already");
  auto report = output<hrt_replay_report>();
  expect_error(hrt_recording_replay("/no/such/file", nullptr, 0, &report), HRT_ERROR_SYSTEM, "/no/such/file");
}

TEST_F(RecordingTest, ReplayStopsWhereRowsWereLost) {
  std::string text = recording();
  const std::size_t at = text.find("\nupdate,0,40000000,") + 1;
  text.insert(at, "# lost 3 calls here: the disk was too slow\n");
  const hrt_replay_report report = replay(text);
  EXPECT_EQ(report.complete, 0u);
  EXPECT_EQ(report.rows, 2u);
}

TEST_F(RecordingTest, CallsOutOfOrderAreRefused) {
  auto status = output<hrt_recording_status>();
  expect_error(hrt_recording_stop(session, &status), HRT_ERROR_WRONG_STATE, "nothing is being recorded");
  expect_error(hrt_recording_get_status(session, &status), HRT_ERROR_WRONG_STATE, "nothing is being recorded");
  expect_error(hrt_recording_start(session, "/no/such/folder/file"), HRT_ERROR_SYSTEM, "/no/such/folder/file");
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_WRONG_STATE, "already");
  stop();
  begin_reach();
  expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_WRONG_STATE, "under way");
}

TEST_F(RecordingTest, PathsAreUtf8) {
  const std::filesystem::path file = folder() / std::filesystem::path(u8"\u00fcbung \u65e5.csv");
  const std::u8string utf8 = file.u8string();
  const char* path = reinterpret_cast<const char*>(utf8.c_str());
  ASSERT_OK(hrt_recording_start(session, path));
  stop();
  EXPECT_TRUE(std::filesystem::exists(file));
  auto report = output<hrt_replay_report>();
  ASSERT_OK(hrt_recording_replay(path, nullptr, 0, &report));
  EXPECT_EQ(report.complete, 1u);
}

TEST_F(RecordingTest, DestroyedSessionCompletesItsRecording) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  begin_reach();
  update(direction_sample(0, 0.0));
  destroy();
  const hrt_replay_report report = replay(read(path()));
  EXPECT_EQ(report.complete, 1u);
  EXPECT_EQ(report.rows, 2u);
}

}  // namespace
}  // namespace hrt::test
