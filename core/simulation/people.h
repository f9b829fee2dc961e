// Families of simulated people, trackers and plates, with which controllers are evaluated. A family is a distribution
// from which people are drawn; most families change one thing about the base model.
#pragma once

#include <cstdint>
#include <span>

#include "core/plate/plate_model.h"
#include "core/simulation/person.h"
#include "core/simulation/tracker.h"

namespace hrt {

struct PersonCondition {
  Person person;
  TrackerModel tracker;
  PlateDynamics plate{.max_speed_deg_s = 400.0, .latency_ns = 30'000'000};  ///< true dynamics of the plate
  double plate_offset_deg = 0.0;  ///< rotation of the ridges from the orientation that the controller assumes
  double real_direction_deg = -5.0;
  double virtual_direction_deg = 5.0;
  double distance_mm = 100.0;
  /// SD of the error of the position at which an object is touched after each reach; 0: no contacts.
  double contact_sd_mm = 0.0;
  bool random_side = false;  ///< the real target of each reach is on a random side of the virtual one
  bool faulty = false;       ///< each reach has a random fault of tracker or plate, or none: draw_fault()
};

enum class FamilyKind {
  invented,   ///< traits are guesses
  recorded,   ///< path and pace have the statistics of recorded reaches; the response to touch is a guess
  misplaced,  ///< error of the tracker's frame or plate's zero, which no reach reveals; placed-touch3 is without error
};

// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): in the order in which the table reads best
struct PeopleFamily {
  const char* name;
  const char* description;
  /// true: the controller's parameters were searched with this family; false: it was held out, and only the last few
  /// candidates were compared on it
  bool tuned;
  void (*set)(PersonCondition& condition, Draws& draws);
  FamilyKind kind = FamilyKind::invented;
};

/// Returns all families; the first is the base model.
std::span<const PeopleFamily> people_families();

/// Returns the family with that name, or null.
const PeopleFamily* people_family(const char* name);

/// Draws person `index` of a family, who moves for `duration_s`: tactile weight 0.12 to 0.30, gain 5 to 12 /s, delay up
/// to 120 ms, initial direction between mid-line and virtual target, varied by 1 degree (SD), and a gap of 10 degrees
/// to either side. The family then changes some of these.
PersonCondition draw_person(const PeopleFamily& family, double duration_s, std::uint64_t seed, std::uint32_t index);

/// Sets the own path, the pace and the scatter of recorded reaches, an initial direction towards the virtual target,
/// and a marker-based tracker of 100 Hz with a noise of 0.2 mm.
void move_as_recorded(PersonCondition& condition, OwnPath path);

/// Applies one of 11 families of faults, or none, each with a probability of 1/12.
void draw_fault(PersonCondition& condition, Draws& draws);

/// Random streams of a person: argument `stream` of Draws.
namespace PersonStream {
enum : std::uint32_t { drawn, steering, tracking, touching, faults };
}

/// Returns true if the gap is feasible for this person: if the largest shift for plate orientations within 75 degrees
/// of the motion exceeds the gap including the biases.
bool gap_is_feasible(const PersonCondition& condition);

}  // namespace hrt
