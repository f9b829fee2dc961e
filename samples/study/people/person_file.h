// A simulated person from a JSON file of parameters with names and units.
#pragma once

#include <string>
#include <string_view>

#include "core/simulation/people.h"

namespace hrt::study {

struct PersonFile {
  PersonCondition condition;
  bool has_duration = false;  ///< the file sets condition.person.duration_s
};

/// Parses JSON, {"tactile_weight": 0.18, "illusion": "sine"}. Missing parameters have their default. `name`: file
/// name for errors. Throws UsageError naming file, parameter and the allowed values.
PersonFile parse_person(const std::string& name, std::string_view text);

/// Reads and parses the file at `path`. Throws UsageError naming `argument` if the file cannot be read or exceeds 1
/// MiB, and like parse_person().
PersonFile read_person(const std::string& argument, const std::string& path);

/// Returns all parameters with ranges and defaults, one per line.
std::string person_parameters();

}  // namespace hrt::study
