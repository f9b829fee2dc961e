// Options of the subcommands: CLI11's, with the checks and parsers that it lacks. The help and the error message both
// state what is allowed.
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

/// Numbers that an option or a field of a file takes.
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
inline constexpr NumberRange direction_range{-180.0, 180.0};
inline constexpr NumberRange plate_bound_range{0.0, 90.0, false};

/// Adds a subcommand whose help ends with `footer`; `run` is called after all arguments are read.
CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& help, const std::string& footer,
                      const std::function<void()>& run);

/// Check of an option's text. `allowed` says in the help and in errors what passes.
CLI::Validator must_be(const std::string& allowed, const std::function<bool(const std::string&)>& passes);
CLI::Validator must_be(const NumberRange& range);

/// Adds an option for a number of `range`, or for a whole number of [low, high]; the help shows the default.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, const NumberRange& range,
                        const std::string& help);
template <typename Integer>
CLI::Option* add_integer(CLI::App& app, const std::string& name, Integer& value, double low, double high,
                         const std::string& help) {
  return app.add_option(name, value, help)
      ->check(must_be({.low = low, .high = high, .whole = true}))
      ->capture_default_str();
}

/// Adds an option for numbers of `range`: "0.1,0.15" or "0.05:0.45:9", nine values evenly spaced from the first to the
/// last.
CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<double>& values, const NumberRange& range,
                         const std::string& help);

/// Adds an option for one of `allowed`.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& allowed, const std::string& help);

/// Adds an option for a file or folder, whose name is not empty.
CLI::Option* add_path(CLI::App& app, const std::string& name, std::string& value, const std::string& help);
CLI::Option* add_out(CLI::App& app, std::string& path);
/// Adds --plot, a file whose name ends with .svg.
CLI::Option* add_plot(CLI::App& app, std::string& path, const std::string& help);

/// Adds --threads; the default is every processor.
CLI::Option* add_threads(CLI::App& app, std::uint64_t& threads);
CLI::Option* add_seed(CLI::App& app, std::uint64_t& seed);
CLI::Option* add_trials(CLI::App& app, std::uint64_t& trials, const std::string& help);

/// Adds --family, different names of people_families(); `standard` is what the help shows as the default.
CLI::Option* add_families(CLI::App& app, std::vector<const PeopleFamily*>& families, const std::string& standard,
                          const std::string& help);

/// Adds an option for different traits of the controller's model.
CLI::Option* add_traits(CLI::App& app, const std::string& name, std::vector<PersonState::Index>& traits,
                        const std::string& standard, const std::string& help);

/// Adds --tune, fields of `tuning` by name.
CLI::Option* add_tuning(CLI::App& app, Tuning& tuning);
/// The names that it takes, and their ranges.
std::string tuning_names();

/// The parts of `text` between separators, empty ones too; at least one.
std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace hrt::study
