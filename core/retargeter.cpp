#include "core/retargeter.h"

#include <cmath>

namespace hrt {

bool is_valid(const RetargeterConfig& config) {
  return is_valid(config.participant) && is_valid(config.mpc) &&
         std::isfinite(config.fixed_plate_orientation_deg);
}

Retargeter::Retargeter(const RetargeterConfig& config)
    : config_(config),
      mpc_(config.mpc),
      filter_(config.participant, 0.0),
      gains_(config.participant, config.mpc.horizon) {}

void Retargeter::begin(const Reach& reach) {
  reach_ = reach;
  mpc_ = Mpc(config_.mpc);
  filter_ = PerceptionFilter(config_.participant, reach.virtual_direction_deg);
  plate_orientation_deg_ = reach.plate_orientation_deg;
  gains_ = GainWindow(config_.participant, config_.mpc.horizon);
}

PlateCommand Retargeter::step(double finger_direction_deg) {
  PlateCommand command{
      .plate_orientation_deg = config_.fixed_plate_orientation_deg,
      .finger_direction_deg = finger_direction_deg,
      .perceived_direction_deg = 0.0,
      .active = ActiveBound::none,
  };
  if (config_.mode == ControlMode::mpc) {
    const Mpc::Command optimum = mpc_.solve({
        .finger_offset_deg = finger_direction_deg - reach_.virtual_direction_deg,
        .real_offset_deg = reach_.real_direction_deg - reach_.virtual_direction_deg,
        .tactile_weight = config_.participant.tactile_weight,
        .plate_offset_deg = plate_orientation_deg_ - reach_.virtual_direction_deg,
        .gains = gains_.data(),
    });
    command.plate_orientation_deg = reach_.virtual_direction_deg + optimum.plate_offset_deg;
    command.active = optimum.active;
  }
  gains_.advance();
  plate_orientation_deg_ = command.plate_orientation_deg;
  command.perceived_direction_deg = filter_.update(command.plate_orientation_deg, finger_direction_deg);
  return command;
}

}  // namespace hrt
