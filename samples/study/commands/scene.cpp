#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/math/elementary.h"
#include "core/paper/participant.h"
#include "samples/app/text/text.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/numbers/results.h"

namespace hrt::study {
namespace {

struct SceneOptions {
  std::string file;
  std::vector<double> tactile_weights{0.1, 0.15, 0.2};
  double plate_bound_deg = 84.5;
  Writing writing;
};

const SceneTarget& real_of(const Scene& scene, const SceneTarget& virtual_target) {
  return scene.targets[virtual_target.served_by.value()];
}

// Wraps the gap to [-180, 180]: 175 and -175 degrees are 10 degrees apart.
GapFeasibility gap_feasibility_of(const Scene& scene, const SceneTarget& virtual_target, double tactile_weight,
                                  double plate_bound_deg) {
  const double virtual_deg = direction_deg(scene, virtual_target);
  const double gap_deg = wrap_deg(virtual_deg - direction_deg(scene, real_of(scene, virtual_target)), 360.0);
  return paper_gap_feasibility(virtual_deg - gap_deg, virtual_deg, tactile_weight, plate_bound_deg);
}

// Avoids "-0" for a value that rounds to zero.
std::string rounded(double value, int decimals) {
  return fmt::format("{:.{}f}", std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value, decimals);
}

std::string degrees(double angle_deg) { return rounded(angle_deg, 2); }
std::string millimetres(double metres) { return rounded(1e3 * metres, 1); }

std::string text(const Scene& scene, const SceneOptions& options) {
  const ScenePlate& plate = scene.plate;
  std::string page = fmt::format("Plate {}: radius {} mm", plate.node_path, millimetres(plate.radius_m));
  if (plate.max_speed_deg_s) page += fmt::format(", at most {} deg/s", *plate.max_speed_deg_s);
  page +=
      fmt::format("\nStart {}: x {} mm, z {} mm from the plate's centre\n\n", scene.start_path.value_or("(default)"),
                  millimetres(scene.start_m.x), millimetres(scene.start_m.z));

  std::size_t widest = 6;
  for (const SceneTarget& target : scene.targets) widest = std::max(widest, length_of(target.name));
  page +=
      fmt::format("{:{}}  kind     direction  distance  height  node\n{:{}}                 deg        mm      mm\n",
                  "target", widest, "", widest);
  for (const SceneTarget& target : scene.targets)
    page += fmt::format("{:{}}  {:7}{:>11}{:>10}{:>8}  {}\n", target.name, widest,
                        target.served_by ? "virtual" : "real", degrees(direction_deg(scene, target)),
                        millimetres(distance_m(scene, target)), millimetres(target.position_m.y), target.node_path);

  page += fmt::format(
      "\nPlate orientation, in deg from the mid-line, that sustains the gap of each pair; -: infeasible, as no "
      "orientation\nwithin {} deg of the virtual direction sustains it. Computed from the paper's model; there was no "
      "human trial.\n\n{:{}}  {:{}}     gap  tactile weight\n{:{}}     deg",
      options.plate_bound_deg, "virtual", widest, "real", widest, "", 2 * widest + 2);
  for (const double tactile_weight : options.tactile_weights) page += fmt::format("{:>8}", tactile_weight);
  page += '\n';
  for (const SceneTarget& target : scene.targets) {
    if (!target.served_by) continue;
    const double first_weight = options.tactile_weights.front();
    const double gap_deg = gap_feasibility_of(scene, target, first_weight, options.plate_bound_deg).gap_deg;
    page +=
        fmt::format("{:{}}  {:{}}{:>8}", target.name, widest, real_of(scene, target).name, widest, degrees(gap_deg));
    for (const double tactile_weight : options.tactile_weights) {
      const GapFeasibility feasibility = gap_feasibility_of(scene, target, tactile_weight, options.plate_bound_deg);
      page += fmt::format("{:>8}", feasibility.reachable ? cell(feasibility.plate_orientation_deg, 1) : "-");
    }
    page += '\n';
  }
  return page;
}

Results results(const Scene& scene, const SceneOptions& options) {
  Results found{.about = {{"simulation", true},
                          {"plate_node", scene.plate.node_path},
                          {"plate_radius_m", scene.plate.radius_m},
                          {"start_m", {scene.start_m.x, scene.start_m.y, scene.start_m.z}},
                          {"plate_bound_deg", options.plate_bound_deg}},
                .rows = {}};
  for (const SceneTarget& target : scene.targets) {
    if (!target.served_by) continue;
    for (const double tactile_weight : options.tactile_weights) {
      const GapFeasibility feasibility = gap_feasibility_of(scene, target, tactile_weight, options.plate_bound_deg);
      found.rows.push_back({{"virtual", target.name},
                            {"real", real_of(scene, target).name},
                            {"tactile_weight", tactile_weight},
                            {"gap_deg", feasibility.gap_deg},
                            {"max_gap_deg", feasibility.max_gap_deg},
                            {"reachable", feasibility.reachable},
                            {"plate_orientation_deg", feasibility.plate_orientation_deg}});
    }
  }
  return found;
}

}  // namespace

void add_scene(CLI::App& app) {
  const auto options = std::make_shared<SceneOptions>();
  CLI::App& command =
      add_command(app, "scene", "Show the contents of a glTF scene, and which of its gaps are feasible.",
                  R"(scene/README.md lists the properties of the file.

Examples:
  hrt-study scene samples/scenes/desk.gltf
  hrt-study scene desk.glb --tactile-weight 0.05:0.25:5 --format json --out desk.json)",
                  [options] {
                    options->writing.write([options] { return load_scene(options->file); },
                                           [options](const Scene& scene) { return results(scene, *options); },
                                           [options](const Scene& scene) { return text(scene, *options); });
                  });
  add_path(command, "FILE", options->file, "The scene, .gltf or .glb.")->required();
  add_numbers(command, "--tactile-weight", options->tactile_weights, tactile_weight_range,
              "Tactile weights w_T; the table has a column for each.");
  add_number(command, "--plate-bound", options->plate_bound_deg, plate_bound_range,
             "Largest angle between plate orientation and virtual direction, deg.");
  options->writing.add_options(command);
}

}  // namespace hrt::study
