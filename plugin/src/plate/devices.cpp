// Table of the kinds of devices, and parser of device names such as "dynamixel:/dev/ttyUSB0?id=1&speed=200".
#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "plugin/include/plate_driver/device.h"

namespace hrt::plate {

DeviceMaker serial_device(const DeviceName& name);
DeviceMaker dynamixel_device(const DeviceName& name);

namespace {

struct Kind {
  std::string_view name;
  DeviceMaker (*check)(const DeviceName& name);
};
constexpr Kind kinds[] = {{"serial", serial_device}, {"dynamixel", dynamixel_device}};

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

std::string list_of(std::initializer_list<std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text.empty() ? "none" : text;
}

std::string known_kinds() {
  std::string text;
  for (const std::string& kind : device_kinds()) text += (text.empty() ? "" : ", ") + kind + ":...";
  return text;
}

DeviceName parts_of(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos)
    refuse("device \"" + std::string(text) + "\" has no kind; allowed: " + known_kinds() + ", a plate file (.json)");
  const std::size_t question = std::min(text.find('?', colon), text.size());
  DeviceName name{std::string(text.substr(0, colon)), std::string(text.substr(colon + 1, question - colon - 1)), {}};
  if (name.path.empty())
    refuse("device \"" + name.kind + ":\" names no serial line; add one, as in " + name.kind + ":/dev/ttyACM0");
  for (std::string_view rest = text.substr(question); !rest.empty();) {
    rest.remove_prefix(1);
    const std::string_view option = rest.substr(0, rest.find('&'));
    const std::size_t equals = option.find('=');
    if (equals == std::string_view::npos || equals == 0)
      refuse("option \"" + std::string(option) + "\" of the device must have the form name=value, as in id=1");
    name.options.emplace_back(option.substr(0, equals), option.substr(equals + 1));
    rest.remove_prefix(option.size());
  }
  return name;
}

}  // namespace

void DeviceName::check_options(std::initializer_list<std::string_view> known) const {
  for (auto option = options.begin(); option != options.end(); ++option) {
    const std::string& word = option->first;
    if (std::find(known.begin(), known.end(), word) == known.end())
      refuse("devices of kind " + kind + " have no option \"" + word + "\"; allowed: " + list_of(known));
    if (std::any_of(options.begin(), option, [&](const auto& other) { return other.first == word; }))
      refuse("option " + word + " is given twice; remove one of the two");
  }
}

int DeviceName::integer(std::string_view option, int default_value, int min, int max, const char* allowed) const {
  for (const auto& [word, text] : options) {
    if (word != option) continue;
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < min || value > max)
      refuse("option " + word + " is \"" + text +
             "\"; allowed: " + (allowed != nullptr ? allowed : std::to_string(min) + " to " + std::to_string(max)));
    return value;
  }
  return default_value;
}

std::vector<std::string> device_kinds() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds) names.emplace_back(kind.name);
  return names;
}

DeviceMaker device_named(std::string_view text) {
  const DeviceName name = parts_of(text);
  for (const Kind& kind : kinds)
    if (kind.name == name.kind) return kind.check(name);
  refuse("device is of kind \"" + name.kind + "\"; allowed: " + known_kinds());
}

}  // namespace hrt::plate
