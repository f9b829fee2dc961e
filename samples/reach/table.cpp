#include "samples/reach/table.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <string_view>

#include "samples/app/base/say.h"
#include "samples/app/text/format.h"
#include "samples/app/text/text.h"

namespace hrt::reach {
namespace {

constexpr std::size_t widest_name = 32;

// Avoids "-0.0" in a text with one decimal.
double without_minus_zero(double value) { return std::abs(value) < 0.05 ? 0.0 : value; }

std::string line(const char* name, const hrt_interval& interval, const char* unit) {
  if (interval.known == 0) return format("%-34s unknown\n", name);
  return format("%-34s %8.3f %-3s  95 %% interval %.3f to %.3f\n", name, interval.value, unit, interval.lower,
                interval.upper);
}

std::string lack_of_fit_text(std::uint32_t lack_of_fit) {
  if (lack_of_fit == 0) return "The model fits the slides.\n";
  std::string text;
  if (lack_of_fit & HRT_LACK_OF_FIT_ANGLE)
    text +=
        "No illusion curve fits the slides: check orientation 0 of the plate and that the user faces straight ahead, "
        "then calibrate again.\n";
  if (lack_of_fit & HRT_LACK_OF_FIT_ORDER)
    text += "The slides changed from the first to the last: let the user practise or rest, then calibrate again.\n";
  if (lack_of_fit & HRT_LACK_OF_FIT_PATH)
    text +=
        "The shape of the paths does not fit the model: ask for slower, longer and steady slides, then calibrate "
        "again.\n";
  return text;
}

constexpr auto refresh_period = std::chrono::milliseconds(50);

}  // namespace

StatusLine::StatusLine(bool verbose) : verbose_(verbose), on_terminal_(isatty(STDERR_FILENO) == 1) {}

void StatusLine::show(const TargetPair& pair, const Moment& moment) {
  if (verbose_) {
    std::fprintf(
        stderr, "%.9f s  %s  tip %+8.2f mm right %+8.2f mm away  bearing %+7.2f  feels %+7.2f  plate %+7.2f deg%s%s\n",
        static_cast<double>(moment.time) * 1e-9, pair.virtual_name.c_str(), moment.position_m[0] * 1e3,
        -moment.position_m[2] * 1e3, moment.bearing_deg, moment.felt_direction_deg, moment.plate_orientation_deg,
        moment.tracked ? "" : "  not tracked", moment.saturated ? "  plate at a limit" : "");
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (!on_terminal_ || now - last_ < refresh_period) return;
  last_ = now;
  shown_ = true;
  const std::string text = format(": %5.1f mm to go, bearing %+6.1f, feels %+6.1f, plate %+6.1f deg%s",
                                  moment.distance_to_go_m * 1e3, moment.bearing_deg, moment.felt_direction_deg,
                                  moment.plate_orientation_deg, moment.tracked ? "" : "  (finger not tracked)");
  // A longer line would wrap, and clear() clears one line only.
  std::fprintf(stderr, "\r\033[K%s", cut_to(cut_to(pair.virtual_name, 24) + text, columns() - 1).c_str());
}

void StatusLine::clear() {
  if (shown_) say("\r\033[K");
  shown_ = false;
}

bool is_within_tolerance(const ReachResult& result) { return std::abs(result.miss_deg) <= tolerance_deg; }

bool is_reached(const TargetPair& pair, const ReachResult& result) {
  if (pair.real_radius_m > 0.0) return result.miss_m <= pair.real_radius_m;
  return is_within_tolerance(result);
}

Table::Table(const std::vector<TargetPair>& pairs)
    : virtual_width_(std::string_view("virtual").size()), real_width_(virtual_width_) {
  for (const TargetPair& pair : pairs) {
    virtual_width_ = std::min(widest_name, std::max(virtual_width_, length_of(pair.virtual_name)));
    real_width_ = std::min(widest_name, std::max(real_width_, length_of(pair.real_name)));
  }
}

void Table::print_header(std::ostream& out) const {
  out << left("virtual", virtual_width_) << format(" %6s  ", "deg") << left("real", real_width_)
      << format(" %6s  %9s %8s %8s %7s  %5s %7s %7s %7s %5s %6s\n", "deg", "final deg", "peak deg", "miss deg",
                "miss mm", "touch", "assumed", "max gap", "frames", "lost", "bound");
}

std::string Table::names(const TargetPair& pair) const {
  return left(cut_to(pair.virtual_name, virtual_width_), virtual_width_) +
         format(" %+6.1f  ", without_minus_zero(pair.virtual_direction_deg)) +
         left(cut_to(pair.real_name, real_width_), real_width_) +
         format(" %+6.1f  ", without_minus_zero(pair.real_direction_deg));
}

void Table::print_row(std::ostream& out, const TargetPair& pair, const std::string& what) const {
  out << names(pair) << what << std::endl;
}

void Table::print_row(std::ostream& out, const TargetPair& pair, const ReachResult& result) const {
  out << names(pair)
      << format("%+9.2f %8s %+8.2f %7.1f  %5s %7.3f %7s %7d %5d %5.0f%%  %s", result.final_direction_deg,
                result.peak_felt_error_deg > 0.0 ? format("%.1f", result.peak_felt_error_deg).c_str() : "-",
                result.miss_deg, result.miss_m * 1e3,
                result.is_truth ? format("%.3f", result.tactile_weight).c_str() : "-",
                result.summary.learnt.tactile_weight,
                result.is_truth ? format("%.1f", result.max_gap_deg).c_str() : "-", result.frames, result.dropouts,
                result.saturated_share * 100.0, is_reached(pair, result) ? "reached" : "missed");
  if (result.changed_hands) out << " (hands changed)";
  if (!result.is_feasible) out << " (flag: gap infeasible)";
  if (result.summary.flags & HRT_COMMAND_OFF_TARGET) out << " (flag: off target)";
  if (result.summary.flags & HRT_COMMAND_MISFIT) out << " (flag: model does not fit)";
  if (result.summary.flags & HRT_COMMAND_IMPLAUSIBLE) out << " (flag: check units, axes and clock)";
  out << std::endl;
}

void Table::print_legend(std::ostream& out) const {
  out << R"(final: bearing of the end of the reach, seen from the start; --controller paper: last direction of motion
peak: largest difference between perceived and virtual direction while the finger moves
miss: bearing of the end minus that of the real target; distance of the end from the real target along the plate
touch: tactile weight w_T of the user; assumed: estimate of the controller
max gap: largest feasible gap of this user; lost: frames without a tracked finger
bound: percentage of controller steps with the plate at a limit
reached: the reach ended inside the radius of the real target; without a radius, within 1.5 deg of its bearing
flag: warning of the controller; gap infeasible: the plate cannot sustain this gap for this user
)";
}

void Tally::add(const TargetPair& pair, const ReachResult& result) {
  ++reaches;
  if (!result.is_feasible) return;
  ++feasible;
  feasible_reached += is_reached(pair, result) ? 1 : 0;
  feasible_within_tolerance += is_within_tolerance(result) ? 1 : 0;
}

void print_summary(std::ostream& out, const Tally& tally) {
  out << format("%d of %d reaches with a feasible gap ended at the target, %d of %d within %.1f degrees of it",
                tally.feasible_reached, tally.feasible, tally.feasible_within_tolerance, tally.feasible, tolerance_deg);
  if (tally.feasible < tally.reaches) out << format("; %d more had an infeasible gap", tally.reaches - tally.feasible);
  if (tally.unfinished > 0) out << format("; %d more did not begin or end in time", tally.unfinished);
  if (tally.skipped > 0) out << format("; %d skipped", tally.skipped);
  out << ".\n";
}

bool is_enough(const hrt_setup_result& result) {
  const hrt_interval& weight = result.tactile_weight;
  return weight.known != 0 && weight.upper - weight.lower <= hrt_setup_config_init().enough_weight_width;
}

std::string calibration_text(const hrt_setup_result& result, const hrt_session_config& config) {
  return format("%u slides, of which %u were used\n", result.slides, result.slides_used) +
         line("tactile weight, 60 deg off normal", result.tactile_weight, "") +
         line("largest feasible gap", result.max_gap_deg, "deg") + line("bias, left positive", result.bias_deg, "deg") +
         format("%-34s %8.0f deg\n", "limit, ridge normal to motion", config.person.motion_bound_deg) +
         format("%-34s %8.3f mm\n", "tracker noise, white", 1e3 * config.tracker.noise_m) +
         format("%-34s %8.3f mm\n", "tracker noise, correlated", 1e3 * config.tracker.correlated_noise_m);
}

std::string verdict_text(const hrt_setup_result& result) {
  return lack_of_fit_text(result.lack_of_fit) +
         (is_enough(result) ? "The tactile weight is known with the required precision.\n"
                            : "The tactile weight is not known with the required precision.\n");
}

}  // namespace hrt::reach
