#include "plugin/src/session/gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/assignment.h"
#include "core/math/distributions.h"
#include "core/math/elementary.h"
#include "core/person/person_model.h"

namespace hrt::plugin {
namespace {

double needed_share(const GapFeasibility& feasibility) {
  if (!feasibility.reachable) return std::numeric_limits<double>::infinity();
  return feasibility.gap_deg == 0.0 ? 0.0 : std::abs(feasibility.gap_deg) / feasibility.max_gap_deg;
}

}  // namespace

Gaps::Real Gaps::real(const TargetPlace& place) const {
  const TargetView seen = view(model_, place);
  return {seen.direction_deg,
          in_quadrature(bearing_sd_deg(model_.control.touched, model_.control.frame, start_of(model_), seen.point),
                        model_.control.tracker_bearing_sd_deg),
          illusion_of(model_, seen.distance_mm)};
}

double Gaps::goal_deg(const TargetPlace& virtual_place) const {
  const RetargeterConfig& control = model_.control;
  return view(model_, virtual_place).direction_deg +
         (control.mode == ControlMode::reach ? control.person.mean(PersonState::bias) : control.participant.bias_deg);
}

Gap Gaps::gap(const Real& real, double goal_deg) const {
  const RetargeterConfig& control = model_.control;
  const double real_deg = goal_deg - wrap_deg(goal_deg - real.direction_deg, 360.0);
  const GapFeasibility paper =
      paper_gap_feasibility(real_deg, goal_deg, control.participant.tactile_weight, control.mpc.plate_bound_deg);
  return {.feasibility = control.mode == ControlMode::reach
                             ? gap_feasibility(real_deg, goal_deg, real.illusion, control.reach.bound_deg)
                             : paper,
          .paper_max_gap_deg = paper.max_gap_deg,
          .bearing_sd_deg = real.bearing_sd_deg};
}

std::vector<Assigned> assign(const SessionModel& model, std::span<const Target* const> virtuals,
                             std::span<const Target* const> reals, bool exclusive) {
  const Gaps gaps(model);
  std::vector<Gaps::Real> seen;
  for (const Target* real : reals) seen.push_back(gaps.real(real->place));
  std::vector<double> goals_deg, shares;
  std::vector<std::size_t> nearest, serves;
  for (const Target* virtual_target : virtuals) {
    const double goal_deg = goals_deg.emplace_back(gaps.goal_deg(virtual_target->place));
    double min_gap_deg = std::numeric_limits<double>::infinity(), min_share = min_gap_deg;
    nearest.push_back(0);
    serves.push_back(unserved);
    for (std::size_t j = 0; j < seen.size(); ++j) {
      const GapFeasibility feasibility = gaps.gap(seen[j], goal_deg).feasibility;
      const double share = shares.emplace_back(needed_share(feasibility));
      if (share < min_share) min_share = share, serves.back() = j;
      if (std::abs(feasibility.gap_deg) < min_gap_deg) min_gap_deg = std::abs(feasibility.gap_deg), nearest.back() = j;
    }
  }
  if (exclusive) serves = assign_exclusively(shares, reals.size());
  std::vector<Assigned> served;
  for (std::size_t i = 0; i < virtuals.size(); ++i) {
    const std::size_t real = serves[i] == unserved ? nearest[i] : serves[i];
    served.push_back({real, serves[i] != unserved, gaps.gap(seen[real], goals_deg[i])});
  }
  return served;
}

}  // namespace hrt::plugin
