#include "core/plate/touched_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/trigonometry.h"

namespace hrt {
namespace {

constexpr PlatePoint home{0.01, -0.05};
constexpr PlatePoint target{0.01, 0.05};  // 100 mm straight ahead
const FrameCovariance exact = FrameCovariance::Zero();

TouchedFrame frame() { return {.home = home}; }

// A prior of 2 % of 100 mm is 2 mm: a contact of 2 mm moves the finger half way to where it is, in either
// direction, and halves the variance. At half of the way there is half of the correction.
TEST(TouchedFrame, SharesAContactByVariance) {
  const PlatePoint true_place{target.right_m + 0.004, target.away_m - 0.002};
  const TouchedFrame after = after_contact(frame(), exact, {target, true_place, 4e-6});
  const PlatePoint moved = corrected(after, target);
  EXPECT_NEAR(moved.right_m, target.right_m + 0.002, 1e-12);
  EXPECT_NEAR(moved.away_m, target.away_m - 0.001, 1e-12);
  EXPECT_NEAR(corrected(after, {home.right_m, 0.0}).right_m, home.right_m + 0.001, 1e-12);
  EXPECT_NEAR(corrected(after, home).right_m, home.right_m, 1e-15);
  EXPECT_NEAR(bearing_sd_deg(after, exact, home, target), deg_per_rad * 0.02 / std::sqrt(2.0), 1e-9);
  EXPECT_TRUE(is_valid(after));
}

// The finger that two contacts saw is where the second one has it: 2 mm and 1.414 mm of prior, and 0.2 %.
TEST(TouchedFrame, WidensBetweenContacts) {
  const TouchedFrame once = after_contact(frame(), exact, {target, target, 4e-6});
  const TouchedFrame twice = after_contact(once, exact, {target, target, 4e-6});
  const double before_m2 = 2e-6 + 4e-8;
  EXPECT_NEAR(twice.covariance(1, 1), before_m2 * 4e-6 / (before_m2 + 4e-6) / 0.01, 1e-12);
}

// A registration whose turn is known to 0.04 rad and whose plate is centred on the target's line: at the
// target, 50 mm from the centre, it moves to the right by 2 mm (SD), as much as the 2 % do.
TEST(TouchedFrame, BeginsAsTheRegistrationHasIt) {
  FrameCovariance registered = exact;
  registered(0, 0) = 0.04 * 0.04;
  const Contact contact{{0.0, 0.05}, {0.004, 0.05}, 8e-6};
  TouchedFrame central{.home = {0.0, -0.05}};
  EXPECT_NEAR(corrected(after_contact(central, registered, contact), contact.finger).right_m, 0.002, 1e-5);
  EXPECT_NEAR(corrected(after_contact(central, exact, contact), contact.finger).right_m, 0.004 / 3.0, 1e-5);
  EXPECT_EQ(bearing_sd_deg(central, registered, central.home, contact.finger),
            frame_bearing_sd_deg(registered, central.home, contact.finger));
}

TEST(TouchedFrame, TurnsTheBearingOfWhatItMoves) {
  const PlatePoint left{target.right_m - 0.1 * std::tan(2.0 / deg_per_rad), target.away_m};
  const TouchedFrame after = after_contact(frame(), exact, {target, left, 1e-12});
  EXPECT_NEAR(turned_deg(frame(), after, target), 2.0, 1e-4);
  EXPECT_NEAR(turned_deg(after, after, left), 0.0, 1e-12);
}

// A frame that is turned by 2 degrees and a plate of 5 % is found by exact contacts at two places.
TEST(TouchedFrame, FindsAnyLinearFrame) {
  const auto seen = [](double right_m, double away_m) {
    return PlatePoint{home.right_m + 1.05 * right_m - 0.035 * away_m, home.away_m + 0.035 * right_m + away_m};
  };
  TouchedFrame found = frame();
  for (int i = 0; i < 20; ++i) {
    const double right_m = i % 2 == 0 ? 0.02 : -0.02;
    const Contact contact{corrected(found, seen(right_m, 0.1)), {home.right_m + right_m, home.away_m + 0.1}, 1e-10};
    found = after_contact(found, exact, contact);
  }
  const PlatePoint place = corrected(found, seen(0.01, 0.06));
  EXPECT_NEAR(place.right_m, home.right_m + 0.01, 1e-5);
  EXPECT_NEAR(place.away_m, home.away_m + 0.06, 1e-5);
}

// 3.717 deviations of 2 mm are the 99.9 % quantile of two coordinates.
TEST(TouchedFrame, ContradictsARegistrationThatIsFarOff) {
  for (const double off_m : {0.0074, 0.0075}) {
    const Contact contact{target, {target.right_m + off_m, target.away_m}, 1e-14};
    EXPECT_EQ(contradicts(after_contact(frame(), exact, contact), exact, target), off_m > 0.00744) << off_m;
  }
  EXPECT_FALSE(contradicts(frame(), exact, target));
}

}  // namespace
}  // namespace hrt
