// One reach after another: the tracked fingertip in, the plate's orientation out. Chooses who leads a reach:
// the controller for people (person_reach) or the paper's (paper_reach).
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "core/paper/paper_reach.h"
#include "core/person/person_reach.h"
#include "core/reach_end.h"
#include "core/retargeter_config.h"

namespace hrt {

/// Runs one reach after another. Uses no heap, lock or exception. One thread at a time.
class Retargeter {
 public:
  /// Requires is_valid(config).
  explicit Retargeter(RetargeterConfig config);

  /// Starts a reach. Requires is_valid(reach) for the goal of config.participant.
  void begin(const Reach& reach);

  /// Restarts the reach from the first position of the finger; the plate continues to move. Requires begin(), and
  /// is_valid(reach) as there.
  void begin_here(const Reach& reach);

  /// Takes one sample in and returns command(). Requires begin(); the sample's time must
  /// not be before the last one's. However long the gap, at most StepClock::max_catch_up_steps are predicted.
  const PlateCommand& update(const FingerSample& sample);

  /// Redirects the reach to these positions of its targets. The reach continues from the position of the finger, with
  /// all estimates. Returns the reach as seen from there; the virtual target is seen from the position that the person
  /// will perceive at the time of the answer. Before the finger moves, and with directions alone, directions are seen
  /// from the start. Requires begin().
  Reach retarget(const PlatePoint& real, const PlatePoint& virtual_place);

  /// The paper's loop, without a clock: one model step with the finger moving along
  /// `finger_direction_deg` (finite). Requires begin(); not to be mixed with update() in one reach.
  const PlateCommand& step(double finger_direction_deg);

  /// The last one; begin()'s before the first sample. Valid until the next call. Requires begin().
  const PlateCommand& command() const { return command_; }
  /// Requires begin().
  ReachSummary summary() const;
  /// The reach is led by the controller for people.
  bool leads_person() const { return leader_ && std::holds_alternative<PersonReach>(*leader_); }
  /// The belief about finger and person; null where the paper's controller leads, and before
  /// begin().
  const PersonFilter* person_filter() const {
    return leads_person() ? &std::get<PersonReach>(*leader_).filter() : nullptr;
  }
  /// State of the finger; none before it moves, and with directions alone. Requires begin().
  std::optional<SeenFinger> finger() const;
  /// The belief about the person, for carried(); none if the reach ended early, did not fit the model, or had
  /// no positions under ControlMode::reach.
  std::optional<PersonBelief> learnt() const;

 private:
  void begin(const Reach& reach, const std::optional<PlateHandover>& handover);
  void observe(const FingerSample& sample);
  std::optional<PlateHandover> handover() const;
  void lead_by_directions();
  Reach seen_from_here(const PlatePoint& real, const PlatePoint& virtual_place);

  RetargeterConfig config_;
  Reach reach_{};  // the last aim
  ReachEnd end_;
  PlateCommand command_;
  // Position of the finger at that time or later, and the position that the person perceived.
  PlatePoint passed_;
  PlatePoint felt_passed_;
  // The paper's controller takes over if directions are streamed. None before begin().
  std::optional<std::variant<PersonReach, PaperReach>> leader_;
};

}  // namespace hrt
