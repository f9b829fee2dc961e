#include "core/plate/touched_frame.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

constexpr PlatePoint home{10.0, -50.0};
constexpr PlatePoint ahead{10.0, 50.0};  // 100 mm straight ahead
const FrameCovariance exact = FrameCovariance::Zero();

TouchedFrame frame() { return {.home = home}; }

// The prior variance of the second contact is (2 mm)^2 / 2 + (0.2 mm)^2.
TEST(TouchedFrame, TimeBetweenContacts_WidensTheCovariance) {
  const TouchedFrame once = after_contact(frame(), exact, {ahead, ahead, 4.0});
  const TouchedFrame twice = after_contact(once, exact, {ahead, ahead, 4.0});
  const double before_mm2 = 2.0 + 0.04;
  EXPECT_NEAR(twice.covariance(1, 1), before_mm2 * 4.0 / (before_mm2 + 4.0) / 1e4, 1e-12);
}

// The registration's rotation has an SD of 0.04 rad about a centre 50 mm from the target: an SD of 2 mm to the right at
// the target, in addition to the 2 mm of the prior of the correction at 100 mm from home.
TEST(TouchedFrame, TheFirstContact_UsesTheUncertaintyOfTheRegistration) {
  FrameCovariance registered = exact;
  registered(0, 0) = 0.04 * 0.04;
  const Contact contact{{0.0, 50.0}, {4.0, 50.0}, 8.0};
  TouchedFrame central{.home = {0.0, -50.0}};
  EXPECT_NEAR(corrected(after_contact(central, registered, contact), contact.finger).right_mm, 2.0, 1e-2);
  EXPECT_NEAR(corrected(after_contact(central, exact, contact), contact.finger).right_mm, 4.0 / 3.0, 1e-2);
  EXPECT_EQ(bearing_sd_deg(central, registered, central.home, contact.finger),
            frame_bearing_sd_deg(registered, central.home, contact.finger));
}

// Exact contacts at two positions determine a frame that is rotated by 2 degrees and stretched by 5 % to the right.
TEST(TouchedFrame, ExactContacts_GiveAnyLinearFrame) {
  const auto seen = [](double right_mm, double away_mm) {
    return PlatePoint{home.right_mm + 1.05 * right_mm - 0.035 * away_mm, home.away_mm + 0.035 * right_mm + away_mm};
  };
  TouchedFrame found = frame();
  for (int i = 0; i < 20; ++i) {
    const double right_mm = i % 2 == 0 ? 20.0 : -20.0;
    const Contact contact{
        corrected(found, seen(right_mm, 100.0)), {home.right_mm + right_mm, home.away_mm + 100.0}, 1e-4};
    found = after_contact(found, exact, contact);
  }
  const PlatePoint place = corrected(found, seen(10.0, 60.0));
  EXPECT_NEAR(place.right_mm, home.right_mm + 10.0, 1e-2);
  EXPECT_NEAR(place.away_mm, home.away_mm + 60.0, 1e-2);
}

// The 99.9 % quantile for two coordinates is 3.717 SDs of 2 mm: 7.43 mm.
TEST(TouchedFrame, ALargeCorrection_ContradictsTheRegistration) {
  for (const double off_mm : {7.4, 7.5}) {
    const Contact contact{ahead, {ahead.right_mm + off_mm, ahead.away_mm}, 1e-8};
    EXPECT_EQ(contradicts(after_contact(frame(), exact, contact), exact, ahead), off_mm > 7.44) << off_mm;
  }
  EXPECT_FALSE(contradicts(frame(), exact, ahead));
}

}  // namespace
}  // namespace hrt
