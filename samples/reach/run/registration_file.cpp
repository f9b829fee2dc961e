#include "samples/reach/run/registration_file.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "samples/reach/base/exit_code.h"
#include "samples/whole_file.h"

namespace hrt::reach {
namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 1;
constexpr const char* hand_names[] = {"left", "right"};

// Numbers of a registered plate, by name.
struct Numbers {
  const char* name;
  std::span<double> values;
};
std::vector<Numbers> numbers_of(RegisteredPlate& plate) {
  hrt_registration& r = plate.registration;
  return {{"position_m", r.plate_position_m},   {"rotation", r.plate_rotation},
          {"scale", {&r.plate_scale, 1}},       {"covariance", r.covariance},
          {"touch_sd_m", {&r.touch_sd_m, 1}},   {"residual_m", {&r.residual_m, 1}},
          {"turn_sd_deg", {&r.turn_sd_deg, 1}}, {"check_m", plate.check.position_m}};
}
std::vector<Numbers> numbers_of(hrt_fingertip& fingertip) {
  return {{"offset_m", fingertip.offset_m}, {"sd_m", fingertip.sd_m}};
}

void put(const std::vector<Numbers>& all, Json& json) {
  for (const auto& [name, values] : all) json[name] = std::vector<double>(values.begin(), values.end());
}

void take(const std::vector<Numbers>& all, const Json& json) {
  for (const auto& [name, values] : all) {
    const auto numbers = json.at(name).get<std::vector<double>>();
    if (numbers.size() != values.size())
      throw std::invalid_argument(std::string(name) + " must have " + std::to_string(values.size()) +
                                  " numbers");
    std::copy(numbers.begin(), numbers.end(), values.begin());
  }
}

RegisteredPlate plate_of(const Json& json) {
  if (json.at("version") != version) throw std::invalid_argument("version must be 1");
  const std::string space = json.at("space");
  if (space != "STAGE" && space != "LOCAL") throw std::invalid_argument("space must be STAGE or LOCAL");
  RegisteredPlate plate{};
  plate.space = space == "STAGE" ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL;
  plate.check.name = json.at("check");
  if (std::any_of(plate.check.name.begin(), plate.check.name.end(),
                  [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
    throw std::invalid_argument("check has a control character");
  plate.registration.struct_size = sizeof plate.registration;
  plate.registration.verdict = HRT_REGISTRATION_HOLDS;
  plate.registration.left_out = -1;
  take(numbers_of(plate), json);
  for (std::size_t hand = 0; hand < plate.fingertips.size(); ++hand) {
    if (!json.at("fingertips").contains(hand_names[hand])) continue;
    hrt_fingertip& fingertip = plate.fingertips[hand];
    fingertip.struct_size = sizeof fingertip;
    fingertip.known = 1;
    take(numbers_of(fingertip), json["fingertips"][hand_names[hand]]);
  }
  return plate;
}

}  // namespace

void write_registration(const std::filesystem::path& file, const RegisteredPlate& plate) {
  RegisteredPlate copy = plate;
  Json json{{"version", version},
            {"space", plate.space == XR_REFERENCE_SPACE_TYPE_STAGE ? "STAGE" : "LOCAL"},
            {"check", plate.check.name}};
  put(numbers_of(copy), json);
  json["fingertips"] = Json::object();
  for (std::size_t hand = 0; hand < copy.fingertips.size(); ++hand)
    if (copy.fingertips[hand].known != 0)
      put(numbers_of(copy.fingertips[hand]), json["fingertips"][hand_names[hand]]);
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
