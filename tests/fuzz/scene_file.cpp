// Loads arbitrary bytes: a scene must fulfil the postconditions of load_scene(), an error must be one line.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "scene/scene.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check_scene(const hrt::Scene& scene) {
  require(hrt::is_unit(scene.plate.pose.orientation));
  require(hrt::length(scene.plate.pose.position_m) < 2000.0);
  require(scene.plate.radius_m > 0.0);
  require(hrt::length(scene.start_m) <= scene.plate.radius_m);
  for (const hrt::SceneTarget& target : scene.targets) {
    require(!target.name.empty() && !target.node_path.empty());
    require(std::abs(hrt::direction_deg(scene, target)) <= 180.0);
    require(hrt::distance_m(scene, target) >= hrt::min_distance_m && std::isfinite(hrt::distance_m(scene, target)));
    require(std::isfinite(target.position_m.y));
    require(target.served_by.has_value() != target.is_real);
    if (target.served_by) require(scene.targets.at(*target.served_by).is_real);
  }
}

void check_message(std::string_view message) {
  require(message.starts_with("file: ") && message.size() > 6 && message.size() < 2000);
  for (const char c : message) require(static_cast<unsigned char>(c) >= 0x20);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check_scene(hrt::load_scene({reinterpret_cast<const char*>(data), size}, "file"));
  } catch (const hrt::SceneError& error) {
    check_message(error.what());
  }
  return 0;
}
