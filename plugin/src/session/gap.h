#pragma once

#include <span>
#include <vector>

#include "plugin/src/session/targets.h"

namespace hrt::plugin {

struct Gap {
  GapFeasibility feasibility;
  double paper_max_gap_deg;  ///< largest feasible gap in the paper's model
  double bearing_sd_deg;     ///< SD of the bearing at which reaches end, due to registration and tracker alone
};

/// Gaps of the targets of one session. real() computes what all gaps of a real target have in common; gap() uses it.
class Gaps {
 public:
  struct Real {
    double direction_deg;
    double bearing_sd_deg;
    Illusion illusion;
  };

  explicit Gaps(const SessionModel& model) : model_(model) {}
  Real real(const TargetPlace& place) const;
  /// Direction in which the user aims at a virtual target: its direction plus the user's bias.
  double goal_deg(const TargetPlace& virtual_place) const;
  Gap gap(const Real& real, double goal_deg) const;

 private:
  const SessionModel& model_;
};

struct Assigned {
  std::size_t real;  ///< index of the assigned real target or, if none is assigned, of that with the smallest gap
  bool is_feasible;  ///< true if a real target is assigned; its gap is feasible
  Gap gap;
};

/// Assigns real targets to as many virtual ones as possible, with feasible gaps only. Among these assignments, returns
/// one whose largest ratio |gap| / largest feasible gap is minimal. `exclusive`: each real target is assigned at most
/// once.
std::vector<Assigned> assign(const SessionModel& model, std::span<const Target* const> virtuals,
                             std::span<const Target* const> reals, bool exclusive);

}  // namespace hrt::plugin
