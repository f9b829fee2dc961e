#include "haptic_retargeting/person.h"

#include <Eigen/Geometry>

#include "core/math/elementary.h"
#include "core/simulation/simulated_hand.h"
#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/entry.h"
#include "plugin/src/api/recorded_session.h"
#include "plugin/src/api/write.h"

namespace hrt::plugin {
namespace {

struct SimulatedUser {
  SimulatedHand hand;
  std::uint64_t session = 0;  // handle of the session whose set-up the person follows, if hand.is_guided()
};

using People = HandleTable<SimulatedUser, HRT_PEOPLE_MAX, 0x9e>;
constinit People people("person");

constexpr double default_duration_s = 1.5;
// In a set-up: pose of the plate in the world (position, rotation about y), and vector from the tracked joint to the
// skin, in the joint's axes.
constexpr double user_plate_m[] = {0.3, 0.75, -0.4};
constexpr double user_turn_deg = 20.0;
constexpr double user_skin_m[] = {0.002, -0.008, -0.012};

std::unique_ptr<SimulatedUser> made(const hrt_person_config& config, std::uint64_t seed) {
  auto user = std::make_unique<SimulatedUser>(
      SimulatedUser{SimulatedHand(config.duration_s != 0.0 ? config.duration_s : default_duration_s, seed)});
  PersonCondition& condition = user->hand.condition();
  if (config.tactile_weight != 0.0) condition.person.illusion.tactile_weight = config.tactile_weight;
  condition.person.bias_deg = config.bias_deg;
  if (config.tracker_noise_m != 0.0) condition.tracker.white_mm = mm_per_m * config.tracker_noise_m;
  if (config.plate_max_speed_deg_s != 0.0) condition.plate.max_speed_deg_s = config.plate_max_speed_deg_s;
  if (config.plate_latency_ns != 0) condition.plate.latency_ns = config.plate_latency_ns;
  return user;
}

hrt_result check_begun(const SimulatedHand& hand) {
  if (hand.has_begun()) return HRT_OK;
  return fail(HRT_ERROR_WRONG_STATE,
              "the person has begun no reach: call hrt_person_begin() with a virtual target first");
}

hrt_result follow(SimulatedUser& user, std::int64_t time_ns, double plate_orientation_deg, hrt_sample* sample) {
  return sessions.with("hrt_person_move", user.session, [&](RecordedSession& s) -> hrt_result {
    const Session& session = s.session();
    std::optional<SetupStep> step;
    if (session.is_setting_up()) step = session.setup_step();
    const Eigen::Vector3d seen_m = user.hand.follow(time_ns, plate_orientation_deg, step) / mm_per_m;
    const bool finds_plate = step && (step->part & (setup_fingertip | setup_registration | setup_check)) != 0;
    Eigen::Vector3d at_m = seen_m;
    if (finds_plate || session.model().registration.made) {
      sample->flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_JOINT_ROTATION;
      Eigen::Quaterniond turned(cos_deg(0.5 * user_turn_deg), 0.0, sin_deg(0.5 * user_turn_deg), 0.0);
      const Eigen::Quaterniond joint = turned * user.hand.attitude();
      at_m = turned * seen_m + Eigen::Vector3d::Map(user_plate_m) - joint * Eigen::Vector3d::Map(user_skin_m);
      Eigen::Vector4d::Map(sample->joint_rotation) = joint.coeffs();
    } else {
      sample->flags = HRT_SAMPLE_PLATE_POSITION;
    }
    Eigen::Vector3d::Map(sample->finger_position_m) = at_m;
    return HRT_OK;
  });
}

}  // namespace
}  // namespace hrt::plugin

using hrt::SimulatedHand;
using namespace hrt::plugin;

hrt_result hrt_person_create(const hrt_person_config* config, uint64_t seed, hrt_person* out_person) noexcept {
  return guarded("hrt_person_create", [&]() -> hrt_result {
    if (!out_person) return fail_of_null("out_person");
    hrt_person_config known{};
    if (config) HRT_RETURN_IF_FAILED(read_struct("config", config, &known));
    HRT_RETURN_IF_FAILED(check_fields(known));
    const std::uint64_t handle = people.insert(made(known, seed));
    if (handle == 0)
      return fail(HRT_ERROR_LIMIT_REACHED, "there are ", HRT_PEOPLE_MAX,
                  " simulated people, the maximum; destroy one first");
    out_person->value = handle;
    return HRT_OK;
  });
}

hrt_result hrt_person_destroy(hrt_person person) noexcept { return people.destroy("hrt_person_destroy", person.value); }

hrt_result hrt_person_begin(hrt_person person, hrt_session session, hrt_target virtual_target) noexcept {
  return people.with("hrt_person_begin", person.value, [&](SimulatedUser& user) -> hrt_result {
    return sessions.with("hrt_person_begin", session.value, [&](RecordedSession& s) -> hrt_result {
      if (virtual_target.value == 0) {
        if (!s.session().is_setting_up())
          return fail(HRT_ERROR_WRONG_STATE,
                      "virtual_target is 0, and no set-up is in progress; pass a virtual target, or begin a set-up");
        user.hand.begin_setup();
        user.session = session.value;
        return HRT_OK;
      }
      const SessionModel& model = s.session().model();
      const Target* target = nullptr;
      HRT_RETURN_IF_FAILED(
          s.session().targets.find("virtual_target", virtual_target.value, TargetRole::virtual_target, &target));
      const TargetView seen = view(model, target->place);
      user.hand.begin(start_of(model), seen.direction_deg, seen.distance_mm);
      return HRT_OK;
    });
  });
}

hrt_result hrt_person_move(hrt_person person, int64_t time_ns, double plate_orientation_deg,
                           hrt_sample* out_sample) noexcept {
  return people.with("hrt_person_move", person.value, [&](SimulatedUser& user) -> hrt_result {
    SimulatedHand& hand = user.hand;
    HRT_RETURN_IF_FAILED(check_output("out_sample", out_sample));
    if (!hand.is_guided()) HRT_RETURN_IF_FAILED(check_begun(hand));
    hrt_sample sample{};
    sample.plate_orientation_deg = plate_orientation_deg;
    HRT_RETURN_IF_FAILED(check_field(sample, Fields<hrt_sample>::plate_orientation_deg));
    if (hand.is_past(time_ns))
      return fail(HRT_ERROR_TIME_REVERSED, "time_ns is ", time_ns,
                  ", earlier than in the last call; times must not decrease");
    sample.time_ns = time_ns;
    if (hand.is_guided()) {
      HRT_RETURN_IF_FAILED(follow(user, time_ns, plate_orientation_deg, &sample));
    } else {
      sample.flags = HRT_SAMPLE_PLATE_POSITION;
      write_point(hand.move(time_ns, plate_orientation_deg), sample.finger_position_m);
    }
    sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
    sample.plate_orientation_deg = hand.plate_orientation_deg();
    write_struct(sample, out_sample);
    return HRT_OK;
  });
}

hrt_result hrt_person_get_state(hrt_person person, hrt_person_state* out_state) noexcept {
  return people.with("hrt_person_get_state", person.value, [&](SimulatedUser& user) -> hrt_result {
    const SimulatedHand& hand = user.hand;
    HRT_RETURN_IF_FAILED(check_output("out_state", out_state));
    HRT_RETURN_IF_FAILED(check_begun(hand));
    hrt_person_state state{};
    state.done = hand.finger().done() ? 1 : 0;
    write_point(hand.finger().position(), state.position_m);
    write_point(hand.finger().felt_position(), state.felt_position_m);
    state.plate_orientation_deg = hand.plate_orientation_deg();
    state.felt_error_deg = hand.finger().felt_error_deg();
    write_struct(state, out_state);
    return HRT_OK;
  });
}
