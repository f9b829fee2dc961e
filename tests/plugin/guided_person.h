// A simulated participant who follows the instructions of a set-up: touches marks, rests and slides. The tracker
// reports the position of a joint in the world, at an offset from the skin, with latency and noise.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <optional>

#include "core/plate/plate_model.h"
#include "core/simulation/guided_hand.h"
#include "tests/plugin/fixture.h"

namespace hrt::test {

class GuidedPerson {
 public:
  /// Creates person `index` of the family "linear", without a habit.
  explicit GuidedPerson(std::uint32_t index)
      : condition(draw_person(people_families().front(), 1.5, 77, index)), draws_(78, 0, index, 0), index_(index) {
    condition.person.habit_deg = 0.0;
  }

  PersonCondition condition;
  Eigen::Matrix3d rotation =
      (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(-0.1, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  Eigen::Vector3d position_m{0.3, 0.9, -0.4};
  Eigen::Vector3d offset_m{0.002, -0.008, -0.012};  ///< from the joint to the skin, in the axes of the joint
  double touch_sd_m = 0.0015;
  double noise_m = 0.001;
  double scale = 1.0;  ///< tracked length of 1 m; not 1 if the tracker's unit is wrong
  int latency_ms = 40;
  int frame_ms = 11;
  bool in_plate = false;  ///< true: the tracker reports the fingertip in plate coordinates, without a joint

  /// Advances by one frame, and returns the sample of tracker and servo.
  hrt_sample follow(const hrt_setup_step& step) {
    if (!hand_) hand_.emplace(condition.person, mm_per_m * touch_sd_m, 78, index_);
    hand_->set_person(condition.person);
    hand_->ask({.part = static_cast<SetupPart>(step.part),
                .instruction = static_cast<Instruction>(step.instruction),
                .problem = SetupProblem::none,
                .number = static_cast<int>(step.number),
                .done = static_cast<int>(step.done),
                .of = static_cast<int>(step.of),
                .place_mm = mm_per_m * Eigen::Vector3d::Map(step.place_m),
                .plate_orientation_deg = step.plate_orientation_deg,
                .observed = {},
                .reason = {}});
    plate_.command(step.plate_orientation_deg);
    for (const std::int64_t until = time_ms_ + frame_ms; time_ms_ < until;) {
      plate_.advance(++time_ms_ * 1'000'000);
      hand_->advance(plate_.orientation_deg());
      seen_.push_back({hand_->skin_mm() / mm_per_m, hand_->attitude()});
    }
    return sample();
  }

  std::int64_t time_ns() const { return time_ms_ * 1'000'000; }
  void lift(int duration_ms) { lifted_until_ms_ = time_ms_ + duration_ms; }

 private:
  struct Held {
    Eigen::Vector3d skin_m;
    Eigen::Quaterniond attitude;
  };

  hrt_sample sample() {
    auto sample = output<hrt_sample>();
    sample.time_ns = time_ns();
    sample.flags = HRT_SAMPLE_PLATE_ORIENTATION;
    sample.plate_orientation_deg = plate_.orientation_deg();
    const auto late = static_cast<std::size_t>(std::max<std::int64_t>(0, time_ms_ - 1 - latency_ms));
    const Held& held = seen_[late];
    Eigen::Vector3d seen_m = held.skin_m;
    for (double& coordinate_m : seen_m) coordinate_m += noise_m * draws_.normal();
    if (time_ms_ < lifted_until_ms_) sample.flags |= HRT_SAMPLE_LIFTED;
    if (in_plate) {
      sample.flags |= HRT_SAMPLE_PLATE_POSITION;
    } else {
      const Eigen::Quaterniond joint = Eigen::Quaterniond(rotation) * held.attitude;
      seen_m = scale * (rotation * seen_m + position_m - joint * offset_m);
      sample.flags |= HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_JOINT_ROTATION;
      Eigen::Vector4d::Map(sample.joint_rotation) = joint.coeffs();
    }
    for (int i = 0; i < 3; ++i) sample.finger_position_m[i] = seen_m(i);
    return sample;
  }

  Draws draws_;
  std::uint32_t index_;
  PlateModel plate_{PlateDynamics{.max_speed_deg_s = 400.0, .latency_ns = 30'000'000}, 0.0};
  std::optional<GuidedHand> hand_;
  std::int64_t time_ms_ = 0;
  std::int64_t lifted_until_ms_ = 0;
  std::vector<Held> seen_;
};

/// Returns a person without noise of movement and touch, under a tracker without noise and latency.
inline GuidedPerson quiet_person(bool in_plate = false) {
  GuidedPerson person(1);
  person.condition.person = Person{};
  person.condition.person.noise_deg2_per_s = 0.0;
  person.touch_sd_m = person.noise_m = 0.0;
  person.latency_ms = 0;
  person.in_plate = in_plate;
  return person;
}

/// Runs a set-up that was begun until it is over, or until `watch` returns false for a step; `left` is then not 0.
/// `mistake` changes the samples.
inline hrt_setup_result run_setup(
    hrt_session session, GuidedPerson* person,
    const std::function<bool(const hrt_setup_step&)>& watch = [](const auto&) { return true; },
    const std::function<void(hrt_sample&)>& mistake = [](auto&) {}) {
  auto step = output<hrt_setup_step>();
  auto result = output<hrt_setup_result>();
  result.left = ~0u;
  for (int frame = 0; result.left != 0 && frame < 40'000; ++frame) {
    hrt_sample sample = person->follow(step);
    mistake(sample);
    EXPECT_OK(hrt_setup_update(session, &sample, &step));
    EXPECT_NE(step.text[0], '\0');
    if (!watch(step)) return result;
    if (step.instruction != HRT_STEP_FINISH) continue;
    EXPECT_OK(hrt_setup_finish(session, &result));
  }
  EXPECT_EQ(result.left, 0u) << step.text;
  return result;
}

inline hrt_setup_result set_up(hrt_session session, std::uint32_t what, GuidedPerson* person,
                               const hrt_setup_config& config = hrt_setup_config_init()) {
  EXPECT_OK(hrt_setup_begin(session, what, &config));
  return run_setup(session, person);
}

}  // namespace hrt::test
