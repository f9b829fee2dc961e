#include "samples/reach/application.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "samples/reach/followed_plate.h"
#include "samples/reach/interrupt.h"
#include "samples/reach/output/status_line.h"
#include "samples/reach/output/svg_plot.h"
#include "samples/reach/output/table.h"
#include "samples/reach/reach.h"
#include "samples/reach/runtime_plate.h"
#include "samples/reach/serial_plate.h"
#include "samples/reach/simulated_servo.h"

namespace hrt::reach {
namespace {

constexpr int losses_allowed = 3;  // of the session or the instance, in a row

TargetSet load_targets(const Plugin& plugin, const Options& options) {
  hrt_session_config config;
  plugin.check(plugin.hrt_session_config_default(&config, sizeof config));
  constexpr double paper_tactile_weight = 0.15;
  if (!options.for_people) config.tactile_weight = paper_tactile_weight;
  if (options.tactile_weight) config.tactile_weight = *options.tactile_weight;
  config.adaptation = options.for_people ? HRT_ADAPTATION_CARRIED : HRT_ADAPTATION_OFF;
  config.guidance = options.for_people ? HRT_GUIDANCE_ARRIVAL : HRT_GUIDANCE_FIXED_DIRECTION;
  config.motor_variance_deg2 = options.motor_variance_deg2;
  return load_targets(plugin, options.scene, config);
}

// The reaches to make, in order.
std::vector<TargetPair> choose(const TargetSet& targets, const Options& options) {
  std::vector<TargetPair> chosen;
  if (options.targets.empty()) chosen = targets.pairs;
  for (const std::string& name : options.targets) {
    const auto found = std::find_if(targets.pairs.begin(), targets.pairs.end(),
                                    [&](const TargetPair& pair) { return pair.virtual_name == name; });
    if (found == targets.pairs.end())
      throw Failure(ExitCode::scene, "the scene has no virtual target named \"" + name + "\"");
    chosen.push_back(*found);
  }
  if (chosen.empty()) throw Failure(ExitCode::scene, "the scene has no virtual target");
  std::vector<TargetPair> all;
  for (int round = 0; round < options.repeat; ++round) all.insert(all.end(), chosen.begin(), chosen.end());
  return all;
}

std::unique_ptr<Plate> make_plate(const PlateChoice& choice, Simulation* simulation,
                                  const XrHeadlessSession& session, const std::string& runtime_name) {
  switch (choice.kind) {
    case PlateChoice::Kind::servo:
      return std::make_unique<SimulatedServo>(choice.servo_speed_deg_per_s);
    case PlateChoice::Kind::serial:
      return std::make_unique<SerialPlate>(choice.serial_device);
    case PlateChoice::Kind::runtime:
      break;
  }
  if (simulation == nullptr)
    throw Failure(ExitCode::plate,
                  "the OpenXR runtime " + runtime_name + " has no plate to turn; --plate names another one");
  return std::make_unique<RuntimePlate>(*simulation, session);
}

// The reaches of one run, across as many sessions and instances as the runtime makes necessary.
class Run {
 public:
  explicit Run(const Options& options)
      : options_(options),
        plugin_(options.plugin),
        targets_(load_targets(plugin_, options)),
        pairs_(choose(targets_, options)),
        table_(pairs_),
        status_(options.verbose) {
    open_plot();
    start_recording();
  }

  ~Run() { plugin_.hrt_session_destroy(targets_.session); }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  // However the run ends, the files keep the reaches made until then.
  ExitCode run() {
    ExitCode code = ExitCode::success;
    try {
      make_reaches();
    } catch (const Interrupted&) {
      status_.clear();
      std::cerr << "hrt-reach: interrupted; the unfinished reach does not count\n";
      code = ExitCode::interrupted;
    } catch (...) {
      status_.clear();
      keep_files_as_they_are();
      throw;
    }
    table_.print_legend(std::cout);
    print_summary(std::cout, tally_);
    check_output();
    stop_recording();
    write_plot();
    if (code == ExitCode::success && tally_.holdable_reached < tally_.holdable)
      code = ExitCode::target_missed;
    return code;
  }

 private:
  void make_reaches() {
    int losses = 0;
    while (next_ < pairs_.size()) {
      const std::size_t before = next_;
      try {
        run_in_one_session();
      } catch (const XrLost& lost) {
        status_.clear();
        losses = next_ == before ? losses + 1 : 1;
        if (losses > losses_allowed)
          throw Failure(ExitCode::runtime_failed,
                        std::string("the OpenXR runtime was lost repeatedly: ") + lost.what());
        std::cerr << "hrt-reach: " << lost.what() << "; starting anew\n";
      }
    }
  }

  // During a failure, which a second one must not hide.
  void keep_files_as_they_are() {
    try {
      stop_recording();
      write_plot();
    } catch (const Failure& failure) {
      std::cerr << "hrt-reach: " << failure.what() << "\n";
    }
  }

  // Makes instance and session, then the remaining reaches.
  void run_in_one_session() {
    XrRuntime runtime({XR_HRTX_RIDGED_PLATE_EXTENSION_NAME});
    XrHeadlessSession session(runtime, targets_.plate_pose, options_.runtime_limit);
    std::optional<Simulation> simulation;
    if (runtime.enabled(XR_HRTX_RIDGED_PLATE_EXTENSION_NAME) && !options_.person) {
      simulation.emplace(runtime, session);
      simulation->place_plate(targets_.plate_pose, targets_.plate_radius_m);
      // A new session has the same person.
      simulation->seed(options_.seed, static_cast<std::uint32_t>(next_));
    }
    std::unique_ptr<Plate> plate =
        make_plate(options_.plate, simulation ? &*simulation : nullptr, session, runtime.name());
    if (simulation && options_.plate.kind != PlateChoice::Kind::runtime)
      plate = std::make_unique<FollowedPlate>(std::move(plate), *simulation);
    if (const std::optional<PlateLimits> limits = plate->limits()) plan_with(*limits);
    is_simulated_ = simulation.has_value();
    print_header_once(runtime);

    Stage stage{.plugin = plugin_,
                .targets = targets_,
                .session = session,
                .simulation = simulation ? &*simulation : nullptr,
                .plate = *plate,
                .hands = options_.hands,
                .time_limit_ns = static_cast<XrDuration>(options_.time_limit_s * 1e9),
                .on_frame = [this](const TargetPair& pair, const Moment& m) { status_.show(pair, m); },
                .tell_user = [](const std::string& what) { std::cerr << what << "\n"; }};
    for (; next_ < pairs_.size(); ++next_) {
      const ReachResult result = run_reach(stage, pairs_[next_]);
      status_.clear();
      table_.print_row(std::cout, pairs_[next_], result);
      check_output();
      tally_.add(pairs_[next_], result);
      if (plot_.is_open() && plotted_.size() <= most_plotted) plotted_.push_back({pairs_[next_], result});
    }
    session.end();
  }

  // The device's own limits replace the scene's.
  void plan_with(const PlateLimits& limits) {
    constexpr double least_turn_deg = 180.0;  // that the plugin can plan with: ridges repeat so
    hrt_session_config config{.struct_size = sizeof config};
    plugin_.check(plugin_.hrt_session_get_config(targets_.session, &config));
    config.plate_max_speed_deg_s = limits.speed_deg_s;
    if (limits.most_deg - limits.least_deg >= least_turn_deg) {
      config.plate_lower_stop_deg = limits.least_deg;
      config.plate_upper_stop_deg = limits.most_deg;
    }
    plugin_.check(plugin_.hrt_session_set_config(targets_.session, &config));
  }

  // Whose numbers these are.
  std::string origin() const {
    if (!is_simulated_) return "Tracked directions; felt ones as the model predicts.";
    return "SIMULATION, seed " + std::to_string(options_.seed) + ": no person took part.";
  }

  void start_recording() {
    if (options_.record.empty()) return;
    if (plugin_.hrt_recording_start(targets_.session, options_.record.c_str()) != HRT_OK)
      throw Failure(ExitCode::output, plugin_.hrt_last_error());
  }

  void stop_recording() {
    if (options_.record.empty()) return;
    hrt_recording_status status{.struct_size = sizeof status};
    plugin_.check(plugin_.hrt_recording_stop(targets_.session, &status));
    if (status.rows_lost > 0 || status.system_error != 0)
      throw Failure(ExitCode::output, options_.record.string() + " is not complete: " +
                                          std::to_string(status.rows_lost) + " rows could not be written");
  }

  // The reader of the rows may have closed the pipe.
  static void check_output() {
    if (!std::cout.flush()) throw Failure(ExitCode::output, "the standard output cannot be written");
  }

  void open_plot() {
    if (options_.plot.empty()) return;
    plot_.open(options_.plot);
    if (!plot_) fail_to_plot();
  }

  void write_plot() {
    if (!plot_.is_open()) return;
    plot_ << svg_of(plotted_, targets_, origin()) << std::flush;
    if (!plot_) fail_to_plot();
  }

  [[noreturn]] void fail_to_plot() const {
    throw Failure(ExitCode::output, options_.plot.string() + " cannot be written: " + std::strerror(errno));
  }

  void print_header_once(const XrRuntime& runtime) {
    if (std::exchange(header_printed_, true)) return;
    std::cout << "OpenXR runtime: " << runtime.name() << ". " << origin() << "\n";
    table_.print_header(std::cout);
    check_output();
  }

  const Options& options_;
  Plugin plugin_;
  TargetSet targets_;
  std::vector<TargetPair> pairs_;
  Table table_;
  StatusLine status_;
  std::size_t next_ = 0;
  bool header_printed_ = false;
  bool is_simulated_ = false;
  std::ofstream plot_;
  std::vector<PlottedReach> plotted_;
  Tally tally_;
};

}  // namespace

ExitCode run(const Options& options) {
  return Run(options).run();
}

}  // namespace hrt::reach
