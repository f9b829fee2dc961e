#include "samples/reach/run/registration.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "samples/format.h"
#include "samples/reach/base/exit_code.h"
#include "samples/reach/run/set_up.h"
#include "samples/whole_file.h"

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

using Json = nlohmann::ordered_json;

constexpr int version = 2;
constexpr const char* hand_names[] = {"left", "right"};

// Numbers of a registered plate, by name.
struct Numbers {
  const char* name;
  std::span<double> values;
};
std::vector<Numbers> numbers_of(RegisteredPlate& plate) {
  std::vector<Numbers> all = {{"position_m", plate.position_m},
                              {"rotation", plate.rotation},
                              {"covariance", plate.covariance},
                              {"check_m", plate.check.position_m}};
  if (plate.hand) all.push_back({"skin_m", plate.skin_m});
  return all;
}

void put(const std::vector<Numbers>& all, Json& json) {
  for (const auto& [name, values] : all) json[name] = std::vector<double>(values.begin(), values.end());
}

void take_numbers(const std::vector<Numbers>& all, const Json& json) {
  for (const auto& [name, values] : all) {
    const auto numbers = json.at(name).get<std::vector<double>>();
    if (numbers.size() != values.size())
      throw std::invalid_argument(std::string(name) + " must have " + std::to_string(values.size()) + " numbers");
    std::copy(numbers.begin(), numbers.end(), values.begin());
  }
}

RegisteredPlate plate_of(const Json& json) {
  if (json.at("version") != version)
    throw std::invalid_argument("version must be 2: register the plate anew (--register)");
  const std::string space = json.at("space");
  if (space != "STAGE" && space != "LOCAL") throw std::invalid_argument("space must be STAGE or LOCAL");
  RegisteredPlate plate{};
  plate.space = space == "STAGE" ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL;
  plate.check.name = json.at("check");
  if (std::any_of(plate.check.name.begin(), plate.check.name.end(),
                  [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
    throw std::invalid_argument("check has a control character");
  if (json.contains("hand")) {
    const auto hand = std::find(std::begin(hand_names), std::end(hand_names), json["hand"]);
    if (hand == std::end(hand_names)) throw std::invalid_argument("hand must be left or right");
    plate.hand = static_cast<Hand>(hand - std::begin(hand_names));
  }
  take_numbers(numbers_of(plate), json);
  return plate;
}

}  // namespace

RegisteredPlate register_plate(Stage& stage, std::span<const Mark> marks, bool fingertip) {
  RegisteredPlate plate{.space = stage.session.steady_space(), .check = marks.front()};
  stage.session.place_plate(plate.space, world);
  const hrt_setup_result found = touch(stage, HRT_SETUP_REGISTRATION | (fingertip ? HRT_SETUP_FINGERTIP : 0), marks);
  const hrt_session_config config = config_of(stage);
  std::copy(std::begin(config.plate_position_m), std::end(config.plate_position_m), plate.position_m);
  std::copy(std::begin(config.plate_rotation), std::end(config.plate_rotation), plate.rotation);
  std::copy(std::begin(config.plate_covariance), std::end(config.plate_covariance), plate.covariance);
  if (fingertip) {
    const double(&o)[3] = config.fingertip_offset_m;
    plate.hand = stage.hands.front();
    plate.skin_m = {o[0], o[1], o[2]};
    stage.tell_user(format("The skin is %.1f mm from the joint, ", millimetres * std::hypot(o[0], o[1], o[2])) +
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
            format("\" was touched %.0f mm from where it was registered: register the plate anew (--register)",
                   millimetres * found.check_distance_m));
  stage.tell_user(format("It is: the touch was %.0f mm off.", millimetres * found.check_distance_m));
  place_plate(stage, plate);
}

void write_registration(const std::filesystem::path& file, const RegisteredPlate& plate,
                        const XrHeadlessSession& session) {
  RegisteredPlate copy = plate;
  const auto [q, p] = session.now(plate.space, to_xr(plate.position_m, plate.rotation));
  std::copy_n(std::array{p.x, p.y, p.z}.begin(), 3, copy.position_m);
  std::copy_n(std::array{q.x, q.y, q.z, q.w}.begin(), 4, copy.rotation);
  Json json{{"version", version},
            {"space", plate.space == XR_REFERENCE_SPACE_TYPE_STAGE ? "STAGE" : "LOCAL"},
            {"check", plate.check.name}};
  put(numbers_of(copy), json);
  if (plate.hand) json["hand"] = hand_names[static_cast<std::size_t>(*plate.hand)];
  // The name of a mark may be no UTF-8.
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  if (const int error = write_whole_file(file, text); error != 0)
    throw Failure(ExitCode::output, file.string() + " cannot be written: " + std::strerror(error));
}

RegisteredPlate read_registration(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw Failure(ExitCode::registration, file.string() + " cannot be read");
  try {
    return plate_of(Json::parse(stream));
  } catch (const std::exception& error) {
    throw Failure(ExitCode::registration, file.string() + " is no registration: " + error.what());
  }
}

}  // namespace hrt::reach
