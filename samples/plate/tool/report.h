// Measurements of a plate as text, as a file for sessions and scenes, and as a picture.
#pragma once

#include <filesystem>
#include <string>

#include "samples/plate/tool/measure.h"

namespace hrt::plate {

/// Lines for people.
std::string text_of(const Measurements& found);

/// JSON: what was measured (null: not measurable), `session` with fields of hrt_session_config, `scene` with
/// the plate's properties of a glTF scene.
std::string json_of(const Measurements& found);

/// SVG: reported less commanded orientation over the commanded one, both directions of the sweep.
std::string svg_of(const Measurements& found);

/// Replaces the file in one step. Throws std::runtime_error, and leaves nothing behind, if that fails.
void write_file(const std::filesystem::path& file, const std::string& content);

}  // namespace hrt::plate
