// The simulated side of the page, as one WebAssembly module: a person of core/simulation who slides a finger
// over the plate, the plate's servo (or a connected plate in its place), and a tracker with white noise. The
// controller and all drawing are in the page's scripts.
//
// Units are in the names. Coordinates are to the right of and away from the centre of the plate, in metres in the
// exported calls and in millimetres inside (core/plate/plate_frame.h).
// The plate's orientation is the direction of the normal of the ridges, counter-clockwise from the mid-line.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/plate/plate_model.h"
#include "core/simulation/people.h"
#include "core/simulation/person.h"
#include "samples/app/person/quest.h"

#define HRT_WEB_EXPORT(name) __attribute__((export_name(#name)))
#define HRT_WEB_VALUE(name, value) \
  HRT_WEB_EXPORT(name) double hrt_web_##name() { return value; }

namespace {

constexpr std::int64_t tick_ns = 1'000'000;
constexpr std::int64_t plate_latency_ns = 30'000'000;
constexpr double rest_s = 0.6;  // before the motion
constexpr double tail_s = 0.3;  // tracked rest after the motion

/// Probability that a visitor who noticed nothing answers "yes".
constexpr double false_alarms = 0.05;

struct World {
  hrt::PersonCondition condition;
  std::uint64_t seed = 1;
  std::int64_t now_ns = 0;
  hrt::PlateModel plate{hrt::PlateDynamics{}, 0.0};
  std::optional<hrt::SlidingPerson> person;
  std::optional<hrt::Draws> tracker;
  double peak_felt_error_deg = 0.0;
  double ended_s = -1.0;
  hrt::PlatePoint seen{};
  hrt::app::QuestPlus series{1.0, 30.0, false_alarms};
};

World world;

void place_plate(double orientation_deg) {
  world.now_ns = 0;
  world.plate = hrt::PlateModel(world.condition.plate, orientation_deg);
  world.plate.advance(0);
}

}  // namespace

extern "C" {

/// Creates another person with a linear illusion. Gain, delay and start direction are drawn from `seed`. The tactile
/// weight must be above 0 and below 0.5, the duration of a reach above 0.
HRT_WEB_EXPORT(set_person)
void hrt_web_set_person(double seed, double tactile_weight, double duration_s) {
  world.seed = static_cast<std::uint64_t>(seed);
  const hrt::PersonCondition drawn = hrt::draw_person(hrt::people_families().front(), 1.5, world.seed, 0);
  world.condition.person = drawn.person;
  world.condition.person.illusion.tactile_weight = tactile_weight;
  world.condition.person.duration_s = duration_s;
  // Here a fraction of the virtual target's direction, which begin_reach() receives.
  world.condition.person.start_direction_deg = drawn.person.start_direction_deg / drawn.virtual_direction_deg;
}

/// Sets the tracker's white noise (SD of each coordinate) and the servo's maximum speed, which must be above 0.
/// The servo's latency is plate_latency_ms().
HRT_WEB_EXPORT(set_apparatus)
void hrt_web_set_apparatus(double noise_m, double max_speed_deg_s) {
  world.condition.tracker.white_mm = hrt::mm_per_m * noise_m;
  world.condition.plate = {.max_speed_deg_s = max_speed_deg_s, .latency_ns = plate_latency_ns};
}

HRT_WEB_VALUE(plate_latency_ms, 1e-6 * static_cast<double>(plate_latency_ns))
/// Resets the time, with the plate at rest at `plate_deg` and the finger at the start. The person will move
/// `distance_m` towards the virtual target; `number` seeds the noise of the reach.
HRT_WEB_EXPORT(begin_reach)
void hrt_web_begin_reach(double number, double start_right_m, double start_away_m, double virtual_deg,
                         double distance_m, double plate_deg) {
  place_plate(plate_deg);
  const auto reach = static_cast<std::uint32_t>(number);
  hrt::Person person = world.condition.person;
  person.start_direction_deg *= virtual_deg;
  const hrt::PlatePoint start{hrt::mm_per_m * start_right_m, hrt::mm_per_m * start_away_m};
  world.person.emplace(person, start, virtual_deg, hrt::mm_per_m * distance_m,
                       hrt::Draws(world.seed, hrt::PersonStream::steering, 0, reach));
  world.tracker.emplace(world.seed, hrt::PersonStream::tracking, 0, reach);
  world.peak_felt_error_deg = 0.0;
  world.ended_s = -1.0;
}

/// Resets the time, without a person: only the plate moves.
HRT_WEB_EXPORT(begin_hand)
void hrt_web_begin_hand(double plate_deg) {
  world.person.reset();
  place_plate(plate_deg);
}

/// Advances the world by one millisecond.
HRT_WEB_EXPORT(advance)
void hrt_web_advance() {
  world.now_ns += tick_ns;
  world.plate.advance(world.now_ns);
  const double now_s = 1e-9 * static_cast<double>(world.now_ns);
  if (!world.person || now_s <= rest_s || world.person->done()) return;
  hrt::SlidingPerson& person = *world.person;
  person.advance(world.plate.orientation_deg());
  if (person.elapsed_s() > 0.05 && person.speed_mm_s() > 10.0)
    world.peak_felt_error_deg = std::max(world.peak_felt_error_deg, std::abs(person.felt_error_deg()));
  if (person.done()) world.ended_s = now_s;
}

/// Takes one tracker sample of the finger, which seen_*() return.
HRT_WEB_EXPORT(look)
void hrt_web_look() {
  if (!world.person || !world.tracker) return;
  const double noise_mm = world.condition.tracker.white_mm;
  world.seen.right_mm = world.person->position().right_mm + noise_mm * world.tracker->normal();
  world.seen.away_mm = world.person->position().away_mm + noise_mm * world.tracker->normal();
}

HRT_WEB_EXPORT(command)
void hrt_web_command(double plate_deg) { world.plate.command(plate_deg); }

/// Sets the orientation that a connected plate reports, until the next call of set_plate() or command().
HRT_WEB_EXPORT(set_plate)
void hrt_web_set_plate(double plate_deg) {
  world.plate = hrt::PlateModel(world.condition.plate, plate_deg);
  world.plate.advance(world.now_ns);
}

HRT_WEB_VALUE(time_ms, 1e-6 * static_cast<double>(world.now_ns))
HRT_WEB_VALUE(plate_deg, world.plate.orientation_deg())

/// The following values are 0 without a person. moving() is 1 from the first motion to the last; over() is 1 once
/// the rest after the motion has ended too.
HRT_WEB_VALUE(moving, world.person && !world.person->done() && world.person->elapsed_s() > 0.0 ? 1.0 : 0.0)

HRT_WEB_EXPORT(over)
double hrt_web_over() {
  const double now_s = 1e-9 * static_cast<double>(world.now_ns);
  return world.ended_s >= 0.0 && now_s > world.ended_s + tail_s ? 1.0 : 0.0;
}

HRT_WEB_VALUE(finger_right_m, world.person ? world.person->position().right_mm / hrt::mm_per_m : 0.0)
HRT_WEB_VALUE(finger_away_m, world.person ? world.person->position().away_mm / hrt::mm_per_m : 0.0)
HRT_WEB_VALUE(felt_right_m, world.person ? world.person->felt_position().right_mm / hrt::mm_per_m : 0.0)
HRT_WEB_VALUE(felt_away_m, world.person ? world.person->felt_position().away_mm / hrt::mm_per_m : 0.0)
HRT_WEB_VALUE(finger_deg, world.person ? world.person->direction_deg() : 0.0)
/// Perceived direction minus the virtual target's direction.
HRT_WEB_VALUE(felt_error_deg, world.person ? world.person->felt_error_deg() : 0.0)
HRT_WEB_VALUE(peak_felt_error_deg, world.person ? world.peak_felt_error_deg : 0.0)
HRT_WEB_VALUE(seen_right_m, world.seen.right_mm / hrt::mm_per_m)
HRT_WEB_VALUE(seen_away_m, world.seen.away_mm / hrt::mm_per_m)

/// Perceived minus true direction, for this person, of a finger that moves in `finger_deg` over a plate at `plate_deg`.
HRT_WEB_EXPORT(felt_shift_deg)
double hrt_web_felt_shift_deg(double plate_deg, double finger_deg) {
  return hrt::felt_shift_deg(world.condition.person.illusion, plate_deg - finger_deg);
}

/// Starts a series of slides. After each slide the visitor answers whether they noticed the gap; next_gap_deg() is the
/// next gap that QUEST+ chooses, between `min_gap_deg` and `max_gap_deg`.
HRT_WEB_EXPORT(begin_series)
void hrt_web_begin_series(double min_gap_deg, double max_gap_deg) {
  world.series = hrt::app::QuestPlus(min_gap_deg, max_gap_deg, false_alarms);
}

HRT_WEB_EXPORT(answer)
void hrt_web_answer(double gap_deg, double noticed) { world.series.update(gap_deg, noticed != 0.0); }

HRT_WEB_VALUE(next_gap_deg, world.series.next_gap_deg())
/// Detection threshold of the gap, with the limits of its 95 % interval.
HRT_WEB_VALUE(limit_deg, world.series.threshold().deg)
HRT_WEB_VALUE(limit_lower_deg, world.series.threshold().lower_deg)
HRT_WEB_VALUE(limit_upper_deg, world.series.threshold().upper_deg)

/// The largest gap that a plate within `bound_deg` of the motion can sustain for the person.
HRT_WEB_EXPORT(max_gap_deg)
double hrt_web_max_gap_deg(double bound_deg) {
  return hrt::max_shift_deg(world.condition.person.illusion, bound_deg, 1.0);
}

}  // extern "C"
