#include "samples/reach/run/registration_file.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>

#include "samples/format.h"
#include "samples/reach/base/exit_code.h"
#include "samples/whole_file.h"

namespace hrt::reach {
namespace {

constexpr const char* first_line = "hrt-reach registration, version 1";
constexpr std::size_t max_line = 2000;

struct SpaceName {
  const char* name;
  XrReferenceSpaceType space;
};
constexpr SpaceName spaces[] = {{"STAGE", XR_REFERENCE_SPACE_TYPE_STAGE},
                                {"LOCAL", XR_REFERENCE_SPACE_TYPE_LOCAL}};

// The numbers of a registered plate, by the names of their lines.
struct Numbers {
  const char* name;
  std::span<double> values;
};
std::vector<Numbers> numbers_of(RegisteredPlate& plate) {
  hrt_registration& r = plate.registration;
  return {{"position_m", r.plate_position_m},   {"rotation", r.plate_rotation},
          {"scale", {&r.plate_scale, 1}},       {"covariance", r.covariance},
          {"touch_sd_m", {&r.touch_sd_m, 1}},   {"residual_m", {&r.residual_m, 1}},
          {"turn_sd_deg", {&r.turn_sd_deg, 1}}, {"check_m", plate.check.position_m}};
}

constexpr const char* fingertip_name[] = {"fingertip_left", "fingertip_right"};
std::vector<Numbers> numbers_of(hrt_fingertip& fingertip, const char* name) {
  return {{name, fingertip.offset_m}, {"sd_m", fingertip.sd_m}};
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), stream_(file) {
    if (!stream_) throw Failure(ExitCode::registration, file.string() + " cannot be read");
  }

  std::string line() {
    ++number_;
    if (ahead_) return *std::exchange(ahead_, std::nullopt);
    std::string text;
    if (!std::getline(stream_, text)) refuse("the file ends here");
    if (!text.empty() && text.back() == '\r') text.pop_back();
    if (text.size() > max_line) refuse("the line is too long");
    return text;
  }

  /// Whether the next line has this name.
  bool follows(const std::string& name) {
    if (!ahead_ && stream_.peek() == std::ifstream::traits_type::eof()) return false;
    if (!ahead_) {
      ahead_ = line();
      --number_;
    }
    return ahead_->starts_with(name + " ");
  }

  void end() {
    if (!ahead_ && stream_.peek() == std::ifstream::traits_type::eof()) return;
    ++number_;
    refuse("the file is to end here");
  }

  /// What follows the name.
  std::string rest(const std::string& name) {
    const std::string text = line();
    if (!text.starts_with(name + " ")) refuse("\"" + name + "\" is needed here");
    return text.substr(name.size() + 1);
  }

  void numbers(const char* name, std::span<double> values) {
    constexpr double finite = std::numeric_limits<double>::max();
    std::istringstream words(rest(name));
    std::string word;
    for (double& value : values) {
      words >> word;
      const std::optional<double> number = words ? number_in(word, -finite, finite) : std::nullopt;
      if (!number) refuse(std::string(name) + " is not " + std::to_string(values.size()) + " numbers");
      value = *number;
    }
    if (words >> word)
      refuse(std::string(name) + " has more than " + std::to_string(values.size()) + " numbers");
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw Failure(ExitCode::registration, file_.string() + ", line " + std::to_string(number_) + ": " + what);
  }

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
  std::optional<std::string> ahead_;  // read, and not yet taken
  int number_ = 0;
};

}  // namespace

void write_registration(const std::filesystem::path& file, const RegisteredPlate& plate) {
  RegisteredPlate copy = plate;
  std::string text = std::string(first_line) + "\n";
  for (const SpaceName& known : spaces)
    if (known.space == plate.space) text += std::string("space ") + known.name + "\n";
  text += "check " + plate.check.name + "\n";
  std::vector<Numbers> lines = numbers_of(copy);
  for (std::size_t hand = 0; hand < copy.fingertips.size(); ++hand)
    if (copy.fingertips[hand].known != 0)
      for (const Numbers& numbers : numbers_of(copy.fingertips[hand], fingertip_name[hand]))
        lines.push_back(numbers);
  for (const Numbers& numbers : lines) {
    text += numbers.name;
    for (const double value : numbers.values) {
      char digits[40];
      text += " " + std::string(digits, std::to_chars(std::begin(digits), std::end(digits), value).ptr);
    }
    text += "\n";
  }
  if (const int error = write_whole_file(file, text); error != 0)
    throw Failure(ExitCode::output, file.string() + " cannot be written: " + std::strerror(error));
}

RegisteredPlate read_registration(const std::filesystem::path& file) {
  Reader reader(file);
  RegisteredPlate plate{};
  plate.registration.struct_size = sizeof plate.registration;
  plate.registration.verdict = HRT_REGISTRATION_HOLDS;
  plate.registration.left_out = -1;
  if (reader.line() != first_line) reader.refuse(std::string("\"") + first_line + "\" is needed here");
  const std::string space = reader.rest("space");
  const auto* known = std::find_if(std::begin(spaces), std::end(spaces),
                                   [&](const SpaceName& candidate) { return space == candidate.name; });
  if (known == std::end(spaces)) reader.refuse("the space is to be STAGE or LOCAL");
  plate.space = known->space;
  plate.check.name = reader.rest("check");
  if (std::any_of(plate.check.name.begin(), plate.check.name.end(),
                  [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
    reader.refuse("the mark's name has a control character");
  for (const Numbers& numbers : numbers_of(plate)) reader.numbers(numbers.name, numbers.values);
  for (std::size_t hand = 0; hand < plate.fingertips.size(); ++hand) {
    if (!reader.follows(fingertip_name[hand])) continue;
    hrt_fingertip& fingertip = plate.fingertips[hand];
    fingertip.struct_size = sizeof fingertip;
    fingertip.known = 1;
    for (const Numbers& numbers : numbers_of(fingertip, fingertip_name[hand]))
      reader.numbers(numbers.name, numbers.values);
  }
  reader.end();
  return plate;
}

}  // namespace hrt::reach
