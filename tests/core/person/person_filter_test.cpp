#include "core/person/person_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <set>

#include "core/person/person_belief.h"
#include "core/person/tuning.h"
#include "core/simulation/person.h"

namespace hrt {
namespace {

using F = PersonFilter;
using X = PersonState;

// Corrects the filter by a position unless the NIS of the position exceeds `gate`. Returns the NIS.
double observe(PersonFilter& filter, const PlatePoint& position, double gate) {
  const F::Innovation innovation = filter.innovation(position);
  if (innovation.nis <= gate) filter.correct(innovation);
  return innovation.nis;
}

PersonFilter moving_filter() {
  PersonFilter filter(unknown_person(), 5.0, 100.0, {});
  filter.begin(0.0, 0.02, 0.3);
  for (int i = 0; i < 40; ++i) filter.move(0.01, 40.0 - i);
  return filter;
}

// Returns the smallest eigenvalue of the correlation matrix.
double min_eigenvalue(const F::Covariance& covariance) {
  const F::State sd = covariance.diagonal().cwiseSqrt();
  const F::Covariance symmetric = 0.5 * (covariance + covariance.transpose());
  F::Covariance correlation;
  for (int i = 0; i < X::count; ++i)
    for (int j = 0; j < X::count; ++j)
      correlation(i, j) = sd(i) > 0.0 && sd(j) > 0.0 ? symmetric(i, j) / (sd(i) * sd(j)) : (i == j ? 1.0 : 0.0);
  return Eigen::SelfAdjointEigenSolver<F::Covariance>(correlation).eigenvalues()(0);
}

// A person without illusion starts in the direction h V and turns towards V: phi = V (1 - (1 - h) exp(-k t)). At a
// constant speed, the path of 100 mm is complete after one second.
TEST(PersonFilter, APersonWithoutIllusion_MovesByTheClosedForm) {
  PersonBelief belief = unknown_person();
  belief.mean << 0.01, 0.0, 5.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.5;
  Tuning tuning;
  tuning.first_direction = 0.4;
  PersonFilter filter(belief, 10.0, 100.0, {}, tuning);
  filter.begin(0.0, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(filter.direction_deg(), 4.0);
  double away_mm = 0.0;
  double right_mm = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double phi_rad = (10.0 - 6.0 * std::exp(-5.0 * 0.01 * (i + 0.5))) * 0.017453292519943295;
    right_mm -= std::sin(phi_rad);
    away_mm += std::cos(phi_rad);
    filter.move(0.01, filter.direction_deg());  // ridges across the motion cause no shift
  }
  EXPECT_NEAR(filter.direction_deg(), 10.0 - 6.0 * std::exp(-5.0), 0.01);
  EXPECT_NEAR(filter.mean(X::right), right_mm, 0.05);
  EXPECT_NEAR(filter.mean(X::away), away_mm, 0.01);
  EXPECT_NEAR(filter.mean(X::phase), 1.0, 1e-9);
  const double end_mm = filter.mean(X::away);
  filter.move(0.012, 0.0);
  EXPECT_EQ(filter.mean(X::away), end_mm);
}

// With a variance in one trait only, cov(x, trait) / var(trait) of a state x after some steps is the derivative of x by
// the trait. The test compares this derivative with the difference quotient of two runs.
TEST(PersonFilter, Covariances_FollowTheDerivativesOfTheMotion) {
  const struct {
    X::Index trait;
    double step;
  } cases[] = {{X::weight, 1e-4}, {X::curve, 1e-4}, {X::gain, 1e-2},
               {X::bias, 1e-3},   {X::habit, 1e-3}, {X::fading, 1e-3}};
  constexpr int steps = 30;
  constexpr double step_s = 0.002;
  for (const auto& c : cases) {
    const auto run = [&](double change) {
      PersonBelief belief = unknown_person();
      belief.mean(c.trait) += change;
      PersonFilter filter(belief, 10.0, 100.0, {});
      filter.begin(0.0, 0.0, 0.0);
      for (int i = 0; i < steps; ++i) filter.move(step_s, 45.0);
      return filter;
    };
    PersonBelief sure = unknown_person();
    sure.covariance *= 1e-12;
    sure.mean(X::scatter) = 0.0;
    sure.covariance(c.trait, c.trait) = 1.0;
    PersonFilter filter(sure, 10.0, 100.0, {});
    filter.begin(0.0, 0.0, 0.0);
    for (int i = 0; i < steps; ++i) filter.move(step_s, 45.0);
    const F::State difference = (run(c.step).mean() - run(-c.step).mean()) / (2.0 * c.step);
    for (const X::Index i : {X::right, X::away, X::steered}) {
      const double slope = filter.covariance()(i, c.trait) / filter.covariance()(c.trait, c.trait);
      EXPECT_NEAR(slope, difference(i), 0.03 * std::abs(difference(i)) + 0.001) << c.trait << ' ' << i;
    }
  }
}

// The variances are 4 mm^2 (prior), 1 mm^2 (white noise) and 2 mm^2 (correlated noise). 4/7 of the innovation of 3 mm
// are attributed to the position, and 2/7 to the correlated noise; the NIS is 9/7.
TEST(PersonFilter, AnInnovation_IsDividedByVariance) {
  PersonFilter filter(unknown_person(), 0.0, 100.0, {.white_mm = 1.0, .correlated_mm = std::sqrt(2.0)});
  filter.begin(0.0, 0.0, 2.0);
  EXPECT_NEAR(observe(filter, {3.0, 0.0}, 25.0), 9.0 / 7.0, 1e-12);
  EXPECT_NEAR(filter.mean(X::right), 3.0 * 4.0 / 7.0, 1e-12);
  EXPECT_NEAR(filter.mean(X::noise_right), 3.0 * 2.0 / 7.0, 1e-12);
  EXPECT_NEAR(filter.covariance()(X::right, X::right), 4.0 - 16.0 / 7.0, 1e-12);
}

TEST(PersonFilter, ARejectedPosition_LeavesTheStateUnchanged) {
  PersonFilter filter = moving_filter();
  const F::State state = filter.mean();
  const F::Covariance covariance = filter.covariance();
  EXPECT_GT(observe(filter, {500.0, 0.0}, 25.0), 25.0);
  EXPECT_EQ(filter.mean(), state);
  EXPECT_EQ(filter.covariance(), covariance);
}

TEST(PersonFilter, ARestingFinger_LosesCorrelatedNoiseWithItsTimeConstant) {
  for (const double correlation_s : {0.03, 0.3}) {
    PersonFilter filter(unknown_person(), 5.0, 100.0, {0.1, 3.0, correlation_s});
    filter.begin(0.0, 0.02, 1e-6);
    observe(filter, {3.0, 0.0}, 1e9);
    const double before_mm = filter.mean(X::noise_right);
    ASSERT_GT(before_mm, 2.5);
    filter.rest(correlation_s);
    EXPECT_NEAR(filter.mean(X::noise_right), before_mm / std::exp(1.0), 1e-9);
    // The variance returns to its stationary value, 9 mm^2.
    EXPECT_LT(filter.covariance()(X::noise_right, X::noise_right), 8.0);
    filter.rest(20.0 * correlation_s);
    EXPECT_NEAR(filter.covariance()(X::noise_right, X::noise_right), 9.0, 1e-6);
  }
}

TEST(PersonFilter, PeopleOfTheModel_GiveAMeanNisOfTwo) {
  Draws draws(7, 0, 0, 0);
  double sum = 0.0;
  int samples = 0;
  const PersonBelief belief = unknown_person();
  for (int person = 0; person < 60; ++person) {
    PersonBelief drawn = belief;
    for (int i = 0; i < X::traits; ++i) {
      if (i == X::weight || i == X::curve || i == X::evenness) continue;
      drawn.mean(i) += 0.5 * std::sqrt(belief.covariance(i, i)) * draws.normal();
    }
    PersonFilter truth(drawn, 5.0, 100.0, {});
    PersonFilter filter(belief, 5.0, 100.0, {});
    filter.begin(truth.mean(X::log_rate), 0.02, 0.3);
    double noise_right = 0.9 * draws.normal();
    double noise_away = 0.9 * draws.normal();
    const double kept = std::exp(-0.1);
    for (int i = 0; i < 60; ++i) {
      truth.move(0.01, 30.0);
      filter.move(0.01, 30.0);
      const double fresh = 0.9 * std::sqrt(1.0 - kept * kept);
      noise_right = kept * noise_right + fresh * draws.normal();
      noise_away = kept * noise_away + fresh * draws.normal();
      sum += observe(filter,
                     {truth.mean(X::right) + noise_right + 0.8 * draws.normal(),
                      truth.mean(X::away) + noise_away + 0.8 * draws.normal()},
                     100.0);
      ++samples;
    }
  }
  EXPECT_NEAR(sum / samples, 1.95, 0.15);
}

TEST(PersonFilter, LongRuns_KeepTheCovariancePositive) {
  for (const TrackerNoise noise : {TrackerNoise{0.8, 0.9}, TrackerNoise{0.0066, 0.0075}, TrackerNoise{66.0, 75.0}}) {
    for (const double seconds : {0.0005, 0.004, 0.012}) {
      PersonFilter filter(unknown_person(), 5.0, 100.0, noise);
      filter.begin(0.0, 0.02, 0.3);
      for (int i = 0; i < 2000; ++i) {
        filter.move(seconds, 60.0 * std::sin(0.01 * i));
        observe(filter, {filter.mean(X::right) + 0.01 * (i % 7 - 3), filter.mean(X::away)}, 25.0);
        if (i % 100 == 0) filter.add_phase_sd(0.07);
        if (i % 500 == 0) filter.place_at({1.0, 2.0});
      }
      EXPECT_TRUE(filter.mean().allFinite());
      EXPECT_GT(filter.covariance().diagonal().minCoeff(), 0.0);
      EXPECT_GT(min_eigenvalue(filter.covariance()), -1e-9);
    }
  }
}

TEST(PersonBelief, AnyConfiguration_GivesAValidPrior) {
  for (const double weight : {0.01, 0.2, 0.49})
    for (const double weight_sd : {0.001, 0.05, 0.49})
      for (const double bias_deg : {-200.0, 0.0, 200.0})
        EXPECT_TRUE(is_valid(unknown_person(weight, weight_sd, bias_deg)));
  EXPECT_TRUE(is_valid(known_person(0.3, -8.0)));
}

TEST(PersonBelief, AKnownPerson_HasTheGivenWeightAndBias) {
  const PersonBelief person = known_person(0.25, 3.0);
  EXPECT_NEAR(person.mean(X::weight), 0.25, 0.001);
  EXPECT_NEAR(person.mean(X::curve), 0.0, 0.002);
  EXPECT_EQ(person.mean(X::bias), 3.0);
  EXPECT_LT(std::sqrt(person.covariance(X::weight, X::weight)), 0.002);
}

TEST(PersonBelief, InvalidMeansAndCovariances_AreRejected) {
  const PersonBelief person = unknown_person();
  for (int i = 0; i < X::traits; ++i) {
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), 1e9, -1e9}) {
      PersonBelief bad = person;
      bad.mean(i) = value;
      EXPECT_FALSE(is_valid(bad)) << i << ' ' << value;
    }
    PersonBelief sure = person;
    sure.covariance(i, i) = 0.0;
    EXPECT_FALSE(is_valid(sure)) << i;
  }
  PersonBelief skewed = person;
  skewed.covariance(X::weight, X::curve) *= 0.5;
  EXPECT_FALSE(is_valid(skewed));
  PersonBelief correlated = person;
  correlated.covariance(X::weight, X::curve) *= 2.0;
  correlated.covariance(X::curve, X::weight) *= 2.0;
  EXPECT_FALSE(is_valid(correlated));
}

TEST(Tuning, EveryField_HasOneNameAndIsInItsRange) {
  Tuning tuning;
  std::set<std::string> names;
  std::set<const double*> values;
  for (const TuningField& field : tuning_fields(tuning)) {
    names.insert(field.name);
    values.insert(field.value);
    EXPECT_GE(*field.value, field.min) << field.name;
    EXPECT_LE(*field.value, field.max) << field.name;
  }
  EXPECT_EQ(names.size(), sizeof(Tuning) / sizeof(double));
  EXPECT_EQ(values.size(), names.size());
}

}  // namespace
}  // namespace hrt
