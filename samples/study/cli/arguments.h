// Options of the subcommands, whose values are checked against a range that
// the help and the error message both state.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/person/tuning.h"
#include "samples/study/cli/output.h"

// CLI11 takes seconds to compile: only arguments.cpp and main.cpp include it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hrt {
struct PeopleFamily;
}

namespace hrt::study {

/// The numbers that an option takes.
struct NumberRange {
  double low;
  double high;
  bool low_allowed = true;
  bool high_allowed = true;
  bool infinity_allowed = false;  ///< "inf" as well
  bool whole = false;             ///< whole numbers only

  bool contains(double value) const;
  std::optional<double> parse(std::string_view words) const;  ///< nothing unless it is one of them
  std::string text() const;                                   ///< "a number in (0, 0.5)"
};

inline constexpr NumberRange tactile_weight_range{0.0, 0.5, false, false};
inline constexpr NumberRange variance_range{0.0, 1e6};
inline constexpr NumberRange positive_variance_range{0.0, 1e6, false};
inline constexpr NumberRange weight_range{0.0, 1e6};
inline constexpr NumberRange positive_weight_range{0.0, 1e6, false};
inline constexpr NumberRange direction_range{-180.0, 180.0};
inline constexpr NumberRange gap_range{-90.0, 90.0, false, false};
inline constexpr NumberRange plate_bound_range{0.0, 90.0, false};
inline constexpr NumberRange plate_rate_bound_range{0.0, 360.0, false, true, true};

/// Adds a subcommand whose help ends with `footer`; `run` is called once all arguments are read.
CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& help, const std::string& footer,
                      const std::function<void()>& run);

/// Adds `name VALUE`. `take` stores the text's value, or returns false if it is not `allowed`: that, and the
/// default, are what the help and the error message say.
CLI::Option* add_value(CLI::App& app, const std::string& name, const std::string& allowed,
                       const std::string& default_text, const std::string& help,
                       const std::function<bool(const std::string&)>& take);

/// Adds `name VALUE` for a number of `range`; the help shows the range and `*value` as the default.
CLI::Option* add_number(CLI::App& app, const std::string& name, double* value, NumberRange range,
                        const std::string& help);

/// Adds `name VALUE` for a whole number of [low, high].
CLI::Option* add_integer(CLI::App& app, const std::string& name, std::uint64_t* value, std::uint64_t low,
                         std::uint64_t high, const std::string& help);

/// Adds `name LIST` for one or several numbers of `range`: "0.1,0.15" or "0.05:0.45:9", the latter being
/// nine values evenly spaced from the first to the last.
CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<double>* values, NumberRange range,
                         const std::string& help);

/// Adds `name WORD` for one of `allowed`.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string* value,
                        const std::vector<std::string>& allowed, const std::string& help);

/// Adds `name TEXT` for a file or folder; not empty.
CLI::Option* add_path(CLI::App& app, const std::string& name, std::string* value, const std::string& what,
                      const std::string& help);

/// Adds --out, a file.
CLI::Option* add_out(CLI::App& app, std::string* path);

/// Adds --plot, a file whose name ends with .svg.
CLI::Option* add_plot(CLI::App& app, std::string* path, const std::string& help);

/// Adds --threads; the default is every processor.
CLI::Option* add_threads(CLI::App& app, std::uint64_t* threads);

/// Adds the option --seed.
CLI::Option* add_seed(CLI::App& app, std::uint64_t* seed);

/// Adds the option --trials.
CLI::Option* add_trials(CLI::App& app, std::uint64_t* trials, const std::string& help);

/// Adds a list of traits of the controller's model.
CLI::Option* add_traits(CLI::App& app, const std::string& name, std::vector<PersonState::Index>* traits,
                        const std::string& standard, const std::string& help);

/// Adds --tune, fields of `tuning` by name.
CLI::Option* add_tuning(CLI::App& app, Tuning* tuning);
/// The names that it takes, and their ranges.
std::string tuning_names();

/// Adds --family, names of people_families(), each once; `standard` is what the help shows as the default.
CLI::Option* add_families(CLI::App& app, std::vector<const PeopleFamily*>* families, const std::string& standard,
                          const std::string& help);

/// The parts of `text` between separators, empty ones too; at least one.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The option must be given.
void require(CLI::Option* option);

/// The help shows this as the default; nothing if empty.
void show_default(CLI::Option* option, const std::string& text);

/// Has the help show range and default of each option on a line of their own.
void format_help(CLI::App& app);

}  // namespace hrt::study
