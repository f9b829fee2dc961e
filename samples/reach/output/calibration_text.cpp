#include "samples/reach/output/calibration_text.h"

#include "samples/format.h"

namespace hrt::reach {
namespace {

const char* illusion_text(std::uint32_t illusion) {
  constexpr const char* families[] = {
      "in proportion to the offset",        "in proportion, constant beyond some offset",
      "as the sine of twice the offset",    "levels off (hyperbolic tangent)",
      "nothing within some offset",         "unequal to the left and to the right",
      "levels off (the controller's curve)"};
  return illusion < std::size(families) ? families[illusion] : "no curve fits";
}

std::string line(const char* name, const hrt_interval& interval, const char* unit) {
  if (interval.known == 0) return format("%-34s not known\n", name);
  return format("%-34s %8.3f %-3s  95 %% within %.3f to %.3f\n", name, interval.value, unit, interval.lower,
                interval.upper);
}

std::string lack_of_fit_text(std::uint32_t lack_of_fit) {
  if (lack_of_fit == 0) return "The model fits the slides.\n";
  std::string text;
  if (lack_of_fit & HRT_LACK_OF_FIT_ANGLE)
    text +=
        "No curve fits over the plate's angles: check the plate's zero and the way that the user faces, and "
        "repeat.\n";
  if (lack_of_fit & HRT_LACK_OF_FIT_ORDER)
    text += "The slides change from first to last: let the user practise or rest, and repeat.\n";
  if (lack_of_fit & HRT_LACK_OF_FIT_PATH)
    text +=
        "The paths bend as neither a habit nor steering does: ask for slower, longer and even slides, and "
        "repeat.\n";
  return text;
}

}  // namespace

bool is_enough(const hrt_setup_result& result) {
  const hrt_interval& weight = result.tactile_weight;
  return weight.known != 0 && weight.upper - weight.lower <= hrt_setup_config_init().enough_weight_width;
}

std::string calibration_text(const hrt_setup_result& result, const hrt_session_config& config) {
  return format("%u slides, %u used\n", result.slides, result.slides_used) +
         format("%-34s %s\n", "illusion", illusion_text(result.illusion)) +
         line("share of touch (w_T) at 60 deg", result.tactile_weight, "") +
         line("largest gap that a plate can hold", result.max_gap_deg, "deg") +
         line("bias, left positive", result.bias_deg, "deg") +
         format("%-34s %8.0f deg at most\n", "the plate is turned from the motion", config.motion_bound_deg) +
         format("%-34s %8.3f mm\n", "tracker noise, white", 1e3 * config.tracker_noise_m) +
         format("%-34s %8.3f mm\n", "tracker noise, correlated", 1e3 * config.tracker_correlated_noise_m) +
         lack_of_fit_text(result.lack_of_fit) +
         (is_enough(result) ? "Enough: the share of touch is known as well as was asked.\n"
                            : "The share of touch is not known as well as was asked.\n");
}

}  // namespace hrt::reach
