// Registration: a person touches marks of the plate, the plugin fits the plate's pose to the touches, and a file stores
// the pose.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "samples/app/run/run_context.h"

namespace hrt::app {

/// A registered plate, in a reference space of the runtime.
struct RegisteredPlate {
  XrReferenceSpaceType space;
  Mark check;                  ///< mark touched before the reaches, to check that the plate has not moved
  hrt_session_config found{};  ///< pose and covariance, and the offset from joint to skin if it was measured
  std::optional<Hand> hand;    ///< hand whose offset was measured; unset: touches are positions of the joint
};

/// Configuration of a set-up that asks for these marks and checks the first one.
hrt_setup_config config_of(std::span<const Mark> marks);

/// Locates fingertips relative to this plate from now on, with the measured offset from joint to skin.
void place_plate(RunContext& context, const RegisteredPlate& plate);

/// Asks for touches of all marks, and places the session's plate space at the fitted pose in steady_space(). With
/// `fingertip`, first asks for touches of the first mark with different attitudes of the finger, and locates the skin
/// from then on. Throws as SetUp::run().
RegisteredPlate register_plate(RunContext& context, std::span<const Mark> marks, bool fingertip);

/// Asks for a touch that checks the pose, and places the session's plate space where the plate was registered, with the
/// measured offset from joint to skin. Returns the distance of the touch from the mark, in metres. Throws as
/// SetUp::run(); Failure (ExitCode::registration) if the plate has moved, the runtime lacks `plate.space`, or another
/// hand than `plate.hand` may touch.
double check_plate(RunContext& context, const RegisteredPlate& plate);

/// Writes the registration into a session's configuration, whose numbers the plugin checks.
void put_registration(const RegisteredPlate& plate, hrt_session_config& config);

/// Content of a registration file. The pose is in the present coordinates of its space.
std::string registration_text(const RegisteredPlate& plate, const XrHeadlessSession& session);

/// Replaces the file atomically. Throws Failure (ExitCode::output).
void write_registration(const std::filesystem::path& file, const std::string& text);

/// Parses the text of the registration file `name`. Throws Failure (ExitCode::registration) that names the file. The
/// plugin checks the numbers when they are used.
RegisteredPlate parse_registration(const std::string& text, const std::string& name);
RegisteredPlate read_registration(const std::filesystem::path& file);

}  // namespace hrt::app
