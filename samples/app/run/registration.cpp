#include "samples/app/run/registration.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "samples/app/base/exit_code.h"
#include "samples/app/run/set_up.h"
#include "samples/app/text/format.h"
#include "samples/app/text/whole_file.h"

namespace hrt::app {
namespace {

constexpr double millimetres = 1000.0;

hrt_setup_result touch(RunContext& context, std::uint32_t what, std::span<const Mark> marks) {
  return SetUp(context.plugin, context.targets.session, what, config_of(marks), names_of(marks)).run(context);
}

using Json = nlohmann::ordered_json;

// Returns a text about the target at which errors of registration and tracker have the largest effect.
std::string accuracy_text(const RunContext& context) {
  hrt_gap worst = hrt_gap_init();
  for (const TargetPair& pair : context.targets.pairs) {
    hrt_gap gap = hrt_gap_init();
    context.plugin.check(
        context.plugin.hrt_gap_query(context.targets.session, pair.real_target, pair.virtual_target, &gap));
    if (gap.bearing_sd_deg >= worst.bearing_sd_deg) worst = gap;
  }
  return format(
             "Errors of registration and tracker displace the ends of reaches by %.2f degrees [standard deviation]. "
             "For this reason, %.1f of 100 reaches to the most affected target miss it.",
             worst.bearing_sd_deg, 100.0 * worst.miss_share) +
         (worst.miss_share > 0.05 ? " Register the plate again for a better result." : "");
}

constexpr int version = 2;
constexpr const char* hand_names[] = {"left", "right"};

// An array of numbers of a registered plate, and its key in the file.
struct Numbers {
  const char* name;
  std::span<double> values;
};
std::vector<Numbers> numbers_of(RegisteredPlate& plate) {
  std::vector<Numbers> all = {{"position_m", plate.found.plate.position_m},
                              {"rotation", plate.found.plate.rotation},
                              {"covariance", plate.found.plate.covariance},
                              {"check_m", plate.check.position_m}};
  if (plate.hand) all.push_back({"skin_m", plate.found.fingertip_offset_m});
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
  if (json.at("version") != version) throw std::invalid_argument("version must be 2");
  const std::string space = json.at("space");
  if (space != "STAGE" && space != "LOCAL") throw std::invalid_argument("space must be STAGE or LOCAL");
  RegisteredPlate plate{};
  plate.space = space == "STAGE" ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL;
  plate.check.name = json.at("check");
  if (!is_printable(plate.check.name)) throw std::invalid_argument("check must have no control characters");
  if (json.contains("hand")) {
    const auto hand = std::find(std::begin(hand_names), std::end(hand_names), json["hand"]);
    if (hand == std::end(hand_names)) throw std::invalid_argument("hand must be left or right");
    plate.hand = static_cast<Hand>(hand - std::begin(hand_names));
  }
  take_numbers(numbers_of(plate), json);
  return plate;
}

}  // namespace

hrt_setup_config config_of(std::span<const Mark> marks) {
  hrt_setup_config config = hrt_setup_config_init();
  config.check_mark = 0;
  for (const Mark& mark : marks)
    std::copy(mark.position_m.begin(), mark.position_m.end(), config.marks_m + std::size_t{3} * config.mark_count++);
  return config;
}

void place_plate(RunContext& context, const RegisteredPlate& plate) {
  context.session.place_plate(plate.space, to_xr(plate.found.plate.position_m, plate.found.plate.rotation));
  std::copy_n(plate.found.fingertip_offset_m, 3, context.skin_m.begin());
}

void put_registration(const RegisteredPlate& plate, hrt_session_config& config) {
  std::copy_n(plate.found.plate.position_m, 3, config.plate.position_m);
  std::copy_n(plate.found.plate.rotation, 4, config.plate.rotation);
  std::copy_n(plate.found.plate.covariance, 6, config.plate.covariance);
  std::copy_n(plate.found.fingertip_offset_m, 3, config.fingertip_offset_m);
  config.flags |= HRT_SESSION_REGISTERED;
}

RegisteredPlate register_plate(RunContext& context, std::span<const Mark> marks, bool fingertip) {
  const XrReferenceSpaceType space = context.session.steady_space();
  context.session.place_plate(space, world);
  const hrt_setup_result found = touch(context, HRT_SETUP_REGISTRATION | (fingertip ? HRT_SETUP_FINGERTIP : 0), marks);
  RegisteredPlate plate{space, marks.front(), config_of(context)};
  if (fingertip) {
    const double(&o)[3] = plate.found.fingertip_offset_m;
    plate.hand = context.hands.front();
    const double offset_m = std::hypot(o[0], o[1], o[2]);
    context.tell_user(format("The skin of the fingertip is %.1f mm from the tracked joint ", millimetres * offset_m) +
                      format("[standard deviation %.1f mm].", millimetres * found.fingertip_sd_m));
  }
  context.tell_user(
      format("The plate is registered [residual of the touches %.1f mm, standard deviation of the plate's rotation "
             "%.2f degrees].",
             millimetres * found.registration_residual_m, found.registration_turn_sd_deg));
  place_plate(context, plate);
  context.tell_user(accuracy_text(context));
  return plate;
}

double check_plate(RunContext& context, const RegisteredPlate& plate) {
  if (plate.hand && context.hands != std::vector{*plate.hand})
    throw Failure(
        ExitCode::registration,
        format("the registration is valid for one hand only: select the %s hand (hrt-reach: --hand), or register "
               "the plate again (hrt-reach: --register)",
               hand_names[static_cast<std::size_t>(*plate.hand)]));
  hrt_session_config config = config_of(context);
  put_registration(plate, config);
  context.plugin.check(context.plugin.hrt_session_set(context.targets.session, &config));
  context.session.place_plate(plate.space, world);
  // A set-up needs at least three marks; this one asks for a touch of the first only.
  const std::array<Mark, 3> marks{plate.check, plate.check, plate.check};
  const hrt_setup_result found = touch(context, HRT_SETUP_CHECK, marks);
  if (found.done == 0)
    throw Failure(ExitCode::registration,
                  "the mark \"" + plate.check.name +
                      format("\" was touched %.0f mm from where it was registered: register the plate again "
                             "(hrt-reach: --register)",
                             millimetres * found.check_distance_m));
  context.tell_user(
      format("The plate has not moved: you touched %.0f mm from the mark.", millimetres * found.check_distance_m));
  place_plate(context, plate);
  return found.check_distance_m;
}

std::string registration_text(const RegisteredPlate& plate, const XrHeadlessSession& session) {
  RegisteredPlate copy = plate;
  const auto [q, p] = session.now(plate.space, to_xr(plate.found.plate.position_m, plate.found.plate.rotation));
  std::copy_n(std::array{p.x, p.y, p.z}.begin(), 3, copy.found.plate.position_m);
  std::copy_n(std::array{q.x, q.y, q.z, q.w}.begin(), 4, copy.found.plate.rotation);
  Json json{{"version", version},
            {"space", plate.space == XR_REFERENCE_SPACE_TYPE_STAGE ? "STAGE" : "LOCAL"},
            {"check", plate.check.name}};
  put(numbers_of(copy), json);
  if (plate.hand) json["hand"] = hand_names[static_cast<std::size_t>(*plate.hand)];
  // The name of a mark may be invalid UTF-8.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_registration(const std::filesystem::path& file, const std::string& text) {
  if (const int error = write_whole_file(file, text); error != 0)
    throw Failure(ExitCode::output,
                  file.string() + " cannot be written: " + std::strerror(error) + "; select another file (--register)");
}

RegisteredPlate parse_registration(const std::string& text, const std::string& name) {
  try {
    return plate_of(Json::parse(text));
  } catch (const std::exception& error) {
    throw Failure(ExitCode::registration, name + " is not a valid registration (" + error.what() +
                                              "); register the plate again (hrt-reach: --register)");
  }
}

RegisteredPlate read_registration(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream || !std::filesystem::is_regular_file(file))
    throw Failure(ExitCode::registration,
                  file.string() + " cannot be read; give the file that --register wrote (--registered)");
  return parse_registration({std::istreambuf_iterator<char>(stream), {}}, file.string());
}

}  // namespace hrt::app
