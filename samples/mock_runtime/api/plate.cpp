// XR_HRTX_ridged_plate.
#include <cmath>

#include "samples/mock_runtime/api/space.h"

namespace hrt::mock {
namespace {

constexpr double max_m = 10.0;

void require_length(double length_m, const char* why) {
  require(length_m > 0.0 && length_m <= max_m, XR_ERROR_VALIDATION_FAILURE, why);
}

void require_hand(XrHandEXT hand) {
  require(hand == XR_HAND_LEFT_EXT || hand == XR_HAND_RIGHT_EXT, XR_ERROR_VALIDATION_FAILURE, "no such hand");
}

}  // namespace

void place_plate(Session& session, const XrPlatePlacementHRTX* placement) {
  const Space& space = space_of(session, placement->space);
  const Pose pose = checked_pose(placement->pose);
  require_length(placement->radius, "radius must be in (0, 10] m");
  const auto in_world = space.in_world(session.instance().clock.now());
  require(in_world.has_value(), XR_ERROR_VALIDATION_FAILURE, "the space is not tracked now");
  session.world().place_plate(*in_world * pose);
}

void set_simulation_seed(Session& session, std::uint64_t seed, std::uint32_t next_reach) {
  session.world().set_seed(seed, next_reach);
}

void set_plate_orientation(Session& session, double orientation_deg) {
  require(std::abs(orientation_deg) <= 360.0, XR_ERROR_VALIDATION_FAILURE, "orientation must be within 360 degrees");
  session.world().command_plate(orientation_deg);
}

void get_plate_orientation(Session& session, XrTime time, double* orientation_deg) {
  require(time > 0, XR_ERROR_TIME_INVALID, "times are positive");
  *orientation_deg = session.world().plate_orientation_deg(time);
}

void instruct_reach(Session& session, const XrReachInstructionHRTX* instruction) {
  require_hand(instruction->hand);
  const Eigen::Vector3d start_m = from_xr(instruction->start);
  require(start_m.allFinite() && start_m.norm() <= max_m, XR_ERROR_VALIDATION_FAILURE,
          "start must be within 10 m of the plate");
  require(std::abs(instruction->goalDirection) <= 180.0, XR_ERROR_VALIDATION_FAILURE,
          "goalDirection must be within 180 degrees");
  require_length(instruction->pathLength, "pathLength must be in (0, 10] m");
  World& world = session.world();
  require(world.plate_is_placed(), XR_ERROR_CALL_ORDER_INVALID, "the plate has not been placed");
  world.instruct(instruction->hand, {{start_m.x(), start_m.z()}, instruction->goalDirection, instruction->pathLength},
                 start_m.y(), session.instance().clock.now());
}

void get_reach_truth(Session& session, XrHandEXT hand, XrReachTruthHRTX* truth) {
  require_hand(hand);
  World& world = session.world();
  const Reach* reach = world.reach(hand);
  require(reach != nullptr, XR_ERROR_CALL_ORDER_INVALID, "this hand has not been instructed");
  *truth = {truth->type,
            truth->next,
            reach->true_direction_deg(),
            reach->perceived_direction_deg(),
            reach->peak_felt_error_deg(),
            reach->outermost_direction_deg(1.0),
            reach->outermost_direction_deg(-1.0),
            reach->tactile_weight(),
            to_xr(world.true_index_tip_m(hand)),
            XrBool32{reach->done()}};
}

}  // namespace hrt::mock
