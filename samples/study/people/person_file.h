// A simulated person from a file: somebody's own parameters, by name and with units.
#pragma once

#include <string>
#include <string_view>

#include "core/simulation/people.h"

namespace hrt::study {

struct PersonFile {
  PersonCondition condition;
  bool has_duration = false;  ///< the file gives condition.person.duration_s
};

/// Reads JSON, {"tactile_weight": 0.18, "illusion": "sine"}. What the file does not name keeps its default.
/// Throws UsageError naming file, parameter and the allowed values. `name` is the file's name in errors.
PersonFile parse_person(const std::string& name, std::string_view text);

/// Reads the file at `path`, of at most 1 MiB; throws UsageError naming `argument` if that fails.
PersonFile read_person(const std::string& argument, const std::string& path);

/// All parameters with their ranges and defaults, a line each.
std::string person_parameters();

}  // namespace hrt::study
