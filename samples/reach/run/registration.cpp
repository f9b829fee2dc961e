#include "samples/reach/run/registration.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "samples/format.h"
#include "samples/reach/base/exit_code.h"
#include "samples/reach/run/set_up.h"

namespace hrt::reach {
namespace {

constexpr XrPosef world{{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};
constexpr double millimetres = 1000.0;

hrt_setup_result touch(Stage& stage, std::uint32_t what, std::span<const Mark> marks) {
  hrt_setup_config config = hrt_setup_config_init();
  config.mark_count = static_cast<std::uint32_t>(marks.size());
  config.check_mark = 0;
  std::vector<std::string> names;
  for (const Mark& mark : marks) {
    std::copy(mark.position_m.begin(), mark.position_m.end(), config.marks_m + 3 * names.size());
    names.push_back(mark.name);
  }
  return SetUp(stage.plugin, stage.targets.session, what, config, names).run(stage);
}

void place_plate(Stage& stage, const RegisteredPlate& plate) {
  stage.session.place_plate(plate.space, to_xr(plate.position_m, plate.rotation));
  stage.skin_m = plate.skin_m;
}

// Of this run, in the plugin, which refuses what is no plate.
void take(Stage& stage, const RegisteredPlate& plate) {
  hrt_session_config config = config_of(stage);
  std::copy(std::begin(plate.position_m), std::end(plate.position_m), config.plate_position_m);
  std::copy(std::begin(plate.rotation), std::end(plate.rotation), config.plate_rotation);
  std::copy(std::begin(plate.covariance), std::end(plate.covariance), config.plate_covariance);
  std::copy(plate.skin_m.begin(), plate.skin_m.end(), config.fingertip_offset_m);
  config.flags |= HRT_SESSION_REGISTERED;
  stage.plugin.check(stage.plugin.hrt_session_set(stage.targets.session, &config));
}

}  // namespace

RegisteredPlate register_plate(Stage& stage, std::span<const Mark> marks, bool fingertip) {
  RegisteredPlate plate{.space = stage.session.steady_space(), .check = marks.front()};
  stage.session.place_plate(plate.space, world);
  const hrt_setup_result found =
      touch(stage, HRT_SETUP_REGISTRATION | (fingertip ? HRT_SETUP_FINGERTIP : 0), marks);
  const hrt_session_config config = config_of(stage);
  std::copy(std::begin(config.plate_position_m), std::end(config.plate_position_m), plate.position_m);
  std::copy(std::begin(config.plate_rotation), std::end(config.plate_rotation), plate.rotation);
  std::copy(std::begin(config.plate_covariance), std::end(config.plate_covariance), plate.covariance);
  if (fingertip) {
    const double(&o)[3] = config.fingertip_offset_m;
    plate.hand = stage.hands.front();
    plate.skin_m = {o[0], o[1], o[2]};
    stage.tell_user(
        format("The skin is %.1f mm from the joint, ", millimetres * std::hypot(o[0], o[1], o[2])) +
        format("known to %.1f mm.", millimetres * found.fingertip_sd_m));
  }
  stage.tell_user(format("The plate is registered: residual %.1f mm, its turn known to %.2f degrees.",
                         millimetres * found.registration_residual_m, found.registration_turn_sd_deg));
  place_plate(stage, plate);
  return plate;
}

void check_plate(Stage& stage, const RegisteredPlate& plate) {
  if (plate.hand && stage.hands != std::vector{*plate.hand})
    throw Failure(ExitCode::registration,
                  "the plate was registered by the skin of one hand (--fingertip): choose that hand, or "
                  "register the plate anew (--register)");
  take(stage, plate);
  stage.session.place_plate(plate.space, world);
  const std::array<Mark, 3> marks{plate.check, plate.check, plate.check};  // of which one is touched
  const hrt_setup_result found = touch(stage, HRT_SETUP_CHECK, marks);
  if (found.done == 0)
    throw Failure(
        ExitCode::registration,
        "the mark \"" + plate.check.name +
            format(
                "\" was touched %.0f mm from where it was registered: register the plate anew (--register)",
                millimetres * found.check_distance_m));
  stage.tell_user(format("It is: the touch was %.0f mm off.", millimetres * found.check_distance_m));
  place_plate(stage, plate);
}

}  // namespace hrt::reach
