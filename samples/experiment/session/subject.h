// Interface of a session to the participant and the experimenter, human or simulated.
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

/// One reach to perform, in a recorded session of the plugin.
struct ReachOrder {
  hrt_session session;
  hrt_target real_target;
  hrt_target virtual_target;
  double real_deg;
  double virtual_deg;
  double distance_m;
  double radius_m;  ///< radius of the real object; 0: unknown
  unsigned number;  ///< number of the reach, for random draws; differs between the ended reaches of a session
};

struct ReachOutcome {
  bool has_ended = false;
  std::string problem;      ///< why the reach is invalid, apart from the rules of validity; empty: none
  double end_m[3]{};        ///< final position of the fingertip, in plate coordinates
  double duration_s = 0.0;  ///< duration of the motion
  double peak_felt_error_deg = 0.0;
  bool is_truth = false;  ///< peak_felt_error_deg is ground truth; false: the plugin's estimate
  hrt_reach_summary summary{};
};

/// Keys of the experimenter, returned by Subject::key().
enum class Key { none, note, rest, stop_plate, unblind, leave };

/// Thrown by calls that wait, if the experimenter interrupts the task; reach() returns a problem instead.
/// Subject::key() then returns the key, unless the key only marks a reach or slide as invalid.
struct Ended : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Subject {
 public:
  virtual ~Subject() = default;

  virtual Now now() = 0;
  /// Sets a simulated clock to the last time of the journal.
  virtual void continue_after(const Now&) {}
  /// Returns an identifier of the computer's boot; monotonic times of the same boot are comparable.
  virtual std::string boot() const = 0;
  /// Sets the fields of the configuration that describe plate, tracker, start and registration.
  virtual void plan(hrt_session_config&) const {}
  /// Returns the kind of participant and the tracker, if there is one; the same in each run of a session.
  virtual std::string description() const = 0;
  /// Returns a description of the plate; may be empty.
  virtual std::string plate() const { return {}; }
  /// Returns the last key that was pressed since the previous call. After Key::stop_plate, calls wait until the
  /// experimenter resumes or quits.
  virtual Key key() { return Key::none; }
  virtual void say(const std::string& text) = 0;
  /// Displays the state of the session on the live page.
  virtual void show(const nlohmann::json&) {}
  /// Returns the text of a note, after Key::note.
  virtual std::string note() = 0;

  /// Returns the marks for registration by touch; nullopt if the session does not register the plate by touch.
  virtual std::optional<hrt_setup_config> marks() const { return std::nullopt; }
  /// Applies the pose that was found by touches. Returns the registration as a text, which verify() reads.
  virtual std::string registered(const hrt_session_config&) { return {}; }
  /// Uses a registration, and checks it by one touch. Returns the distance of the touch from the mark in metres;
  /// nullopt if the plate must be registered again.
  virtual std::optional<double> verify(const std::string&) { return 0.0; }

  virtual bool consents() = 0;
  /// Runs one slide or touch of a set-up. Passes each sample to `use`, which returns the next step, or nullopt at the
  /// end of the slide or touch. `number`: number of the slide or touch in the set-up, from 0. `from_ns`: time of
  /// the previous sample; all samples must be later.
  virtual void slide(hrt_session session, const hrt_setup_step& step, unsigned number, std::int64_t from_ns,
                     const std::function<std::optional<hrt_setup_step>(const hrt_sample&)>& use) = 0;
  /// Asks a questionnaire. Returns an answer to each item: whole numbers or texts.
  virtual std::vector<nlohmann::json> fill_in(const Questionnaire& paper) = 0;
  virtual void rest(double minutes) = 0;
  /// Turns the plate to 0 degrees, waits for the finger at the start, and runs one reach.
  virtual ReachOutcome reach(const ReachOrder& order) = 0;
  /// Asks a question and returns the index of the answer. `felt_deg`: largest perceived-direction error of each reach
  /// of the trial, from which a simulated participant answers. `number`: number of the next reach, for random draws.
  virtual unsigned answer(const std::string& question, const std::vector<std::string>& answers,
                          const std::vector<double>& felt_deg, unsigned number) = 0;
};

}  // namespace hrt::experiment
