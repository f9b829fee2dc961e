// hrt-reach from its command line to its exit code.
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "samples/app/base/exit_code.h"
#include "samples/app/base/interrupt.h"
#include "samples/app/base/say.h"
#include "samples/app/finger/touch_frame.h"
#include "samples/app/run/finger_record.h"
#include "samples/app/run/make_plate.h"
#include "samples/app/run/reach.h"
#include "samples/app/run/registration.h"
#include "samples/app/run/set_up.h"
#include "samples/app/text/format.h"
#include "samples/app/text/whole_file.h"
#include "samples/reach/choice.h"
#include "samples/reach/command_line.h"
#include "samples/reach/files.h"
#include "samples/reach/measure_tracker.h"
#include "samples/reach/table.h"

namespace hrt::reach {
namespace {

constexpr int losses_allowed = 3;    // lost sessions or instances without a finished reach or slide in between
constexpr int unfinished_limit = 3;  // the run ends at this number of unfinished reaches in a row

// Thrown during a reach when the person requests another reach.
struct OtherReach : std::exception {
  explicit OtherReach(bool previous) : is_previous(previous) {}
  const char* what() const noexcept override { return "another reach is wanted"; }
  bool is_previous;  // the previous reach is requested; false: the next one
};

// Handles the keys of the person in every frame of one session, and reports recentring.
class KeyHandler {
 public:
  KeyHandler(Prompt& prompt, const RunContext& context) : prompt_(prompt), context_(context) {}

  // Call it when the plate's pose is known, so that the `w` key can give the finger's position.
  void plate_is_placed() { is_placed_ = true; }
  void reaches_begin() { in_reaches_ = true; }

  // Handles the pressed keys. Throws OtherReach, or Interrupted for the key that stops the run.
  void handle(XrTime time) {
    if (context_.session.recentrings() != recentrings_) {
      recentrings_ = context_.session.recentrings();
      prompt_.say("The view was centred again. The position of the plate in the room is unchanged.");
    }
    while (const std::optional<char> key = prompt_.key()) handle_key(*key, time);
  }

 private:
  void handle_key(char key, XrTime time) {
    switch (key) {
      case 'r':
        return prompt_.repeat();
      case 'w':
        return say_where(time);
      case 'h':
      case '?':
        return prompt_.say(keys_in_words);
      case 'q':
        throw Interrupted();
      case 'n':
      case 'b':
        if (in_reaches_) throw OtherReach(key == 'b');
        return prompt_.say("This key has an effect during reaches only.");
      default:
        return;
    }
  }

  void say_where(XrTime time) {
    FingerRecord now(context_.targets.start_m);
    for (const Hand hand : {Hand::left, Hand::right}) now.add(hand, locate(context_, hand, time));
    prompt_.say(now.where(context_, is_placed_));
  }

  Prompt& prompt_;
  const RunContext& context_;
  bool is_placed_ = false;
  bool in_reaches_ = false;
  int recentrings_ = 0;
};

// One run: reaches, a calibration or a measurement of the tracker. A lost session or instance is created again.
class Run {
 public:
  explicit Run(const Options& options)
      : options_(options),
        plugin_(options.plugin),
        targets_(load_targets(plugin_, options)),
        pairs_(choose(targets_, options)),
        table_(pairs_),
        marks_(options.marks.empty() ? marks_of(targets_) : read_marks(options.marks)),
        status_(options.verbose),
        prompt_(options.speak_with, [this](const std::string&) { status_.clear(); }) {
    for (const auto& file : {options.calibrate, options.register_to})
      if (const std::string why = file.empty() ? "" : why_not_writable(file); !why.empty())
        throw Failure(ExitCode::output, file.string() + " cannot be written: " + why + "; select another file");
    if (!options.registered.empty()) registered_ = read_registration(options.registered);
    if (!options.profile.empty()) load_profile(plugin_, targets_.session, options.profile);
    if (!options.finger.empty()) {
      touch_.emplace(options.finger);
      hrt_session_config config{.struct_size = sizeof config};
      plugin_.check(plugin_.hrt_session_get(targets_.session, &config, nullptr));
      touch_->configure(config.tracker);
      plugin_.check(plugin_.hrt_session_set(targets_.session, &config));
    }
    recording_.emplace(plugin_, targets_.session, options.record);
  }

  ~Run() {
    calibration_.reset();
    plugin_.hrt_session_destroy(targets_.session);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  // The recording has all finished reaches, also after a failure.
  ExitCode run() {
    ExitCode code = ExitCode::success;
    try {
      run_in_sessions();
    } catch (const Interrupted&) {
      prompt_.say(calibrates()               ? "The calibration was interrupted; no profile was written."
                  : options_.measure_tracker ? "The measurement was interrupted; start it again."
                                             : "The run was interrupted; the unfinished reach is not counted.");
      code = ExitCode::interrupted;
    } catch (const std::exception& error) {
      status_.clear();
      keep_recording_as_it_is();
      prompt_.speak(dynamic_cast<const XrFailure*>(&error) == nullptr
                        ? error.what()
                        : "The OpenXR runtime failed. Restart it, then start again.");  // run_from() prints the text
      prompt_.finish();
      throw;
    }
    code = calibrates() ? finish_calibration(code) : finish_reaches(code);
    prompt_.finish();
    return code;
  }

 private:
  bool calibrates() const { return !options_.calibrate.empty(); }
  bool is_done() const {
    return tracker_is_measured_ || (calibrates() ? calibrated_.has_value() : next_ == pairs_.size());
  }
  std::size_t slides_made() const { return calibration_ ? calibration_->done() : next_; }

  void run_in_sessions() {
    int losses = 0;
    while (!is_done()) {
      const std::size_t before = slides_made();
      try {
        run_in_one_session();
      } catch (const XrLost& lost) {
        losses = slides_made() == before ? losses + 1 : 1;
        if (losses > losses_allowed)
          throw Failure(ExitCode::runtime_failed, std::string("the OpenXR runtime was lost repeatedly: ") +
                                                      lost.what() + "; restart the runtime, then start again");
        status_.clear();
        std::cerr << "hrt-reach: " << lost.what() << "; connecting again\n";
        prompt_.speak("The connection to the headset was lost. The program connects again.");
      }
    }
  }

  void run_in_one_session() {
    XrRuntime runtime({XR_HRTX_RIDGED_PLATE_EXTENSION_NAME, local_floor_extension});
    XrHeadlessSession session(runtime, spaces_, options_.runtime_limit);
    std::optional<Simulation> simulation;
    if (runtime.enabled(XR_HRTX_RIDGED_PLATE_EXTENSION_NAME)) simulation.emplace(runtime, session);
    // Null: a person is instructed by text and speech. The mock runtime may still simulate a user, who feels the plate.
    Simulation* const instructed = simulation && !options_.person ? &*simulation : nullptr;
    if (instructed != nullptr) {
      session.place_plate(session.floor_space(), targets_.plate_pose);
      // The same participant continues in a new session.
      instructed->seed(options_.seed, static_cast<std::uint32_t>(next_));
    } else {
      prompt_.listen();
      if (touch_)
        scene_place_ = {session.floor_space(), targets_.plate_pose,
                        "The position of the plate relative to the touch frame is that of --finger."};
      // place_of() may wait for an answer. An open plate, which needs service() in each frame, would stop meanwhile.
      if (!is_registered() && !scene_place_) scene_place_ = place_of(targets_, session, options_.eye_height_m, prompt_);
    }
    const std::unique_ptr<Plate> plate =
        make_plate(options_.plate, simulation ? &*simulation : nullptr, session, runtime.name());
    is_simulated_ = instructed != nullptr;
    print_header_once(runtime, *plate);

    RunContext context{.plugin = plugin_,
                       .targets = targets_,
                       .session = session,
                       .simulation = instructed,
                       .plate = *plate,
                       .hands = options_.hands,
                       .time_limit_ns = static_cast<XrDuration>(options_.time_limit_s * 1e9),
                       .on_frame = [this](const TargetPair& pair, const Moment& m) { status_.show(pair, m); },
                       .tell_user = [this](const std::string& what) { prompt_.ask(what); },
                       .hint = [this](const std::string& what) { prompt_.hint(what); },
                       .handle_keys = {},
                       .touch = touch_ ? &*touch_ : nullptr};
    KeyHandler keys(prompt_, context);
    context.handle_keys = [&](XrTime time) { keys.handle(time); };
    if (options_.measure_tracker) {
      if (instructed != nullptr)
        throw Failure(ExitCode::usage, "--measure-tracker needs a person, who touches dimples: add --person");
      session.place_plate(session.steady_space(), world);
      const std::string text = measure_tracker(context);
      std::cout << text;
      prompt_.speak(text.substr(0, text.find(',')) + ".");
      tracker_is_measured_ = true;
      return session.end();
    }
    if (is_registered())
      find_plate(context);
    else if (instructed == nullptr)
      place_by_scene(session);
    if (simulation) simulation->place_plate(session.plate_space(), targets_.plate_radius_m);
    keys.plate_is_placed();
    if (calibrates()) calibrate(context);
    keys.reaches_begin();
    checked_ = true;  // by find_plate(), if the plate is registered
    while (!is_done()) make_next_reach(context);
    session.end();
  }

  bool is_registered() const { return registered_ || !options_.register_to.empty(); }

  void place_by_scene(XrHeadlessSession& session) {
    prompt_.say(scene_place_->words);
    session.place_plate(scene_place_->space, scene_place_->pose);
  }

  // Takes the plate's pose from touches in this run or an earlier one, instead of from the scene.
  void find_plate(RunContext& context) {
    if (context.simulation != nullptr)
      throw Failure(ExitCode::usage,
                    "--register and --registered need a person, who touches the marks: add --person, or use a runtime "
                    "that does not simulate its user");
    if (registered_) return void(check_plate(context, *registered_));
    registered_ = register_plate(context, marks_, options_.fingertip);
    write_registration(options_.register_to, registration_text(*registered_, context.session));
  }

  void calibrate(RunContext& context) {
    if (!calibration_) {
      hrt_setup_config config = hrt_setup_config_init();
      config.max_slides = options_.max_slides;
      calibration_.emplace(plugin_, targets_.session, HRT_SETUP_CALIBRATION, config);
      context.tell_user(
          format("Please slide one fingertip straight ahead many times. Shut your eyes during each slide, and move in "
                 "the direction that feels straight ahead. There are 16 to %u slides. Before each slide, you may rest "
                 "your hand for up to %.0f seconds.",
                 options_.max_slides, options_.time_limit_s));
    }
    calibrated_ = calibration_->run(context, &std::cout);
    check_output();
  }

  // Makes one reach. A reach that does not begin or end is reported; the third one in a row ends the run.
  void make_next_reach(RunContext& context) {
    const TargetPair& pair = pairs_[next_];
    try {
      if (options_.check_each && registered_ && !std::exchange(checked_, false)) check_plate(context, *registered_);
      if (const hrt_plate_report* report = context.plate.report()) plan_with(plugin_, targets_.session, *report);
      const ReachResult result = run_reach(context, pair);
      status_.clear();
      table_.print_row(std::cout, pair, result);
      tally_.add(pair, result);
      unfinished_in_a_row_ = 0;
      if (context.simulation == nullptr) prompt_.speak("Done.");
    } catch (const OtherReach& request) {
      status_.clear();
      if (request.is_previous) {
        if (next_ > 0) --next_;
        return;
      }
      table_.print_row(std::cout, pair, "skipped");
      ++tally_.skipped;
    } catch (const Failure& failure) {
      if (failure.code() != ExitCode::no_hand) throw;
      status_.clear();
      table_.print_row(std::cout, pair, "not made");
      prompt_.say(failure.what());
      ++tally_.unfinished;
      if (++unfinished_in_a_row_ == unfinished_limit && next_ + 1 < pairs_.size())
        throw Failure(ExitCode::no_hand, format("%d reaches in a row did not begin or end in time; see the messages "
                                                "above, or allow more time (--time-limit)",
                                                unfinished_limit));
    }
    check_output();
    ++next_;
  }

  ExitCode finish_reaches(ExitCode code) {
    if (options_.measure_tracker) return code;
    std::ostringstream summary;
    print_summary(summary, tally_);
    table_.print_legend(std::cout);
    std::cout << summary.str();
    check_output();
    recording_->finish();
    if (!is_simulated_) prompt_.speak(summary.str());
    if (code != ExitCode::success) return code;
    if (tally_.unfinished > 0) return ExitCode::no_hand;
    return tally_.feasible_reached < tally_.feasible ? ExitCode::target_missed : ExitCode::success;
  }

  ExitCode finish_calibration(ExitCode code) {
    if (!calibrated_) {
      recording_->finish();
      return code;
    }
    hrt_session_config config{.struct_size = sizeof config};
    plugin_.check(plugin_.hrt_session_get(targets_.session, &config, nullptr));
    std::cout << "\n" << calibration_text(*calibrated_, config) << verdict_text(*calibrated_);
    if (calibrated_->done == 0) {
      keep_recording_as_it_is();
      const char* const why =
          "no profile was written: the slides do not determine the user's parameters; calibrate again with slower, "
          "even slides";
      prompt_.speak(why);
      prompt_.finish();
      throw Failure(ExitCode::calibration, why);
    }
    save_profile(plugin_, targets_.session, options_.calibrate);
    recording_->finish();
    check_output();
    prompt_.speak(verdict_text(*calibrated_));
    return is_enough(*calibrated_) ? ExitCode::success : ExitCode::target_missed;
  }

  // Prints a failure instead of throwing it.
  void keep_recording_as_it_is() {
    try {
      recording_->finish();
    } catch (const Failure& failure) {
      say(format("hrt-reach: %s\n", failure.what()));
    }
  }

  std::string origin() const {
    if (!is_simulated_) return "Perceived directions are estimates of the controller.";
    return "SIMULATION, seed " + std::to_string(options_.seed) + ": no person took part.";
  }

  static void check_output() {
    if (!std::cout.flush())
      throw Failure(
          ExitCode::output,
          "standard output cannot be written: its reader has closed it, or the disk is full; send it elsewhere");
  }

  void print_header_once(const XrRuntime& runtime, const Plate& plate) {
    if (std::exchange(header_printed_, true)) return;
    std::cout << "OpenXR runtime: " << runtime.name() << ". " << origin() << "\n";
    if (const std::string device = plate.description(); !device.empty()) std::cout << device << "\n";
    if (touch_) std::cout << touch_->description() << "\n";
    if (!calibrates() && !options_.measure_tracker) table_.print_header(std::cout);
    check_output();
    name_conditions(plugin_, targets_.session, options_.plate, touch_ ? touch_->description() : runtime.name());
  }

  const Options& options_;
  Plugin plugin_;
  TargetSet targets_;
  std::vector<TargetPair> pairs_;
  Table table_;
  std::vector<Mark> marks_;
  std::optional<RegisteredPlate> registered_;
  std::optional<ScenePlace> scene_place_;
  SpaceMotion spaces_;
  std::optional<TouchFrame> touch_;  // unset: the runtime tracks hands
  StatusLine status_;
  Prompt prompt_;
  std::optional<RecordingFile> recording_;
  std::size_t next_ = 0;
  int unfinished_in_a_row_ = 0;
  bool checked_ = false;  // the registration has been checked for the next reach
  bool header_printed_ = false;
  bool tracker_is_measured_ = false;
  bool is_simulated_ = false;
  Tally tally_;
  std::optional<SetUp> calibration_;  // set if the run calibrates instead of reaching
  std::optional<hrt_setup_result> calibrated_;
};

int run_from(int argc, char** argv) {
  Options options;
  try {
    if (const std::optional<int> code = parse_command_line(argc, argv, options)) return *code;
    watch_runtime(options.runtime_limit);
    return static_cast<int>(Run(options).run());
  } catch (const Failure& failure) {
    std::cerr << "hrt-reach: " << failure.what() << "\n";
    return static_cast<int>(failure.code());
  } catch (const XrFailure& failure) {
    std::cerr << "hrt-reach: the OpenXR runtime failed: " << failure.what()
              << "; restart the runtime, then start again\n";
    return static_cast<int>(ExitCode::runtime_failed);
  } catch (const std::exception& error) {
    std::cerr << "hrt-reach: " << error.what() << "\n";
    return static_cast<int>(ExitCode::internal);
  }
}

}  // namespace
}  // namespace hrt::reach

int main(int argc, char** argv) {
  hrt::app::note_interrupts();
  std::signal(SIGPIPE, SIG_IGN);  // check_output() reports a closed output
  // Suppresses the messages of the OpenXR loader, unless the user has set this variable.
  setenv("XR_LOADER_DEBUG", "none", 0);
  return hrt::reach::run_from(argc, argv);
}
