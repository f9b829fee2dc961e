#include "samples/mock_runtime/world/fingers.h"

#include <array>

#include "core/math/trigonometry.h"
#include "samples/mock_runtime/world/pose.h"

namespace hrt::mock {
namespace {

// The joints of a finger from the one that its bones turn about to its tip.
using Chain = std::array<std::size_t, 4>;
constexpr Chain thumb{XR_HAND_JOINT_THUMB_METACARPAL_EXT, XR_HAND_JOINT_THUMB_PROXIMAL_EXT,
                      XR_HAND_JOINT_THUMB_DISTAL_EXT, XR_HAND_JOINT_THUMB_TIP_EXT};
constexpr Chain index_finger{XR_HAND_JOINT_INDEX_PROXIMAL_EXT, XR_HAND_JOINT_INDEX_INTERMEDIATE_EXT,
                             XR_HAND_JOINT_INDEX_DISTAL_EXT, XR_HAND_JOINT_INDEX_TIP_EXT};

// How far each bone of a fist is bent against the one before it.
constexpr std::array<double, 3> finger_fist_deg{75.0, 95.0, 65.0};
constexpr std::array<double, 3> thumb_fist_deg{15.0, 40.0, 60.0};

// Where the tips of thumb and index finger meet, in reach of both, and how far apart they are then: less
// than the two radii, since skin gives.
const Eigen::Vector3d meeting_m(-0.042, -0.050, -0.100);
constexpr double pinch_gap_m = 0.008;

Chain finger(std::size_t number) {  // 1: index, to 4: little finger
  Chain chain = index_finger;
  for (std::size_t& joint : chain) joint += 5 * (number - 1);
  return chain;
}

std::array<double, 3> lengths(const JointPositions& hand_m, const Chain& chain) {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = (hand_m[chain[i + 1]] - hand_m[chain[i]]).norm();
  return result;
}

// Turns the bones of a straight finger about one axis, each further than the one before.
void curl(const Chain& chain, const Eigen::Vector3d& straight, const Eigen::Vector3d& axis, double amount,
          const std::array<double, 3>& fist_deg, JointPositions& hand_m) {
  const auto bones_m = lengths(hand_m, chain);
  double angle_deg = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    angle_deg -= amount * fist_deg[i];
    hand_m[chain[i + 1]] = hand_m[chain[i]] + bones_m[i] * (turn(angle_deg, axis) * straight);
  }
}

// Brings the tip to a place in reach. Aristidou and Lasenby 2011, FABRIK: from the tip to the root and back,
// each joint is put onto the line to its neighbour, at the bone's length.
void reach(const Chain& chain, const Eigen::Vector3d& tip_m, JointPositions& hand_m) {
  const auto bones_m = lengths(hand_m, chain);
  const Eigen::Vector3d root_m = hand_m[chain[0]];
  const auto pull = [&](std::size_t moved, std::size_t to, double bone_m) {
    const Eigen::Vector3d along = hand_m[chain[moved]] - hand_m[chain[to]];
    hand_m[chain[moved]] = hand_m[chain[to]] + along * (bone_m / along.norm());
  };
  for (int sweep = 0; sweep < 40; ++sweep) {
    hand_m[chain[3]] = tip_m;
    for (std::size_t i = 3; i > 0; --i) pull(i - 1, i, bones_m[i - 1]);
    hand_m[chain[0]] = root_m;
    for (std::size_t i = 0; i < 3; ++i) pull(i + 1, i, bones_m[i]);
  }
}

}  // namespace

Fingers between(const Fingers& from, const Fingers& to, double share) {
  Fingers fingers{from.curl, from.pinch + share * (to.pinch - from.pinch)};
  if (from.curl && to.curl)
    for (std::size_t i = 0; i < 5; ++i) (*fingers.curl)[i] += share * ((*to.curl)[i] - (*from.curl)[i]);
  return fingers;
}

void bend(const Fingers& fingers, JointPositions& hand_m) {
  if (fingers.curl) {
    for (std::size_t number = 1; number <= 4; ++number) {
      const Chain chain = finger(number);
      const Eigen::Vector3d straight = (hand_m[chain[0]] - hand_m[chain[0] - 1]).normalized();
      curl(chain, straight, Eigen::Vector3d::UnitX(), (*fingers.curl)[number], finger_fist_deg, hand_m);
    }
    // The thumb bends across the palm.
    const Eigen::Vector3d straight = (hand_m[thumb[1]] - hand_m[thumb[0]]).normalized();
    const Eigen::Vector3d to_pad(0.3, -0.4, 0.0);
    curl(thumb, straight, to_pad.cross(straight).normalized(), (*fingers.curl)[0], thumb_fist_deg, hand_m);
  }
  if (fingers.pinch > 0.0) {
    const Eigen::Vector3d half_m(0.0, 0.0, pinch_gap_m / 2.0);
    const Eigen::Vector3d thumb_tip_m = hand_m[thumb[3]], index_tip_m = hand_m[index_finger[3]];
    reach(thumb, thumb_tip_m + fingers.pinch * (meeting_m + half_m - thumb_tip_m), hand_m);
    reach(index_finger, index_tip_m + fingers.pinch * (meeting_m - half_m - index_tip_m), hand_m);
  }
}

}  // namespace hrt::mock
