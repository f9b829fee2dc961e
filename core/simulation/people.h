// Families of simulated people, trackers and plates, with which the controllers are evaluated.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/plate/plate_model.h"
#include "core/simulation/person.h"
#include "core/simulation/tracker.h"

namespace hrt {

/// A move of both targets during a reach.
struct TargetMove {
  double at_share = 1.0;  ///< fraction of the distance to the real target at which this happens
  PlatePoint by;
};

/// A person with an apparatus.
struct PersonCondition {
  Person person;
  TrackerModel tracker;
  PlateDynamics plate{.max_speed_deg_s = 400.0, .latency_ns = 30'000'000};  ///< true dynamics
  double plate_offset_deg = 0.0;  ///< rotation of the ridges from the orientation that the controller assumes
  double real_direction_deg = -5.0;
  double virtual_direction_deg = 5.0;
  double distance_mm = 100.0;
  std::optional<TargetMove> move;  ///< within each reach
  /// After each reach the finger meets an object, and its place is known to this (SD); 0: none.
  double contact_sd_mm = 0.0;
  bool random_side = false;  ///< each reach has its real target to a side of the virtual one that is drawn
  bool faulty = false;       ///< each reach has a fault of tracker or plate, see draw_fault()
};

enum class FamilyKind {
  invented,   ///< traits are guesses about people and apparatus
  recorded,   ///< path and pace have the statistics of recorded reaches; the answer to touch is invented
  misplaced,  ///< the tracker's frame or the plate's zero is wrong, which a reach does not show
};

/// A kind of people or apparatus.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): in the order in which the table reads best
struct PeopleFamily {
  const char* name;
  const char* says;  ///< description for tables
  bool tuned;        ///< the controller's numbers were searched with it; with others only its last settings were
                     ///< compared
  void (*set)(PersonCondition& condition, Draws& draws);
  FamilyKind kind = FamilyKind::invented;
};

/// All families; the first is people whose illusion is linear.
std::span<const PeopleFamily> people_families();

/// Returns the family with that name, or null.
const PeopleFamily* people_family(const char* name);

/// Person `index` of a family, who moves for `duration_s`: w_T in 0.12 to 0.30, gain 5 to 12 /s, delay up to
/// 120 ms, a first direction between the mid-line and the virtual target; gap 10 degrees to either side.
PersonCondition draw_person(const PeopleFamily& family, double duration_s, std::uint64_t seed, std::uint32_t index);

/// The person moves along `path`, at the pace of recorded reaches, tracked by a marker system of 0.2 mm at 100 Hz.
void move_as_recorded(PersonCondition& condition, OwnPath path);

/// Gives tracker or plate what one of the families of such faults has, or nothing: each as likely.
void draw_fault(PersonCondition& condition, Draws& draws);

/// Streams of Draws for person `index`.
namespace PersonStream {
enum : std::uint32_t { drawn, steering, tracking, touching, faults };
}

/// True if a plate within 75 degrees of the motion can hold the gap for this person: their largest felt shift
/// exceeds the gap and their bias.
bool can_hold(const PersonCondition& condition);

}  // namespace hrt
