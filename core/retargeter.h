// One reach: the tracked fingertip in, the plate's orientation out. A sample passes through
//   estimate (person_estimator), aim, plan (reach_control), limit (plate_limits), command
// in a reach of a person (person_reach), and with the controller of the paper through
//   estimate (reach_estimator), aim (authority), plan (paper_control), limit (plate_limits), command.
//
// Samples may come at any rate. Exact directions move the paper's controller once a model step; each position
// moves either controller, since each refines the estimate. In between the command is held.
#pragma once

#include <cstdint>
#include <optional>

#include "core/finger_sample.h"
#include "core/paper_control.h"
#include "core/person_belief.h"
#include "core/person_reach.h"
#include "core/plate_limits.h"
#include "core/plate_model.h"
#include "core/reach.h"
#include "core/reach_estimator.h"

namespace hrt {

/// What decides the plate's orientation.
enum class ControlMode {
  mpc,          ///< the controller of paper section III
  reach,        ///< the controller for people, where positions are streamed; with directions alone, as mpc
  fixed_plate,  ///< none: the plate stays at RetargeterConfig::fixed_plate_orientation_deg (paper Fig. 8)
};

/// The defaults are the paper's controller.
struct RetargeterConfig {
  Participant participant;  ///< whom the controller assumes; w_T is where adaptation starts
  MpcConfig mpc;
  ControlMode mode = ControlMode::mpc;
  double fixed_plate_orientation_deg = 0.0;   ///< finite
  EstimatorConfig estimator;                  ///< of the paper's person
  PlateDynamics plate;                        ///< its latency at most `max_lead` model steps
  std::int64_t step_period_ns = 100'000'000;  ///< 1 ms to 10 s
  PersonBelief person = unknown_person();     ///< whom the controller for people assumes
  ReachControlConfig reach;
  std::int64_t tracker_latency_ns =
      0;                     ///< from a motion to its sample's time, 0 to 0.5 s; of ControlMode::reach
  bool plate_waits = false;  ///< do not turn the plate before the finger moves; of ControlMode::reach
};

/// True if every field is in its range.
bool is_valid(const RetargeterConfig& config);

/// Runs one reach after another. No heap, no lock, no exception. One thread at a time.
class Retargeter {
 public:
  /// Requires is_valid(config).
  explicit Retargeter(const RetargeterConfig& config);

  /// Starts a reach; whatever the last one left is forgotten. Requires is_valid(reach,
  /// config.participant).
  void begin(const Reach& reach);

  /// Takes one sample in and returns the command that holds now. Requires begin(); the sample's time must
  /// not be before the last one's. However long the gap, at most StepClock::max_catch_up_steps are predicted.
  PlateCommand update(const FingerSample& sample);

  /// The paper's loop, without a clock: one model step with the finger moving along
  /// `finger_direction_deg` (finite). Requires begin(); not to be mixed with update() in one reach.
  PlateCommand step(double finger_direction_deg);

  /// The last one; begin()'s before the first sample.
  PlateCommand command() const { return person_ ? person_->command() : command_; }
  ReachSummary summary() const;
  /// The reach is led by the controller for people.
  bool leads_person() const { return person_.has_value(); }
  /// What the reach says of the person, for carried(); none if it ended early, did not fit the model, or had
  /// no positions under ControlMode::reach.
  std::optional<PersonBelief> learnt() const { return person_ ? person_->learnt() : std::nullopt; }

 private:
  /// Where the finger is wanted.
  struct Aim {
    double direction_deg;
    bool unreachable;
  };
  /// What the plate was last turned to, and for what.
  struct Decision {
    std::int64_t step = -1;
    Aim aim;
    PlateOrientation plate;
  };
  /// The finger as commands and summary show it.
  struct Finger {
    double direction_deg;
    double perceived_direction_deg;
    double tactile_weight;
    double tactile_weight_sd;
  };

  void lead_by_directions();
  Aim aim(const ReachState& state) const;
  PlateOrientation plan(const ReachState& state, const Aim& aim);
  void decide(const Decision& decision);
  Finger finger(const ReachState& state, double plate_orientation_deg) const;
  PlateCommand publish(const ReachState& state, bool held);
  double distance_to_go_m() const;

  RetargeterConfig config_;
  Reach reach_{};
  double goal_deg_ = 0.0;
  PlatePoint target_;
  std::optional<PersonReach> person_;  // none under the paper's controller, and once directions are streamed
  ReachEstimator estimator_;
  PaperControl control_;
  PlateLimits limits_;
  PlateModel plate_;
  Decision decision_{};
  Finger finger_{};
  PlateCommand command_;
  std::int64_t saturated_steps_ = 0;  // without the last decision's
  std::int64_t rate_limited_steps_ = 0;
};

}  // namespace hrt
