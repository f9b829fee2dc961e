#include "core/person/person_belief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hrt {
namespace {

using T = PersonTrait;

TEST(PersonBelief, AnUnknownPersonIsValidWhateverWasConfigured) {
  for (const double weight : {0.01, 0.2, 0.49})
    for (const double weight_sd : {0.001, 0.05, 0.49})
      for (const double bias_deg : {-200.0, 0.0, 200.0})
        EXPECT_TRUE(is_valid(unknown_person(weight, weight_sd, bias_deg)));
  EXPECT_TRUE(is_valid(known_person(0.3, -8.0)));
}

TEST(PersonBelief, AKnownPersonIsKnown) {
  const PersonBelief person = known_person(0.25, 3.0);
  EXPECT_NEAR(person.mean(T::weight), 0.25, 0.001);
  EXPECT_NEAR(person.mean(T::curve), 0.0, 0.002);
  EXPECT_EQ(person.mean(T::bias), 3.0);
  EXPECT_LT(std::sqrt(person.covariance(T::weight, T::weight)), 0.002);
}

TEST(PersonBelief, RefusesWhatIsNoBelief) {
  const PersonBelief person = unknown_person();
  for (int i = 0; i < T::count; ++i) {
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
  skewed.covariance(T::weight, T::curve) *= 0.5;
  EXPECT_FALSE(is_valid(skewed));
  PersonBelief correlated = person;
  correlated.covariance(T::weight, T::curve) *= 2.0;
  correlated.covariance(T::curve, T::weight) *= 2.0;
  EXPECT_FALSE(is_valid(correlated));
}

}  // namespace
}  // namespace hrt
