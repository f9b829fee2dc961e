#include "samples/study/figures/figures.h"

namespace hrt::study {

std::string drawing(const Figure& figure, const std::string& ending) {
  const std::string size = std::to_string(figure.width_px) + ',' + std::to_string(figure.height_px);
  const std::string terminal = ending == "svg" ? "svg size " + size + " enhanced font 'DejaVu Sans,13'"
                                               : "pngcairo size " + size + " enhanced font 'DejaVu Sans,10'";
  return "reset\nset encoding utf8\nset terminal " + terminal + " background rgb 'white'\nset output '" +
         figure.name + '.' + ending + "'\n" + figure.script + "unset output\n";
}

}  // namespace hrt::study
