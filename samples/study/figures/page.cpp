#include "samples/study/figures/page.h"

#include "samples/text.h"

namespace hrt::study {

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
    page += "<figure><img src=\"" + figure.name + ".svg\" alt=\"" + escaped(figure.title) +
            "\"><figcaption><b>" + escaped(figure.title) + ".</b> " + escaped(figure.caption) +
            " Simulation.</figcaption></figure>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace hrt::study
