#include "samples/study/pages/html.h"

#include <algorithm>

#include "samples/text.h"

namespace hrt::study {
namespace {

constexpr const char* style = R"(
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 1.5rem auto; padding: 0 1rem; color: #111; }
h1 { font-size: 1.5rem; line-height: 1.2; }
svg { width: 100%; height: auto; }
figure { margin: 1.5rem 0; border-top: 1px solid #ccc; padding-top: 1rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 1rem 0; }
table.small { font-size: .8rem; line-height: 1.3; }
th, td { padding: .15rem .4rem; text-align: right; vertical-align: top; border-bottom: 1px solid #ddd; }
small { color: #555; white-space: nowrap; }
th:first-child, td:first-child, .words { text-align: left; }
tr.head td { background: #eef2f6; }
tr.mean td { border-bottom: 2px solid #888; font-weight: bold; }
tr.last td { border-bottom: 2px solid #888; }
summary { cursor: pointer; }
.note { border: 2px solid #111; padding: .5rem 1rem; font-weight: bold; }
@media (max-width: 600px) {
  table.small { font-size: .62rem; }
  table.small th, table.small td { padding: .1rem .2rem; }
  table.small small { display: block; }
}
@media print {
  body { font-size: 10pt; margin: 0; max-width: none; }
  figure, tr { break-inside: avoid; }
  h2 { break-after: avoid; }
  thead { display: table-header-group; }
  figure svg { max-height: 18cm; }
  table.small { font-size: 7.5pt; }
  .wide { overflow: visible; }
}
)";

// The <svg> element alone; its ids are made unique, since gnuplot repeats them in every file.
std::string inlined(const Figure& figure) {
  std::string svg = figure.svg.substr(std::min(figure.svg.find("<svg"), figure.svg.size()));
  const std::string prefix = figure.name + '-';
  for (const char* quote : {"'", "\""}) {
    replace_all(svg, std::string(" id=") + quote, std::string(" id=") + quote + prefix);
    replace_all(svg, std::string("href=") + quote + '#', std::string("href=") + quote + '#' + prefix);
  }
  replace_all(svg, "url(#", "url(#" + prefix);
  replace_all(svg, "<title>Gnuplot</title>", "<title>" + escaped(figure.title) + "</title>");
  return svg;
}

}  // namespace

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

std::string folded(const std::string& words, const std::string& html) {
  return "<details><summary>" + escaped(words) + "</summary>\n" + html + "</details>\n";
}

std::string page_start(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + escaped(title) +
         "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" + escaped(title) +
         "</h1>\n<p class=\"note\">Everything on this page is simulation, the paper's numbers too. There was "
         "no human trial.</p>\n";
}

std::string with_symbols(std::string text) {
  replace_all(text, " deg^2", " (°)²");
  replace_all(text, " deg²", " (°)²");
  for (const char* after : {" ", ",", ".", ";", ")"})
    replace_all(text, std::string(" deg") + after, std::string("°") + after);
  if (text.ends_with(" deg")) text.replace(text.size() - 4, 4, "°");
  return text;
}

std::string table_cells(std::initializer_list<std::string> values) {
  std::string row;
  for (const std::string& value : values) row += "<td>" + escaped(value) + "</td>";
  return row;
}

std::string figure_element(const Figure& figure) {
  return "<figure role=\"img\" aria-label=\"" + escaped(figure.title) +
         "\" style=\"max-width: " + std::to_string(figure.width_px) + "px\">\n" + inlined(figure) +
         "<figcaption><b>" + escaped(figure.title) + ".</b> " + escaped(figure.caption) +
         " Simulation.</figcaption>\n</figure>\n";
}

}  // namespace hrt::study
