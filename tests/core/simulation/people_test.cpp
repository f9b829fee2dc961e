#include "core/simulation/people.h"
#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>

namespace hrt {
namespace {

PersonCondition draw(const char* family, std::uint32_t index = 0, double duration_s = 1.5) {
  return draw_person(*people_family(family), duration_s, 1, index);
}

// The different values of one quantity of 30 people of a family.
std::set<double> values(const char* family, const std::function<double(const PersonCondition&)>& value) {
  std::set<double> found;
  for (std::uint32_t i = 0; i < 30; ++i) found.insert(value(draw(family, i)));
  return found;
}

// A gap of 10 degrees to the left (`side` 1) or right (-1).
PersonCondition condition(IllusionFamily family, double scale_deg, double weight, double side = 1.0) {
  PersonCondition result;
  result.person.illusion = {.family = family, .tactile_weight = weight, .scale_deg = scale_deg};
  result.virtual_direction_deg = 5.0 * side;
  result.real_direction_deg = -5.0 * side;
  return result;
}

// Summary of a first reach with the controller for people.
ReachSummary guided(const PersonCondition& condition) {
  const RetargeterConfig controller = people_controller();
  return simulate_person(condition, &controller, 1, 1, 0).front().summary;
}

TEST(SimulationPeople, Families_HaveDifferentNames) {
  std::set<std::string> names;
  int apart = 0;
  for (const PeopleFamily& family : people_families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_EQ(people_family(family.name), &family);
    EXPECT_NE(std::string(family.description), "");
    apart += !family.tuned;
  }
  EXPECT_EQ(std::string(people_families().front().name), "linear");
  EXPECT_GE(apart, 2);
  EXPECT_EQ(people_family("unknown"), nullptr);
}

TEST(SimulationPeople, SeedDurationAndIndex_DetermineThePerson) {
  const auto weight = [](std::uint64_t seed, double duration_s, std::uint32_t index) {
    return draw_person(*people_family("linear"), duration_s, seed, index).person.illusion.tactile_weight;
  };
  EXPECT_EQ(weight(1, 1.5, 3), weight(1, 1.5, 3));
  EXPECT_NE(weight(1, 1.5, 3), weight(2, 1.5, 3));
  EXPECT_NE(weight(1, 1.5, 3), weight(1, 2.0, 3));
  EXPECT_NE(weight(1, 1.5, 3), weight(1, 1.5, 4));
}

TEST(SimulationPeople, Families_HaveTheTraitOfTheirName) {
  using C = const PersonCondition&;
  using Values = std::set<double>;
  EXPECT_EQ(values("bias-3", [](C c) { return c.person.bias_deg; }), (Values{-3.0, 3.0}));
  EXPECT_EQ(values("drift", [](C c) { return c.person.weight_drift; }), (Values{-0.05, 0.05}));
  EXPECT_EQ(values("wild-rest", [](C c) { return 1.0 * c.tracker.burst_samples; }), (Values{1.0, 2.0}));
  EXPECT_EQ(values("turned-2", [](C c) { return c.tracker.turned_deg; }), (Values{-2.0, 2.0}));
  EXPECT_EQ(values("clip-60", [](C c) { return c.person.illusion.scale_deg; }), (Values{60.0}));
  EXPECT_EQ(draw("sine-45").person.illusion.family, IllusionFamily::sine);
  EXPECT_EQ(draw("heavy-arm").person.steering, Steering::heavy_arm);
  EXPECT_EQ(people_controller(draw("latency-45")).tracker_latency_ns, 0) << "the controller does not know the latency";
  EXPECT_EQ(people_controller(draw("latency-100")).tracker_latency_ns, 100'000'000);
}

// A gap of 10 degrees is feasible if w_T exceeds 10 / (largest effective angle): 75 degrees (the bound, if linear), 60
// and 45 (saturation), 45 (sine), 65 (75 minus a dead band of 10). With the unequal illusion, w_T must be twice as
// large for gaps to the right.
TEST(SimulationPeople, WeightsAtTheLimit_GiveTheHandCalculatedFeasibility) {
  struct Limit {
    IllusionFamily family;
    double scale_deg;
    double left;
    double right;
  };
  using enum IllusionFamily;
  for (const Limit& limit :
       {Limit{linear, 45.0, 10.0 / 75.0, 10.0 / 75.0}, Limit{saturating, 60.0, 10.0 / 60.0, 10.0 / 60.0},
        Limit{saturating, 45.0, 10.0 / 45.0, 10.0 / 45.0}, Limit{sine, 45.0, 10.0 / 45.0, 10.0 / 45.0},
        Limit{dead_band, 10.0, 10.0 / 65.0, 10.0 / 65.0}, Limit{unequal, 45.0, 10.0 / 75.0, 20.0 / 75.0}}) {
    EXPECT_FALSE(gap_is_feasible(condition(limit.family, limit.scale_deg, limit.left - 1e-6, 1.0)));
    EXPECT_TRUE(gap_is_feasible(condition(limit.family, limit.scale_deg, limit.left + 1e-6, 1.0)));
    EXPECT_FALSE(gap_is_feasible(condition(limit.family, limit.scale_deg, limit.right - 1e-6, -1.0)));
    EXPECT_TRUE(gap_is_feasible(condition(limit.family, limit.scale_deg, limit.right + 1e-6, -1.0)));
  }
}

// A visual bias of 3 degrees makes the gap 13 degrees; a bias of 3 degrees of the perceived own direction makes it 7.
TEST(SimulationPeople, ABias_ChangesTheGap) {
  const auto holds = [](double weight, double bias_deg, double own_bias_deg) {
    PersonCondition person = condition(IllusionFamily::linear, 45.0, weight);
    person.person.bias_deg = bias_deg;
    person.person.own_bias_deg = own_bias_deg;
    return gap_is_feasible(person);
  };
  EXPECT_FALSE(holds(13.0 / 75.0 - 1e-6, 3.0, 0.0));
  EXPECT_TRUE(holds(13.0 / 75.0 + 1e-6, 3.0, 0.0));
  EXPECT_FALSE(holds(7.0 / 75.0 - 1e-6, 0.0, 3.0));
  EXPECT_TRUE(holds(7.0 / 75.0 + 1e-6, 0.0, 3.0));
  EXPECT_TRUE(holds(10.0 / 75.0 + 1e-6, 3.0, 3.0));
}

TEST(SimulationPeople, EqualArguments_GiveEqualOutcomes) {
  const PersonCondition person = draw("mixture", 3);
  const RetargeterConfig controller = people_controller();
  const auto five = simulate_person(person, &controller, 5, 1, 3);
  const auto again = simulate_person(person, &controller, 5, 1, 3);
  ASSERT_EQ(five.size(), 5U);
  for (std::size_t i = 0; i < five.size(); ++i) {
    EXPECT_EQ(five[i].miss_mm, again[i].miss_mm);
    EXPECT_EQ(five[i].summary.estimate.tactile_weight, again[i].summary.estimate.tactile_weight);
  }
  // The number of reaches does not change the first reach; seed and index do. Successive reaches differ.
  EXPECT_EQ(simulate_person(person, &controller, 1, 1, 3).front().miss_mm, five.front().miss_mm);
  EXPECT_NE(simulate_person(person, &controller, 1, 2, 3).front().miss_mm, five.front().miss_mm);
  EXPECT_NE(simulate_person(person, &controller, 1, 1, 4).front().miss_mm, five.front().miss_mm);
  EXPECT_NE(five[0].miss_mm, five[1].miss_mm);
}

// The virtual target is 10 degrees from the real one.
TEST(SimulationPeople, WithoutIllusion_TheHandReachesTheVirtualTarget) {
  const RetargeterConfig controller = people_controller();
  for (const double side : {1.0, -1.0}) {
    PersonCondition person = condition(IllusionFamily::dead_band, 90.0, 0.2, side);
    person.person.noise_deg2_per_s = 0.0;
    person.person.start_direction_deg = person.virtual_direction_deg;
    EXPECT_FALSE(gap_is_feasible(person));
    const RetargeterConfig* const none = nullptr;
    for (const RetargeterConfig* config : {none, &controller}) {
      const PersonOutcome outcome = simulate_person(person, config, 1, 1, 0).front();
      EXPECT_NEAR(outcome.bearing_error_deg, 10.0 * side, 1e-6);
      EXPECT_EQ(outcome.summary.person.has_value(), config != none);
      EXPECT_NEAR(outcome.miss_mm, side * 100.0 * std::sin(10.0 * 3.14159265358979 / 180.0), 1e-6);
      EXPECT_NEAR(outcome.peak_felt_error_deg, 0.0, 1e-6);
    }
  }
}

// Samples come at 90 Hz during a rest of 0.4 to 0.8 s, 1.5 s of motion, and 0.3 s after it.
TEST(SimulationPeople, Trackers_HaveTheirRateAndLosses) {
  const auto summary = [](const char* family) { return guided(draw(family)); };
  const ReachSummary usual = summary("linear");
  EXPECT_GE(usual.samples + usual.dropped_samples, 90.0 * 2.2 - 2.0);
  EXPECT_LE(usual.samples, 90.0 * 2.6 + 2.0);
  EXPECT_NEAR(static_cast<double>(summary("slow-tracker").samples), static_cast<double>(usual.samples) / 3.0, 8.0);
  EXPECT_GT(summary("dropouts").dropped_samples, usual.dropped_samples + 10);
  EXPECT_GT(summary("outliers").dropped_samples, usual.dropped_samples);
}

TEST(SimulationPeople, InformedControllers_HaveTheTrueTraits) {
  EXPECT_EQ(people_controller().mode, ControlMode::reach);
  EXPECT_EQ(paper_controller().mode, ControlMode::mpc);
  EXPECT_TRUE(is_valid(people_controller()));
  EXPECT_TRUE(is_valid(paper_controller()));
  for (const PeopleFamily& family : people_families())
    EXPECT_TRUE(is_valid(informed_controller(draw(family.name)))) << family.name;
  using T = PersonState;
  const PersonCondition biased = draw("bias-3", 2);
  const PersonBelief linear = informed_controller(biased).person;
  EXPECT_NEAR(linear.mean(T::weight), biased.person.illusion.tactile_weight, 1e-12);
  EXPECT_NEAR(linear.mean(T::curve), 0.0, 1e-12);
  EXPECT_EQ(linear.mean(T::bias), biased.person.bias_deg);
  EXPECT_NEAR(linear.mean(T::log_rate), -std::log(1.5), 1e-9);
  EXPECT_EQ(informed_controller(draw("habit-5")).person.mean(T::habit), draw("habit-5").person.habit_deg);
  EXPECT_GT(informed_controller(draw("clip-45")).person.mean(T::curve), 0.02);
}

TEST(SimulationPeople, DrawFault_GivesOneFaultOrNone) {
  std::set<int> faults;
  Draws draws(1, PersonStream::faults, 0, 0);
  for (int i = 0; i < 100; ++i) {
    PersonCondition with = draw("linear");
    const TrackerModel before = with.tracker;
    const PlateDynamics plate = with.plate;
    draw_fault(with, draws);
    const TrackerModel& now = with.tracker;
    // One criterion for each fault: slow-tracker also changes the jitter, and noise-100 the white noise.
    const bool has[] = {now.rate_hz != before.rate_hz,
                        now.correlated_mm != before.correlated_mm,
                        now.white_mm > before.white_mm,
                        now.burst_samples > 0 && now.burst_at_s < 0.5,
                        now.burst_samples > 0 && now.burst_at_s >= 0.5,
                        now.outlier_share > 0.0,
                        now.dropout_share > 0.0,
                        with.plate.max_speed_deg_s != plate.max_speed_deg_s,
                        with.plate.latency_ns != plate.latency_ns,
                        now.late_s > 0.0,
                        now.latency_s > 0.0};
    EXPECT_LE(std::count(std::begin(has), std::end(has), true), 1);
    faults.insert(static_cast<int>(std::find(std::begin(has), std::end(has), true) - std::begin(has)));
  }
  EXPECT_EQ(faults.size(), 12U);  // 11 faults, and the condition without one
}

// Trackers without noise, with a rotated, scaled or sheared frame, and a headset with an error of 11 mm at the target.
TEST(SimulationPeople, FramesWithErrors_GiveTheHandCalculatedBearings) {
  const auto seen = [](PersonCondition condition) {
    condition.person.illusion = {.family = IllusionFamily::dead_band, .tactile_weight = 0.2, .scale_deg = 90.0};
    condition.person.noise_deg2_per_s = condition.person.start_direction_deg = 0.0;
    condition.virtual_direction_deg = 0.0;
    condition.real_direction_deg = 5.0;
    condition.tracker.white_mm = 0.0;
    return guided(condition);
  };
  const ReachSummary turned = seen(draw("turned-2"));
  const double turned_deg = draw("turned-2").tracker.turned_deg;
  EXPECT_NEAR(turned.bearing_error_deg, turned_deg - 5.0, 0.05);
  const ReachSummary sheared = seen(draw("sheared-2"));
  EXPECT_NEAR(std::abs(sheared.bearing_error_deg + 5.0), 2.0, 0.05);
  // The third side of a triangle with sides of 100 mm and 95 or 105 mm, 5 degrees apart.
  const double scale = draw("scaled-5").tracker.scale;
  const double across_mm = 100.0 * std::sin(5.0 * 3.14159265358979 / 180.0);
  const double along_mm = 100.0 * std::cos(5.0 * 3.14159265358979 / 180.0) - 100.0 * scale;
  EXPECT_NEAR(seen(draw("scaled-5")).distance_to_target_mm, std::hypot(across_mm, along_mm), 0.3);
  for (std::uint32_t i = 0; i < 20; ++i) {
    const TrackerModel tracker = draw("headset", i).tracker;
    const double turn = tracker.turned_deg * 3.14159265358979 / 180.0;
    EXPECT_NEAR(std::hypot(100.0 * tracker.scale * std::cos(turn) - 100.0, 100.0 * tracker.scale * std::sin(turn)),
                11.0, 1e-9);
  }
}

// The shift of the perceived direction is the tactile weight times the angle between motion and ridge normal, which the
// plate offset changes by 10 degrees.
TEST(SimulationPeople, APlateOffset_DeflectsThePathByTheWeight) {
  PersonCondition condition = draw("linear");
  condition.person.noise_deg2_per_s = 0.0;
  condition.plate_offset_deg = 10.0;
  const double weight = condition.person.illusion.tactile_weight;
  const double goal_deg = condition.virtual_direction_deg;
  condition.person.start_direction_deg = (goal_deg - weight * 10.0) / (1.0 - weight);
  const double end_deg =
      simulate_person(condition, nullptr, 1, 1, 0).front().bearing_error_deg + condition.real_direction_deg;
  EXPECT_NEAR(end_deg, condition.person.start_direction_deg, 0.3);
}

// Geometric mean of the wander's SD that is estimated after five reaches.
double learnt_wander_deg(const char* family) {
  const RetargeterConfig controller = people_controller();
  double sum = 0.0;
  int people = 0;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const auto learnt = simulate_person(draw(family, i), &controller, 5, 1, i).back().learnt;
    if (!learnt) continue;  // for example, the last reach did not fit the model
    sum += learnt->mean(PersonState::log_wander);
    ++people;
  }
  return std::exp(sum / people);
}

TEST(SimulationPeople, FiveReaches_EstimateTheSdOfTheWander) {
  EXPECT_LT(learnt_wander_deg("linear"), 3.0);
  EXPECT_GT(learnt_wander_deg("recorded"), std::exp(unknown_person().mean(PersonState::log_wander)));
}

// The weight drops from 0.28 to 0.16, with which a gap of 10 degrees is still feasible.
TEST(SimulationPeople, AWeightThatDrops_IsEstimatedAgainWithinTwoReaches) {
  const RetargeterConfig controller = people_controller();
  int near = 0;
  for (std::uint32_t i = 0; i < 100; ++i) {
    PersonCondition condition = draw("linear", i);
    condition.person.illusion.tactile_weight = 0.28;
    RetargeterConfig later = controller;
    later.person = *simulate_person(condition, &controller, 4, 1, i).back().learnt;
    condition.person.illusion.tactile_weight = 0.16;
    const auto outcomes = simulate_person(condition, &later, 3, 2, i);
    near += std::abs(outcomes.back().bearing_error_deg) <= 1.5;
  }
  EXPECT_GE(near, 70);
}

// The tracker's frame is rotated by 6 degrees. Contacts after each reach measure the rotation.
TEST(SimulationPeople, Contacts_CorrectARotatedFrame) {
  PersonCondition condition = draw("linear");
  condition.tracker.turned_deg = 6.0;
  const RetargeterConfig controller = people_controller();
  const auto mean_miss_deg = [&](double contact_sd_mm) {
    condition.contact_sd_mm = contact_sd_mm;
    constexpr std::uint32_t people = 20;
    double sum_deg = 0.0;
    for (std::uint32_t i = 0; i < people; ++i)
      sum_deg += std::abs(simulate_person(condition, &controller, 4, 1, i).back().bearing_error_deg);
    return sum_deg / people;
  };
  EXPECT_GT(mean_miss_deg(0.0), 3.0);
  EXPECT_LT(mean_miss_deg(1.0), 1.0);
}

}  // namespace

}  // namespace hrt
