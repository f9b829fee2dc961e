// One reach: the fingertip's direction in, the plate's orientation out, one model step at a time.
#pragma once

#include "core/mpc.h"
#include "core/perception.h"

namespace hrt {

/// What decides the plate's orientation.
enum class ControlMode {
  mpc,          ///< the controller of paper section III
  fixed_plate,  ///< none: the plate stays at RetargeterConfig::fixed_plate_orientation_deg (paper Fig. 8)
};

struct RetargeterConfig {
  Participant participant;  ///< whom the controller assumes
  MpcConfig mpc;
  ControlMode mode = ControlMode::mpc;
  double fixed_plate_orientation_deg = 0.0;
};

/// True if every field is in its range.
bool is_valid(const RetargeterConfig& config);

/// The two directions of a reach, degrees from the mid-line, and where the plate stands before it.
struct Reach {
  double real_direction_deg;
  double virtual_direction_deg;
  double plate_orientation_deg = 0.0;
};

struct PlateCommand {
  double plate_orientation_deg;    ///< T_k
  double finger_direction_deg;     ///< P_k, as used
  double perceived_direction_deg;  ///< theta_hat_k, as the filter predicts it under this command
  ActiveBound active;              ///< the bound that holds the command
};

/// Runs one reach after another. No heap, no lock, no exception. One thread at a time.
class Retargeter {
 public:
  /// Requires is_valid(config).
  explicit Retargeter(const RetargeterConfig& config);

  /// Starts a reach; whatever the last one left is forgotten. Directions finite, |theta_V - P_R| < 90.
  void begin(const Reach& reach);

  /// One model step with the finger moving along `finger_direction_deg` (finite). Requires begin().
  PlateCommand step(double finger_direction_deg);

  const RetargeterConfig& config() const { return config_; }
  const Reach& reach() const { return reach_; }

 private:
  RetargeterConfig config_;
  Mpc mpc_;
  Reach reach_{};
  PerceptionFilter filter_;
  double plate_orientation_deg_ = 0.0;
  GainWindow gains_;
};

}  // namespace hrt
