#include <algorithm>
#include <cmath>

#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"
#include "samples/study/cli/output.h"
#include "samples/study/figures/figures.h"

namespace hrt::study {
namespace {

constexpr double plate_radius_mm = 75.0;
constexpr double start_away_mm = -50.0;  // as seen from the plate's centre
constexpr double ridge_mm = 10.0;
constexpr double still_s = 1.2;    // at the end, before it begins again
constexpr double before_s = 0.25;  // of the motion
constexpr int frames_a_second = 25;

// On the picture: right, and down towards the person.
struct Spot {
  double x;
  double y;
};

Spot spot(const PlatePoint& point) { return {point.right_mm, -(point.away_mm + start_away_mm)}; }

Spot target(const PersonCondition& condition, double direction_deg) {
  return spot(point_ahead({0.0, 0.0}, direction_deg, condition.distance_mm));
}

// The samples of each frame of the picture, from shortly before the finger moves.
std::vector<TracedSample> frames(const Trace& trace) {
  const auto& samples = trace.samples;
  const auto moves = std::find_if(samples.begin(), samples.end(),
                                  [](const TracedSample& sample) { return distance_mm({}, sample.finger) > 1.0; });
  const double first_s = std::max(samples.front().time_s, moves->time_s - before_s);
  std::vector<TracedSample> found;
  auto next = samples.begin();
  for (int i = 0; next != samples.end(); ++i) {
    const double time_s = first_s + static_cast<double>(i) / frames_a_second;
    while (next != samples.end() && next->time_s < time_s) ++next;
    if (next != samples.end()) found.push_back(*next);
  }
  return found;
}

// The values of an attribute over the picture's time, the last one held.
std::string animation(const std::string& opening, const std::vector<std::string>& values) {
  const double total_s = static_cast<double>(values.size()) / frames_a_second + still_s;
  std::string list, times;
  for (std::size_t i = 0; i < values.size(); ++i) {
    list += values[i] + ';';
    times += fixed(static_cast<double>(i) / frames_a_second / total_s, 4) + ';';
  }
  return opening + " dur=\"" + fixed(total_s, 2) + "s\" repeatCount=\"indefinite\" values=\"" + list + values.back() +
         "\" keyTimes=\"" + times + "1\"/>";
}

std::string attribute(const std::string& name, const std::vector<std::string>& values) {
  return animation("<animate attributeName=\"" + name + '"', values);
}

// A path that is drawn as the finger comes along, and the dot at its end.
std::string moving(const std::vector<Spot>& spots, const std::string& line, const std::string& dot) {
  std::string points;
  std::vector<std::string> left_mm, xs, ys;
  double length_mm = 0.0;
  for (std::size_t i = 1; i < spots.size(); ++i)
    length_mm += std::hypot(spots[i].x - spots[i - 1].x, spots[i].y - spots[i - 1].y);
  double done_mm = 0.0;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (i > 0) done_mm += std::hypot(spots[i].x - spots[i - 1].x, spots[i].y - spots[i - 1].y);
    xs.push_back(fixed(spots[i].x, 1));
    ys.push_back(fixed(spots[i].y, 1));
    left_mm.push_back(fixed(length_mm - done_mm, 1));
    points += xs.back() + ',' + ys.back() + ' ';
  }
  return "<polyline fill=\"none\" stroke-width=\"1.4\" " + line + " stroke-dasharray=\"" + fixed(length_mm, 1) +
         " 999\" points=\"" + points + "\">" + attribute("stroke-dashoffset", left_mm) +
         "</polyline>\n<circle r=\"3.2\" " + dot + '>' + attribute("cx", xs) + attribute("cy", ys) + "</circle>\n";
}

std::string ridges(const std::vector<TracedSample>& samples) {
  std::string lines;
  for (double across = -plate_radius_mm + ridge_mm / 2; across < plate_radius_mm; across += ridge_mm) {
    const double half = std::sqrt(plate_radius_mm * plate_radius_mm - across * across);
    lines += 'M' + fixed(-half, 1) + ' ' + fixed(across, 1) + 'h' + fixed(2 * half, 1);
  }
  std::vector<std::string> turns;
  for (const TracedSample& sample : samples) turns.push_back(fixed(-sample.plate_deg, 1));
  return "<g stroke=\"#b9c4d0\" stroke-width=\"1.1\">" +
         animation("<animateTransform attributeName=\"transform\" type=\"rotate\"", turns) + "<path d=\"" + lines +
         "\"/></g>\n";
}

std::string label(const Spot& at, const char* anchor, const std::string& color, const std::string& text) {
  return "<text x=\"" + fixed(at.x, 1) + "\" y=\"" + fixed(at.y, 1) + "\" text-anchor=\"" + anchor + "\" fill=\"" +
         color + "\">" + text + "</text>\n";
}

// A state of the filter with its unit, such as "bias_deg".
std::string state_name(const StateVariable& variable) {
  return *variable.unit ? std::string(variable.name) + '_' + variable.unit : variable.name;
}

}  // namespace

Trace trace_reach(const PersonCondition& condition, int reach, std::uint64_t seed, std::uint32_t index) {
  Trace trace{.condition = condition, .samples = {}};
  const RetargeterConfig controller = people_controller(condition);
  simulate_person(condition, &controller, reach, seed, index, [&](int number, const PersonMoment& moment) {
    if (number + 1 != reach) return;
    trace.samples.push_back({.time_s = moment.time_s,
                             .finger = moment.finger,
                             .felt = moment.felt,
                             .plate_deg = moment.plate_deg,
                             .commanded_deg = moment.command.plate_orientation_deg,
                             .felt_error_deg = moment.command.felt_error_deg,
                             .mean = {},
                             .deviation = {}});
    for (const StateVariable& variable : person_state) {
      trace.samples.back().mean[variable.index] = moment.filter->mean(variable.index);
      trace.samples.back().deviation[variable.index] = moment.filter->sd(variable.index);
    }
  });
  return trace;
}

std::string trace_csv(const Trace& trace) {
  std::string page =
      "time_s,finger_right_mm,finger_away_mm,felt_right_mm,felt_away_mm,plate_deg,commanded_deg,felt_error_"
      "deg";
  for (const StateVariable& variable : person_state)
    page += ',' + state_name(variable) + ',' + state_name(variable) + "_sd";
  page += '\n';
  for (const TracedSample& sample : trace.samples) {
    page += number(sample.time_s);
    for (const double value : {sample.finger.right_mm, sample.finger.away_mm, sample.felt.right_mm, sample.felt.away_mm,
                               sample.plate_deg, sample.commanded_deg, sample.felt_error_deg})
      page += ',' + number(value);
    for (std::size_t i = 0; i < sample.mean.size(); ++i)
      page += ',' + number(sample.mean[i]) + ',' + number(sample.deviation[i]);
    page += '\n';
  }
  return page;
}

Figure trace_figure(const Trace& trace) {
  Row data;
  for (const TracedSample& sample : trace.samples) data["time_s"].push_back(sample.time_s);
  for (const StateVariable& variable : person_state) {
    Row state{{"name", state_name(variable)}};
    for (const TracedSample& sample : trace.samples) {
      state["mean"].push_back(sample.mean[variable.index]);
      state["sd"].push_back(sample.deviation[variable.index]);
    }
    data["states"].push_back(state);
  }
  return {.name = "trace",
          .title = "Every state of the filter and two deviations, over seconds",
          .caption = "",
          .data = data};
}

std::string moving_picture(const Trace& trace) {
  const std::vector<TracedSample> samples = frames(trace);
  const Spot real = target(trace.condition, trace.condition.real_direction_deg);
  const Spot felt = target(trace.condition, trace.condition.virtual_direction_deg);
  std::vector<Spot> finger, feels;
  for (const TracedSample& sample : samples) {
    finger.push_back(spot(sample.finger));
    feels.push_back(spot(sample.felt));
  }
  const auto circle = [](const Spot& at, const std::string& look) {
    return "<circle cx=\"" + fixed(at.x, 1) + "\" cy=\"" + fixed(at.y, 1) + "\" r=\"6\" " + look + "/>\n";
  };
  const bool real_is_left = real.x < felt.x;
  const double side = real_is_left ? -9.0 : 9.0;
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-105 -82 210 174\" width=\"630\" "
         "height=\"522\" "
         "font-family=\"sans-serif\" font-size=\"7\">\n<title>A simulated reach from above: the plate turns, "
         "the finger arrives at "
         "the real target, and the perceived path ends at the virtual one</title>\n<rect x=\"-105\" y=\"-82\" "
         "width=\"210\" "
         "height=\"174\" fill=\"#ffffff\"/>\n<circle r=\"75\" fill=\"#eef1f5\" stroke=\"#8794a3\"/>\n" +
         ridges(samples) + circle(real, "fill=\"#8fb0d6\" stroke=\"#08306b\" stroke-width=\"1.4\"") +
         circle(felt, "fill=\"none\" stroke=\"#c45a00\" stroke-width=\"1.4\" stroke-dasharray=\"3 2\"") +
         moving(feels, "stroke=\"#c45a00\" stroke-opacity=\"0.75\"",
                "fill=\"none\" stroke=\"#c45a00\" stroke-width=\"1.2\"") +
         moving(finger, "stroke=\"#08306b\"", "fill=\"#08306b\" stroke=\"#ffffff\" stroke-width=\"0.6\"") +
         label({real.x + side, real.y}, real_is_left ? "end" : "start", "#08306b", "real target") +
         label({felt.x - side, felt.y}, real_is_left ? "start" : "end", "#c45a00", "virtual target") +
         label({0.0, 85.0}, "middle", "#56616e", "simulated: where the finger is (blue), where it is felt (orange)") +
         "</svg>\n";
}

}  // namespace hrt::study
