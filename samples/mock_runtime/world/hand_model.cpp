#include "samples/mock_runtime/world/hand_model.h"

#include "core/math/trigonometry.h"

namespace hrt::mock {
namespace {

// A right hand, palm down, wrist at the origin, in metres: +X right, +Y up, -Z to the fingers. The index
// finger touches a surface that the others, bent further, clear. The palm is computed: the middle of a bone.
struct Rest {
  Eigen::Vector3d position_m;
  double radius_m;
};

const std::array<Rest, XR_HAND_JOINT_COUNT_EXT>& rest_hand() {
  static const std::array<Rest, XR_HAND_JOINT_COUNT_EXT> rest{{
      {{}, 0.022},                        // palm: see below
      {{0.000, 0.000, 0.000}, 0.025},     // wrist
      {{-0.025, -0.010, -0.018}, 0.019},  // thumb: metacarpal, proximal, distal, tip
      {{-0.045, -0.022, -0.052}, 0.013},
      {{-0.050, -0.028, -0.084}, 0.011},
      {{-0.048, -0.032, -0.112}, 0.009},
      {{-0.020, 0.000, -0.030}, 0.020},  // index: metacarpal, proximal, intermediate, distal, tip
      {{-0.025, 0.003, -0.090}, 0.011},
      {{-0.027, -0.016, -0.126}, 0.009},
      {{-0.028, -0.034, -0.144}, 0.008},
      {{-0.028, -0.055, -0.158}, 0.007},
      {{0.000, 0.000, -0.028}, 0.020},  // middle
      {{-0.002, 0.005, -0.092}, 0.011},
      {{-0.002, -0.008, -0.130}, 0.009},
      {{-0.002, -0.035, -0.125}, 0.008},
      {{-0.002, -0.042, -0.105}, 0.007},
      {{0.018, -0.001, -0.028}, 0.019},  // ring
      {{0.020, 0.002, -0.086}, 0.010},
      {{0.020, -0.012, -0.120}, 0.009},
      {{0.020, -0.036, -0.114}, 0.008},
      {{0.020, -0.042, -0.092}, 0.007},
      {{0.033, -0.004, -0.027}, 0.018},  // little
      {{0.038, -0.002, -0.078}, 0.009},
      {{0.039, -0.014, -0.104}, 0.008},
      {{0.039, -0.033, -0.098}, 0.007},
      {{0.038, -0.038, -0.080}, 0.006},
  }};
  return rest;
}

// Axes with -Z along `forward` and +X as near to `right` as that allows.
Eigen::Quaterniond axes(const Eigen::Vector3d& forward, const Eigen::Vector3d& right) {
  Eigen::Matrix3d columns;
  const Eigen::Vector3d back = -forward.normalized();
  const Eigen::Vector3d across = (right - right.dot(back) * back).normalized();
  columns << across, back.cross(across), back;
  return Eigen::Quaterniond(columns);
}

bool is_tip(int joint) {
  return joint == XR_HAND_JOINT_THUMB_TIP_EXT ||
         (joint >= XR_HAND_JOINT_INDEX_TIP_EXT && (joint - XR_HAND_JOINT_INDEX_TIP_EXT) % 5 == 0);
}

HandJoints right_hand(const Fingers& fingers) {
  const auto& rest = rest_hand();
  JointPositions bent_m;
  for (std::size_t joint = 0; joint < rest.size(); ++joint) bent_m[joint] = rest[joint].position_m;
  bend(fingers, bent_m);
  const auto at = [&](int joint) { return bent_m[static_cast<std::size_t>(joint)]; };
  HandJoints joints;
  for (int joint = XR_HAND_JOINT_WRIST_EXT; joint < XR_HAND_JOINT_COUNT_EXT; ++joint) {
    Eigen::Vector3d forward;
    if (joint == XR_HAND_JOINT_WRIST_EXT)
      forward = at(XR_HAND_JOINT_MIDDLE_METACARPAL_EXT) - at(joint);
    else if (is_tip(joint))
      forward = at(joint) - at(joint - 1);
    else
      forward = at(joint + 1) - at(joint);
    // The thumb's nail looks up and to the side.
    const bool of_thumb = joint >= XR_HAND_JOINT_THUMB_METACARPAL_EXT && joint <= XR_HAND_JOINT_THUMB_TIP_EXT;
    const Eigen::Vector3d right = of_thumb ? Eigen::Vector3d(0.8, 0.6, 0.0) : Eigen::Vector3d::UnitX();
    joints[static_cast<std::size_t>(joint)] = {{axes(forward, right), at(joint)},
                                               rest[static_cast<std::size_t>(joint)].radius_m};
  }
  const HandJoint& middle = joints[XR_HAND_JOINT_MIDDLE_METACARPAL_EXT];
  joints[XR_HAND_JOINT_PALM_EXT] = {
      {middle.pose.orientation,
       (at(XR_HAND_JOINT_MIDDLE_METACARPAL_EXT) + at(XR_HAND_JOINT_MIDDLE_PROXIMAL_EXT)) / 2.0},
      rest[XR_HAND_JOINT_PALM_EXT].radius_m};
  return joints;
}

// The mirror image in the plane x = 0 of a frame whose +X is mirrored as well, so that it stays
// right-handed: a rotation (w, x, y, z) becomes (w, x, -y, -z).
HandJoints mirrored(HandJoints joints) {
  for (HandJoint& joint : joints) {
    joint.pose.position_m.x() = -joint.pose.position_m.x();
    const Eigen::Quaterniond& q = joint.pose.orientation;
    joint.pose.orientation = Eigen::Quaterniond(q.w(), q.x(), -q.y(), -q.z());
  }
  return joints;
}

}  // namespace

HandJoints shape_hand(XrHandEXT hand, const Fingers& fingers) {
  const HandJoints right = right_hand(fingers);
  return hand == XR_HAND_LEFT_EXT ? mirrored(right) : right;
}

HandJoints place_hand(HandJoints shape, const Eigen::Vector3d& index_tip_m, const Eigen::Quaterniond& orientation) {
  const Eigen::Vector3d wrist_m = index_tip_m - orientation * shape[XR_HAND_JOINT_INDEX_TIP_EXT].pose.position_m;
  for (HandJoint& joint : shape) joint.pose = Pose{orientation, wrist_m} * joint.pose;
  return shape;
}

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
