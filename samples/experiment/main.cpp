// hrt-experiment: a study of haptic retargeting, from its design to its data. See README.md beside this file.
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <iostream>
#include <optional>

#include "samples/app/base/interrupt.h"
#include "samples/app/text/format.h"
#include "samples/app/text/whole_file.h"
#include "samples/app/xr/check.h"
#include "samples/experiment/design/design.h"
#include "samples/experiment/output/export.h"
#include "samples/experiment/session/session.h"
#include "samples/experiment/session/simulated.h"
#include "samples/experiment/session/xr_subject.h"

namespace hrt::experiment {
namespace {

struct Options {
  std::string study;
  std::string data = "data";
  unsigned participant = 1;
  unsigned session = 1;
  unsigned threads = 2;
  bool unblinds = false;
  bool simulated = false;
  std::string live, power;
  std::string plate = "runtime";
  app::Options reach;  // options that hrt-reach has, too
};

void put(const std::filesystem::path& file, const std::string& content) {
  if (const int error = write_whole_file(file, content); error != 0)
    throw Refusal(file.string() + ": cannot be written: " + std::strerror(error) +
                  "; free space, or check the permissions of the folder");
}

// Runs one session: in this process if --simulated is given without --scene, else through OpenXR.
void run_one(const Options& options) {
  const Design design = read_design(options.study);
  SessionPlace place{options.data, options.participant, options.session};
  if (options.plate.ends_with(".json")) place.plate = content_of(options.plate);
  if (!options.reach.registered.empty()) place.registration = content_of(options.reach.registered);
  std::string end;
  if (options.simulated && options.reach.scene.empty()) {
    SimulatedSubject subject(design, options.participant, options.reach.seed);
    end = run_session(design, place, subject, Disk());
  } else {
    if (options.reach.scene.empty())
      throw Refusal("--scene is missing: give the scene of the plate, or --simulated SEED for a simulated participant");
    app::note_interrupts();
    app::Options at_plate = options.reach;
    at_plate.person = !options.simulated;
    at_plate.plate = app::parse_plate(options.plate).value();
    app::watch_runtime(at_plate.runtime_limit);
    std::optional<Live> live;
    if (!options.live.empty()) std::cerr << live.emplace(options.live == "keys").addresses();
    XrSubject subject(design, options.participant, at_plate, live ? &*live : nullptr);
    try {
      end = run_session(design, place, subject, Disk([&subject](const char*) { subject.between_frames(); }));
    } catch (const app::Interrupted&) {
      end = "left";
    } catch (const app::XrFailure& failure) {
      subject.speak("The OpenXR runtime failed. Restart it, then run the same command again.");
      throw Refusal(std::string("the OpenXR runtime failed: ") + failure.what() +
                    "; restart the runtime, then run the same command again to resume the session");
    } catch (const std::exception& error) {
      subject.speak(error.what());
      throw;
    }
  }
  if (end == "left") end = "interrupted (run the same command again to resume)";
  std::cout << "sub-" << options.participant << ": " << end
            << (options.simulated ? ", SIMULATED: no person took part\n" : "\n");
}

std::string run_simulated(const Design& design, const Options& options, unsigned participant) {
  SimulatedSubject subject(design, participant, options.reach.seed);
  return run_session(design, {options.data, participant, 1}, subject, Disk());
}

// Runs all participants in several processes. Threads of one process would share the numbering of targets, so that
// recordings would differ from those of single sessions.
void simulate(const Options& options) {
  const Design design = read_design(options.study);
  freeze(design, options.data, Disk());
  for (unsigned first = 1; first <= options.threads; ++first) {
    const pid_t child = fork();
    if (child < 0)
      throw Refusal(format("cannot start process %u of %u: %s. Use fewer processes (--threads)", first, options.threads,
                           std::strerror(errno)));
    if (child > 0) continue;
    try {
      for (unsigned participant = first; participant <= design.participants; participant += options.threads)
        run_simulated(design, options, participant);
    } catch (const std::exception&) {
      // The parent process runs the remaining sessions, and reports the error if it occurs again.
    }
    _exit(0);
  }
  while (wait(nullptr) > 0) continue;
  // Runs or resumes the sessions that the processes have not finished; a finished session is not changed.
  for (unsigned participant = 1; participant <= design.participants; ++participant)
    std::cout << "sub-" << participant << ": " << run_simulated(design, options, participant) << "\n";
  std::cout << "SIMULATED: no person took part\n";
}

void write_tables(const Options& options) {
  const std::filesystem::path study = options.data;
  if (!std::filesystem::exists(study / "study.json"))
    throw Refusal(study.string() + ": this folder has no study.json, with which a session begins; check --data");
  const Design design = read_design(study / "study.json");
  const Tables tables = export_study(design, study, options.unblinds);
  std::filesystem::create_directories(study / "export");
  for (const auto& [name, content] : tables.files) put(study / "export" / name, content);
  std::cout << (study / "export").string() << ": " << tables.sessions << " sessions\n";
}

void add_commands(CLI::App& app, Options& options) {
  const auto add = [&](const char* name, const char* help, bool has_study, void (*run)(const Options&)) {
    CLI::App* command = app.add_subcommand(name, help);
    if (has_study) command->add_option("study", options.study, "The design, study.json")->required();
    command->callback([run, &options] { run(options); });
    return command;
  };
  add("design", "Check a design, and print its trials, time plan, balance and orders", true,
      [](const Options& o) { std::cout << design_text(read_design(o.study)); });
  add("preregister", "Print the text of a registered report, in Markdown, to be completed", true, [](const Options& o) {
    const std::string power = o.power.empty() ? "" : content_of(o.power);
    if (!o.power.empty() && power.empty())
      throw Refusal(o.power + ": is empty; write the output of samples/experiment/power to it");
    std::cout << preregistration_text(read_design(o.study), power);
  })->add_option("--power", options.power, "Output of samples/experiment/power for this design, to be included");
  add("protocol", "Print the experimenters' protocol, in Markdown", true,
      [](const Options& o) { std::cout << protocol_text(read_design(o.study)); });
  add("schema", "Print the JSON schema of designs", false,
      [](const Options&) { std::cout << design_schema().dump(2) << "\n"; });
  CLI::App* run = add("run", "Run or resume the session of a participant", true, run_one);
  CLI::App* all = add("simulate", "Simulate the sessions of all participants of the design", true, simulate);
  CLI::App* tables = add("export", "Write the journals as tables with a data dictionary", false, write_tables);
  run->add_option("--participant", options.participant,
                  "Number of the participant, from 1. In a design with P participants, number N + P replaces N")
      ->required();
  run->add_option("--session", options.session, "Number of the session, from 1 [1]")->check(CLI::Range(1, 99));
  run->add_option("--simulated", options.reach.seed,
                  "Seed of a simulated participant; without --scene, no runtime is used")
      ->each([&options](const std::string&) { options.simulated = true; });
  run->add_option("--scene", options.reach.scene,
                  "glTF file with the plate and the start, for a session through OpenXR. Required without --simulated");
  run->add_option("--plate", options.plate, "Plate, as in hrt-reach --help [runtime]")
      ->needs("--scene")
      ->check([](const std::string& text) {
        if (app::parse_plate(text)) return std::string();
        return "\"" + text +
               "\" is not a plate; allowed: runtime, servo, servo:SPEED (1 to 1000000), serial:LINE, dynamixel:LINE or "
               "a file *.json";
      });
  run->add_option("--finger", options.reach.finger,
                  "Touch frame as the tracker, as in hrt-reach --help: evdev:/dev/input/by-id/NAME [hand tracking]")
      ->needs("--scene")
      ->excludes("--simulated");
  run->add_option("--registered", options.reach.registered,
                  "Registration file of hrt-reach --register [register by touches]")
      ->needs("--scene")
      ->excludes("--simulated", "--finger");
  run->add_option(
         "--live", options.live,
         "Serve a page on 127.0.0.1. look: a page that displays the session; keys: also a second page, with the "
         "experimenter's keys")
      ->needs("--scene")
      ->check(CLI::IsMember({"look", "keys"}));
  run->add_flag_callback(
         "--speak", [&options] { options.reach.speak_with = "espeak-ng"; },
         "Speak requests to the participant with espeak-ng")
      ->needs("--scene");
  run->add_option("--speak-with", options.reach.speak_with,
                  "Speak with this program and its arguments; each text is a line on its standard input")
      ->needs("--scene")
      ->excludes("--speak");
  all->add_option("--seed", options.reach.seed, "Seed of the simulated participants [1]");
  all->add_option("--threads", options.threads, "Number of processes; the data do not depend on it [2]")
      ->check(CLI::Range(1, 64));
  for (CLI::App* command : {run, all, tables})
    command->add_option("--data", options.data, "Folder of the study's data [data]");
  tables->add_flag("--unblind", options.unblinds, "Write the names of conditions instead of letters");
}

}  // namespace
}  // namespace hrt::experiment

namespace {

int run_from(int argc, char** argv) {
  CLI::App app(
      "Runs a study of haptic retargeting by touch, from its design to its data. The program has been run with\n"
      "simulated participants only.",
      "hrt-experiment");
  app.require_subcommand(1);
  setenv("XR_LOADER_DEBUG", "none", 0);
  hrt::experiment::Options options;
  options.reach.hands = {hrt::app::Hand::right};
  options.reach.plugin = hrt::app::default_plugin();
  hrt::experiment::add_commands(app, options);
  try {
    app.parse(argc, argv);
    if (!std::cout.flush())
      throw hrt::Refusal(
          "standard output cannot be written: it is closed, or the disk is full; redirect it to another disk");
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "hrt-experiment: " << error.what() << " (see --help)\n";
    return 2;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_from(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "hrt-experiment: " << error.what() << "\n";
    return 1;
  }
}
