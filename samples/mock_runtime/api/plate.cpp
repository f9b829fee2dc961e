#include <cmath>

#include "samples/mock_runtime/api/space.h"

namespace hrt::mock {
namespace {

void require_length(double length_m, const char* field) {
  require_valid(length_m > 0.0 && length_m <= 10.0, "{} is {} m; must be > 0 and at most 10", field, length_m);
}

void require_angle(double angle_deg, double max_deg, const char* field) {
  require_valid(std::abs(angle_deg) <= max_deg, "{} is {} degrees; must be from -{} to {}", field, angle_deg, max_deg,
                max_deg);
}

}  // namespace

void xrPlacePlateHRTX(Session& session, const XrPlatePlacementHRTX* placement) {
  const Space& space = space_of(session, placement->space);
  const Pose pose = checked_pose(placement->pose);
  require_length(placement->radius, "radius");
  const auto in_world = space.in_world(session.instance().clock.now());
  require_valid(in_world.has_value(), "space is that of an action, which is not tracked; pass a reference space");
  session.world().place_plate(*in_world * pose);
}

void xrSetSimulationSeedHRTX(Session& session, std::uint64_t seed, std::uint32_t next_reach) {
  session.world().set_seed(seed, next_reach);
}

void xrSetPlateOrientationHRTX(Session& session, double orientation_deg) {
  require_angle(orientation_deg, 360.0, "orientation");
  session.world().command_plate(orientation_deg);
}

void xrGetPlateOrientationHRTX(Session& session, XrTime time, double* orientation_deg) {
  require_time(time);
  *orientation_deg = session.world().plate_orientation_deg(time);
}

void xrInstructReachHRTX(Session& session, const XrReachInstructionHRTX* instruction) {
  require_hand(instruction->hand);
  const Eigen::Vector3d start_m = from_xr(instruction->start);
  require_valid(start_m.allFinite() && start_m.norm() <= 10.0,
                "start is {} m from the plate's centre; must be at most 10", start_m.norm());
  require_angle(instruction->goalDirection, 180.0, "goalDirection");
  require_length(instruction->pathLength, "pathLength");
  World& world = session.world();
  require(world.plate_is_placed(), XR_ERROR_CALL_ORDER_INVALID,
          "the plate has not been placed; call xrPlacePlateHRTX first");
  world.instruct(instruction->hand, {{start_m.x(), start_m.z()}, instruction->goalDirection, instruction->pathLength},
                 start_m.y(), session.instance().clock.now());
}

void xrGetReachTruthHRTX(Session& session, XrHandEXT hand, XrReachTruthHRTX* truth) {
  require_hand(hand);
  World& world = session.world();
  const Reach* reach = world.reach(hand);
  require(reach != nullptr, XR_ERROR_CALL_ORDER_INVALID, "this hand has made no reach; call xrInstructReachHRTX first");
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
