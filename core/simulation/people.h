// Families of simulated people, trackers and plates, and reaches of them one after another: what the
// controller for people is measured on. Results are of simulation.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/retargeter.h"
#include "core/simulation/person.h"

namespace hrt {

/// A tracker of the fingertip.
struct TrackerModel {
  double rate_hz = 90.0;
  double white_m = 0.0012;    ///< noise of a coordinate, standard deviation, anew at each sample
  double correlated_m = 0.0;  ///< and decaying within correlation_s
  double correlation_s = 0.1;
  double latency_s = 0.0;           ///< from a motion to its sample
  double declared_latency_s = 0.0;  ///< of it, what the controller is given
  double late_s = 0.0;         ///< samples come up to this later still, each anew; less than between samples
  double outlier_share = 0.0;  ///< of samples that are off by 30 mm, standard deviation
  double dropout_share = 0.0;  ///< of samples at which tracking is lost, for some ten samples
  double jitter_share = 0.0;   ///< of the time between samples
  double turned_deg = 0.0;     ///< of its frame about the start
  double scale = 1.0;          ///< of its frame about the start
  double shear = 0.0;          ///< seen to the right by this for each metre away from the start
};

/// Both targets are elsewhere from some moment of a reach on.
struct TargetMove {
  double at_share = 1.0;  ///< of the distance to the real target, once the finger is as far from the start
  PlatePoint by;
};

/// One person with an apparatus.
struct PersonCondition {
  Person person;
  TrackerModel tracker;
  PlateDynamics plate{.max_speed_deg_s = 400.0, .latency_ns = 30'000'000};  ///< as it is
  double plate_offset_deg = 0.0;  ///< of the ridges from where the controller believes that they stand
  double real_direction_deg = -5.0;
  double virtual_direction_deg = 5.0;
  double distance_m = 0.1;
  std::optional<TargetMove> move;  ///< within each reach
};

/// A kind of people or apparatus.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): in the order in which the table reads best
struct PeopleFamily {
  const char* name;
  const char* says;  ///< what sets them apart, for tables
  bool tuned;  ///< the controller's numbers were searched with it; with others only its last settings were
               ///< compared
  void (*set)(PersonCondition& condition, Draws& draws);
  /// The tracker's frame or the plate's zero is off: no controller sees that in a reach.
  bool misplaced = false;
};

/// All families; the first is people whose illusion is linear.
std::span<const PeopleFamily> people_families();

/// The family of that name; null if there is none.
const PeopleFamily* people_family(const char* name);

/// Person `index` of a family, who moves for `duration_s`: w_T in 0.12 to 0.30, gain 5 to 12 /s, delay up to
/// 120 ms, a first direction between the mid-line and the virtual target; gap 10 degrees to either side.
PersonCondition draw_person(const PeopleFamily& family, double duration_s, std::uint64_t seed,
                            std::uint32_t index);

/// True if a plate within 75 degrees of the motion can hold the gap for this person: their largest felt shift
/// exceeds the gap and their bias.
bool can_hold(const PersonCondition& condition);

/// How a reach ended: truth, not estimate.
struct PersonOutcome {
  double bearing_error_deg;            ///< bearing of the end from the start, less the real target's
  double miss_m;                       ///< across the real direction, signed as bearing_error_deg
  double peak_felt_error_deg;          ///< largest felt less virtual direction while the finger moves
  ReachSummary summary;                ///< the controller's own account; zero without a controller
  std::optional<PersonBelief> learnt;  ///< what the next reach begins from, if this one taught anything
};

/// `reaches` of one person, one after another, each led by `controller` with what it has learnt; as
/// ControlMode::reach carries it. Without a controller (null) the plate stays at 0. Any thread.
std::vector<PersonOutcome> simulate_person(const PersonCondition& condition,
                                           const RetargeterConfig* controller, int reaches,
                                           std::uint64_t seed, std::uint32_t index);

/// A controller for people that knows what the usual plate and tracker can do, and nothing of the person.
RetargeterConfig people_controller();

/// The same, with the tracker's declared latency.
RetargeterConfig people_controller(const PersonCondition& condition);

/// A controller for people with plate, tracker and person known, as far as its model has words for them.
RetargeterConfig informed_controller(const PersonCondition& condition);

/// The paper's, with w_T assumed 0.15.
RetargeterConfig paper_controller();

}  // namespace hrt
