#include "core/simulation/person.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/elementary.h"

namespace hrt {
namespace {

constexpr double virtual_deg = 5.0;
constexpr double path_mm = 100.0;
constexpr Pace paces[] = {Pace::minimum_jerk, Pace::even,      Pace::skewed,   Pace::stop_and_go,
                          Pace::pause,        Pace::two_parts, Pace::reversal, Pace::submovements};

SimulatedIllusion illusion(IllusionFamily family, double scale_deg = 45.0, double weight = 0.2) {
  return {.family = family, .tactile_weight = weight, .scale_deg = scale_deg};
}

// A person without illusion and noise who starts towards the virtual target.
Person numb() {
  Person person;
  person.illusion = illusion(IllusionFamily::dead_band, 90.0);
  person.noise_deg2_per_s = 0.0;
  person.start_direction_deg = virtual_deg;
  return person;
}

// A person with a linear illusion, without noise.
Person linear() {
  Person person = numb();
  person.illusion = illusion(IllusionFamily::linear);
  return person;
}

Draws draws(std::uint32_t reach = 0) { return {1, 2, 3, reach}; }

struct Walk {
  std::vector<PlatePoint> places;  // one per millisecond
  SlidingPerson person;

  double length_mm() const {
    double sum_mm = 0.0;
    for (std::size_t i = 1; i < places.size(); ++i) sum_mm += distance_mm(places[i - 1], places[i]);
    return sum_mm;
  }
};

// Simulates a reach over a plate whose ridge normal is always at `offset_deg` from the motion.
Walk walk_beside(const Person& person, double offset_deg) {
  Walk result{.places = {{}}, .person = {person, {}, virtual_deg, path_mm, draws()}};
  while (!result.person.done()) {
    result.person.advance(result.person.direction_deg() + offset_deg);
    result.places.push_back(result.person.position());
  }
  return result;
}

TEST(SimulationPerson, Illusions_GiveTheHandCalculatedShifts) {
  using enum IllusionFamily;
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(linear), 40.0), 8.0);
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(linear), 100.0), -16.0);  // folded to -80
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(saturating), 30.0), 6.0);
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(saturating), 60.0), 9.0);
  EXPECT_NEAR(felt_shift_deg(illusion(sine), 45.0), 9.0, 1e-12);
  EXPECT_NEAR(felt_shift_deg(illusion(sine), 15.0), 4.5, 1e-12);
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(IllusionFamily::tanh, 60.0), 30.0), 12.0 * std::tanh(0.5));
  EXPECT_EQ(felt_shift_deg(illusion(dead_band, 10.0), 9.0), 0.0);
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(dead_band, 10.0), -30.0), -4.0);
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(unequal), 30.0), 6.0);
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(unequal), -30.0), -3.0);
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(peaked), 30.0), 6.0);
  EXPECT_DOUBLE_EQ(felt_shift_deg(illusion(peaked), -60.0), -6.0);
}

TEST(SimulationPerson, Illusions_GiveTheHandCalculatedLargestShift) {
  using enum IllusionFamily;
  for (const double w : {0.1, 0.2, 0.3})
    for (const double sign : {1.0, -1.0}) {
      const auto max = [=](IllusionFamily family, double scale_deg) {
        return max_shift_deg(illusion(family, scale_deg, w), 75.0, sign);
      };
      EXPECT_NEAR(max(linear, 45.0), 75.0 * w, 1e-12);
      EXPECT_NEAR(max(saturating, 45.0), 45.0 * w, 1e-12);
      EXPECT_NEAR(max(sine, 45.0), 45.0 * w, 1e-12);
      EXPECT_NEAR(max(IllusionFamily::tanh, 60.0), 60.0 * w * std::tanh(1.25), 1e-12);
      EXPECT_NEAR(max(dead_band, 10.0), 65.0 * w, 1e-12);
      EXPECT_NEAR(max(unequal, 45.0), (sign > 0.0 ? 75.0 : 37.5) * w, 1e-12);
    }
}

// The path is curved by ridges whose normal is 30 degrees from the motion. With an overshoot by a tenth, its length is
// 1.2 times the requested one.
TEST(SimulationPerson, AnyPace_HasTheRequestedLengthAndDuration) {
  for (const Pace pace : paces) {
    Person person = linear();
    person.noise_deg2_per_s = 8.0;
    person.pace = pace;
    person.duration_s = 1.2;
    person.path_scale = 1.1;
    const Walk bent = walk_beside(person, 30.0);
    EXPECT_NEAR(bent.length_mm(), 1.1 * path_mm * (pace == Pace::reversal ? 1.2 : 1.0), 1e-3);
    const double pauses_s = pace == Pace::stop_and_go || pace == Pace::pause ? 0.6 : 0.0;
    const double back_s = pace == Pace::reversal ? 0.48 : 0.0;
    EXPECT_NEAR(bent.person.elapsed_s(), 1.2 + pauses_s + back_s, 0.0011);
  }
}

// 10 / 64 - 15 / 256 + 6 / 1024 = 0.103515625 of the path in the first quarter of the time.
TEST(SimulationPerson, MinimumJerk_GivesTheHandCalculatedPath) {
  Person person = numb();
  person.duration_s = 2.0;
  const Walk straight = walk_beside(person, 0.0);
  EXPECT_NEAR(distance_mm({}, straight.places[500]), 0.103515625 * path_mm, 1e-6);
  EXPECT_NEAR(distance_mm({}, straight.places[1000]), 0.5 * path_mm, 1e-6);
  EXPECT_NEAR(distance_mm(straight.places[1000], straight.places[1001]), 1.875 * path_mm * 0.0005, 1e-5);
}

TEST(SimulationPerson, PacesWithPauses_RestForTheirDuration) {
  Person person = numb();
  person.duration_s = 1.0;
  const auto at_rest_ms = [&](Pace pace) {
    person.pace = pace;
    const Walk straight = walk_beside(person, 0.0);
    int count = 0;
    for (std::size_t i = 200; i + 200 < straight.places.size(); ++i)
      count += distance_mm(straight.places[i], straight.places[i + 1]) == 0.0;
    return count;
  };
  EXPECT_NEAR(at_rest_ms(Pace::minimum_jerk), 0, 0);
  EXPECT_NEAR(at_rest_ms(Pace::pause), 600, 2);
  EXPECT_NEAR(at_rest_ms(Pace::stop_and_go), 600, 4);
}

TEST(SimulationPerson, WithoutIllusion_AnySteeringReachesTheVirtualTarget) {
  const PlatePoint target = point_ahead({}, virtual_deg, path_mm);
  for (const Steering steering : {Steering::continuous, Steering::predictive, Steering::place, Steering::crossings})
    for (const Pace pace : paces) {
      Person person = numb();
      person.steering = steering;
      person.pace = pace;
      EXPECT_LT(distance_mm(walk_beside(person, 60.0).person.position(), target), 1e-6);
      // A person who starts in another direction also ends at the target, except for a small error.
      person.start_direction_deg = 0.0;
      if (pace != Pace::minimum_jerk) continue;
      EXPECT_LT(distance_mm(walk_beside(person, 60.0).person.position(), target), 0.5);
    }
  Person heavy = numb();
  heavy.steering = Steering::heavy_arm;
  const Walk arm = walk_beside(heavy, 60.0);
  EXPECT_NEAR(bearing_deg({}, arm.person.position()), virtual_deg, 1e-6);
  EXPECT_NEAR(distance_mm({}, arm.person.position()), path_mm, 2.0);
}

// With steering in steps of 100 ms, reaches end at the virtual target on average, and are straight between steps.
TEST(SimulationPerson, SteeringInSteps_ChangesDirectionEvery100Ms) {
  Person person = numb();
  person.steering = Steering::steps;
  double sum_deg = 0.0;
  for (std::uint32_t i = 0; i < 200; ++i) {
    SlidingPerson now(person, {}, virtual_deg, path_mm, draws(i));
    double last_deg = now.direction_deg();
    for (int millisecond = 1; !now.done(); ++millisecond) {
      now.advance(0.0);
      if (now.direction_deg() != last_deg) {
        ASSERT_EQ(millisecond % 100, 0);
      }
      last_deg = now.direction_deg();
    }
    sum_deg += bearing_deg({}, now.position());
  }
  EXPECT_NEAR(sum_deg / 200.0, virtual_deg, 0.15);
}

// Each correction removes the fraction of the error that continuous steering would remove in 250 ms.
TEST(SimulationPerson, SteeringByCorrections_ChangesDirectionEvery250Ms) {
  Person person = numb();
  person.steering = Steering::corrections;
  person.start_direction_deg = 0.0;
  SlidingPerson now(person, {}, virtual_deg, path_mm, draws());
  const double left = std::exp(-0.25 * person.gain_per_s);
  for (int millisecond = 1; millisecond < 740; ++millisecond) {
    now.advance(0.0);
    EXPECT_NEAR(now.direction_deg(), virtual_deg * (1.0 - std::pow(left, millisecond / 250)), 1e-9) << millisecond;
  }
}

// With the ridge normal 50 degrees to the left of the motion, the perceived direction is 0.2 * 50 = 10 degrees to the
// left of the motion.
TEST(SimulationPerson, AConstantOffset_DeflectsTheMotionByTheShift) {
  for (const Steering steering : {Steering::continuous, Steering::predictive}) {
    Person person = linear();
    person.steering = steering;
    const SlidingPerson end = walk_beside(person, 50.0).person;
    EXPECT_NEAR(end.direction_deg(), virtual_deg - 10.0, 0.01);
    EXPECT_NEAR(end.felt_error_deg(), 0.0, 0.01);
  }
}

TEST(SimulationPerson, BiasHabitAndDrift_GiveTheHandCalculatedDirections) {
  Person person = numb();
  person.bias_deg = 3.0;
  EXPECT_NEAR(walk_beside(person, 0.0).person.direction_deg(), virtual_deg + 3.0, 0.01);
  person = numb();
  person.own_bias_deg = 3.0;
  const SlidingPerson biased = walk_beside(person, 0.0).person;
  EXPECT_NEAR(biased.direction_deg(), virtual_deg - 3.0, 0.01);
  EXPECT_NEAR(biased.felt_error_deg(), 0.0, 0.01);
  person = numb();
  person.habit_deg = 4.0;  // from +4 to -4: the path is curved, and its chord points to the target
  const Walk bent = walk_beside(person, 0.0);
  EXPECT_NEAR(bent.person.direction_deg(), virtual_deg - 4.0, 0.1);
  EXPECT_NEAR(bearing_deg({}, bent.person.position()), virtual_deg, 0.5);
  EXPECT_GT(bearing_deg({}, bent.places[bent.places.size() / 2]), virtual_deg + 1.0);
  // The shift at the end is 0.25 * 40; the direction lags by 40 * 0.05 / 1.5 / 9 = 0.15.
  person = linear();
  person.weight_drift = 0.05;
  EXPECT_NEAR(walk_beside(person, 40.0).person.direction_deg(), virtual_deg - 10.0 + 0.15, 0.05);
}

TEST(SimulationPerson, SteeringToAPosition_ReducesTheMiss) {
  Person person = linear();
  person.start_direction_deg = -10.0;
  person.pace = Pace::even;
  person.illusion = illusion(IllusionFamily::dead_band, 90.0);
  const double by_direction_deg = bearing_deg({}, walk_beside(person, 0.0).person.position());
  person.steering = Steering::place;
  const double by_place_deg = bearing_deg({}, walk_beside(person, 0.0).person.position());
  EXPECT_LT(by_direction_deg, virtual_deg - 0.5);
  EXPECT_LT(std::abs(by_place_deg - virtual_deg), 0.5 * std::abs(by_direction_deg - virtual_deg));
}

// Ridges along the motion are never crossed. With the normal 40 degrees from the motion, the finger crosses a ridge
// every 10 mm / cos(40 degrees) = 13 mm.
TEST(SimulationPerson, RidgesAlongTheMotion_CauseNoShift) {
  Person person = linear();
  person.steering = Steering::crossings;
  EXPECT_NEAR(walk_beside(person, 90.0).person.direction_deg(), virtual_deg, 1e-9);
  double min_deg = virtual_deg;
  SlidingPerson now(person, {}, virtual_deg, path_mm, draws());
  while (!now.done()) {
    now.advance(now.direction_deg() + 40.0);
    min_deg = std::min(min_deg, now.direction_deg());
  }
  EXPECT_LT(min_deg, virtual_deg - 2.0);
  EXPECT_GT(min_deg, virtual_deg - 8.0);  // the shift of 0.2 * 40 degrees decays between ridges
}

// Without steering, the direction is a random walk: 8 deg^2 per second for 1.5 s.
TEST(SimulationPerson, Noise_HasItsVariance) {
  Person person = numb();
  person.gain_per_s = 0.0;
  person.pace = Pace::even;
  person.noise_deg2_per_s = 8.0;
  constexpr int n = 1000;
  double squares = 0.0;
  for (std::uint32_t i = 0; i < n; ++i) {
    SlidingPerson now(person, {}, virtual_deg, path_mm, draws(i));
    while (!now.done()) now.advance(0.0);
    squares += std::pow(now.direction_deg() - virtual_deg, 2);
  }
  EXPECT_NEAR(squares / n, 8.0 * person.duration_s, 4.0 * 12.0 * std::sqrt(2.0 / n));
}

}  // namespace
}  // namespace hrt
