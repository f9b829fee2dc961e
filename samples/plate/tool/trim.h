// Trims the plate's 0 against a mark.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "plugin/src/plate/device.h"

namespace hrt::plate {

/// What a person enters: nothing while they think; "" for an empty line; no more lines: an end.
struct Entry {
  bool ended = false;
  std::optional<std::string> line;
};

/// Turns to 0 and asks, by `say`, how far the mark is off, until an empty line; then saves. `read` returns at
/// once. True if the trim was saved; false if the entries ended, and the old one still holds. Throws
/// PlateFailure.
bool trim(Device& device, const std::function<Entry()>& read,
          const std::function<void(const std::string&)>& say);

}  // namespace hrt::plate
