#include "core/simulation/people.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/math/elementary.h"

namespace hrt {
namespace {

constexpr double bound_deg = 75.0;
constexpr double tan_of_2_deg = 0.03492076949174773;

double either_side(double size, Draws& draws) { return draws.uniform() < 0.5 ? -size : size; }

template <IllusionFamily family>
void illusion(PersonCondition& condition, double scale_deg) {
  condition.person.illusion.family = family;
  condition.person.illusion.scale_deg = scale_deg;
}

void headset(PersonCondition& condition, Draws& draws) {
  TrackerModel& tracker = condition.tracker;
  tracker.rate_hz = 72.0;
  tracker.latency_s = 0.045;
  // The tracked position of the target is off by 11 mm in a random direction.
  const double towards_deg = 360.0 * draws.uniform();
  const double along = 1.0 + 11.0 / condition.distance_mm * cos_deg(towards_deg);
  const double across = 11.0 / condition.distance_mm * sin_deg(towards_deg);
  tracker.turned_deg = atan2_deg(across, along);
  tracker.scale = std::sqrt(along * along + across * across);
}

void arm(PersonCondition& condition, Steering steering, double mass_kg, double muscle_s) {
  Person& person = condition.person;
  person.steering = steering;
  person.delay_s = 0.08;
  person.mass_kg = mass_kg;
  person.muscle_s = muscle_s;
}

void outlier_burst(PersonCondition& condition, Draws& draws, double from_s, double to_s) {
  condition.tracker.burst_samples = draws.uniform() < 0.5 ? 1 : 2;
  condition.tracker.burst_mm = 10.0 + 290.0 * draws.uniform();
  condition.tracker.burst_at_s = from_s + (to_s - from_s) * draws.uniform();
}

void turned_and_touched(PersonCondition& condition, Draws& draws, double contact_sd_mm) {
  condition.tracker.turned_deg = either_side(2.0, draws);
  condition.contact_sd_mm = contact_sd_mm;
}

void recorded(PersonCondition& condition, Draws& draws, double size) {
  move_as_recorded(condition, draw_own_path(size, draws));
}

// An infrared touch frame; move_as_recorded() has set its rate of 100 Hz.
void on_touch_frame(PersonCondition& condition) {
  TrackerModel& tracker = condition.tracker;
  tracker.white_mm = 0.5;
  tracker.latency_s = tracker.declared_latency_s = 0.015;
  tracker.bearing_sd_deg = tracker.declared_bearing_sd_deg = 0.2;
}

// A headset of 2021, as measured against a marker on the fingertip; see the table in README.md.
void by_headset(PersonCondition& condition, Draws& draws) {
  TrackerModel& tracker = condition.tracker;
  tracker.rate_hz = 71.0;
  tracker.jitter_share = 0.2;
  tracker.white_mm = 0.06;
  tracker.correlated_mm = 1.3;
  tracker.correlation_s = 0.131;
  tracker.smoothing_s = 0.022;
  tracker.correlated_log_sd = 0.77;
  tracker.latency_s = tracker.declared_latency_s = 0.048;
  tracker.bearing_sd_deg = atan2_deg(5.0, condition.distance_mm);
  tracker.turned_deg = 1.7 * draws.normal();
  tracker.declared_bearing_sd_deg = 3.6;  // SD of the bearing from all errors of this headset
  tracker.creep_mm = 6.0;
  tracker.end_loss_share = 0.14;
  tracker.excursions_hz = 1.0 / 12.0;
}

constexpr PeopleFamily all_families[] = {
    {"linear", "linear illusion up to t = 90°, where its sign flips; continuous steering", true,
     [](PersonCondition&, Draws&) {}},
    {"steps", "the paper's person, steering every 100 ms", true,
     [](PersonCondition& c, Draws&) {
       c.person.steering = Steering::steps;
       c.person.start_direction_deg = 0.0;
     }},
    {"predictive", "predict their own motion over the sensory delay", false,
     [](PersonCondition& c, Draws&) { c.person.steering = Steering::predictive; }},
    {"clip-60", "illusion saturates at t = 60°", true,
     [](PersonCondition& c, Draws&) { illusion<IllusionFamily::saturating>(c, 60.0); }},
    {"clip-45", "illusion saturates at t = 45°", false,
     [](PersonCondition& c, Draws&) { illusion<IllusionFamily::saturating>(c, 45.0); }},
    {"tanh-60", "illusion w 60° tanh(t / 60°)", true,
     [](PersonCondition& c, Draws&) { illusion<IllusionFamily::tanh>(c, 60.0); }},
    {"sine-45", "illusion w 45° sin 2t", true,
     [](PersonCondition& c, Draws&) { illusion<IllusionFamily::sine>(c, 45.0); }},
    {"dead-band", "no illusion for t within ±10°", true,
     [](PersonCondition& c, Draws&) { illusion<IllusionFamily::dead_band>(c, 10.0); }},
    {"unequal", "illusion half as large to the right", false,
     [](PersonCondition& c, Draws&) { illusion<IllusionFamily::unequal>(c, 45.0); }},
    {"bias-3", "visual bias ±3°", true, [](PersonCondition& c, Draws& d) { c.person.bias_deg = either_side(3.0, d); }},
    {"bias-6", "visual bias ±6°", true, [](PersonCondition& c, Draws& d) { c.person.bias_deg = either_side(6.0, d); }},
    {"own-3", "bias of ±3° in the felt direction of their own motion", true,
     [](PersonCondition& c, Draws& d) { c.person.own_bias_deg = either_side(3.0, d); }},
    {"habit-5", "habit of curving by ±5°", true,
     [](PersonCondition& c, Draws& d) { c.person.habit_deg = either_side(5.0, d); }},
    {"habit-10", "habit of curving by ±10°", false,
     [](PersonCondition& c, Draws& d) { c.person.habit_deg = either_side(10.0, d); }},
    {"place", "steer towards the virtual target's position", false,
     [](PersonCondition& c, Draws&) { c.person.steering = Steering::place; }},
    {"heavy-arm", "arm of 1 kg, muscles with a time constant of 40 ms, feedback after 80 ms", false,
     [](PersonCondition& c, Draws&) { arm(c, Steering::heavy_arm, 1.0, 0.04); }},
    {"slow-arm", "arm of 2 kg, muscles with a time constant of 60 ms, feedback after 80 ms, gain times 0.6", true,
     [](PersonCondition& c, Draws&) {
       arm(c, Steering::heavy_arm, 2.0, 0.06);
       c.person.gain_per_s *= 0.6;
     }},
    {"placing-arm", "heavy-arm, steers towards the virtual target's position, gain times 0.6", true,
     [](PersonCondition& c, Draws&) {
       arm(c, Steering::placing_arm, 1.0, 0.04);
       c.person.gain_per_s *= 0.6;
     }},
    {"slow-touch", "perceived shift follows with a time constant of 150 ms", true,
     [](PersonCondition& c, Draws&) { c.person.touch_s = 0.15; }},
    {"corrections", "correct every 250 ms", true,
     [](PersonCondition& c, Draws&) { c.person.steering = Steering::corrections; }},
    {"crossings", "ridges felt only as they are crossed", true,
     [](PersonCondition& c, Draws&) { c.person.steering = Steering::crossings; }},
    {"drift", "w_T drifts by ±0.05 within a reach", true,
     [](PersonCondition& c, Draws& d) { c.person.weight_drift = either_side(0.05, d); }},
    {"even", "even pace", true, [](PersonCondition& c, Draws&) { c.person.pace = Pace::even; }},
    {"skewed", "early peak of speed", true, [](PersonCondition& c, Draws&) { c.person.pace = Pace::skewed; }},
    {"stop-and-go", "two rests of 0.3 s", false, [](PersonCondition& c, Draws&) { c.person.pace = Pace::stop_and_go; }},
    {"pause", "a rest of 0.6 s", false, [](PersonCondition& c, Draws&) { c.person.pace = Pace::pause; }},
    {"two-parts", "two motions, one after the other", false,
     [](PersonCondition& c, Draws&) { c.person.pace = Pace::two_parts; }},
    {"submovements", "three submovements, drawn in each reach", true,
     [](PersonCondition& c, Draws&) { c.person.pace = Pace::submovements; }},
    {"scatter-2", "bias scatters by 2° from reach to reach", true,
     [](PersonCondition& c, Draws&) { c.person.scatter_deg = 2.0; }},
    {"scatter-3", "bias scatters by 3° from reach to reach", false,
     [](PersonCondition& c, Draws&) { c.person.scatter_deg = 3.0; }},
    {"scatter-4", "bias scatters by 4° from reach to reach", true,
     [](PersonCondition& c, Draws&) { c.person.scatter_deg = 4.0; }},
    {"reversal", "overshoot by a tenth of the path, and come back", false,
     [](PersonCondition& c, Draws&) { c.person.pace = Pace::reversal; }},
    {"path-5", "path 5 % (SD) too long or too short", false,
     [](PersonCondition& c, Draws& d) { c.person.path_scale = 1.0 + 0.05 * d.normal(); }},
    {"noise-100", "tracker noise correlated over 100 ms", true,
     [](PersonCondition& c, Draws&) {
       c.tracker.white_mm = 0.0;
       c.tracker.correlated_mm = 1.2;
     }},
    {"noise-300", "tracker noise correlated over 300 ms", false,
     [](PersonCondition& c, Draws&) {
       c.tracker.white_mm = 0.0;
       c.tracker.correlated_mm = 1.2;
       c.tracker.correlation_s = 0.3;
     }},
    {"noise-3", "tracker noise of 3 mm", true, [](PersonCondition& c, Draws&) { c.tracker.white_mm = 3.0; }},
    {"wild-rest", "one or two positions off by 10 to 300 mm while the finger rests", true,
     [](PersonCondition& c, Draws& d) { outlier_burst(c, d, 0.1, 0.4); }},
    {"wild-moving", "one or two positions off by 10 to 300 mm during the motion", false,
     [](PersonCondition& c, Draws& d) { outlier_burst(c, d, 0.8, 0.5 + c.person.duration_s); }},
    {"outliers", "3 % of positions off by 30 mm", false,
     [](PersonCondition& c, Draws&) { c.tracker.outlier_share = 0.03; }},
    {"dropouts", "tracking lost for 0.1 s, every third of a second", false,
     [](PersonCondition& c, Draws&) { c.tracker.dropout_share = 0.03; }},
    {"slow-tracker", "tracker of 30 Hz with jitter", false,
     [](PersonCondition& c, Draws&) {
       c.tracker.rate_hz = 30.0;
       c.tracker.jitter_share = 0.5;
     }},
    {"slow-plate", "plate at 250°/s, assumed 400", false,
     [](PersonCondition& c, Draws&) { c.plate.max_speed_deg_s = 250.0; }},
    {"late-plate", "plate latency 30 ms longer than assumed", false,
     [](PersonCondition& c, Draws&) { c.plate.latency_ns = 60'000'000; }},
    {"late-samples", "samples up to 8 ms late, each independently", false,
     [](PersonCondition& c, Draws&) { c.tracker.late_s = 0.008; }},
    {"latency-100", "tracker 100 ms late, and declared so", false,
     [](PersonCondition& c, Draws&) { c.tracker.latency_s = c.tracker.declared_latency_s = 0.1; }},
    {"latency-45", "tracker 45 ms late, not declared", false,
     [](PersonCondition& c, Draws&) { c.tracker.latency_s = 0.045; }},
    {"faults", "a fault of tracker or plate, or none, drawn in each reach", false,
     [](PersonCondition& c, Draws&) { c.faulty = true; }},
    {"mixture", "clip-60, bias ±2°, habit ±3°, white and correlated noise", true,
     [](PersonCondition& c, Draws& d) {
       illusion<IllusionFamily::saturating>(c, 60.0);
       c.person.bias_deg = either_side(2.0, d);
       c.person.habit_deg = either_side(3.0, d);
       c.tracker.white_mm = 0.6;
       c.tracker.correlated_mm = 1.04;
     }},
    {"recorded", "path and pace of recorded reaches", false, [](PersonCondition& c, Draws& d) { recorded(c, d, 1.0); },
     FamilyKind::recorded},
    {"recorded-50", "recorded, half as curved", false, [](PersonCondition& c, Draws& d) { recorded(c, d, 0.5); },
     FamilyKind::recorded},
    {"recorded-ir", "recorded, on an infrared touch frame: 0.5 mm, 0.2° a reach", false,
     [](PersonCondition& c, Draws& d) {
       recorded(c, d, 1.0);
       on_touch_frame(c);
     },
     FamilyKind::recorded},
    {"recorded-25", "recorded, a quarter as curved", false, [](PersonCondition& c, Draws& d) { recorded(c, d, 0.25); },
     FamilyKind::recorded},
    {"recorded-side", "recorded, the gap to a random side", false,
     [](PersonCondition& c, Draws& d) {
       recorded(c, d, 1.0);
       c.random_side = true;
     },
     FamilyKind::recorded},
    {"recorded-stay", "recorded wander over the first half of the path, without return to the line", false,
     [](PersonCondition& c, Draws& d) {
       recorded(c, d, 1.0);
       c.person.own_path.mean_deg = {};
       c.person.own_path.returns = false;
     },
     FamilyKind::recorded},
    {"recorded-felt", "recorded-stay, steered from the perceived position to the target", false,
     [](PersonCondition& c, Draws& d) {
       recorded(c, d, 1.0);
       c.person.own_path.mean_deg = {};
       c.person.own_path.returns = false;
       c.person.steering = Steering::place;
     },
     FamilyKind::recorded},
    {"recorded-lag", "the recorded path is the goal, followed with the lag of steering", false,
     [](PersonCondition& c, Draws& d) {
       recorded(c, d, 1.0);
       c.person.own_path.lags = true;
     },
     FamilyKind::recorded},
    {"turned-1", "tracker frame turned by ±1°", false,
     [](PersonCondition& c, Draws& d) { c.tracker.turned_deg = either_side(1.0, d); }, FamilyKind::misplaced},
    {"turned-2", "tracker frame turned by ±2°", false,
     [](PersonCondition& c, Draws& d) { c.tracker.turned_deg = either_side(2.0, d); }, FamilyKind::misplaced},
    {"scaled-5", "tracker frame 5 % too large or too small", false,
     [](PersonCondition& c, Draws& d) { c.tracker.scale = 1.0 + either_side(0.05, d); }, FamilyKind::misplaced},
    {"sheared-2", "mid-line of the tracker frame off by ±2°, right axis correct", false,
     [](PersonCondition& c, Draws& d) { c.tracker.shear = either_side(tan_of_2_deg, d); }, FamilyKind::misplaced},
    {"headset", "tracker of 72 Hz, 45 ms late, with an error that grows to 11 mm over the path", false, headset,
     FamilyKind::misplaced},
    {"quest", "recorded, tracked by a headset of 2021 as it was measured", false,
     [](PersonCondition& c, Draws& d) {
       recorded(c, d, 1.0);
       by_headset(c, d);
     },
     FamilyKind::misplaced},
    {"half-quest", "family recorded-50, tracked by the headset of family quest", false,
     [](PersonCondition& c, Draws& d) {
       recorded(c, d, 0.5);
       by_headset(c, d);
     },
     FamilyKind::misplaced},
    {"linear-quest", "family linear, tracked by the headset of family quest", false, by_headset, FamilyKind::misplaced},
    {"marks", "tracker frame turned by 1.2° (SD), as after a registration by six touches of 3 mm", false,
     [](PersonCondition& c, Draws& d) { c.tracker.turned_deg = 1.2 * d.normal(); }, FamilyKind::misplaced},
    {"marks-touch3", "family marks, and a contact known to 3 mm after each reach", false,
     [](PersonCondition& c, Draws& d) {
       c.tracker.turned_deg = 1.2 * d.normal();
       c.contact_sd_mm = 3.0;
     },
     FamilyKind::misplaced},
    {"turned-touch1", "family turned-2, and a contact known to 1 mm after each reach", false,
     [](PersonCondition& c, Draws& d) { turned_and_touched(c, d, 1.0); }, FamilyKind::misplaced},
    {"turned-touch3", "family turned-2, and a contact known to 3 mm after each reach", false,
     [](PersonCondition& c, Draws& d) { turned_and_touched(c, d, 3.0); }, FamilyKind::misplaced},
    {"headset-touch", "family headset, and a contact known to 1 mm after each reach", false,
     [](PersonCondition& c, Draws& d) {
       headset(c, d);
       c.contact_sd_mm = 1.0;
     },
     FamilyKind::misplaced},
    {"placed-touch3", "correct tracker frame, and a contact known to 3 mm after each reach: cost of contacts", false,
     [](PersonCondition& c, Draws&) { c.contact_sd_mm = 3.0; }, FamilyKind::misplaced},
    {"plate-off-5", "ridges ±5° off the reported plate orientation", false,
     [](PersonCondition& c, Draws& d) { c.plate_offset_deg = either_side(5.0, d); }, FamilyKind::misplaced},
};

}  // namespace

// Motor noise is 0, since the recorded paths include it.
void move_as_recorded(PersonCondition& condition, OwnPath path) {
  condition.tracker.rate_hz = 100.0;
  condition.tracker.white_mm = 0.2;
  Person& person = condition.person;
  person.pace = Pace::recorded;
  person.noise_deg2_per_s = 0.0;
  person.scatter_deg = 0.9;
  person.start_direction_deg = condition.virtual_direction_deg;
  person.own_path = std::move(path);
}

std::span<const PeopleFamily> people_families() { return all_families; }

const PeopleFamily* people_family(const char* name) {
  for (const PeopleFamily& family : all_families)
    if (std::strcmp(family.name, name) == 0) return &family;
  return nullptr;
}

void draw_fault(PersonCondition& condition, Draws& draws) {
  constexpr std::array faults{"linear",   "noise-100",    "noise-3",    "wild-rest",  "wild-moving",  "outliers",
                              "dropouts", "slow-tracker", "slow-plate", "late-plate", "late-samples", "latency-45"};
  const auto drawn = static_cast<std::size_t>(draws.uniform() * static_cast<double>(faults.size()));
  people_family(faults[drawn])->set(condition, draws);
}

PersonCondition draw_person(const PeopleFamily& family, double duration_s, std::uint64_t seed, std::uint32_t index) {
  Draws draws(seed, PersonStream::drawn, index, static_cast<std::uint32_t>(std::llround(1000.0 * duration_s)));
  PersonCondition condition;
  Person& person = condition.person;
  person.illusion.tactile_weight = 0.12 + 0.18 * draws.uniform();
  person.gain_per_s = 5.0 + 7.0 * draws.uniform();
  person.delay_s = 0.12 * draws.uniform();
  person.duration_s = duration_s;
  condition.virtual_direction_deg = either_side(5.0, draws);
  condition.real_direction_deg = -condition.virtual_direction_deg;
  person.start_direction_deg = condition.virtual_direction_deg * draws.uniform() + draws.normal();
  family.set(condition, draws);
  return condition;
}

bool gap_is_feasible(const PersonCondition& condition) {
  const Person& person = condition.person;
  const double gap_deg =
      condition.virtual_direction_deg + person.bias_deg - person.own_bias_deg - condition.real_direction_deg;
  return max_shift_deg(person, condition.distance_mm / person.duration_s, bound_deg, gap_deg) > std::abs(gap_deg);
}

}  // namespace hrt
