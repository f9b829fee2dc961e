// The gaps between real and virtual targets that the plate can sustain, and the assignment of real to virtual targets.
#pragma once

#include <span>
#include <vector>

#include "plugin/src/session/targets.h"

namespace hrt::plugin {

struct Gap {
  Authority authority;
  double paper_max_gap_deg;  ///< largest gap in the paper's model
  double bearing_sd_deg;     ///< SD of the bearing at which reaches end, due to registration and tracker alone
};

/// Gaps of the targets of one session. Properties of a single target are computed once.
class Gaps {
 public:
  struct Real {
    double direction_deg;
    double bearing_sd_deg;
    Illusion illusion;
  };

  explicit Gaps(const SessionModel& model) : model_(model) {}
  Real real(const TargetPlace& place) const;
  /// Direction to which the person goes for a virtual target.
  double goal_deg(const TargetPlace& virtual_place) const;
  Gap gap(const Real& real, double goal_deg) const;

 private:
  const SessionModel& model_;
};

/// A real target, by its index, assigned to a virtual one; the nearest one if the gap cannot be sustained.
struct Served {
  std::size_t real;
  bool is_served;
  Gap gap;
};

/// Assigns a real target to each virtual one: to as many as possible, and such that the largest ratio of gap to largest
/// possible gap is minimal. `exclusive`: each real target is assigned at most once.
std::vector<Served> assign(const SessionModel& model, std::span<const Target* const> virtuals,
                           std::span<const Target* const> reals, bool exclusive);

}  // namespace hrt::plugin
