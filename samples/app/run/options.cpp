#include "samples/app/run/options.h"

#include "samples/app/text/format.h"

namespace hrt::app {

std::optional<PlateChoice> parse_plate(const std::string& text) {
  PlateChoice choice{.name = text};
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kind == "runtime" && colon == std::string::npos) return choice;
  if (kind == "servo") {
    choice.kind = PlateChoice::Kind::servo;
    if (colon == std::string::npos) return choice;
    if (const auto speed = number_in(rest, 1.0, 1e6)) {
      choice.servo_speed_deg_per_s = *speed;
      return choice;
    }
  }
  if ((kind != "servo" && !rest.empty()) || text.ends_with(".json")) {
    choice.kind = PlateChoice::Kind::device;
    return choice;
  }
  return std::nullopt;
}

std::filesystem::path default_plugin() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  auto beside = program.parent_path().parent_path() / "lib" / "libhaptic_retargeting.so";
  return std::filesystem::exists(beside, error) ? beside : std::filesystem::path(HRT_REACH_SONAME);
}

}  // namespace hrt::app
