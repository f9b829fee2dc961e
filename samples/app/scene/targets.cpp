#include "samples/app/scene/targets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "samples/app/base/exit_code.h"
#include "samples/app/base/scope_exit.h"
#include "samples/app/text/format.h"
#include "samples/app/text/text.h"

namespace hrt::app {
namespace {

std::array<double, 3> to_array(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

constexpr std::size_t min_marks = 3;
constexpr std::size_t max_marks = HRT_MARKS_MAX;
constexpr std::size_t max_line = 200;
constexpr double farthest_m = 1.0;

[[noreturn]] void refuse(const std::filesystem::path& file, std::size_t line, const std::string& what) {
  throw Failure(ExitCode::registration, file.string() + ", line " + std::to_string(line) + ": " + what);
}

}  // namespace

XrPosef to_xr(const double (&position_m)[3], const double (&rotation)[4]) {
  const auto f = [](double value) { return static_cast<float>(value); };
  return {{f(rotation[0]), f(rotation[1]), f(rotation[2]), f(rotation[3])},
          {f(position_m[0]), f(position_m[1]), f(position_m[2])}};
}

TargetSet load_targets(const Plugin& plugin, const std::filesystem::path& scene_file,
                       const hrt_session_config& config) {
  hrt_scene scene{};
  if (plugin.hrt_scene_load(scene_file.c_str(), nullptr, 0, &scene) != HRT_OK)
    throw Failure(ExitCode::scene, std::string("the scene cannot be loaded: ") + plugin.hrt_last_error());
  const ScopeExit registered([&] { plugin.hrt_scene_destroy(scene); });
  hrt_scene_info info{.struct_size = sizeof info};
  plugin.check(plugin.hrt_scene_get_info(scene, &info));
  TargetSet set{.plate_pose = to_xr(info.plate_position_m, info.plate_rotation),
                .plate_radius_m = info.plate_radius_m,
                .start_m = to_array(info.start_position_m)};
  std::vector<hrt_target> ids(info.target_count);
  plugin.check(plugin.hrt_session_create(HRT_VERSION, &config, &set.session));
  plugin.check(plugin.hrt_scene_register(scene, set.session, info.target_count, ids.data()));

  const auto target = [&](std::uint32_t index) {
    hrt_scene_target found{.struct_size = sizeof found};
    plugin.check(plugin.hrt_scene_get_target(scene, index, &found));
    return found;
  };
  for (std::uint32_t i = 0; i < info.target_count; ++i) {
    const hrt_scene_target seen = target(i);
    if (seen.role != HRT_TARGET_VIRTUAL) continue;
    const auto serving = static_cast<std::uint32_t>(seen.served_by);
    const hrt_scene_target touched = target(serving);
    set.pairs.push_back({.virtual_name = seen.name,
                         .real_name = touched.name,
                         .virtual_direction_deg = seen.direction_deg,
                         .real_direction_deg = touched.direction_deg,
                         .real_distance_m = touched.distance_m,
                         .real_radius_m = touched.radius_m,
                         .virtual_position_m = to_array(seen.position_m),
                         .real_position_m = to_array(touched.position_m),
                         .virtual_target = ids[i],
                         .real_target = ids[serving]});
  }
  return set;
}

bool is_printable(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return c >= 0x20 && c != 0x7f; });
}

std::vector<std::string> names_of(std::span<const Mark> marks) {
  std::vector<std::string> names;
  for (const Mark& mark : marks) names.push_back(mark.name);
  return names;
}

std::vector<Mark> marks_of(const TargetSet& targets) {
  const double r = targets.plate_radius_m;
  const double right_m = r * std::sqrt(0.75);
  return {{"start", targets.start_m},
          {"rim nearest to you", {0.0, 0.0, r}},
          {"rim near right", {right_m, 0.0, 0.5 * r}},
          {"rim far right", {right_m, 0.0, -0.5 * r}},
          {"rim far left", {-right_m, 0.0, -0.5 * r}},
          {"rim near left", {-right_m, 0.0, 0.5 * r}}};
}

std::vector<Mark> read_marks(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream || !std::filesystem::is_regular_file(file))
    throw Failure(ExitCode::registration, file.string() + " cannot be read; select a CSV file of marks (--marks)");
  const std::array<std::string, 4> columns{"name", "x_m", "y_m", "z_m"};
  std::vector<Mark> marks;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.size() > max_line || !is_printable(line))
      refuse(file, number, "the line has more than 200 bytes or a control character; shorten or correct it");
    if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    std::vector<std::string> cells = csv_fields(line);
    cells.resize(std::max<std::size_t>(cells.size(), 4));
    if (number == 1) {
      if (!std::equal(columns.begin(), columns.end(), cells.begin()))
        refuse(file, number, "the first columns must be name,x_m,y_m,z_m");
      continue;
    }
    if (line.empty()) continue;
    Mark mark{cells[0], {}};
    if (mark.name.empty()) refuse(file, number, "the mark has no name; add one in the first column");
    for (std::size_t i = 0; i < mark.position_m.size(); ++i) {
      const std::optional<double> value_m = number_in(cells[1 + i], -farthest_m, farthest_m);
      if (!value_m) refuse(file, number, "\"" + cells[1 + i] + "\" is not a number of metres from -1 to 1");
      mark.position_m[i] = *value_m;
    }
    marks.push_back(mark);
    if (marks.size() > max_marks) refuse(file, number, "there are more than 8 marks; allowed: 3 to 8");
  }
  if (number == 0) refuse(file, 1, "the first columns must be name,x_m,y_m,z_m; the file is empty");
  if (marks.size() < min_marks) refuse(file, number, "there are fewer than 3 marks; allowed: 3 to 8");
  return marks;
}

}  // namespace hrt::app
