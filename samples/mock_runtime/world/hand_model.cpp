#include "samples/mock_runtime/world/hand_model.h"

#include "core/math/elementary.h"

namespace hrt::mock {
namespace {

// A right hand with the palm down and the wrist at the origin: +X right, +Y up, -Z to the fingers. The other fingers
// are bent further than the index finger, so that only the index finger touches a surface.
struct Rest {
  Eigen::Vector3d position_m;
  double radius_m;
};

const std::array<Rest, XR_HAND_JOINT_COUNT_EXT>& rest_hand() {
  static const std::array<Rest, XR_HAND_JOINT_COUNT_EXT> rest{{
      {{}, 0.022},                        // palm: right_hand() computes its position
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

// Returns the rotation whose -Z axis is along `forward` and whose +X axis is as close to `right` as possible.
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

HandJoints right_hand() {
  const auto& rest = rest_hand();
  const auto at = [&](int joint) { return rest[static_cast<std::size_t>(joint)].position_m; };
  HandJoints joints;
  for (int joint = XR_HAND_JOINT_WRIST_EXT; joint < XR_HAND_JOINT_COUNT_EXT; ++joint) {
    Eigen::Vector3d forward;
    if (joint == XR_HAND_JOINT_WRIST_EXT)
      forward = at(XR_HAND_JOINT_MIDDLE_METACARPAL_EXT) - at(joint);
    else if (is_tip(joint))
      forward = at(joint) - at(joint - 1);
    else
      forward = at(joint + 1) - at(joint);
    // The thumb is rotated about its bone: its nail faces up and to the side.
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

// Mirrors the joints in the plane x = 0. The +X axis of each joint is inverted as well, so that its axes remain
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

HandJoints place_hand(XrHandEXT hand, const Eigen::Vector3d& index_tip_m, const Eigen::Quaterniond& orientation) {
  static const HandJoints right = right_hand(), left = mirrored(right);
  HandJoints joints = hand == XR_HAND_LEFT_EXT ? left : right;
  const Eigen::Vector3d wrist_m = index_tip_m - orientation * joints[XR_HAND_JOINT_INDEX_TIP_EXT].pose.position_m;
  for (HandJoint& joint : joints) joint.pose = Pose{orientation, wrist_m} * joint.pose;
  return joints;
}

}  // namespace hrt::mock
