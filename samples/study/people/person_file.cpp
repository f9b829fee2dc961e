#include "samples/study/people/person_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "samples/app/text/json_file.h"
#include "samples/study/cli/output.h"
#include "samples/study/numbers/csv.h"

namespace hrt::study {
namespace {

constexpr std::size_t max_person_bytes = 1 << 20;

using C = PersonCondition;

struct NumberParameter {
  const char* name;
  NumberRange range;
  double (*get)(const C& condition);
  void (*set)(C& condition, double value);
};

#define HRT_FIELD(field) [](const C& c) { return c.field; }, [](C& c, double value) { c.field = value; }

constexpr NumberRange share{0.0, 0.5};
constexpr NumberRange angle{-45.0, 45.0};

constexpr NumberParameter number_parameters[] = {
    {"tactile_weight", tactile_weight_range, HRT_FIELD(person.illusion.tactile_weight)},
    {"illusion_scale_deg", {0.0, 90.0, false}, HRT_FIELD(person.illusion.scale_deg)},
    {"gain_per_s", {0.5, 20.0}, HRT_FIELD(person.gain_per_s)},
    {"delay_s", {0.0, 0.25}, HRT_FIELD(person.delay_s)},
    {"noise_deg2_per_s", {0.0, 1000.0}, HRT_FIELD(person.noise_deg2_per_s)},
    {"start_direction_deg", angle, HRT_FIELD(person.start_direction_deg)},
    {"bias_deg", angle, HRT_FIELD(person.bias_deg)},
    {"own_bias_deg", angle, HRT_FIELD(person.own_bias_deg)},
    {"habit_deg", angle, HRT_FIELD(person.habit_deg)},
    {"scatter_deg", {0.0, 30.0}, HRT_FIELD(person.scatter_deg)},
    {"weight_drift", {-0.5, 0.5}, HRT_FIELD(person.weight_drift)},
    {"duration_s", {0.3, 20.0}, HRT_FIELD(person.duration_s)},
    {"path_scale", {0.5, 2.0}, HRT_FIELD(person.path_scale)},
    {"tracker_rate_hz", {10.0, 1000.0}, HRT_FIELD(tracker.rate_hz)},
    {"tracker_white_mm", {0.0, 20.0}, HRT_FIELD(tracker.white_mm)},
    {"tracker_correlated_mm", {0.0, 20.0}, HRT_FIELD(tracker.correlated_mm)},
    {"tracker_correlation_s", {0.0, 10.0, false}, HRT_FIELD(tracker.correlation_s)},
    {"tracker_latency_s", share, HRT_FIELD(tracker.latency_s)},
    {"tracker_declared_latency_s", share, HRT_FIELD(tracker.declared_latency_s)},
    {"tracker_outlier_share", share, HRT_FIELD(tracker.outlier_share)},
    {"tracker_dropout_share", share, HRT_FIELD(tracker.dropout_share)},
    {"tracker_jitter_share", {0.0, 0.9}, HRT_FIELD(tracker.jitter_share)},
    {"tracker_turned_deg", angle, HRT_FIELD(tracker.turned_deg)},
    {"tracker_scale", {0.5, 2.0}, HRT_FIELD(tracker.scale)},
    {"tracker_shear", {-0.5, 0.5}, HRT_FIELD(tracker.shear)},
    {"plate_speed_deg_s", {10.0, 10'000.0}, HRT_FIELD(plate.max_speed_deg_s)},
    {"plate_latency_s", share, [](const C& c) { return static_cast<double>(c.plate.latency_ns) / 1e9; },
     [](C& c, double value) { c.plate.latency_ns = std::llround(1e9 * value); }},
    {"plate_offset_deg", {-90.0, 90.0}, HRT_FIELD(plate_offset_deg)},
    {"real_direction_deg", angle, HRT_FIELD(real_direction_deg)},
    {"virtual_direction_deg", angle, HRT_FIELD(virtual_direction_deg)},
    {"distance_mm", {30.0, 500.0}, HRT_FIELD(distance_mm)},
};

#undef HRT_FIELD

// Names of the first values of IllusionFamily, Steering and Pace, in their order. A file cannot set the other values.
constexpr const char* illusions[] = {"linear", "saturating", "sine", "tanh", "dead_band", "unequal"};
constexpr const char* steerings[] = {"steps", "continuous", "predictive", "place", "heavy_arm", "crossings"};
constexpr const char* paces[] = {"minimum_jerk", "even", "skewed", "stop_and_go", "pause", "two_parts", "reversal"};

struct WordParameter {
  const char* name;
  std::span<const char* const> words;
  std::size_t (*get)(const C& condition);
  void (*set)(C& condition, std::size_t word);
};

const WordParameter word_parameters[] = {
    {"illusion", illusions, [](const C& c) { return static_cast<std::size_t>(c.person.illusion.family); },
     [](C& c, std::size_t word) { c.person.illusion.family = static_cast<IllusionFamily>(word); }},
    {"steering", steerings, [](const C& c) { return static_cast<std::size_t>(c.person.steering); },
     [](C& c, std::size_t word) { c.person.steering = static_cast<Steering>(word); }},
    {"pace", paces, [](const C& c) { return static_cast<std::size_t>(c.person.pace); },
     [](C& c, std::size_t word) { c.person.pace = static_cast<Pace>(word); }},
};

std::string all_names() {
  std::vector<std::string> names;
  for (const WordParameter& parameter : word_parameters) names.emplace_back(parameter.name);
  for (const NumberParameter& parameter : number_parameters) names.emplace_back(parameter.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

// Sets one parameter. `where`: file and parameter, for errors.
void take(const std::string& where, std::string_view parameter, const Json& value, PersonFile* file) {
  for (const WordParameter& known : word_parameters) {
    if (parameter != known.name) continue;
    const auto word = value.is_string() ? value.get<std::string>() : value.dump();
    const auto found = std::find(known.words.begin(), known.words.end(), word);
    if (found == known.words.end())
      throw UsageError(not_allowed(where, shown(word), fmt::format("one of {}", fmt::join(known.words, ", "))));
    return known.set(file->condition, static_cast<std::size_t>(found - known.words.begin()));
  }
  for (const NumberParameter& known : number_parameters) {
    if (parameter != known.name) continue;
    if (!value.is_number() || !known.range.contains(value.get<double>()))
      throw UsageError(not_allowed(where, shown(value.dump()), known.range.text()));
    if (parameter == "duration_s") file->has_duration = true;
    return known.set(file->condition, value.get<double>());
  }
  throw UsageError(not_allowed(where, shown(parameter), "one of " + all_names()));
}

}  // namespace

PersonFile parse_person(const std::string& name, std::string_view text) {
  Json page;
  try {
    page = parse_json(text, name);
  } catch (const Refusal& refusal) {
    throw UsageError(refusal.what());
  }
  if (!page.is_object() || page.empty())
    throw UsageError(name + ": there is no parameter; the file must be a JSON object with one or more of " +
                     all_names());
  PersonFile file;
  for (const auto& [parameter, value] : page.items()) take(name + ", " + shown(parameter), parameter, value, &file);
  const C& c = file.condition;
  if (c.virtual_direction_deg == c.real_direction_deg)
    throw UsageError(not_allowed(name + ", real_direction_deg", fmt::to_string(c.real_direction_deg),
                                 "another direction than virtual_direction_deg"));
  return file;
}

PersonFile read_person(const std::string& argument, const std::string& path) {
  return parse_person(path, read_input(argument, path, max_person_bytes));
}

std::string person_parameters() {
  const PersonCondition standard;
  std::string page;
  for (const WordParameter& parameter : word_parameters)
    page += fmt::format("  {:28}{}; default {}\n", parameter.name, fmt::join(parameter.words, ", "),
                        parameter.words[parameter.get(standard)]);
  for (const NumberParameter& parameter : number_parameters)
    page += fmt::format("  {:28}{}; default {}\n", parameter.name, parameter.range.text(), parameter.get(standard));
  return page;
}

}  // namespace hrt::study
