#include "samples/study/cli/arguments.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <span>
#include <thread>

#include "core/simulation/people.h"

namespace hrt::study {
namespace {

constexpr std::size_t max_values = 100'000;

template <typename Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string integer_text(std::uint64_t low, std::uint64_t high) {
  return "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
}

// "a,b,c" or "first:last:count"; nullopt if it is neither.
std::optional<std::vector<double>> parse_list(std::string_view text) {
  std::vector<double> values;
  if (const auto parts = split(text, ':'); parts.size() == 3) {
    const auto first = parse<double>(parts[0]);
    const auto last = parse<double>(parts[1]);
    const auto count = parse<std::uint64_t>(parts[2]);
    if (!first || !last || !std::isfinite(*first) || !std::isfinite(*last)) return std::nullopt;
    if (!count || *count < 2 || *count > max_values) return std::nullopt;
    const auto intervals = static_cast<double>(*count - 1);
    for (std::uint64_t i = 0; i < *count; ++i) {
      const auto x = static_cast<double>(i);
      // Exact at both ends.
      values.push_back((*first * (intervals - x) + *last * x) / intervals);
    }
    return values;
  }
  for (const std::string_view part : split(text, ',')) {
    const auto value = parse<double>(part);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::string joined(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ",") + number(value);
  return text;
}

bool takes_value(const CLI::Option* option) { return option->get_items_expected_max() > 0; }

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(34); }
  std::string make_option_opts(const CLI::Option* option) const override { return takes_value(option) ? " VALUE" : ""; }
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_description(const CLI::App* app) const override { return app->get_description() + "\n\n"; }
};

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  if (!takes_value(option)) return text;
  const std::string allowed = option->get_type_name() + '.';
  text += (allowed.size() > 80 ? "\nMust be\n" : "\nMust be ") + allowed;
  const std::string standard = option->get_default_str();
  if (!standard.empty())
    text += (option->get_type_name().size() + standard.size() < 60 ? " Default: " : "\nDefault: ") + standard + '.';
  if (option->get_required()) text += " Required.";
  return text;
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
  if (whole) return "a whole number from " + number(low) + " to " + number(high);
  return std::string("a number in ") + (low_allowed ? "[" : "(") + number(low) + ", " + number(high) +
         (high_allowed ? "]" : ")") + (infinity_allowed ? ", or inf" : "");
}

CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& help, const std::string& footer,
                      const std::function<void()>& run) {
  CLI::App* command = app.add_subcommand(name, help);
  command->footer(footer);
  command->callback(run);
  return *command;
}

CLI::Option* add_value(CLI::App& app, const std::string& name, const std::string& allowed,
                       const std::string& default_text, const std::string& help,
                       const std::function<bool(const std::string&)>& take) {
  return app
      .add_option(
          name,
          [name, allowed, take](const CLI::results_t& texts) {
            if (!take(texts.back())) throw UsageError(not_allowed(name, texts.back(), allowed));
            return true;
          },
          help)
      ->type_name(allowed)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->default_str(default_text);
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double* value, NumberRange range,
                        const std::string& help) {
  return add_value(app, name, range.text(), number(*value), help, [value, range](const std::string& text) {
    const auto parsed = range.parse(text);
    if (parsed) *value = *parsed;
    return parsed.has_value();
  });
}

CLI::Option* add_integer(CLI::App& app, const std::string& name, std::uint64_t* value, std::uint64_t low,
                         std::uint64_t high, const std::string& help) {
  return add_value(app, name, integer_text(low, high), std::to_string(*value), help,
                   [value, low, high](const std::string& text) {
                     const auto parsed = parse<std::uint64_t>(text);
                     if (!parsed || *parsed < low || *parsed > high) return false;
                     *value = *parsed;
                     return true;
                   });
}

CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<double>* values, NumberRange range,
                         const std::string& help) {
  return add_value(app, name, "a list a,b,c or first:last:count, each " + range.text(), joined(*values), help,
                   [values, range](const std::string& text) {
                     const auto list = parse_list(text);
                     const auto is_allowed = [&](double value) { return range.contains(value); };
                     if (!list || !std::all_of(list->begin(), list->end(), is_allowed)) return false;
                     *values = *list;
                     return true;
                   });
}

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string* value,
                        const std::vector<std::string>& allowed, const std::string& help) {
  std::string words;
  for (const std::string& word : allowed) words += (words.empty() ? "" : ", ") + word;
  return add_value(app, name, "one of " + words, *value, help, [value, allowed](const std::string& text) {
    if (std::find(allowed.begin(), allowed.end(), text) == allowed.end()) return false;
    *value = text;
    return true;
  });
}

CLI::Option* add_path(CLI::App& app, const std::string& name, std::string* value, const std::string& what,
                      const std::string& help) {
  return add_value(app, name, what, *value, help, [value](const std::string& text) {
    *value = text;
    return !text.empty() && text.find('\0') == std::string::npos;
  });
}

CLI::Option* add_out(CLI::App& app, std::string* path) {
  return add_path(app, "--out", path, "a file in a folder that can be written",
                  "Write there instead of to standard output.");
}

CLI::Option* add_plot(CLI::App& app, std::string* path, const std::string& help) {
  return add_value(app, "--plot", "a file whose name ends with .svg", *path, help, [path](const std::string& text) {
    *path = text;
    return text.ends_with(".svg") && text.find('\0') == std::string::npos;
  });
}

CLI::Option* add_threads(CLI::App& app, std::uint64_t* threads) {
  *threads = std::max(1U, std::thread::hardware_concurrency());
  return add_integer(app, "--threads", threads, 1, 256,
                     "Threads to work with; the results are the same for any number.");
}

CLI::Option* add_seed(CLI::App& app, std::uint64_t* seed) {
  return add_integer(app, "--seed", seed, 0, std::numeric_limits<std::uint64_t>::max(),
                     "Seed of the random numbers; the same seed gives the same results.");
}

CLI::Option* add_trials(CLI::App& app, std::uint64_t* trials, const std::string& help) {
  return add_integer(app, "--trials", trials, 1, 100'000'000, help);
}

CLI::Option* add_families(CLI::App& app, std::vector<const PeopleFamily*>* families, const std::string& standard,
                          const std::string& help) {
  return add_value(app, "--family", "different families, separated by commas (robustness --help shows them)", standard,
                   help, [families](const std::string& names) {
                     std::vector<const PeopleFamily*> taken;
                     for (const std::string_view name : split(names, ',')) {
                       const PeopleFamily* family = people_family(std::string(name).c_str());
                       if (!family || std::find(taken.begin(), taken.end(), family) != taken.end()) return false;
                       taken.push_back(family);
                     }
                     *families = taken;
                     return true;
                   });
}

CLI::Option* add_traits(CLI::App& app, const std::string& name, std::vector<PersonState::Index>* traits,
                        const std::string& standard, const std::string& help) {
  std::string all;
  const std::span traits_known(person_state, PersonState::traits);
  for (const StateVariable& trait : traits_known) all += (all.empty() ? "" : ",") + std::string(trait.name);
  return add_value(app, name, "from " + all, standard, help, [traits, traits_known](const std::string& names) {
    std::vector<PersonState::Index> taken;
    for (const std::string_view trait_name : split(names, ',')) {
      const auto trait = std::ranges::find(traits_known, trait_name, &StateVariable::name);
      if (trait == traits_known.end() || std::ranges::find(taken, trait->index) != taken.end()) return false;
      taken.push_back(trait->index);
    }
    *traits = taken;
    return true;
  });
}

std::string tuning_names() {
  std::string text = "Tuned numbers of --tune and their ranges (core/person/tuning.h has the meanings):\n";
  Tuning tuning;
  for (const TuningField& field : tuning_fields(tuning))
    text += "  " + field.name + ' ' + number(field.min) + " to " + number(field.max) + ", default " +
            number(*field.value) + '\n';
  return text;
}

CLI::Option* add_tuning(CLI::App& app, Tuning* tuning) {
  const auto set = [tuning](std::string_view assignment) {
    const std::size_t equals = std::min(assignment.find('='), assignment.size());
    for (const TuningField& field : tuning_fields(*tuning)) {
      if (field.name != assignment.substr(0, equals) || equals == assignment.size()) continue;
      const auto value = parse<double>(std::string(assignment.substr(equals + 1)));
      if (!value || !(*value >= field.min && *value <= field.max)) return false;
      *field.value = *value;
      return true;
    }
    return false;
  };
  std::string names;
  for (const TuningField& field : tuning_fields(*tuning))
    names += (names.empty() ? "" : ", ") + field.name + " (" + number(field.min) + " to " + number(field.max) + ')';
  return add_value(app, "--tune", "NAME=VALUE[,NAME=VALUE...], names below", "core/person/tuning.h",
                   "Tuned numbers of our controller to change.", [set, names](const std::string& text) {
                     for (const std::string_view assignment : split(text, ','))
                       if (!set(assignment)) throw UsageError(not_allowed("--tune", text, "NAME=VALUE with " + names));
                     return true;
                   });
}

void require(CLI::Option* option) { option->required(); }

void show_default(CLI::Option* option, const std::string& text) { option->default_str(text); }

void format_help(CLI::App& app) { app.formatter(std::make_shared<HelpFormatter>()); }

}  // namespace hrt::study
