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
      throw std::invalid_argument(std::string(name) + " must have " + std::to_string(values.size()) +
                                  " numbers");
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
