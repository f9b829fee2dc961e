#include "samples/study/figures/figures.h"

namespace hrt::study {

std::string with_minus_signs(std::string text) {
  for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; ++at)
    if (at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9') text.replace(at, 1, "−");
  return text;
}

std::string drawing(const Figure& figure, const std::string& ending) {
  const std::string size = std::to_string(figure.width_px) + ',' + std::to_string(figure.height_px);
  const std::string terminal = ending == "svg" ? "svg size " + size + " enhanced font 'DejaVu Sans,13'"
                                               : "pngcairo size " + size + " enhanced font 'DejaVu Sans,10'";
  return "reset\nset encoding utf8\nset minussign\nset terminal " + terminal +
         " background rgb 'white'\nset output '" + figure.name + '.' + ending + "'\n" + figure.script +
         "unset output\n";
}

}  // namespace hrt::study
