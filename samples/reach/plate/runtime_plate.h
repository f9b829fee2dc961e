// The plate of a runtime that simulates one.
#pragma once

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
  std::optional<double> orientation_deg(XrTime time) override {
    return simulation_.plate_orientation_deg(time);
  }
  void stop(XrTime time) override {
    if (is_runtime_blocked()) return;
    simulation_.set_plate_orientation(simulation_.plate_orientation_deg(time));
  }

 private:
  Simulation& simulation_;
};

}  // namespace hrt::reach
