// The plate of a runtime that simulates one.
#pragma once

#include "samples/reach/plate.h"
#include "samples/reach/simulation.h"

namespace hrt::reach {

class RuntimePlate : public Plate {
 public:
  explicit RuntimePlate(Simulation& simulation) : simulation_(simulation) {}

  void command(XrTime, double orientation_deg) override {
    simulation_.set_plate_orientation(orientation_deg);
  }
  std::optional<double> orientation_deg(XrTime time) override {
    return simulation_.plate_orientation_deg(time);
  }
  void stop(XrTime time) override {
    simulation_.set_plate_orientation(simulation_.plate_orientation_deg(time));
  }

 private:
  Simulation& simulation_;
};

}  // namespace hrt::reach
