// Registration of the plate: a person touches its marks, the plugin fits its pose to the touches, and a file
// keeps it.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "samples/app/run/stage.h"

namespace hrt::app {

/// A registered plate, in a reference space of the runtime.
struct RegisteredPlate {
  XrReferenceSpaceType space;
  Mark check;                  ///< touched before the reaches, to see whether the plate is where it was
  hrt_session_config found{};  ///< pose, covariance, and the skin if it was found
  std::optional<Hand> hand;    ///< whose skin the touches were of, if that was found; else they were of the joint
};

/// Of a set-up that asks for these marks, and checks by the first one.
hrt_setup_config config_of(std::span<const Mark> marks);

/// Fingertips are located there from now on, by the skin that was found.
void place_plate(Stage& stage, const RegisteredPlate& plate);

/// Asks for a touch of each mark, in the session's steady space, until they fit. Places the session's plate
/// space there. With `fingertip`, asks before for touches of the first mark in different attitudes, and from
/// then on locates the skin. Throws as SetUp::run().
RegisteredPlate register_plate(Stage& stage, std::span<const Mark> marks, bool fingertip);

/// Places the session's plate space where the plate was registered, locates the skin of its hand, and asks
/// for a touch that checks it. Throws as SetUp::run(); Failure (ExitCode::registration) if the plate is
/// elsewhere or the runtime lacks its space. Returns how far off the touch was, metres.
double check_plate(Stage& stage, const RegisteredPlate& plate);

/// In a session's configuration, which the plugin refuses if it is no plate.
void put_registration(const RegisteredPlate& plate, hrt_session_config& config);

/// As a file has it; the pose is in the present coordinates of its space.
std::string registration_text(const RegisteredPlate& plate, const XrHeadlessSession& session);

/// Replaces the file as a whole. Throws Failure (ExitCode::output).
void write_registration(const std::filesystem::path& file, const std::string& text);

/// Throws Failure (ExitCode::registration) naming the member. The plugin checks the numbers when they are
/// used.
RegisteredPlate parse_registration(const std::string& text, const std::string& name);
RegisteredPlate read_registration(const std::filesystem::path& file);

}  // namespace hrt::app
