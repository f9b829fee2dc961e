// Converts samples of the fingertip to plate orientations, one reach after another, with the controller for people
// (person_reach) or the paper's (paper_reach).
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "core/paper/paper_reach.h"
#include "core/person/person_reach.h"
#include "core/reach_end.h"
#include "core/retargeter_config.h"

namespace hrt {

/// Controller of successive reaches. All functions except begin(), has_person_controller(), person_filter() and
/// learnt() require a preceding begin(). Uses no heap, lock or exception. One thread at a time.
class Retargeter {
 public:
  /// Requires is_valid(config).
  explicit Retargeter(RetargeterConfig config);

  /// Begins a reach. Requires is_valid(reach, goal) for the goal direction of config.participant.
  void begin(const Reach& reach);

  /// Begins `reach`, which must be valid as in begin(), in place of the present one; the plate continues its motion.
  void begin_here(const Reach& reach);

  /// Processes one sample, not earlier than the previous one, and returns command().
  const PlateCommand& update(const FingerSample& sample);

  /// Moves the targets of the present reach; estimates are kept. Returns the remaining reach: the real target as seen
  /// from the finger, and the virtual target as seen from where the person will perceive the finger one reaction time
  /// later (the paper's participant has no reaction time). Before the finger moves, and without positions, both are
  /// seen from the start.
  Reach retarget(const PlatePoint& real, const PlatePoint& virtual_place);

  /// Advances the paper's controller by one model step, without a clock; the finger moves in `finger_direction_deg`
  /// (finite). Do not use step() and update() in the same reach.
  const PlateCommand& step(double finger_direction_deg);

  /// The last command; before the first sample, that of begin().
  const PlateCommand& command() const { return command_; }
  ReachSummary summary() const;
  bool has_person_controller() const { return controller_ && std::holds_alternative<PersonReach>(*controller_); }
  /// State of finger and person; null before begin() and under the paper's controller.
  const PersonFilter* person_filter() const {
    return has_person_controller() ? &std::get<PersonReach>(*controller_).filter() : nullptr;
  }
  /// Position of the finger; nullopt before the finger moves, and without positions.
  std::optional<FingerPosition> finger() const;
  /// Posterior of the person, for carried() of learning.h; nullopt under the paper's controller, and if the reach ended
  /// early or the model did not fit.
  std::optional<PersonBelief> learnt() const;

 private:
  void begin(const Reach& reach, const std::optional<PlateHandover>& handover);
  std::optional<PlateHandover> handover() const;
  void use_paper_controller();
  Reach reach_from_present_position(const PlatePoint& real, const PlatePoint& virtual_place);

  RetargeterConfig config_;
  Reach reach_{};  // argument of begin(), or result of the last retarget()
  ReachEnd end_;
  PlateCommand command_;
  // The waypoint is the start, then the position of the finger at each retarget() that is more than Tuning::min_leg_mm
  // from the waypoint before.
  PlatePoint waypoint_;
  PlatePoint perceived_waypoint_;  // where the person perceived the finger at the waypoint
  std::optional<std::variant<PersonReach, PaperReach>> controller_;  // nullopt before begin()
};

}  // namespace hrt
