// The gaps between real and virtual targets that the plate can sustain, and the assignment of real to virtual targets.
#pragma once

#include <span>
#include <vector>

#include "plugin/src/session/targets.h"

namespace hrt::plugin {

struct Gap {
  Authority authority;
  double paper_max_gap_deg;  ///< of the paper's model
  double bearing_sd_deg;     ///< of the bearing where reaches end, by registration and tracker alone
};

/// The gaps of one session. What depends on one target alone is derived once for that target.
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

/// The real target, by its index, that serves a virtual one; or the nearest if none can.
struct Served {
  std::size_t real;
  bool is_served;
  Gap gap;
};

/// For each virtual target. As many as possible are served, and of all such assignments the largest share of a gap in
/// the largest possible one is the smallest. `exclusive`: a real target serves one virtual target at most.
std::vector<Served> assign(const SessionModel& model, std::span<const Target* const> virtuals,
                           std::span<const Target* const> reals, bool exclusive);

}  // namespace hrt::plugin
