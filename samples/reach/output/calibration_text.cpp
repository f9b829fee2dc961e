#include "samples/reach/output/calibration_text.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "samples/format.h"

namespace hrt::reach {
namespace {

constexpr double normal_975 = 1.959964;

std::string illusion_text(const hrt_calibration_result& result) {
  constexpr const char* families[] = {"in proportion to the offset",
                                      "in proportion, constant beyond %.0f deg",
                                      "as the sine of twice the offset",
                                      "levels off (hyperbolic tangent, scale %.0f deg)",
                                      "nothing within %.0f deg",
                                      "unequal to the left and to the right",
                                      "levels off (the controller's curve)"};
  if (result.illusion == HRT_ILLUSION_NONE) return "no curve fits";
  if (result.illusion >= std::size(families)) return format("family %u", result.illusion);
  return format(families[result.illusion], result.illusion_scale_deg);
}

void print_interval(std::ostream& out, const char* name, const hrt_interval& interval, double scale,
                    const char* unit) {
  if (interval.known != 0) {
    out << format("%-34s %8.3f %-3s  95 %% within %.3f to %.3f\n", name, scale * interval.value, unit,
                  scale * interval.lower, scale * interval.upper);
  } else {
    out << format("%-34s not known\n", name);
  }
}

// w t - b t (t / 75)^2 with the deviation that follows from those of w and b.
void print_curve(std::ostream& out, const hrt_calibration_result& result) {
  const hrt_interval& w = result.person_weight;
  const hrt_interval& b = result.person_curve;
  if (w.known == 0 || b.known == 0) {
    out << "curve of the illusion              not known\n";
    return;
  }
  const double w_sd = (w.upper - w.lower) / (2.0 * normal_975);
  const double b_sd = (b.upper - b.lower) / (2.0 * normal_975);
  out << "ridge normal less motion, deg     ";
  for (int offset_deg = 15; offset_deg <= 75; offset_deg += 15) out << format(" %11d", offset_deg);
  out << "\nfelt shift, deg                   ";
  for (int offset_deg = 15; offset_deg <= 75; offset_deg += 15) {
    const double t_deg = offset_deg;
    const double bend_deg = t_deg * (t_deg / 75.0) * (t_deg / 75.0);
    const double variance_deg2 = t_deg * t_deg * w_sd * w_sd + bend_deg * bend_deg * b_sd * b_sd -
                                 2.0 * result.weight_curve_correlation * t_deg * w_sd * bend_deg * b_sd;
    out << format(" %5.1f +-%4.1f", w.value * t_deg - b.value * bend_deg,
                  normal_975 * std::sqrt(std::max(0.0, variance_deg2)));
  }
  out << "\n";
}

void print_lack_of_fit(std::ostream& out, const hrt_calibration_result& result) {
  if (result.lack_of_fit == 0) out << "The model fits the slides.\n";
  if (result.lack_of_fit & HRT_LACK_OF_FIT_ANGLE)
    out << format(
        "No curve fits over the plate's angles (p = %.4f). Check the plate's zero and the way that the user "
        "faces, and repeat.\n",
        result.angle_p);
  if (result.lack_of_fit & HRT_LACK_OF_FIT_ORDER)
    out << format(
        "The slides change from first to last (p = %.4f). Let the user practise or rest, and repeat.\n",
        result.order_p);
  if (result.lack_of_fit & HRT_LACK_OF_FIT_PATH)
    out << format(
        "The paths bend as neither a habit nor steering does (p = %.4f). Ask for slower, longer and even "
        "slides, and repeat.\n",
        result.path_p);
}

void print_left_out(std::ostream& out, const CalibrationOutcome& outcome) {
  for (const hrt_calibration_slide& slide : outcome.slides) {
    if (slide.verdict == HRT_SLIDE_OUTLYING)
      out << format("left out: slide %u, plate at %.0f deg: unlike the others, %+.1f deg off the fit\n",
                    slide.trial + 1, slide.plate_deg, slide.residual_deg);
    if (slide.verdict == HRT_SLIDE_ALONG_RIDGES)
      out << format("left out: slide %u, plate at %.0f deg: the finger moved along the ridges\n",
                    slide.trial + 1, slide.plate_deg);
  }
}

}  // namespace

void print_calibration(std::ostream& out, const CalibrationOutcome& outcome) {
  const hrt_calibration_result& result = outcome.result;
  const std::uint32_t left_out = result.slides_outlying + result.slides_along_ridges;
  out << format("\n%u slides, %u used", result.trials,
                result.trials_used - std::min(left_out, result.trials_used));
  out << "\n";
  out << format("%-34s %s\n", "illusion", illusion_text(result).c_str());
  print_curve(out, result);
  print_interval(out, "share of touch (w_T) at 60 deg", result.tactile_weight, 1.0, "");
  print_interval(out, "largest gap that a plate can hold", result.max_gap_deg, 1.0, "deg");
  if (result.person_curve.known != 0)
    out << format("%-34s %8.0f deg from the motion; the plate is not turned farther\n", "illusion largest at",
                  result.peak_offset_deg);
  print_interval(out, "bias, left positive", result.bias_deg, 1.0, "deg");
  print_interval(out, "habit of curving", result.habit_deg, 1.0, "deg");
  print_interval(out, "tracker noise, white", result.tracker_noise_m, 1e3, "mm");
  print_interval(out, "tracker noise, correlated", result.correlated_noise_m, 1e3, "mm");
  print_interval(out, "its correlation time", result.noise_correlation_s, 1e3, "ms");
  print_left_out(out, outcome);
  print_lack_of_fit(out, result);
  out << (outcome.enough ? "Enough: the share of touch is known as well as was asked.\n"
                         : "The time ran out before the share of touch was known as well as was asked.\n");
}

std::string calibration_in_words(const CalibrationOutcome& outcome) {
  const hrt_calibration_result& result = outcome.result;
  std::string words = format("The calibration is complete after %u slides. ", result.trials);
  words += outcome.enough ? "It is as exact as was asked. "
                          : "The time ran out before it was as exact as was asked. ";
  if (result.tactile_weight.known != 0)
    words += format("The share of touch is %.0f percent, between %.0f and %.0f. ",
                    1e2 * result.tactile_weight.value, 1e2 * result.tactile_weight.lower,
                    1e2 * result.tactile_weight.upper);
  if (result.max_gap_deg.known != 0)
    words += format("The largest gap that a plate can hold is %.0f degrees. ", result.max_gap_deg.value);
  return words + (result.lack_of_fit == 0 ? "The model fits the slides."
                                          : "The model does not fit the slides: the printed text says why.");
}

}  // namespace hrt::reach
