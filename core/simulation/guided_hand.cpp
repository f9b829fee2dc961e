#include "core/simulation/guided_hand.h"

#include <array>
#include <utility>

#include "core/math/elementary.h"
#include "core/setup/setup.h"
#include "core/simulation/minimum_jerk.h"

namespace hrt {
namespace {

constexpr int reaction_ms = 300;
constexpr int guide_ms = 900;
constexpr double lift_mm = 50.0;
constexpr double start_sd_deg = 2.0;  // SD of the initial direction of a slide

Eigen::Quaterniond turn(double angle_deg, const Eigen::Vector3d& axis) {
  Eigen::Quaterniond q;
  q.w() = cos_deg(0.5 * angle_deg);
  q.vec() = sin_deg(0.5 * angle_deg) * axis;
  return q;
}

// Orientations of the finger, in the order in which a set-up requests them.
Eigen::Quaterniond attitude_of(int number) {
  struct Way {
    double turned_deg, leant_deg, steep_deg;
  };
  constexpr std::array<Way, finger_attitudes> ways{{{0.0, 0.0, 6.0},
                                                    {0.0, 0.0, 52.0},
                                                    {0.0, 34.0, 17.0},
                                                    {0.0, -34.0, 17.0},
                                                    {40.0, 0.0, 11.0},
                                                    {-40.0, 0.0, 11.0}}};
  const Way& way = ways[static_cast<std::size_t>(number % finger_attitudes)];
  return turn(way.turned_deg, Eigen::Vector3d::UnitY()) * turn(way.leant_deg, Eigen::Vector3d::UnitZ()) *
         turn(-way.steep_deg, Eigen::Vector3d::UnitX());
}

bool is_touch(Instruction instruction) {
  return instruction == Instruction::touch_mark || instruction == Instruction::hold_still;
}

}  // namespace

GuidedHand::GuidedHand(Person person, double touch_sd_mm, std::uint64_t seed, std::uint32_t index)
    : person_(std::move(person)),
      touch_sd_mm_(touch_sd_mm),
      seed_(seed),
      index_(index),
      draws_(seed, PersonStream::touching, index, 0),
      attitude_(attitude_of(0)) {}

Eigen::Vector3d GuidedHand::near(const Eigen::Vector3d& place_mm, bool on_plate) {
  const double right_mm = touch_sd_mm_ * draws_.normal();
  const double up_mm = on_plate ? 0.0 : touch_sd_mm_ * draws_.normal();
  return place_mm + Eigen::Vector3d(right_mm, up_mm, touch_sd_mm_ * draws_.normal());
}

void GuidedHand::ask(const SetupStep& step) {
  const bool same =
      asked_ && step.part == asked_->part && step.done == asked_->done && step.instruction == asked_->instruction;
  const bool same_touch = asked_ && step.part == asked_->part && step.done == asked_->done &&
                          is_touch(step.instruction) && is_touch(asked_->instruction);
  asked_ = step;
  asked_->reason = {};
  if (same || same_touch || step.instruction == Instruction::finish) return;
  wait_ms_ = reaction_ms;
  slide_.reset();
  guide_.reset();
  goal_mm_ = skin_mm_;
  if (step.instruction == Instruction::wait) {
    goal_mm_ = {0.0, lift_mm, 60.0};
  } else if (is_touch(step.instruction)) {
    goal_mm_ = near(step.place_mm, false);
    attitude_ = attitude_of(step.part == setup_fingertip ? step.number : 0);
    skin_mm_.y() = lift_mm;
  } else if (step.instruction == Instruction::rest_at_start) {
    goal_mm_ = near(step.place_mm, true);
  } else if (step.part == setup_guides) {
    goal_mm_ = step.place_mm;
    guide_ = {skin_mm_, 0};
  } else {
    Person sliding = person_;
    sliding.start_direction_deg += start_sd_deg * draws_.normal();
    const PlatePoint start{skin_mm_.x(), -skin_mm_.z()};
    const double distance = distance_mm(start, {step.place_mm.x(), -step.place_mm.z()});
    slide_.emplace(sliding, start, 0.0, distance, Draws(seed_, PersonStream::steering, index_, slides_++));
  }
}

void GuidedHand::advance(double plate_orientation_deg) {
  if (wait_ms_ > 0) {
    --wait_ms_;
  } else if (slide_) {
    if (!slide_->done()) slide_->advance(plate_orientation_deg);
    skin_mm_ = {slide_->position().right_mm, 0.0, -slide_->position().away_mm};
  } else if (guide_) {
    const double share = minimum_jerk(static_cast<double>(++guide_->elapsed_ms) / guide_ms);
    skin_mm_ = guide_->from_mm + share * (goal_mm_ - guide_->from_mm);
    if (guide_->elapsed_ms == guide_ms) guide_.reset();
  } else {
    skin_mm_ = goal_mm_;
  }
}

}  // namespace hrt
