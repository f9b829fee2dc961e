#include "samples/reach/output/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samples/format.h"
#include "samples/text.h"

namespace hrt::reach {
namespace {

constexpr double panel_px = 360.0;  // width of a panel; the plate fits into it with a margin
constexpr double title_px = 44.0;   // above the plate
constexpr double footer_px = 82.0;  // below all panels
constexpr std::size_t columns = 3;
constexpr double pi = std::numbers::pi;

std::string text_at(double x, double y, const std::string& attributes, const std::string& text) {
  return format("<text x=\"%.1f\" y=\"%.1f\" ", x, y) + attributes + ">" + escaped(text) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const char* kind) {
  return format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" class=\"%s\"/>\n", x1, y1, x2, y2,
                kind);
}

// Where plate coordinates are in a panel: x to the right, z (towards the user) down.
class Panel {
 public:
  Panel(double left_px, double top_px, double plate_radius_m)
      : centre_x_(left_px + panel_px / 2.0),
        centre_y_(top_px + title_px + panel_px / 2.0),
        scale_((panel_px / 2.0 - 16.0) / plate_radius_m) {}

  double x(double right_m) const { return centre_x_ + scale_ * right_m; }
  double y(double towards_user_m) const { return centre_y_ + scale_ * towards_user_m; }
  double length(double length_m) const { return scale_ * length_m; }
  double left() const { return centre_x_ - panel_px / 2.0; }
  double top() const { return centre_y_ - panel_px / 2.0 - title_px; }

 private:
  double centre_x_, centre_y_, scale_;
};

std::string circle(const Panel& panel, const std::array<double, 3>& at_m, double radius_m,
                   const std::string& attributes) {
  return format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" ", panel.x(at_m[0]), panel.y(at_m[2]),
                std::max(3.0, panel.length(radius_m))) +
         attributes + "/>\n";
}

// Ridges as the finger meets them: a patch of parallel lines, whose normal points along the orientation.
std::string ridges(const Panel& panel, const Moment& moment) {
  constexpr double patch_m = 0.008, spacing_m = 0.002;
  const double angle = moment.plate_orientation_deg * pi / 180.0;
  const double normal_x = -std::sin(angle), normal_z = -std::cos(angle);
  std::string lines;
  for (int i = -3; i <= 3; ++i) {
    const double offset_m = i * spacing_m;
    const double half_m = std::sqrt(patch_m * patch_m - offset_m * offset_m);
    const double x = moment.position_m[0] + offset_m * normal_x,
                 z = moment.position_m[2] + offset_m * normal_z;
    lines += format("M%.1f %.1fL%.1f %.1f", panel.x(x - half_m * normal_z), panel.y(z + half_m * normal_x),
                    panel.x(x + half_m * normal_z), panel.y(z - half_m * normal_x));
  }
  return "<path d=\"" + lines + "\" class=\"ridges\"/>\n";
}

std::string ridges_along(const Panel& panel, const std::vector<Moment>& moments) {
  constexpr std::size_t patches = 5;
  std::string drawn;
  for (std::size_t i = 0; i < patches; ++i)
    drawn += ridges(panel, moments[(2 * i + 1) * (moments.size() - 1) / (2 * patches)]);
  return drawn;
}

std::string true_path(const Panel& panel, const std::vector<Moment>& moments) {
  std::string points;
  for (const Moment& moment : moments)
    if (moment.tracked)
      points += format("%.1f,%.1f ", panel.x(moment.position_m[0]), panel.y(moment.position_m[2]));
  return "<polyline points=\"" + points + "\" class=\"true\"/>\n";
}

// As far as the finger really went, but in the direction that is felt.
std::string felt_path(const Panel& panel, const std::vector<Moment>& moments) {
  std::array<double, 3> at_m = moments.front().position_m;
  std::string points;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (i > 0) {
      const auto& from = moments[i - 1].position_m;
      const auto& to = moments[i].position_m;
      const double step_m = std::hypot(to[0] - from[0], to[2] - from[2]);
      const double angle = moments[i].felt_direction_deg * pi / 180.0;
      at_m[0] -= step_m * std::sin(angle);
      at_m[2] -= step_m * std::cos(angle);
    }
    points += format("%.1f,%.1f ", panel.x(at_m[0]), panel.y(at_m[2]));
  }
  return "<polyline points=\"" + points + "\" class=\"felt\"/>\n";
}

std::string draw(const Panel& panel, const PlottedReach& reach, const TargetSet& targets) {
  const TargetPair& pair = reach.pair;
  const double radius_m = pair.real_radius_m > 0.0 ? pair.real_radius_m : 0.004;
  const auto& start_m = targets.start_m;
  std::string out;
  out += text_at(panel.left() + panel_px / 2.0, panel.top() + 20.0, "class=\"title\"",
                 "feels " + pair.virtual_name + ", touches " + pair.real_name);
  out += text_at(panel.left() + panel_px / 2.0, panel.top() + 37.0, "class=\"middle\"",
                 format("%+.1f° felt as %+.1f°; ended %.1f mm away",
                        std::round(pair.real_direction_deg * 10.0) / 10.0 + 0.0, pair.virtual_direction_deg,
                        reach.result.miss_m * 1e3));
  out += circle(panel, {0.0, 0.0, 0.0}, targets.plate_radius_m, "class=\"plate\"");
  out += line(panel.x(start_m[0]), panel.y(start_m[2]), panel.x(start_m[0]), panel.y(-targets.plate_radius_m),
              "midline");
  if (!reach.result.moments.empty()) {
    out += ridges_along(panel, reach.result.moments);
    out += felt_path(panel, reach.result.moments);
    out += true_path(panel, reach.result.moments);
  }
  out += circle(panel, pair.real_position_m, radius_m, "class=\"real\"");
  out += circle(panel, pair.virtual_position_m, radius_m, "class=\"virtual\"");
  out += circle(panel, start_m, 0.0, "class=\"start\"");
  out += text_at(panel.x(start_m[0]) + 8.0, panel.y(start_m[2]) + 14.0, "", "start");
  // Each name on the side away from the other target.
  const bool virtual_is_left = pair.virtual_position_m[0] < pair.real_position_m[0];
  const double away_px = panel.length(radius_m) + 6.0;
  const auto name = [&](const std::array<double, 3>& at_m, bool to_left, const std::string& text) {
    out += text_at(panel.x(at_m[0]) + (to_left ? -away_px : away_px), panel.y(at_m[2]) + 4.0,
                   to_left ? "text-anchor=\"end\"" : "", text);
  };
  name(pair.virtual_position_m, virtual_is_left, pair.virtual_name);
  name(pair.real_position_m, !virtual_is_left, pair.real_name);
  return out;
}

std::string legend(double y, double width, double scale_bar_px) {
  std::string out;
  out += line(16.0, y - 4.0, 44.0, y - 4.0, "true");
  out += text_at(50, y, "", "true path");
  out += line(126.0, y - 4.0, 154.0, y - 4.0, "felt");
  out += text_at(160, y, "", "felt path");
  for (int i = 0; i < 5; ++i) out += line(15.0 + 5.0 * i, y + 25.0, 25.0 + 5.0 * i, y + 15.0, "ridges");
  out += text_at(50, y + 24.0, "", "ridges under the finger");
  out += line(width - 60.0 - scale_bar_px, y - 4.0, width - 60.0, y - 4.0, "bar");
  out += text_at(width - 54.0, y, "", "20 mm");
  return out;
}

constexpr const char* style =
    "<style>text{font:12px sans-serif;fill:#222}.title{font-size:14px;text-anchor:middle;font-weight:bold}"
    ".middle{text-anchor:middle}.plate{fill:#f4f1ea;stroke:#999}.midline{stroke:#bbb;stroke-dasharray:1 4}"
    ".ridges{stroke:#9a9a9a;stroke-width:1;fill:none}.true{stroke:#0b5394;stroke-width:2.5;fill:none}"
    ".felt{stroke:#d9641e;stroke-width:2;stroke-dasharray:6 4;fill:none}.real{fill:#0b5394;fill-opacity:.35;"
    "stroke:#0b5394;stroke-width:1.5}.virtual{fill:none;stroke:#d9641e;stroke-width:1.5;stroke-dasharray:3 2}"
    ".start{fill:#222}.bar{stroke:#222;stroke-width:2}</style>\n";

}  // namespace

std::string svg_of(const std::vector<PlottedReach>& reaches, const TargetSet& targets,
                   const std::string& note) {
  const std::size_t drawn = std::min(reaches.size(), max_plotted);
  const std::size_t rows = std::max<std::size_t>(1, (drawn + columns - 1) / columns);
  const double width = panel_px * static_cast<double>(std::clamp<std::size_t>(drawn, 1, columns));
  const double panels_px = static_cast<double>(rows) * (panel_px + title_px);
  const double height = panels_px + footer_px;
  std::string out = format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n",
      width, height, width, height);
  out += style;
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  for (std::size_t i = 0; i < drawn; ++i) {
    const std::size_t row = i / columns;
    const Panel panel(static_cast<double>(i % columns) * panel_px,
                      static_cast<double>(row) * (panel_px + title_px), targets.plate_radius_m);
    out += draw(panel, reaches[i], targets);
  }
  out += legend(panels_px + 18.0, width, Panel(0.0, 0.0, targets.plate_radius_m).length(0.02));
  std::string below = note;
  if (drawn < reaches.size()) below += format(" The first %zu of %zu reaches.", drawn, reaches.size());
  out += text_at(16, panels_px + 66.0, "", below);
  return out + "</svg>\n";
}

}  // namespace hrt::reach
