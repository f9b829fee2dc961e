// Plates of a runtime that simulates a user: its own, and another one that the user feels.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "samples/reach/plate/plate.h"
#include "samples/reach/xr/simulation.h"

namespace hrt::reach {

class RuntimePlate : public Plate {
 public:
  explicit RuntimePlate(Simulation& simulation) : simulation_(simulation) {}

  void command(XrTime time, double orientation_deg) override {
    const double from_deg = simulation_.plate_orientation_deg(time);
    simulation_.set_plate_orientation(orientation_within(-360.0, 360.0, orientation_deg, from_deg));
  }
  std::optional<double> orientation_deg(XrTime time) override { return simulation_.plate_orientation_deg(time); }
  void stop(XrTime time) override {
    if (is_runtime_blocked()) return;
    simulation_.set_plate_orientation(simulation_.plate_orientation_deg(time));
  }

 private:
  Simulation& simulation_;
};

/// Forwards to `plate`, and copies its orientation to the simulation in every frame.
class FollowedPlate : public Plate {
 public:
  FollowedPlate(std::unique_ptr<Plate> plate, Simulation& simulation)
      : plate_(std::move(plate)), simulation_(simulation) {}

  std::string description() const override { return plate_->description(); }
  const hrt_plate_report* report() const override { return plate_->report(); }
  void service(XrTime time) override {
    plate_->service(time);
    if (const std::optional<double> orientation_deg = plate_->orientation_deg(time))
      simulation_.set_plate_orientation(*orientation_deg);
  }
  void command(XrTime time, double orientation_deg) override { plate_->command(time, orientation_deg); }
  std::optional<double> orientation_deg(XrTime time) override { return plate_->orientation_deg(time); }
  void stop(XrTime time) override { plate_->stop(time); }

 private:
  std::unique_ptr<Plate> plate_;
  Simulation& simulation_;
};

}  // namespace hrt::reach
