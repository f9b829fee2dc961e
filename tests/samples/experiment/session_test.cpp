#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <set>
#include <sstream>

#include "samples/app/text/text.h"
#include "samples/experiment/data/journal.h"
#include "tests/samples/experiment/study.h"

namespace hrt::experiment {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const char* const session_name = "sub-01/ses-01";

// Returns trials.csv without the columns that a crash may change: attempt, began_utc and recording.
std::string lasting_columns(const Design& design, const fs::path& study) {
  std::istringstream lines(export_study(design, study, false).files.at("trials.csv"));
  std::string text, line;
  std::vector<std::string> names;
  while (std::getline(lines, line)) {
    const std::vector<std::string> row = csv_fields(line);
    if (names.empty()) names = row;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (names[i] != "attempt" && names[i] != "began_utc" && names[i] != "recording") text += row[i] + ",";
    text += "\n";
  }
  return text;
}

std::size_t counted_rows(const std::string& rows) { return occurrences(rows, ",counted,"); }

// Runs a session that is killed (SIGKILL) at step `number`. Returns false if the session ended before that step.
bool killed_at(const Design& design, const fs::path& study, unsigned number) {
  const pid_t child = fork();
  if (child == 0) {
    unsigned steps = 0;
    try {
      run_simulated(design, study,
                    Disk(
                        [&](const char*) {
                          if (++steps == number) kill(getpid(), SIGKILL);
                        },
                        false));
    } catch (const std::exception&) {
      _exit(2);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0) << number;
  return WIFSIGNALED(status);
}

void expect_recordings_replay(const Design& design, const fs::path& study) {
  unsigned whole = 0;
  for (const auto& entry : fs::directory_iterator(study / session_name / "recordings")) {
    if (entry.path().extension() != ".csv" || fs::file_size(entry.path()) == 0) continue;
    hrt_replay_report report = hrt_replay_report_init();
    // A file that a kill has cut within the header is not a recording.
    if (hrt_recording_replay(entry.path().c_str(), nullptr, 0, &report) != HRT_OK) continue;
    EXPECT_EQ(report.first_different_line, 0U) << entry.path();
    whole += report.complete;
  }
  EXPECT_GE(whole, counted_rows(lasting_columns(design, study)));
}

// The session is killed before and after every write, sync, link and change of state. It has a practice trial and 4
// trials, or 40 trials with HRT_EXPERIMENT_REPEATS=10.
TEST(ExperimentCrash, NoFinishedTrialIsLostOrRepeated) {
  const char* const repeats = std::getenv("HRT_EXPERIMENT_REPEATS");
  const Design design = small_design(repeats != nullptr ? static_cast<unsigned>(std::stoi(repeats)) : 1);
  const TemporaryFolder whole;
  ASSERT_EQ(run_simulated(design, whole.path), "done");
  const std::string expected = lasting_columns(design, whole.path);
  ASSERT_EQ(counted_rows(expected), 1U + 4 * design.repeats);
  unsigned number = 1;
  for (;; ++number) {
    const TemporaryFolder folder;
    if (!killed_at(design, folder.path, number)) break;
    ASSERT_EQ(run_simulated(design, folder.path), "done") << number;
    ASSERT_EQ(lasting_columns(design, folder.path), expected) << number;
    if (number % 10 == 0) expect_recordings_replay(design, folder.path);
  }
  EXPECT_GT(number, 80U);
}

// Each process of a session is killed at its 13th to 19th step, until one completes the session.
TEST(ExperimentCrash, ManyCrashesOfOneSession) {
  const Design design = small_design(2);
  const TemporaryFolder whole, folder;
  run_simulated(design, whole.path);
  unsigned processes = 1;
  for (unsigned number = 13; killed_at(design, folder.path, number); number = 13 + processes++ % 7)
    ASSERT_LT(processes, 500U);
  EXPECT_GT(processes, 10U);
  EXPECT_EQ(lasting_columns(design, folder.path), lasting_columns(design, whole.path));
}

// The journal is truncated at every byte, as if the power had failed before the system wrote the rest.
TEST(ExperimentCrash, JournalTruncatedAtEveryByte) {
  const Design design = small_design(2);
  const TemporaryFolder whole;
  run_simulated(design, whole.path);
  const std::string journal = content_of(whole.path / session_name / "journal.jsonl");
  const std::vector<Event> events = read_journal(journal, "whole");
  std::size_t begin = 0;
  for (std::size_t line = 1; begin < journal.size(); ++line) {
    const std::size_t end = journal.find('\n', begin) + 1;
    for (std::size_t cut = begin; cut < end; ++cut) {
      const auto left = read_journal(journal.substr(0, cut), "cut");
      ASSERT_EQ(left.size(), line - (cut < end - 1)) << cut;
    }
    begin = end;
  }
  // Sessions are resumed after some of the cuts.
  std::vector<std::size_t> cuts = {journal.find('\n', journal.size() / 2), journal.size() - 1};
  for (std::size_t cut = 1; cut < journal.size(); cut += journal.size() / 5) cuts.push_back(cut);
  for (const std::size_t cut : cuts) {
    const TemporaryFolder folder;
    fs::copy(whole.path, folder.path, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    fs::resize_file(folder.path / session_name / "journal.jsonl", cut);
    ASSERT_EQ(run_simulated(design, folder.path), "done");
    ASSERT_EQ(lasting_columns(design, folder.path), lasting_columns(design, whole.path)) << cut;
    // The cut line is kept.
    ASSERT_EQ(content_of(folder.path / session_name / "journal.jsonl").substr(0, cut), journal.substr(0, cut));
  }
}

// The journal is cut within a set-up, whose slides are passed to the plugin again.
TEST(ExperimentCrash, AnInterruptedSetUpContinues) {
  const Design design = small_design(1, [](json& study) { study["set_up"] = "calibration"; });
  const TemporaryFolder whole;
  run_simulated(design, whole.path);
  const std::string journal = content_of(whole.path / session_name / "journal.jsonl");
  const std::size_t ninth = journal.find("\"number\":9,\"samples\"");
  ASSERT_NE(ninth, std::string::npos);
  const TemporaryFolder folder;
  fs::create_directories(folder.path / session_name);
  std::ofstream(folder.path / session_name / "journal.jsonl") << journal.substr(0, ninth);
  ASSERT_EQ(run_simulated(design, folder.path), "done");
  EXPECT_EQ(lasting_columns(design, folder.path), lasting_columns(design, whole.path));
  EXPECT_EQ(content_of(folder.path / session_name / "profile.json"),
            content_of(whole.path / session_name / "profile.json"));
}

TEST(ExperimentJournal, ErrorsNameTheDamagedLine) {
  const TemporaryFolder folder;
  run_simulated(small_design(1), folder.path);
  std::string journal = content_of(folder.path / session_name / "journal.jsonl");
  EXPECT_EQ(crc32("123456789"), 0xcbf43926U);  // check value of the standard
  const std::size_t third = journal.find("\"number\":3");
  journal[third + 20] ^= 1;
  EXPECT_TRUE(refusal_of([&] { read_journal(journal, "j"); }).starts_with("j: line 3 is damaged"));
  journal[third + 20] ^= 1;
  const std::size_t begin = journal.rfind('\n', third) + 1;
  journal.erase(begin, journal.find('\n', begin) + 1 - begin);
  EXPECT_TRUE(refusal_of([&] { read_journal(journal, "j"); }).starts_with("j: line 3 has number 4, not 3"));
}

TEST(ExperimentJournal, ASecondProcessIsRejected) {
  const TemporaryFolder folder;
  const Disk disk;
  fs::create_directories(folder.path / session_name);
  const Journal journal(folder.path / session_name / "journal.jsonl", disk, [] { return Now{}; });
  EXPECT_TRUE(has(refusal_of([&] { run_simulated(small_design(1), folder.path); }), "journal.jsonl: another process"));
}

// A full disk, simulated by a limit of the file size.
TEST(ExperimentJournal, AFullDiskLosesNoFinishedTrial) {
  const Design design = small_design(2);
  const TemporaryFolder folder, whole;
  run_simulated(design, whole.path);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{12'000, 12'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string why = refusal_of([&] { run_simulated(design, folder.path); });
    _exit(why.find("journal.jsonl: cannot be written: File too large") != std::string::npos ||
                  why.find("rows were lost") != std::string::npos
              ? 0
              : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(run_simulated(design, folder.path), "done");
  EXPECT_EQ(lasting_columns(design, folder.path), lasting_columns(design, whole.path));
}

// The line that could not be synced remains, and the event "closed" follows it.
TEST(ExperimentJournal, AFailedSyncLeavesAReadableJournal) {
  const Design design = small_design(1);
  const TemporaryFolder whole;
  run_simulated(design, whole.path);
  for (const unsigned failing : {1U, 2U, 5U}) {
    const TemporaryFolder folder;
    unsigned syncs = 0;
    const auto fail = [&](const char* step) {
      if (std::string(step) == "before sync" && ++syncs == failing) throw Refusal("the sync fails");
    };
    EXPECT_EQ(refusal_of([&] { run_simulated(design, folder.path, Disk(fail, false)); }), "the sync fails");
    EXPECT_EQ(run_simulated(design, folder.path), "done") << failing;
    EXPECT_EQ(lasting_columns(design, folder.path), lasting_columns(design, whole.path)) << failing;
  }
}

// A folder within a file cannot be created, even by root.
TEST(ExperimentJournal, ErrorsNameAFolderThatCannotBeCreated) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  EXPECT_TRUE(has(refusal_of([&] { run_simulated(small_design(1), folder.path / "file"); }), "cannot be created"));
}

// A participant whose experimenter quits after `reaches` reaches, and whose clock jumps before the session is resumed.
class Leaving : public SimulatedSubject {
 public:
  Leaving(const Design& design, unsigned reaches, std::int64_t jump_ms)
      : SimulatedSubject(design, 1, 7), left_(reaches), jump_ms_(jump_ms) {}
  Key key() override { return left_ == 0 ? Key::leave : Key::none; }
  ReachOutcome reach(const ReachOrder& order) override {
    if (left_ > 0) --left_;
    return SimulatedSubject::reach(order);
  }
  void continue_after(const Now& last) override {
    SimulatedSubject::continue_after({last.utc_ms + jump_ms_, last.monotonic_ns + jump_ms_ * 1'000'000});
  }

 private:
  unsigned left_;
  std::int64_t jump_ms_;
};

// The block restarts after a pause of an hour or if the clock was set back, and continues after a minute.
TEST(ExperimentSession, ALongPauseRestartsTheBlock) {
  const Design design = small_design(2);
  struct {
    std::int64_t jump_ms;
    bool again;
  } const cases[] = {{3'600'000, true}, {-60'000, true}, {60'000, false}};
  for (const auto& [jump_ms, again] : cases) {
    const TemporaryFolder folder;
    Leaving first(design, 4, 0), second(design, 1000, jump_ms);
    EXPECT_EQ(run_session(design, {folder.path, 1, 1}, first, Disk({}, false)), "left");
    EXPECT_EQ(run_session(design, {folder.path, 1, 1}, second, Disk({}, false)), "done");
    const std::string journal = content_of(folder.path / session_name / "journal.jsonl");
    EXPECT_EQ(journal.find("block_again") != std::string::npos, again) << jump_ms;
    EXPECT_EQ(counted_rows(lasting_columns(design, folder.path)), 9U);
  }
}

TEST(ExperimentSession, TheSameSeedGivesTheSameBytes) {
  const Design design = small_design(2);
  const TemporaryFolder one, two;
  run_simulated(design, one.path);
  run_simulated(design, two.path);
  unsigned files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(one.path)) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(read_file(entry.path()), read_file(two.path / fs::relative(entry.path(), one.path))) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 20U);
}

TEST(ExperimentSession, AChangedDesignIsRejected) {
  const TemporaryFolder folder;
  run_simulated(small_design(1), folder.path);
  const Design changed = small_design(2);
  EXPECT_TRUE(has(refusal_of([&] { run_simulated(changed, folder.path, Disk(), 2); }), changed.sha256));
  // With the same design, a finished session is not repeated.
  const std::string journal = content_of(folder.path / session_name / "journal.jsonl");
  EXPECT_EQ(run_simulated(small_design(1), folder.path), "done");
  EXPECT_EQ(content_of(folder.path / session_name / "journal.jsonl"), journal);
}

// A trial with too many invalid reaches is missing; too many invalid reaches in a row stop the session.
TEST(ExperimentSession, InvalidReaches) {
  const TemporaryFolder some, all;
  const Design twice = small_design(2, [](json& s) { s["validity"] = {{"max_attempts", 1}}; });
  run_simulated(twice, some.path);
  const std::string rows = lasting_columns(twice, some.path);
  EXPECT_TRUE(has(rows, ",missing,"));
  EXPECT_TRUE(has(rows, ",too many samples were dropouts or outliers,"));
  const Design never = small_design(2, [](json& s) {
    s["simulated"]["invalid_share"] = 0.5;
    s["stop"] = {{"max_invalid_in_a_row", 1}};
  });
  EXPECT_EQ(run_simulated(never, all.path), "stopped");
}

// Only the design and the unblinded export have names of conditions; other files have none in their names or contents.
TEST(ExperimentSession, ConditionsAreLetters) {
  const Design design = small_design(2);
  const TemporaryFolder folder;
  run_simulated(design, folder.path);
  for (const auto& entry : fs::recursive_directory_iterator(folder.path)) {
    if (!entry.is_regular_file() || entry.path().filename() == "study.json") continue;
    for (const char* name : {"secret", "hidden"}) {
      EXPECT_FALSE(has(entry.path().string(), name));
      EXPECT_FALSE(has(read_file(entry.path()), name)) << entry.path();
    }
  }
  EXPECT_FALSE(has(export_study(design, folder.path, false).files.at("trials.csv"), "secret"));
  EXPECT_TRUE(has(export_study(design, folder.path, true).files.at("trials.csv"), "secret people"));
}

// Practice and noticeability, whose condition the design reveals, have no letter. Letters differ by participant.
TEST(ExperimentSession, LettersRevealNoCondition) {
  const Design design = small_design(1, [](json& study) {
    study["participants"] = 12;
    study["noticeability"] = {{"trials", 5}, {"condition", "secret people"}};
  });
  const TemporaryFolder folder;
  run_simulated(design, folder.path);
  const std::string journal = content_of(folder.path / session_name / "journal.jsonl");
  std::set<std::string> shown;
  for (const Event& event : read_journal(journal, "journal"))
    if (event.name == "attempt")
      shown.insert(event.data["kind"].get<std::string>() + " " + event.data["condition"].get<std::string>());
  EXPECT_EQ(shown,
            (std::set<std::string>{"practice practice", "reaches A", "reaches B", "noticeability noticeability"}));
  std::set<std::string> letters;
  for (unsigned participant = 1; participant <= 12; ++participant) letters.insert(letter_of(design, participant, 0));
  EXPECT_EQ(letters.size(), 2U);
}

// A participant whose session is resumed after a restart of the computer, where the monotonic clock starts again.
class Rebooted : public SimulatedSubject {
 public:
  Rebooted(const Design& design, bool again) : SimulatedSubject(design, 1, 7), again_(again) {}
  Key key() override { return !again_ && left_-- == 0 ? Key::leave : Key::none; }
  std::string boot() const override { return again_ ? "second" : "first"; }
  void continue_after(const Now& last) override {
    SimulatedSubject::continue_after({last.utc_ms + 600'000, again_ ? 1'000 : last.monotonic_ns});
  }

 private:
  bool again_;
  int left_ = 6;
};

// Consent and trials take some minutes; the pause takes ten.
TEST(ExperimentSession, MaxMinutesIncludesThePauseOfARestart) {
  for (const double max_minutes : {8.0, 60.0}) {
    const Design design = small_design(2, [&](json& study) { study["stop"] = {{"max_minutes", max_minutes}}; });
    const TemporaryFolder folder;
    Rebooted first(design, false), second(design, true);
    EXPECT_EQ(run_session(design, {folder.path, 1, 1}, first, Disk({}, false)), "left");
    EXPECT_EQ(run_session(design, {folder.path, 1, 1}, second, Disk({}, false)),
              max_minutes < 10.0 ? "stopped" : "done");
    const std::string people = export_study(design, folder.path, false).files.at("people.csv");
    EXPECT_TRUE(has(people, max_minutes < 10.0 ? "stopped,the session took too long," : "done,"));
  }
}

class Refusing : public SimulatedSubject {
 public:
  using SimulatedSubject::SimulatedSubject;
  bool consents() override { return false; }
};

TEST(ExperimentSession, RefusedConsentIsTheReasonOfTheEnd) {
  const Design design = small_design(1);
  const TemporaryFolder folder;
  Refusing subject(design, 1, 7);
  EXPECT_EQ(run_session(design, {folder.path, 1, 1}, subject, Disk({}, false)), "stopped");
  EXPECT_TRUE(has(export_study(design, folder.path, false).files.at("people.csv"), "stopped,consent was not given,"));
}

class Unplugged : public SimulatedSubject {
 public:
  using SimulatedSubject::SimulatedSubject;
  ReachOutcome reach(const ReachOrder&) override { throw Refusal("the plate does not answer"); }
};

TEST(ExperimentSession, TablesHaveAllDataOfTheJournal) {
  const Design design = small_design(2, [](json& study) {
    study["participants"] = 4;
    study["between"] = {{"factor", "hand"}, {"levels", {"left", "right"}}};
    study["questionnaires"] = {{{"name", "Fragen, é"}, {"items", {"Übelkeit", "b"}}},
                               {{"name", "effort"}, {"when", "block"}, {"answers", "text"}, {"items", {"How?"}}}};
  });
  const TemporaryFolder folder;
  Unplugged unplugged(design, 1, 7);
  EXPECT_NE(refusal_of([&] { run_session(design, {folder.path, 1, 1}, unplugged, Disk({}, false)); }), "");
  const std::string failed = export_study(design, folder.path, false).files.at("people.csv");
  EXPECT_TRUE(has(failed, "open,the plate does not answer,"));
  EXPECT_EQ(run_simulated(design, folder.path), "done");
  auto files = export_study(design, folder.path, false).files;
  EXPECT_TRUE(has(files["people.csv"], "1,1,\"simulated, seed 7\"," + design.levels[schedule_of(design, 1).level]));
  EXPECT_EQ(occurrences(files["questionnaires.csv"], "\"Fragen, é\",after,"), 2U);
  EXPECT_TRUE(has(files["questionnaires.csv"], ",1,Übelkeit,"));
  for (const char* block : {",effort,block 1,", ",effort,block 2,"})
    EXPECT_EQ(occurrences(files["questionnaires.csv"], block), 1U) << files["questionnaires.csv"];
  EXPECT_EQ(occurrences(files["questionnaires.csv"], ",simulated,"), 2U);
  EXPECT_TRUE(has(files["events.csv"], ",closed,"));
  const std::string journal = content_of(folder.path / session_name / "journal.jsonl");
  EXPECT_EQ(occurrences(files["attempts.csv"], "\n"), 1 + occurrences(journal, "\"event\":\"attempt\""));
  EXPECT_EQ(occurrences(files["attempts.csv"], "interrupted"), 1U);
  for (const auto& [name, content] : files) {
    if (!name.ends_with(".csv")) continue;
    std::istringstream header(content.substr(0, content.find('\n')));
    for (std::string column; std::getline(header, column, ',');)
      EXPECT_TRUE(has(files["dictionary.md"], "| `" + column + "` | ")) << name << column;
  }
}

// Delivered bends are near their gaps; no gap exceeds the feasible gap of the set-up. Each of two QUEST+ runs has half
// of the trials.
TEST(ExperimentSession, NoticeabilityUsesTheDeliveredBend) {
  const Design design = small_design(1, [](json& study) {
    study["participants"] = 2;
    study["set_up"] = "calibration";
    study["simulated"]["invalid_share"] = 0;
    study["conditions"][1]["controller"] = "paper";
    study["noticeability"] = {
        {"trials", 10}, {"condition", "secret people"}, {"control", "hidden none"}, {"runs", 2}, {"max_gap_deg", 45}};
  });
  const TemporaryFolder folder;
  run_simulated(design, folder.path);
  const std::string journal = content_of(folder.path / session_name / "journal.jsonl");
  double max_gap_deg = 0.0, gap_deg = 0.0;
  unsigned bends = 0, first_run = 0;
  json attempt = json::object();
  for (const Event& event : read_journal(journal, "journal")) {
    if (event.name == "set_up") max_gap_deg = event.data["max_gap_deg"];
    if (event.name == "attempt") attempt = event.data;
    gap_deg = attempt.value("gap_deg", 0.0);
    if (event.name != "reach" || !event.data.contains("bend_deg")) continue;
    EXPECT_LE(gap_deg, max_gap_deg);
    EXPECT_NEAR(event.data["bend_deg"].get<double>(), gap_deg, 6.0);
    ++bends;
    first_run += attempt["run"] == 1 ? 1 : 0;
  }
  EXPECT_EQ(bends, 10U);
  EXPECT_EQ(first_run, 5U);
  EXPECT_LT(max_gap_deg, 30.0);
}

TEST(ExperimentSession, ConditionsSetTheConfigurationAndTheGap) {
  const Design design = small_design(1, [](json& study) {
    study["simulated"]["invalid_share"] = 0;
    study["conditions"] = {
        {{"name", "a"}, {"controller", "people"}, {"config", {{{"field", "person.tactile_weight"}, {"value", 0.35}}}}},
        {{"name", "b"}, {"controller", "people"}, {"gap_share", 0.5}}};
  });
  EXPECT_EQ(config_of(design.conditions[0]).person.tactile_weight, 0.35);
  const TemporaryFolder folder;
  EXPECT_EQ(run_simulated(design, folder.path), "done");
  const std::string trials = export_study(design, folder.path, true).files.at("trials.csv");
  EXPECT_EQ(occurrences(trials, ",b,0,left,,1,"), 1U) << trials;
  EXPECT_EQ(occurrences(trials, ",6.0,3.0,"), 1U) << trials;
}

TEST(ExperimentSession, RecordingsAreDescribed) {
  const Design design = small_design(1, [](json& study) { study["set_up"] = "calibration"; });
  const TemporaryFolder folder;
  SimulatedSubject subject(design, 1, 7);
  run_session(design, {folder.path, 1, 1, "a plate's file"}, subject, Disk({}, false));
  EXPECT_EQ(content_of(folder.path / session_name / "plate.json"), "a plate's file");
  const fs::path recordings = folder.path / session_name / "recordings";
  unsigned count = 0;
  for (const auto& entry : fs::directory_iterator(recordings)) {
    if (entry.path().extension() != ".json") continue;
    const json about = json::parse(read_file(entry.path()));
    EXPECT_EQ(about["study_sha256"], design.sha256);
    EXPECT_EQ(about["participant"], 1);
    EXPECT_EQ(about["subject"], "simulated, seed 7");
    EXPECT_EQ(about["sha256"]["plate.json"], sha256_of("a plate's file"));
    EXPECT_EQ(about["sha256"]["profile.json"].get<std::string>().size(), 64U);
    EXPECT_TRUE(entry.path().stem().string().ends_with("cond-" + about["condition"].get<std::string>()));
    EXPECT_TRUE(fs::exists(recordings / (entry.path().stem().string() + ".csv")));
    ++count;
  }
  EXPECT_GE(count, 5U);
}

}  // namespace
}  // namespace hrt::experiment
