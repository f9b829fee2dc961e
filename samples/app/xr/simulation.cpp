#include "samples/app/xr/simulation.h"

namespace hrt::app {
namespace {

std::array<double, 3> to_array(const XrVector3f& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

XrHandEXT to_xr(Hand hand) { return hand == Hand::left ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT; }

}  // namespace

Simulation::Simulation(const XrRuntime& runtime, const XrHeadlessSession& session)
    : session_(session.handle()),
      place_plate_(runtime.function<PFN_xrPlacePlateHRTX>("xrPlacePlateHRTX")),
      set_seed_(runtime.function<PFN_xrSetSimulationSeedHRTX>("xrSetSimulationSeedHRTX")),
      instruct_reach_(runtime.function<PFN_xrInstructReachHRTX>("xrInstructReachHRTX")),
      get_reach_truth_(runtime.function<PFN_xrGetReachTruthHRTX>("xrGetReachTruthHRTX")),
      set_plate_orientation_(runtime.function<PFN_xrSetPlateOrientationHRTX>("xrSetPlateOrientationHRTX")),
      get_plate_orientation_(runtime.function<PFN_xrGetPlateOrientationHRTX>("xrGetPlateOrientationHRTX")) {}

void Simulation::place_plate(XrSpace space, double radius_m) {
  const XrPlatePlacementHRTX placement{
      XR_TYPE_PLATE_PLACEMENT_HRTX, nullptr, space, {.orientation = {.w = 1.0f}}, radius_m};
  CHECK_XR_NAMED("xrPlacePlateHRTX", place_plate_(session_, &placement));
}

void Simulation::seed(std::uint64_t seed, std::uint32_t next_reach) {
  CHECK_XR_NAMED("xrSetSimulationSeedHRTX", set_seed_(session_, seed, next_reach));
}

void Simulation::instruct(Hand hand, const std::array<double, 3>& start_m, double goal_direction_deg,
                          double path_length_m) {
  const auto f = [](double value) { return static_cast<float>(value); };
  const XrVector3f start{f(start_m[0]), f(start_m[1]), f(start_m[2])};
  const XrReachInstructionHRTX instruction{
      XR_TYPE_REACH_INSTRUCTION_HRTX, nullptr, to_xr(hand), start, goal_direction_deg, path_length_m};
  CHECK_XR_NAMED("xrInstructReachHRTX", instruct_reach_(session_, &instruction));
}

Simulation::Truth Simulation::truth(Hand hand) const {
  XrReachTruthHRTX truth{XR_TYPE_REACH_TRUTH_HRTX};
  CHECK_XR_NAMED("xrGetReachTruthHRTX", get_reach_truth_(session_, to_xr(hand), &truth));
  return {truth.trueDirection,      truth.perceivedDirection, truth.peakFeltError,      truth.leftmostDirection,
          truth.rightmostDirection, truth.tactileWeight,      to_array(truth.indexTip), truth.isDone == XR_TRUE};
}

void Simulation::set_plate_orientation(double orientation_deg) {
  CHECK_XR_NAMED("xrSetPlateOrientationHRTX", set_plate_orientation_(session_, orientation_deg));
}

double Simulation::plate_orientation_deg(XrTime time) const {
  double orientation_deg = 0.0;
  CHECK_XR_NAMED("xrGetPlateOrientationHRTX", get_plate_orientation_(session_, time, &orientation_deg));
  return orientation_deg;
}

}  // namespace hrt::app
