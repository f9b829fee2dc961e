// The participant, and the experimenter beside them, as a session meets them.
#pragma once

#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/person.h>
#include <haptic_retargeting/profile.h>
#include <haptic_retargeting/recording.h>
#include <haptic_retargeting/setup.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "samples/experiment/data/journal.h"
#include "samples/experiment/design/design.h"

namespace hrt::experiment {

/// One reach that is to be made, in a session of the plugin that is being recorded.
struct ReachOrder {
  hrt_session session;
  hrt_target real_target;
  hrt_target virtual_target;
  double real_deg;
  double virtual_deg;
  double distance_m;
  double radius_m;  ///< of the real object; 0: unknown
  unsigned number;  ///< of all of the session, from 0
};

struct ReachOutcome {
  bool has_ended = false;
  std::string problem;      ///< why it does not count, beside the rules of validity; empty: nothing
  double end_m[3]{};        ///< of the fingertip, in plate coordinates
  double duration_s = 0.0;  ///< of the motion
  double peak_felt_error_deg = 0.0;
  bool is_truth = false;  ///< simulated; else the plugin's estimates
  hrt_reach_summary summary{};
};

/// Asked for by Subject::key() and during waits.
enum class Key { none, refuse, note, rest, stop_plate, unblind, leave };

/// The experimenter ends what is under way; key() has what is wanted instead. Calls that wait may throw it.
struct Ended : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Subject {
 public:
  virtual ~Subject() = default;

  virtual Now now() = 0;
  /// Sets a simulated clock to after the journal's last time.
  virtual void continue_after(const Now&) {}
  /// Names this run of the machine: its monotonic times can be compared.
  virtual std::string boot() const = 0;
  /// Fills in what the plate can do.
  virtual void plan(hrt_session_config&) const {}
  /// "simulated, seed 7", or a person and what tracks: the same in each process of a session.
  virtual std::string description() const = 0;
  /// Description of the plate, with what was measured of it at this start.
  virtual std::string plate() const { return {}; }
  /// Key that the experimenter has pressed since. After Key::stop_plate the next call waits until the session may
  /// continue.
  virtual Key key() { return Key::none; }
  virtual void say(const std::string& text) = 0;
  /// Shows the state of the session, for page.html.
  virtual void show(const nlohmann::json&) {}
  /// Reads a note, after Key::note.
  virtual std::string note() = 0;

  /// Marks of a plate that the person's touches find. Nothing: its place is simulated.
  virtual std::optional<hrt_setup_config> marks() const { return std::nullopt; }
  /// The plate is where touches found it. Returns its registration.
  virtual std::string registered(const hrt_session_config&) { return {}; }
  /// A touch shows whether the plate is where it was registered. Returns how far off it was, metres; nothing:
  /// elsewhere.
  virtual std::optional<double> verify(const std::string&) { return 0.0; }

  virtual bool consents() = 0;
  /// Runs one slide or touch of a set-up, from its begin to its end: gives each sample to `use`, which returns what the
  /// next step asks for, or nothing at the slide's end. `number` from 0; `from_ns`: time after the last
  /// sample.
  virtual void slide(hrt_session session, const hrt_setup_step& step, unsigned number, std::int64_t from_ns,
                     const std::function<std::optional<hrt_setup_step>(const hrt_sample&)>& use) = 0;
  /// Whole numbers or texts.
  virtual std::vector<nlohmann::json> fill_in(const Questionnaire& paper) = 0;
  virtual void rest(double minutes) = 0;
  /// The plate is at its home, the finger comes to the start, and reaches.
  virtual ReachOutcome reach(const ReachOrder& order) = 0;
  /// Index of the answer. `felt_deg`: largest perceived-direction error of each reach that the question is about, by
  /// which a simulated participant answers. `number`: of the reach, for draws.
  virtual unsigned answer(const std::string& question, const std::vector<std::string>& answers,
                          const std::vector<double>& felt_deg, unsigned number) = 0;
};

}  // namespace hrt::experiment
