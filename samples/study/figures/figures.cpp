#include "samples/study/figures/figures.h"

namespace hrt::study {

std::string with_minus_signs(std::string text) {
  for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; ++at)
    if (at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9') text.replace(at, 1, "−");
  return text;
}

std::string drawing(const Figure& figure) {
  return "reset\nset encoding utf8\nset minussign\nset terminal svg size " + std::to_string(figure.width_px) +
         ',' + std::to_string(figure.height_px) +
         " enhanced font 'DejaVu Sans,13' background rgb 'white'\nset output '" + figure.name + ".svg'\n" +
         figure.script + "unset output\n";
}

}  // namespace hrt::study
