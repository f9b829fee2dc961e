#include "core/learning.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrt {
namespace {

TEST(Learning, ATinySd_IsRaisedToItsLowerBound) {
  const RetargeterConfig next = carried(
      {},
      {.tactile_weight = 0.2, .tactile_weight_sd = 1e-6, .motor_variance_deg2 = 0.5, .motor_variance_sd_deg2 = 1e-6});
  EXPECT_EQ(next.estimator.tactile_weight_sd, Tuning{}.min_carried_weight_sd);
  EXPECT_EQ(next.estimator.motor_variance_sd_deg2, Tuning{}.min_carried_motor_variance_sd_deg2);
}

PersonBelief scaled_person(double scale) {
  PersonBelief belief = unknown_person();
  belief.covariance *= scale * scale;
  return belief;
}

Tuning without_change() {
  Tuning tuning;
  for (TraitTuning& trait : tuning.traits) trait.change = trait.forgotten = 0.0;
  return tuning;
}

TEST(Learning, APosterior_IsWidenedUpToTheUnknownPrior) {
  const PersonBelief unknown = unknown_person();
  for (const double scale : {1e-3, 0.1, 0.9, 1.0, 30.0}) {
    const PersonBelief learnt = scaled_person(scale);
    const PersonBelief next = carried(unknown, learnt, false, unknown);
    EXPECT_TRUE(is_valid(next)) << scale;
    for (int i = 0; i < PersonState::traits; ++i) {
      EXPECT_LE(next.covariance(i, i), unknown.covariance(i, i) * (1.0 + 1e-12)) << scale << ' ' << i;
      if (scale < 0.5) {
        EXPECT_GT(next.covariance(i, i), learnt.covariance(i, i)) << scale << ' ' << i;
      }
    }
  }
}

TEST(Learning, ACovarianceWithRoundingError_BecomesSymmetric) {
  PersonBelief learnt = scaled_person(0.5);
  learnt.covariance(PersonState::weight, PersonState::curve) *= 1.0 + 1e-13;
  EXPECT_FALSE(is_valid(learnt));
  EXPECT_TRUE(is_valid(carried(unknown_person(), learnt, true, unknown_person())));
}

// In a reach that missed, a weight of 0.28 +- 0.02 drops to 0.18, by 5 SDs: the illusion is reset, and the bias is not.
// Nothing is reset after a hit, or after a drop by less than 1.2 SDs.
TEST(Learning, ADropOfTheWeightAfterAMiss_ResetsTheIllusion) {
  const PersonBelief unknown = unknown_person();
  PersonBelief before = unknown;
  before.mean(PersonState::weight) = 0.28;
  before.mean(PersonState::curve) = 0.0;
  before.covariance *= 0.16;
  PersonBelief learnt = before;
  learnt.mean(PersonState::weight) = 0.18;
  learnt.mean(PersonState::bias) = 2.0;
  const PersonBelief next = carried(before, learnt, true, unknown);
  for (const int i : {PersonState::weight, PersonState::curve, PersonState::fading}) {
    EXPECT_EQ(next.mean(i), unknown.mean(i));
    EXPECT_EQ(next.covariance(i, PersonState::weight), unknown.covariance(i, PersonState::weight));
    EXPECT_EQ(next.covariance(i, PersonState::bias), 0.0);
  }
  EXPECT_GT(next.mean(PersonState::bias), 0.3);
  EXPECT_TRUE(is_valid(next));
  EXPECT_NEAR(carried(before, learnt, false, unknown, without_change()).mean(PersonState::weight), 0.18, 1e-9);
  EXPECT_NEAR(carried(unknown, learnt, true, unknown, without_change()).mean(PersonState::weight), 0.18, 1e-9);
}

// Prior: bias 0 +- 4, scatter 1.2 +- 0.8. The posterior of a reach has a bias of 3 +- 0.71. The person's bias becomes
// 3 * 16 / (16 + 1.2^2), and the reach deviates from it by the rest, 0.248. The expected square of this deviation is
// 0.248^2 + 1.3245; the squared scatter moves towards this value by 8 / 17 of the difference.
TEST(Learning, ADeviationOfOneReach_IsDividedBetweenBiasAndScatter) {
  const PersonBelief unknown = unknown_person();
  PersonBelief learnt = unknown;
  set_trait_prior(learnt, PersonState::bias, 3.0, std::sqrt(0.5));
  Tuning tuning = without_change();
  tuning.traits[PersonState::bias].change = 0.5;
  const PersonBelief next = carried(unknown, learnt, false, unknown, tuning);
  EXPECT_NEAR(next.mean(PersonState::bias), 2.7523, 1e-4);
  EXPECT_NEAR(next.covariance(PersonState::bias, PersonState::bias), 1.7419 + 0.25, 1e-4);
  EXPECT_NEAR(next.mean(PersonState::scatter), 1.1893, 1e-4);
  EXPECT_NEAR(next.covariance(PersonState::scatter, PersonState::scatter), 0.3388, 1e-4);
  PersonBelief steady = unknown;
  set_trait_prior(steady, PersonState::scatter, 0.0, 0.1);
  set_trait_prior(learnt, PersonState::scatter, 0.0, 0.1);
  EXPECT_NEAR(carried(steady, learnt, false, unknown, tuning).mean(PersonState::bias), 3.0 * 16.0 / 16.04, 1e-4);
}

// In units of their prior SDs, gain and log_rate are x and y. A reach has determined (x + y) / sqrt(2) as -1 +- 0.1,
// but not (x - y) / sqrt(2), which has the SD 1 of the prior and the mean -2. After a tenth of the information is
// forgotten, the sum has the mean -90 / (90 + 0.1), and the difference 0.9 x -2.
TEST(Learning, ACombinationWithoutInformation_ReturnsToThePrior) {
  const PersonBelief unknown = unknown_person();
  Tuning tuning = without_change();
  const int pair[] = {PersonState::gain, PersonState::log_rate};
  const double sd[] = {trait_sd(unknown, pair[0]), trait_sd(unknown, pair[1])};
  PersonBelief learnt = unknown;
  for (int i = 0; i < 2; ++i) {
    tuning.traits[pair[i]].forgotten = 0.1;
    learnt.mean(pair[i]) += sd[i] * (i == 0 ? -3.0 : 1.0) / std::sqrt(2.0);
    for (int j = 0; j < 2; ++j) learnt.covariance(pair[i], pair[j]) = sd[i] * sd[j] * (i == j ? 0.505 : -0.495);
  }
  const PersonBelief next = carried(unknown, learnt, false, unknown, tuning);
  const PersonBelief::Vector change = next.mean - unknown.mean;
  const double x = change(pair[0]) / sd[0], y = change(pair[1]) / sd[1];
  EXPECT_NEAR((x + y) / std::sqrt(2.0), -90.0 / 90.1, 1e-6);
  EXPECT_NEAR((x - y) / std::sqrt(2.0), -1.8, 1e-6);
  EXPECT_NEAR(next.covariance(pair[0], pair[0]), sd[0] * sd[0] * 0.5 * (1.0 + 1.0 / 90.1), 1e-6);
}

// A reach begins with a habit of 0 +- 2 that has an SD of e^1.4 from reach to reach; the posterior is 3 +- 1.41. The
// variance becomes 3.294, which is 0.8235 of the prior variance. The former error, 9 (SD), shrinks by this factor, to a
// variance of 54.93. The measured value adds 0.1765 x 3.294.
TEST(Learning, AHabitOfAReach_GivesTheSdOfItsErrorAndASmallerOneForSteering) {
  const PersonBelief unknown = unknown_person();
  PersonBelief learnt = steering_belief(unknown, {});
  EXPECT_EQ(learnt.covariance(PersonState::habit, PersonState::habit), 4.0);
  set_trait_prior(learnt, PersonState::habit, 3.0, std::sqrt(2.0));
  const PersonBelief next = carried(unknown, learnt, false, unknown, without_change());
  EXPECT_NEAR(next.covariance(PersonState::habit, PersonState::habit), 55.51, 0.01);
  EXPECT_EQ(trait_sd(steering_belief(next, {}), PersonState::habit), 2.0);
  EXPECT_EQ(steering_belief(next, {}).mean, next.mean);
}

// The contact is 4 mm to the right of the tracked finger, 100 mm from the start. The unknown frame (SD 0.02, that is,
// 2 mm at 100 mm) and the contact (SD 2 mm) are equally uncertain. So half of the 4 mm is attributed to the frame,
// which turns by -1.146 degrees, and the bias changes by the same angle. A bias that was not estimated in reaches is
// unchanged.
TEST(Learning, AContact_MovesPartOfTheBiasToTheFrame) {
  RetargeterConfig config;
  config.person.mean(PersonState::bias) = 2.0;
  const Contact contact{{0.0, 100.0}, {4.0, 100.0}, 4.0};
  const RetargeterConfig learnt = carried(config, contact, true);
  EXPECT_NEAR(learnt.person.mean(PersonState::bias), 2.0 - 1.1458, 1e-3);
  EXPECT_NEAR(corrected(learnt.touched, contact.finger).right_mm, 2.0, 1e-9);
  EXPECT_EQ(learnt.person.covariance, config.person.covariance);
  EXPECT_EQ(carried(config, contact, false).person.mean(PersonState::bias), 2.0);
  EXPECT_TRUE(is_valid(learnt));
}

}  // namespace
}  // namespace hrt
