// Measurements as text, as the file that hrt_plate_open() takes, and as a drawing.
#pragma once

#include <filesystem>
#include <string>

#include "samples/plate/tool/measure.h"

namespace hrt::plate {

std::string text_of(const Measurements& found);
/// `device`: the name to open; `date`: ISO 8601.
std::string file_of(const Measurements& found, const std::string& device, const std::string& date);
/// The sweep: reported less commanded orientation, against the command, of both directions.
std::string svg_of(const Measurements& found);

/// Puts `content` in the place of `file` in one step. Throws std::runtime_error.
void write_file(const std::filesystem::path& file, const std::string& content);

}  // namespace hrt::plate
