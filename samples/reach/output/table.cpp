#include "samples/reach/output/table.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <string_view>

#include "samples/reach/output/text.h"

namespace hrt::reach {
namespace {

constexpr std::size_t widest_name = 32;

// Directions are shown in tenths of a degree, in which -0.01 would be "-0.0".
double without_minus_zero(double value) {
  return std::abs(value) < 0.05 ? 0.0 : value;
}

}  // namespace

bool is_within_tolerance(const ReachResult& result) {
  return std::abs(result.miss_deg) <= tolerance_deg;
}

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
  out << padded_to("virtual", virtual_width_) << format(" %6s  ", "deg") << padded_to("real", real_width_)
      << format(" %6s  %9s %8s %8s %7s  %5s %7s %7s %5s %6s\n", "deg", "final deg", "felt deg", "miss deg",
                "miss mm", "touch", "assumed", "frames", "lost", "bound");
}

void Table::print_row(std::ostream& out, const TargetPair& pair, const ReachResult& result) const {
  out << padded_to(pair.virtual_name, virtual_width_)
      << format(" %+6.1f  ", without_minus_zero(pair.virtual_direction_deg))
      << padded_to(pair.real_name, real_width_)
      << format(" %+6.1f  %+9.2f %+8.2f %+8.2f %7.1f  %5s %7.3f %7d %5d %5.0f%%  %s",
                without_minus_zero(pair.real_direction_deg), result.final_direction_deg,
                result.felt_direction_deg, result.miss_deg, result.miss_m * 1e3,
                result.is_truth ? format("%.3f", result.tactile_weight).c_str() : "-", result.assumed_weight,
                result.frames, result.dropouts, result.saturated_share * 100.0,
                is_reached(pair, result) ? "reached" : "missed");
  if (!result.can_be_held)
    out << format(" (cannot be held: with this touch, gaps up to %.1f deg can)", result.largest_gap_deg);
  if (result.changed_hands) out << " (hands changed)";
  out << std::endl;
}

void Table::print_legend(std::ostream& out) const {
  out << "final: direction of the finger after the last step; felt: as the user feels it. miss: final minus "
         "the "
         "real\n"
         "target's direction, and the distance along the plate from the real target to the fingertip's end.\n"
         "touch: share of touch in what the user feels; assumed: the controller's estimate of touch at the "
         "end.\n"
         "lost: frames without a tracked finger. bound: steps with the plate at a limit. reached: ended "
         "inside "
         "the\n"
         "real target's radius.\n";
}

void Tally::add(const TargetPair& pair, const ReachResult& result) {
  ++reaches;
  if (!result.can_be_held) return;
  ++holdable;
  holdable_reached += is_reached(pair, result) ? 1 : 0;
  holdable_within_tolerance += is_within_tolerance(result) ? 1 : 0;
}

void print_summary(std::ostream& out, const Tally& tally) {
  out << format(
      "%d of %d targets that can be held were reached; in %d of %d reaches the last step was within %.1f deg",
      tally.holdable_reached, tally.holdable, tally.holdable_within_tolerance, tally.holdable, tolerance_deg);
  if (tally.holdable < tally.reaches)
    out << format("; %d more cannot be held", tally.reaches - tally.holdable);
  out << ".\n";
}

}  // namespace hrt::reach
