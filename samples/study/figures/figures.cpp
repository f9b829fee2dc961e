#include "samples/study/figures/figures.h"

#include "samples/app/text/text.h"

namespace hrt::study {

std::string with_minus_signs(std::string text) {
  for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; ++at)
    if (at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9') text.replace(at, 1, "−");
  return text;
}

std::string drawing(const Figure& figure) {
  return "reset\nset encoding utf8\nset minussign\nset terminal svg size " + std::to_string(figure.width_px) + ',' +
         std::to_string(figure.height_px) + " enhanced font 'DejaVu Sans,13' background rgb 'white'\nset output '" +
         figure.name + ".svg'\n" + figure.script + "unset output\n";
}

std::string html_page(const std::string& text, const std::vector<Figure>& figures) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<title>Haptic retargeting by touch: the paper and the model</title>\n<style>\n"
      "body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 1.5rem auto; padding: 0 1rem; "
      "color: #111; }\npre { overflow-x: auto; font-size: .8rem; line-height: 1.3; }\n"
      "img { max-width: 100%; height: auto; }\nfigure { margin: 1.5rem 0; border-top: 1px solid #ccc; }\n"
      "</style>\n</head>\n<body>\n<h1>Haptic retargeting by touch: the paper and the model</h1>\n"
      "<p><b>Everything on this page is simulation, the paper's numbers too. There was no human trial.</b> "
      "Directions are in degrees from the plate's mid-line, counter-clockwise positive seen from "
      "above.</p>\n<pre>" +
      escaped(text) + "</pre>\n";
  for (const Figure& figure : figures)
    page += "<figure><img src=\"" + figure.name + ".svg\" alt=\"" + escaped(figure.title) + "\"><figcaption><b>" +
            escaped(figure.title) + ".</b> " + escaped(figure.caption) + " Simulation.</figcaption></figure>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace hrt::study
