// Registration of the plate: a person touches its marks, the plugin fits its pose to the touches, and a file
// keeps it.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>

#include "samples/reach/run/stage.h"

namespace hrt::reach {

/// A registered plate, in a reference space of the runtime; numbers as the plugin has them.
struct RegisteredPlate {
  XrReferenceSpaceType space;
  double position_m[3];
  double rotation[4];
  double covariance[6];
  Mark check;  ///< touched before the reaches, to see whether the plate is where it was
  /// Whose skin the touches were of, if that was found; else they were of the joint.
  std::optional<Hand> hand;
  Point skin_m{};
};

/// Asks for a touch of each mark, in the session's steady space, until they fit. Places the session's plate
/// space there. With `fingertip`, asks before for touches of the first mark in different attitudes, and from
/// then on locates the skin. Throws as SetUp::run().
RegisteredPlate register_plate(Stage& stage, std::span<const Mark> marks, bool fingertip);

/// Places the session's plate space where the plate was registered, locates the skin of its hand, and asks
/// for a touch that checks it. Throws as SetUp::run(); Failure (ExitCode::registration) if the plate is
/// elsewhere or the runtime lacks its space.
void check_plate(Stage& stage, const RegisteredPlate& plate);

/// Replaces the file as a whole; the pose is in the present coordinates of its space. Throws Failure
/// (ExitCode::output).
void write_registration(const std::filesystem::path& file, const RegisteredPlate& plate,
                        const XrHeadlessSession& session);

/// Throws Failure (ExitCode::registration) naming the member. The plugin checks the numbers when they are
/// used.
RegisteredPlate read_registration(const std::filesystem::path& file);

}  // namespace hrt::reach
