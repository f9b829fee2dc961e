// Options of the subcommands. Help and error messages both state what is allowed.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/person/tuning.h"
#include "samples/study/cli/output.h"

namespace hrt {
struct PeopleFamily;
}

namespace hrt::study {

struct NumberRange {
  double low;
  double high;
  bool low_allowed = true;
  bool high_allowed = true;
  bool infinity_allowed = false;  ///< also above `high`
  bool whole = false;

  bool contains(double value) const;
  std::optional<double> parse(std::string_view words) const;  ///< nullopt if `words` is not an allowed number
  std::string text() const;                                   ///< for example "a number in (0, 0.5)"
};

inline constexpr NumberRange tactile_weight_range{0.0, 0.5, false, false};
inline constexpr NumberRange variance_range{0.0, 1e6};
inline constexpr NumberRange positive_variance_range{0.0, 1e6, false};
inline constexpr NumberRange direction_range{-180.0, 180.0};
inline constexpr NumberRange plate_bound_range{0.0, 90.0, false};

/// Adds a subcommand whose help ends with `footer`; `run` is called after all arguments are read.
CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& help, const std::string& footer,
                      const std::function<void()>& run);

/// Returns a check of an option's text. `allowed`: description of valid texts for help and errors.
CLI::Validator must_be(const std::string& allowed, const std::function<bool(const std::string&)>& passes);
CLI::Validator must_be(const NumberRange& range);

/// Adds an option for a number in `range`, or for an integer in [low, high]; the help shows the default.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, const NumberRange& range,
                        const std::string& help);
template <typename Integer>
CLI::Option* add_integer(CLI::App& app, const std::string& name, Integer& value, double low, double high,
                         const std::string& help) {
  return app.add_option(name, value, help)
      ->check(must_be({.low = low, .high = high, .whole = true}))
      ->capture_default_str();
}

/// Adds an option for a list of numbers in `range`: "0.1,0.15", or "0.05:0.45:9" for nine evenly spaced values from the
/// first to the last.
CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<double>& values, const NumberRange& range,
                         const std::string& help);

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& allowed, const std::string& help);

/// Adds an option for a file or folder; an empty name is rejected.
CLI::Option* add_path(CLI::App& app, const std::string& name, std::string& value, const std::string& help);
CLI::Option* add_out(CLI::App& app, std::string& path);
/// Adds --plot, a file whose name ends with .svg.
CLI::Option* add_plot(CLI::App& app, std::string& path, const std::string& help);

/// Adds --threads; the default is the number of processors.
CLI::Option* add_threads(CLI::App& app, std::uint64_t& threads);
CLI::Option* add_seed(CLI::App& app, std::uint64_t& seed);
CLI::Option* add_trials(CLI::App& app, std::uint64_t& trials, const std::string& help);

/// Adds --family, a list of names of people_families() without repetition. `standard`: description of the default in
/// the help.
CLI::Option* add_families(CLI::App& app, std::vector<const PeopleFamily*>& families, const std::string& standard,
                          const std::string& help);

/// Adds an option for a list of traits of the controller's model, without repetition.
CLI::Option* add_traits(CLI::App& app, const std::string& name, std::vector<PersonState::Index>& traits,
                        const std::string& standard, const std::string& help);

/// Adds --tune, which sets `tuning` to its defaults with the given fields: NAME=VALUE[,NAME=VALUE...].
CLI::Option* add_tuning(CLI::App& app, Tuning& tuning);
std::string tuning_names();

/// Splits `text` at separators, and keeps empty parts; returns at least one part.
std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace hrt::study
