#include "recording_fixture.h"

#include <limits>
#include <span>

#include "generated/fields.h"

namespace hrt::test {
namespace {

// Checks that rows with a changed result are reported as different.
void expect_compared(const std::string& text, const std::vector<std::string>& calls) {
  for (const std::string& call : calls) {
    std::string other = text;
    const std::size_t at = other.find(call);
    ASSERT_NE(at, std::string::npos) << call;
    other.replace(at, call.size(), call.substr(0, call.find(',')) + ",-9,");
    EXPECT_NE(replay(other).first_different_line, 0u) << call;
  }
}

std::vector<std::string> split(const std::string& row) {
  std::istringstream line(row);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(line, cell, ',');) cells.push_back(cell);
  if (row.ends_with(",")) cells.emplace_back();
  return cells;
}

// Both controllers give the same commands in every build on every host, also after calls that fail.
TEST_F(RecordingTest, BothControllersWithEverySampleReplayBitForBit) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  play();
  const hrt_recording_status status = stop();
  EXPECT_EQ(status.rows_lost, 0u);
  EXPECT_EQ(status.system_error, 0);
  auto report = output<hrt_replay_report>();
  ASSERT_OK(hrt_recording_replay(path().c_str(), nullptr, 0, &report));
  expect_same(report);
  EXPECT_EQ(report.rows, 3u * 2u + 64u + 2u * 270u);
  EXPECT_EQ(report.hash, 0x765c9beb5fff43fdu) << "which is 0x" << std::hex << report.hash;
}

TEST_F(RecordingTest, RetargetsAndCancelledReachesReplayBitForBit) {
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  for (const std::uint32_t guidance : {HRT_GUIDANCE_FIXED_DIRECTION, HRT_GUIDANCE_ARRIVAL}) {
    hrt_session_config config = session_config();
    config.guidance = guidance;
    ASSERT_OK(hrt_session_set(session, &config));
    const hrt_target real = add(HRT_TARGET_REAL, -5.0), cup = add(HRT_TARGET_VIRTUAL, 5.0);
    EXPECT_EQ(hrt_reach_retarget(session, real, cup), HRT_ERROR_WRONG_STATE);
    for (const bool cancels : {true, false}) {
      EXPECT_EQ(hrt_reach_cancel(session), HRT_ERROR_WRONG_STATE);
      ASSERT_OK(begin(real, cup, HRT_REACH_START_AT_FINGER));
      for (int i = 0; i < 200; ++i) {
        update(position_sample(i * 10 * ms, 0.001 * noise(), -0.04 + 0.0006 * std::max(0, i - 40)));
        if (i % 7 != 0) continue;
        change(cup, target_config(HRT_TARGET_VIRTUAL, 5.0 + 0.1 * i));
        EXPECT_OK(hrt_reach_retarget(session, real, cup));
        EXPECT_EQ(hrt_reach_retarget(session, cup, cup), HRT_ERROR_OUT_OF_RANGE);
        EXPECT_EQ(hrt_reach_retarget(session, {0}, cup), HRT_ERROR_INVALID_HANDLE);
      }
      if (cancels) {
        ASSERT_OK(hrt_reach_cancel(session));
      } else {
        end();
      }
    }
  }
  stop();
  const std::string text = read(path());
  expect_same(replay(text));
  expect_compared(text, {"\nretarget,0,", "\nretarget,-4,", "\nretarget,-5,", "\ncancel,0,", "\ncancel,-5,"});
}

// Contacts within and after a reach, rejected ones, and ones whose struct cannot be read, which are not recorded.
TEST_F(RecordingTest, ContactsReplayBitForBit) {
  create(session_config(), [](auto& c) { c.flags = HRT_SESSION_REGISTERED; });
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
  expect_same(replay(text));
  std::string elsewhere = text;
  const std::size_t at = elsewhere.find(",0.012,", elsewhere.find("\ntouched,0,"));
  ASSERT_NE(at, std::string::npos);
  elsewhere.replace(at, 7, ",0.013,");
  EXPECT_GT(replay(elsewhere).first_different_line, 270u) << "the next reaches depend on the contact";
}

TEST_F(RecordingTest, ScriptedReachReplaysToItsHash) { expect_golden_bits(); }

// Releases may write different texts for the same double.
TEST_F(RecordingTest, EqualNumbersWithOtherTextsAreNoDifference) {
  std::string text = recording();
  const std::size_t update = text.find("\nupdate,0,");
  const std::size_t weight = text.find(",0.15,", update);
  ASSERT_NE(weight, std::string::npos);
  text.replace(weight, 6, ",1.50e-01,");
  EXPECT_EQ(replay(text).first_different_line, 0u);
}

// Fields that are not read may have any value. The sign of -0 is recorded.
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

TEST_F(RecordingTest, ServedByIsRecordedAsTheTargetsNumber) {
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

// The end line has a checksum of all preceding lines.
TEST_F(RecordingTest, AlteredOrTruncatedRecordingIsNotComplete) {
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
  other = text;
  const hrt_replay_report lossy = replay(other.insert(row + 1, "# lost 3 calls here: the disk was too slow\n"));
  EXPECT_EQ(lossy.ending, HRT_ENDING_LOST_ROWS);
  EXPECT_EQ(lossy.complete, 0u);
  EXPECT_EQ(lossy.rows, 2u) << "the replay stops there";
}

TEST_F(RecordingTest, EveryOutputColumnIsCompared) {
  const std::string text = recording();
  std::istringstream lines(text);
  std::vector<std::string> names, seen;
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
    std::size_t cell_at = at;
    for (std::size_t i = 0; i < cells.size(); cell_at += cells[i++].size() + 1) {
      if (cells[i].empty() || i == 0 || (i > 1 && i < static_cast<std::size_t>(first_out))) continue;
      std::string other = text;
      other.replace(cell_at, cells[i].size(), cells[i] == "1" ? "2" : "1");
      const auto line_number =
          static_cast<uint64_t>(1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
      EXPECT_EQ(replay(other).first_different_line, line_number) << cells[0] << " " << names[i];
      ++compared;
    }
  }
  EXPECT_EQ(seen, (std::vector<std::string>{"begin", "update", "end"}));
  // "begin": result, reach and plate. "update": result and command. "end": result and summary.
  EXPECT_EQ(compared, (1 + 5 + 1) + (1 + std::size(plugin::columns_of<hrt_command>)) +
                          (1 + std::size(plugin::columns_of<hrt_reach_summary>)));
}

TEST_F(RecordingTest, FailedCallsAreRecordedAndReplayed) {
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), cup = add(HRT_TARGET_VIRTUAL, 5.0);
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  std::string expected;
  const auto called = [&](const char* call, hrt_result result, hrt_result expected_result) {
    EXPECT_EQ(result, expected_result) << call << hrt_last_error();
    expected += std::string(call) + "," + std::to_string(result) + "\n";
  };
  called("begin", begin(cup, cup), HRT_ERROR_OUT_OF_RANGE);
  called("begin", begin(real, {~0ull}), HRT_ERROR_INVALID_HANDLE);
  EXPECT_EQ(hrt_reach_begin(session, nullptr), HRT_ERROR_NULL_ARGUMENT) << "which is not recorded";
  called("begin", begin(real, cup), HRT_OK);
  auto command = output<hrt_command>();
  hrt_sample sample = direction_sample(0, 1.0), both = sample;
  both.flags = 3;
  called("update", hrt_reach_update(session, &sample, &command), HRT_OK);
  called("update", hrt_reach_update(session, &both, &command), HRT_ERROR_OUT_OF_RANGE);
  auto summary = output<hrt_reach_summary>();
  called("end", hrt_reach_end(session, &summary), HRT_OK);
  called("end", hrt_reach_end(session, &summary), HRT_ERROR_WRONG_STATE);
  stop();

  const std::string text = read(path());
  std::istringstream lines(text);
  std::string recorded;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("#") && !line.starts_with("call,"))
      recorded += line.substr(0, line.find(',', line.find(',') + 1)) + "\n";
  EXPECT_EQ(recorded, expected);
  expect_same(replay(text));
  expect_compared(text, {"\nbegin,-2,", "\nbegin,-4,", "\nupdate,-4,", "\nend,-5,"});
}

// A recording that starts later begins with the present plate orientation, targets and estimates.
TEST_F(RecordingTest, StartsBetweenReachesWithThePresentState) {
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

TEST_F(RecordingTest, TruncationAtAnyByteIsIncompleteOrRejected) {
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

void expect_malformed(const std::string& text, const std::string& part) {
  auto report = output<hrt_replay_report>();
  report.rows = 77;
  const std::string lines = text + "\n";
  expect_error(hrt_recording_replay(nullptr, lines.data(), lines.size(), &report), HRT_ERROR_BAD_FORMAT, part);
  EXPECT_EQ(report.rows, 77u);
}

TEST_F(RecordingTest, MalformedHeadersAreRejectedNamingTheLine) {
  const std::string golden = recording();
  const std::string header = golden.substr(0, golden.find("# config"));
  const std::string version = "# haptic retargeting recording, version ";
  expect_malformed("", "");
  expect_malformed("time,x\n1,2\n", "");
  expect_malformed(version + "3\n", "version 3");
  expect_malformed(version + "5\r\n", "version 5");
  expect_malformed(version + "4\nupdate,0\n", "line 2");
  expect_malformed(version + "4\ncall,result,time_ns\n", "line 2");
  expect_malformed(header + "update,0\n", "line 8");
  expect_malformed(header + "# config {\"horizons\":3}\n", "\"horizons\"");
  expect_malformed(golden + "update,0", "# end");
}

TEST_F(RecordingTest, MalformedRowsAreRejectedNamingTheField) {
  const std::string golden = recording();
  const std::string with_config = golden.substr(0, golden.find('\n', golden.find("# config")) + 1);
  const auto row = [](const std::string& call, std::string_view column, const std::string& cell) {
    std::string text = call + ",0";
    for (const std::string_view name : std::span(plugin::recording_columns).subspan(2))
      text += name == column ? "," + cell : ",";
    return text;
  };
  const auto target = [](const std::string& name, const std::string& place) {
    return "# target added 1 {\"name\":" + name + ",\"role\":1," + place +
           ",\"direction_deg\":-5,\"distance_m\":0.1,\"position_m\":[0,0,0]}";
  };
  const std::string added = target("\"a\"", "\"place\":1");
  const std::pair<std::string, std::string> malformed[] = {
      {"update,0", "2 columns"},
      {row("jump", "", ""), "\"jump\""},
      {row("update", "time_ns", "soon"), "time_ns"},
      {row("begin", "reach_flags", "-1"), "reach_flags"},
      {"# plate nan", "NaN"},
      {"# plate 1 ", "\"1 \""},
      {"# target lost 1", "\"lost\""},
      {"# target added", "number"},
      {"# target added 1 {}", "role"},
      {"# target set 1", "JSON"},
      {"# target removed 1", "target 1"},
      {target("\"a\"", "\"place\":4"), "place"},
      {target("7", "\"place\":1"), "name"},
      {target('"' + std::string(64, 'x') + '"', "\"place\":1"), "name"},
      {target("\"a\"", "\"plaice\":1"), "\"plaice\""},
      {added + "\n" + added, "line 10"}};
  for (const auto& [text, part] : malformed) expect_malformed(with_config + text, part);
}

TEST_F(RecordingTest, CallsOutOfOrderAreRejected) {
  auto status = output<hrt_recording_status>();
  expect_error(hrt_recording_stop(session, &status), HRT_ERROR_WRONG_STATE);
  expect_error(hrt_recording_get_status(session, &status), HRT_ERROR_WRONG_STATE);
  expect_error(hrt_recording_start(session, "/no/such/folder/file"), HRT_ERROR_SYSTEM, "/no/such/folder/file");
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_WRONG_STATE);
  stop();
  begin_reach();
  expect_error(hrt_recording_start(session, path().c_str()), HRT_ERROR_WRONG_STATE);
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
