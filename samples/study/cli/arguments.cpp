#include "samples/study/cli/arguments.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <thread>

#include "core/simulation/people.h"

namespace hrt::study {
namespace {

constexpr double max_values = 100'000;

template <typename Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Parses "a,b,c" or "first:last:count", each number in `range`; nullopt if invalid.
std::optional<std::vector<double>> parse_list(std::string_view text, const NumberRange& range) {
  std::vector<double> values;
  if (const auto parts = split(text, ':'); parts.size() == 3) {
    const auto first = range.parse(parts[0]), last = range.parse(parts[1]);
    const auto count = NumberRange{.low = 2.0, .high = max_values, .whole = true}.parse(parts[2]);
    if (!first || !last || !count || !std::isfinite(*first) || !std::isfinite(*last)) return std::nullopt;
    const double intervals = *count - 1.0;
    for (double i = 0.0; i <= intervals; ++i) values.push_back((*first * (intervals - i) + *last * i) / intervals);
    return values;
  }
  for (const std::string_view part : split(text, ',')) {
    const auto value = range.parse(part);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

// Adds an option whose text is converted by `parsed`, which returns nullopt if the text is not allowed. `allowed` and
// `standard` describe the allowed texts and the default in the help.
template <typename Value>
CLI::Option* add_parsed(CLI::App& app, const std::string& name, Value& value, const std::string& allowed,
                        const std::string& standard, const std::string& help,
                        const std::function<std::optional<Value>(const std::string&)>& parsed) {
  return app
      .add_option_function<std::string>(
          name, [&value, parsed](const std::string& text) { value = *parsed(text); }, help)
      ->check(must_be(allowed, [parsed](const std::string& text) { return parsed(text).has_value(); }))
      ->default_str(standard);
}

// Parses comma-separated names; returns nullopt if `find` does not know a name, or if two names have the same value.
template <typename Value>
std::optional<std::vector<Value>> parse_names(const std::string& names,
                                              const std::function<std::optional<Value>(std::string_view)>& find) {
  std::vector<Value> values;
  for (const std::string_view name : split(names, ',')) {
    const std::optional<Value> value = find(name);
    if (!value || std::ranges::find(values, *value) != values.end()) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<const PeopleFamily*> family_of(std::string_view name) {
  const PeopleFamily* family = people_family(std::string(name).c_str());
  return family ? std::optional(family) : std::nullopt;
}

std::optional<PersonState::Index> trait_of(std::string_view name) {
  const std::span traits(person_state, PersonState::traits);
  const auto trait = std::ranges::find(traits, name, &StateVariable::name);
  return trait == traits.end() ? std::nullopt : std::optional(trait->index);
}

// Returns `tuning` with the fields of `text`, "NAME=VALUE,NAME=VALUE"; nullopt if a name or a value is not allowed.
std::optional<Tuning> tuned(Tuning tuning, const std::string& text) {
  std::vector<TuningField> fields = tuning_fields(tuning);
  for (const std::string_view assignment : split(text, ',')) {
    const std::size_t equals = std::min(assignment.find('='), assignment.size());
    const auto field = std::ranges::find(fields, assignment.substr(0, equals), &TuningField::name);
    if (field == fields.end() || equals == assignment.size()) return std::nullopt;
    const auto value = NumberRange{field->min, field->max}.parse(assignment.substr(equals + 1));
    if (!value) return std::nullopt;
    *field->value = *value;
  }
  return tuning;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

bool NumberRange::contains(double value) const {
  if (std::isinf(value)) return infinity_allowed && value > 0.0;
  if (whole && value != std::floor(value)) return false;
  return (low_allowed ? value >= low : value > low) && (high_allowed ? value <= high : value < high);
}

std::optional<double> NumberRange::parse(std::string_view words) const {
  const auto value = study::parse<double>(words);
  return value && contains(*value) ? value : std::nullopt;
}

std::string NumberRange::text() const {
  if (whole) return fmt::format("a whole number from {:.0f} to {:.0f}", low, high);
  return fmt::format("a number in {}{}, {}{}{}", low_allowed ? '[' : '(', low, high, high_allowed ? ']' : ')',
                     infinity_allowed ? ", or inf" : "");
}

CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& help, const std::string& footer,
                      const std::function<void()>& run) {
  CLI::App* command = app.add_subcommand(name, help);
  command->footer(footer);
  command->callback(run);
  return *command;
}

CLI::Validator must_be(const std::string& allowed, const std::function<bool(const std::string&)>& passes) {
  return {[allowed, passes](const std::string& text) {
            return passes(text) ? "" : fmt::format("'{}' is not allowed; it must be {}", text, allowed);
          },
          allowed};
}

CLI::Validator must_be(const NumberRange& range) {
  return must_be(range.text(), [range](const std::string& text) { return range.parse(text).has_value(); });
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, const NumberRange& range,
                        const std::string& help) {
  return app.add_option(name, value, help)->check(must_be(range))->capture_default_str();
}

CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<double>& values, const NumberRange& range,
                         const std::string& help) {
  return add_parsed<std::vector<double>>(app, name, values, "a list a,b,c or first:last:count, each " + range.text(),
                                         fmt::format("{}", fmt::join(values, ",")), help,
                                         [range](const std::string& text) { return parse_list(text, range); });
}

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& allowed, const std::string& help) {
  const auto passes = [allowed](const std::string& text) { return std::ranges::find(allowed, text) != allowed.end(); };
  return app.add_option(name, value, help)
      ->check(must_be(fmt::format("one of {}", fmt::join(allowed, ", ")), passes))
      ->capture_default_str();
}

CLI::Option* add_path(CLI::App& app, const std::string& name, std::string& value, const std::string& help) {
  return app.add_option(name, value, help)->check(must_be("a path", [](const std::string& text) {
    return !text.empty();
  }));
}

CLI::Option* add_out(CLI::App& app, std::string& path) {
  return add_path(app, "--out", path, "File to write instead of standard output.");
}

CLI::Option* add_plot(CLI::App& app, std::string& path, const std::string& help) {
  return app.add_option("--plot", path, help)
      ->check(
          must_be("a file whose name ends with .svg", [](const std::string& text) { return text.ends_with(".svg"); }));
}

CLI::Option* add_threads(CLI::App& app, std::uint64_t& threads) {
  threads = std::max(1U, std::thread::hardware_concurrency());
  return add_integer(app, "--threads", threads, 1, 256, "Number of threads; the results do not depend on it.");
}

CLI::Option* add_seed(CLI::App& app, std::uint64_t& seed) {
  const auto passes = [](const std::string& text) { return study::parse<std::uint64_t>(text).has_value(); };
  return app.add_option("--seed", seed, "Seed of the random numbers; the same seed gives the same results.")
      ->check(must_be("a whole number from 0 to 18446744073709551615", passes))
      ->capture_default_str();
}

CLI::Option* add_trials(CLI::App& app, std::uint64_t& trials, const std::string& help) {
  return add_integer(app, "--trials", trials, 1, 100'000'000, help);
}

CLI::Option* add_families(CLI::App& app, std::vector<const PeopleFamily*>& families, const std::string& standard,
                          const std::string& help) {
  return add_parsed<std::vector<const PeopleFamily*>>(
      app, "--family", families, "families, each once, separated by commas (robustness --help shows them)", standard,
      help, [](const std::string& names) { return parse_names<const PeopleFamily*>(names, family_of); });
}

CLI::Option* add_traits(CLI::App& app, const std::string& name, std::vector<PersonState::Index>& traits,
                        const std::string& standard, const std::string& help) {
  std::vector<std::string> names;
  for (const StateVariable& trait : std::span(person_state, PersonState::traits)) names.emplace_back(trait.name);
  return add_parsed<std::vector<PersonState::Index>>(
      app, name, traits, fmt::format("one or more from {}, each once", fmt::join(names, ",")), standard, help,
      [](const std::string& given) { return parse_names<PersonState::Index>(given, trait_of); });
}

std::string tuning_names() {
  std::string text = "Parameters of --tune with their ranges (core/person/tuning.h explains them):\n";
  Tuning tuning;
  for (const TuningField& field : tuning_fields(tuning))
    text += fmt::format("  {} {} to {}, default {}\n", field.name, field.min, field.max, *field.value);
  return text;
}

CLI::Option* add_tuning(CLI::App& app, Tuning& tuning) {
  return add_parsed<Tuning>(app, "--tune", tuning, "NAME=VALUE[,NAME=VALUE...] (robustness --help shows the ranges)",
                            "values of core/person/tuning.h",
                            "Parameters of the plugin's default controller to change.",
                            [](const std::string& text) { return tuned({}, text); });
}

}  // namespace hrt::study
