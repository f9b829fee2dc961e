#include "plate_model.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace hrt {
namespace {

struct Bed {
  double height;
  bool turned;
};

// Of "bed,NAME,HEIGHT,TURNED".
std::map<std::string, Bed> beds() {
  std::map<std::string, Bed> found;
  for (const std::string& line : table_lines()) {
    if (!line.starts_with("bed,")) continue;
    const std::size_t name_end = line.find(',', 4);
    const std::size_t height_end = line.find(',', name_end + 1);
    found[line.substr(4, name_end - 4)] = {std::stod(line.substr(name_end + 1, height_end - name_end - 1)),
                                           line.substr(height_end + 1) == "true"};
  }
  return found;
}

}  // namespace

std::vector<Triangle> printed(const std::string& part) {
  std::ifstream in(std::string(HRT_PLATE_MODEL) + "/" + part + ".stl");
  if (!in) throw std::runtime_error("no " + part + ".stl: build the target plate_model");
  return read_stl(in);
}

const std::vector<Triangle>& installed(const std::string& part) {
  static std::map<std::string, std::vector<Triangle>> kept;
  static const std::map<std::string, Bed> bed_of = beds();
  const auto [place, is_new] = kept.try_emplace(part);
  std::vector<Triangle>& mesh = place->second;
  if (!is_new) return mesh;
  const auto bed = bed_of.find(part);
  if (bed == bed_of.end()) return mesh = printed("bought/" + part);  // in place as it is
  mesh = printed(part);
  for (Triangle& triangle : mesh) {
    for (Eigen::Vector3d& corner : triangle) {
      if (bed->second.turned) corner = {-corner.x(), corner.y(), -corner.z()};
      corner.z() += bed->second.height;
    }
  }
  return mesh;
}

std::vector<std::string> table_lines() {
  std::ifstream in(std::string(HRT_PLATE_MODEL) + "/tables.echo");
  const std::string frame = "ECHO: \"";
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(frame)) lines.push_back(line.substr(frame.size(), line.size() - frame.size() - 1));
  }
  if (lines.empty()) throw std::runtime_error("no tables.echo: build the target plate_model");
  return lines;
}

const std::vector<std::string>& printed_parts() {
  static const std::vector<std::string> names = {"plate", "hub",         "retainer", "deck",
                                                 "drum",  "servo_mount", "bridge",   "object"};
  return names;
}

std::vector<double> heights(const std::string& part, double x, double y) {
  return crossings(installed(part), {x, y, 0.0}, 2);
}

Eigen::Vector2d at_direction(double radius, double direction_deg) {
  const double direction = direction_deg * 0.017453292519943295;
  return {-radius * std::sin(direction), radius * std::cos(direction)};
}

}  // namespace hrt
