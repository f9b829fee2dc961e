// A simulated person who follows the instructions of a set-up: touches marks, rests, and slides.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "core/setup/setup_step.h"
#include "core/simulation/people.h"

namespace hrt {

class GuidedHand {
 public:
  /// `touch_sd_mm`: SD of each coordinate of a touched position, and of a rest at a start, whose height is 0.
  GuidedHand(Person person, double touch_sd_mm, std::uint64_t seed, std::uint32_t index);

  void set_person(const Person& person) { person_ = person; }
  /// Gives an instruction. Repeating the last instruction has no effect.
  void ask(const SetupStep& step);
  /// Advances by one millisecond. `plate_orientation_deg`: plate orientation at the end of the millisecond.
  void advance(double plate_orientation_deg);

  /// Position of the skin in plate coordinates.
  const Eigen::Vector3d& skin_mm() const { return skin_mm_; }
  /// Rotation of the tracked joint relative to the plate's axes.
  const Eigen::Quaterniond& attitude() const { return attitude_; }

 private:
  Eigen::Vector3d near(const Eigen::Vector3d& place_mm, bool on_plate);

  Person person_;
  double touch_sd_mm_;
  std::uint64_t seed_;
  std::uint32_t index_;
  Draws draws_;
  std::uint32_t slides_ = 0;
  std::optional<SetupStep> asked_;
  int wait_ms_ = 0;  // time until the person moves
  Eigen::Vector3d skin_mm_{0.0, 100.0, 200.0};
  Eigen::Vector3d goal_mm_ = skin_mm_;
  Eigen::Quaterniond attitude_;
  std::optional<SlidingPerson> slide_;
  struct AlongGuide {
    Eigen::Vector3d from_mm;
    int elapsed_ms;
  };
  std::optional<AlongGuide> guide_;
};

}  // namespace hrt
