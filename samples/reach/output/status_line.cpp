#include "samples/reach/output/status_line.h"

#include <unistd.h>

#include <cstdio>

#include "samples/format.h"
#include "samples/reach/base/say.h"
#include "samples/text.h"

namespace hrt::reach {
namespace {

constexpr auto refresh_period = std::chrono::milliseconds(50);

}  // namespace

StatusLine::StatusLine(bool verbose) : verbose_(verbose), on_terminal_(isatty(STDERR_FILENO) == 1) {}

void StatusLine::show(const TargetPair& pair, const Moment& moment) {
  if (verbose_) {
    std::fprintf(
        stderr, "%.9f s  %s  tip %+8.2f right %+8.2f away mm  moves %+7.2f  feels %+7.2f  plate %+7.2f deg%s%s\n",
        static_cast<double>(moment.time) * 1e-9, pair.virtual_name.c_str(), moment.position_m[0] * 1e3,
        -moment.position_m[2] * 1e3, moment.finger_direction_deg, moment.felt_direction_deg,
        moment.plate_orientation_deg, moment.tracked ? "" : "  not tracked", moment.saturated ? "  at its bound" : "");
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (!on_terminal_ || now - last_ < refresh_period) return;
  last_ = now;
  shown_ = true;
  const std::string text = format(": %5.1f mm to go, moves %+6.1f, feels %+6.1f, plate %+6.1f deg%s",
                                  moment.distance_to_go_m * 1e3, moment.finger_direction_deg, moment.felt_direction_deg,
                                  moment.plate_orientation_deg, moment.tracked ? "" : "  (finger not tracked)");
  // A longer line would wrap, and clear() clears one line only.
  std::fprintf(stderr, "\r\033[K%s", cut_to(cut_to(pair.virtual_name, 24) + text, columns() - 1).c_str());
}

void StatusLine::clear() {
  if (shown_) say("\r\033[K");
  shown_ = false;
}

}  // namespace hrt::reach
