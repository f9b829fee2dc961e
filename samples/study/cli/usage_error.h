// What a subcommand throws at a mistake in its arguments.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace hrt::study {

/// A mistake of the caller's: one line that names the argument and its allowed values. Exit code 2.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// "NAME: 'TEXT' is not allowed; it must be WHAT".
inline std::string not_allowed(const std::string& name, std::string_view text, const std::string& what) {
  return name + ": '" + std::string(text) + "' is not allowed; it must be " + what;
}

}  // namespace hrt::study
