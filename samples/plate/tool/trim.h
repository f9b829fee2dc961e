// Trims the plate's 0 against a mark.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "samples/plate/driver/plate_link.h"

namespace hrt::plate {

/// What a person enters: nothing while they think; "" for an empty line; no more lines: an end.
struct Entry {
  bool ended = false;
  std::optional<std::string> line;
};

/// Turns to 0 and asks, by `say`, how far the mark is off, until an empty line; then saves. `read` returns at
/// once. True if the settings were saved; false if the entries ended, and the old ones still hold. Throws
/// PlateFailure.
bool trim(PlateLink& link, const std::function<Entry()>& read,
          const std::function<void(const std::string&)>& say);

/// Value of one of the plate's settings.
double setting_of(PlateLink& link, const std::string& name);
/// Changes it. PlateFailure with the reason if the plate refuses.
void change_setting(PlateLink& link, const std::string& name, double value);
/// Keeps all settings in the plate's memory. The plate stops first.
void save_settings(PlateLink& link);

}  // namespace hrt::plate
