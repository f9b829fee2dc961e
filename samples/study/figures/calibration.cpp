#include "samples/study/figures/calibration.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/learning.h"
#include "core/person/person_belief.h"
#include "samples/app/text/text.h"
#include "samples/study/cli/output.h"

namespace hrt::study {
namespace {

// The slides' own colours: used, outlying, along the ridges.
constexpr const char* verdict_name[] = {"used", "outlying", "along_ridges"};

std::string interval_text(const EstimatedTrait& trait) {
  return between(trait.interval.lower, trait.interval.upper, trait.decimals, " to ");
}

std::string row(const std::string& name, const std::string& value, const std::string& rest) {
  return "  " + left(name, 36) + right(value, 15) + "   " + rest + '\n';
}

double direction_deg(const CalibratedSlide& slide) { return settled_direction_deg(slide.parts_deg); }
double fitted_deg(const CalibratedSlide& slide) { return settled_direction_deg(slide.fitted_deg); }

std::string fit_text(const Calibration& calibration) {
  const LackOfFit& lack = calibration.lack_of_fit;
  const auto line = [](const char* over, double p) {
    return row(std::string("  ") + over, fixed(p, 3), p < min_fit_p ? "a pattern" : "none");
  };
  std::string text = "\nPatterns in what the fit leaves, probability by chance\n" +
                     line("over the plate's angle", lack.angle_p) + line("over the order of the slides", lack.order_p) +
                     line("along the paths", lack.path_p);
  for (const CalibratedSlide& slide : calibration.slides) {
    if (slide.verdict != SlideVerdict::outlying) continue;
    Eigen::Index part = 0;
    (slide.parts_deg - slide.fitted_deg).cwiseAbs().maxCoeff(&part);
    text += "  left out: trial " + std::to_string(slide.trial + 1) + ", an outlier: part " + std::to_string(part + 1) +
            " of its path goes to " + fixed(slide.parts_deg(part), 1) + " deg, the fit to " +
            fixed(slide.fitted_deg(part), 1) + '\n';
  }
  if (const std::size_t along = calibration.count(SlideVerdict::along_ridges); along > 0)
    text += "  left out: " + std::to_string(along) + " slides nearly along the ridges, where the illusion flips\n";
  if (calibration.max_plate_deg > 60.0)
    text += "  slides used reach plate angles of " + fixed(calibration.max_plate_deg, 0) +
            " deg; published human data cover 60\n";
  for (const std::string& advice : calibration.advice()) text += "Next: " + advice + ".\n";
  return text;
}

}  // namespace

std::vector<EstimatedTrait> estimated_traits(const Calibration& calibration) {
  return {{"tactile_weight", "tactile weight w_T at 60°", calibration.tactile_weight, 3},
          {"bias_deg", "bias, °, left positive", calibration.bias_deg, 2},
          {"habit_deg", "habit of curving, °", calibration.habit_deg, 2},
          {"max_gap_deg", "largest gap, °", calibration.max_gap_deg, 1},
          {"person_weight", "slope w of the controller's curve", calibration.slope, 3},
          {"person_curve", "curve b of it", calibration.curve, 3},
          {"tracker_noise_mm", "tracker noise, white, mm", calibration.noise.white_mm, 3},
          {"correlated_noise_mm", "tracker noise, correlated, mm", calibration.noise.correlated_mm, 3},
          {"noise_correlation_s", "its correlation time, s", calibration.noise.correlation_s, 3}};
}

std::string calibration_text(const CalibrationReport& report) {
  const Calibration& calibration = report.calibration;
  std::string text = "Calibration of " + report.name + ": " + std::to_string(calibration.count(SlideVerdict::used)) +
                     " of " + std::to_string(report.trials) + " trials have a slide that can be used\n\n";
  text += row("", "estimate", "95 % interval");
  for (const EstimatedTrait& trait : estimated_traits(calibration)) {
    const std::string value = fixed(trait.interval.value, trait.decimals);
    text += trait.interval.known ? row(trait.words, value, interval_text(trait))
                                 : row(trait.words, "not determined", "best fit " + value);
  }
  text += row("largest gap, plate from motion, °", fixed(calibration.peak_offset_deg, 0), "") + fit_text(calibration);
  return text + "\nThe method has been tried on simulated people only; there was no human trial.\n";
}

nlohmann::ordered_json calibration_json(const CalibrationReport& report) {
  const Calibration& calibration = report.calibration;
  nlohmann::ordered_json page{
      {"data", report.name},
      {"tried_on", "simulated people only"},
      {"trials", report.trials},
      {"trials_used", calibration.count(SlideVerdict::used)},
      {"goal_direction_deg", report.goal_direction_deg},
  };
  for (const EstimatedTrait& trait : estimated_traits(calibration))
    page[trait.name] = {{"value", trait.interval.value},
                        {"interval", {trait.interval.lower, trait.interval.upper}},
                        {"known", trait.interval.known}};
  page["slides_turned"] = calibration.slides_turned;
  page["fits"] = calibration.fits();
  page["lack_of_fit"] = {{"angle_p", calibration.lack_of_fit.angle_p},
                         {"order_p", calibration.lack_of_fit.order_p},
                         {"path_p", calibration.lack_of_fit.path_p}};
  page["peak_offset_deg"] = calibration.peak_offset_deg;
  for (const CurvePoint& point : calibration.band)
    page["curve"].push_back({{"offset_deg", point.offset_deg},
                             {"shift_deg", point.shift_deg.value},
                             {"interval", {point.shift_deg.lower, point.shift_deg.upper}}});
  for (const CalibratedSlide& slide : calibration.slides)
    page["slides"].push_back({{"trial", slide.trial + 1},
                              {"verdict", verdict_name[static_cast<int>(slide.verdict)]},
                              {"plate_deg", slide.plate_deg},
                              {"direction_deg", direction_deg(slide)},
                              {"fitted_deg", fitted_deg(slide)}});
  page["advice"] = calibration.advice();
  return page;
}

std::string calibration_profile(const Calibration& calibration) {
  nlohmann::ordered_json profile{{"format", "haptic retargeting profile"}, {"version", 1}};
  const Interval& weight = calibration.tactile_weight;
  if (weight.known) {
    profile["tactile_weight"] = weight.value;
    profile["tactile_weight_sd"] =
        std::max(deviation_of_interval(weight.lower, weight.upper), Tuning{}.min_carried_weight_sd);
  }
  if (calibration.bias_deg.known) profile["bias_deg"] = calibration.bias_deg.value;
  if (const auto noise = known_noise(calibration.noise)) {
    profile["tracker_noise_m"] = noise->white_mm / mm_per_m;
    if (noise->correlated_mm > 0.0) {
      profile["tracker_correlated_noise_m"] = noise->correlated_mm / mm_per_m;
      profile["tracker_correlation_s"] = noise->correlation_s;
    }
  }
  if (calibration.slope.known && calibration.curve.known && calibration.bias_deg.known && calibration.habit_deg.known) {
    const PersonBelief belief = calibrated_person({.weight = calibration.slope,
                                                   .curve = calibration.curve,
                                                   .weight_curve_correlation = calibration.slope_curve_correlation,
                                                   .bias_deg = calibration.bias_deg,
                                                   .habit_deg = calibration.habit_deg});
    for (int i = 0; i < PersonState::traits; ++i) {
      profile["person_mean"].push_back(belief.mean(i));
      for (int j = 0; j <= i; ++j) profile["person_covariance"].push_back(belief.covariance(i, j));
    }
  }
  return profile.dump(2) + '\n';
}

namespace {

constexpr const char* points = " with points pt 7 ps 0.5 lc rgb '#b35806' ";
constexpr const char* crosses = " with points pt 2 ps 1.1 lw 2 lc rgb '#d7191c' ";

// The data of the picture: slides by their verdict, and the band of the curve.
std::string data_blocks(const Calibration& calibration) {
  std::string script;
  const auto block = [&](const char* name, SlideVerdict verdict) {
    script += std::string("$") + name + " << EOD\n";
    for (const CalibratedSlide& slide : calibration.slides)
      if (slide.verdict == verdict)
        script += number(slide.plate_deg) + ' ' + number(direction_deg(slide)) + ' ' + number(fitted_deg(slide)) + ' ' +
                  std::to_string(slide.trial + 1) + ' ' + number(slide.plate_deg - fitted_deg(slide)) + '\n';
    script += "EOD\n";
  };
  block("used", SlideVerdict::used);
  block("outlying", SlideVerdict::outlying);
  block("along", SlideVerdict::along_ridges);
  script += "$band << EOD\n";
  for (const CurvePoint& point : calibration.band)
    script += number(point.offset_deg) + ' ' + number(point.shift_deg.value) + ' ' + number(point.shift_deg.lower) +
              ' ' + number(point.shift_deg.upper) + '\n';
  return script + "EOD\n";
}

// The mean residual of each part, with its standard error.
std::string parts_block(const Calibration& calibration) {
  std::string script = "$parts << EOD\n";
  for (int part = 0; part < slide_parts; ++part) {
    double sum = 0.0;
    double squares = 0.0;
    double n = 0.0;
    for (const CalibratedSlide& slide : calibration.slides) {
      if (slide.verdict != SlideVerdict::used) continue;
      const double residual_deg = slide.parts_deg(part) - slide.fitted_deg(part);
      sum += residual_deg;
      squares += residual_deg * residual_deg;
      n += 1.0;
    }
    const double mean = sum / n;
    script += std::to_string(part + 1) + ' ' + number(mean) + ' ' +
              number(normal_975 * std::sqrt(std::max(squares / n - mean * mean, 0.0) / n)) + '\n';
  }
  return script + "EOD\n";
}

// The curve of the illusion, and the slides' directions.
std::string curve_and_directions(const Calibration& calibration) {
  const auto all = estimated_traits(calibration);
  const char* const rings = " with points pt 6 ps 0.8 lc rgb '#999999' ";
  return "set grid back lt 1 lw 0.6 lc rgb '#dddddd'\nset offsets graph 0.03, graph 0.03, graph 0.05, "
         "graph 0.05\nset lmargin 10\nset rmargin 3\nset multiplot\n"
         "set origin 0,0.66\nset size 1,0.34\nset title \"Illusion\\nw_T = " +
         fixed(all[0].interval.value, 3) + " (" + interval_text(all[0]) + "), largest gap " +
         fixed(all[3].interval.value, 1) + "° (" + interval_text(all[3]) +
         ")\" font ',12'\nset key top left\nset xrange "
         "[-80:80]\nset xtics 15\n"
         "set xlabel 'ridge normal less motion, °'\nset ylabel 'felt shift, °'\n"
         "plot $band using 1:3:4 with filledcurves fc rgb '#c6dbef' title '95 %', $band using 1:2 with lines "
         "lw 2 lc rgb '#08306b' title 'curve'\n"
         "set key top right\nset origin 0,0.33\nset size 1,0.33\nset title \"Directions of " +
         std::to_string(calibration.slides.size()) + " slides\\n" +
         with_minus_signs("bias " + fixed(all[1].interval.value, 2) + "° (" + interval_text(all[1]) + "), habit " +
                          fixed(all[2].interval.value, 2) + "° (" + interval_text(all[2]) + ")") +
         "\" font ',12'\nset xlabel 'plate orientation (normal of the ridges) less goal, °'\n"
         "set ylabel 'direction less goal, °'\nset xrange [-92:92]\n"
         "plot $used using 1:3 with points pt 9 ps 0.8 lc rgb '#08306b' title 'fit', $used using 1:2" +
         points + "title 'slide', $outlying using 1:2" + crosses + "title 'outlier', $along using 1:2" + rings +
         "title 'along ridges'\nunset key\n";
}

// Panels of the residuals over the plate's angle, over the order of slides and along the path.
std::string residual_panels(const LackOfFit& lack) {
  const std::string line = "0 with lines lw 1.5 lc rgb '#08306b' notitle, ";
  const auto residuals = [&](const char* x) {
    return "plot " + line + "$used using " + x + ":($2-$3)" + points + "notitle, $outlying using " + x + ":($2-$3)" +
           crosses + "notitle\n";
  };
  const auto said = [](double p) { return std::string("p = ") + fixed(p, 3) + (p < min_fit_p ? ": a pattern" : ""); };
  return "set lmargin 9\nset rmargin 1\nset origin 0,0\nset size 0.38,0.33\nset title \"Residuals over the "
         "angle\\n" +
         said(lack.angle_p) + "\" font ',11'\nset xtics 60\nset xlabel 'plate, °'\nset ylabel 'slide less fit, °'\n" +
         residuals("1") +
         "set xrange [0:*]\nset xtics 20\nset origin 0.38,0\nset size 0.33,0.33\nset title \"over the "
         "order\\n" +
         said(lack.order_p) + "\" font ',11'\nset xlabel 'trial'\nunset ylabel\n" + residuals("4") +
         "set xrange [0.5:4.5]\nset xtics 1\nset origin 0.71,0\nset size 0.29,0.33\nset title \"along the "
         "path\\n" +
         said(lack.path_p) + "\" font ',11'\nset xlabel 'part of the path'\nplot " + line +
         "$parts using 1:2:3 with yerrorbars pt 7 lw 1.5 lc rgb '#b35806' notitle\nunset multiplot\n";
}

}  // namespace

Figure calibration_figure(const CalibrationReport& report) {
  const Calibration& calibration = report.calibration;
  return {.name = "calibration",
          .title = "Directions over plates at rest",
          .caption = "",
          .width_px = 640,
          .height_px = 1000,
          .script = data_blocks(calibration) + parts_block(calibration) + curve_and_directions(calibration) +
                    residual_panels(calibration.lack_of_fit)};
}

}  // namespace hrt::study
