// Robustness to people, trackers and plates other than assumed: four controllers on the same simulated
// reaches, in the middle case and with one factor at a time changed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/simulation/tracked_trial.h"

namespace hrt::study {

enum class Controller {
  paper,           ///< assumes w_T = 0.15, a fixed direction and a plate that follows at once
  adaptive,        ///< learns w_T within the reach and knows its plate
  adaptive_sight,  ///< that, aimed along the line of sight: what the plugin does with tracked positions
  informed,  ///< as that, but knows the person's w_T, bias, variances and step period, and the tracker's
             ///< noise
};
inline constexpr std::array controllers{Controller::paper, Controller::adaptive, Controller::adaptive_sight,
                                        Controller::informed};

const char* controller_name(Controller controller);   ///< in CSV and JSON
const char* controller_title(Controller controller);  ///< in text

/// A simulated reach, and the deliberate errors of its controller.
struct Setting {
  TrackedCondition condition;  ///< its controller is filled in last
  /// Variances that are assumed, as multiples of the person's; 0: those assumed by default.
  double assumed_motor_scale = 0.0;
  double assumed_sensory_scale = 0.0;
};

/// One thing that is varied; all else is drawn or stands as in the middle case.
struct Factor {
  const char* name;   ///< in CSV and JSON, with its unit
  const char* title;  ///< in text
  std::vector<double> values;
  double middle;  ///< the middle case's value; NaN if people differ in it
  void (*set)(Setting& setting, double value);
  std::vector<const char*> labels{};  ///< of the values, where they are not numbers
};

/// The middle case first, as a factor with one value.
std::span<const Factor> robustness_factors();

/// Results of one controller in the trials of one value of one factor.
struct RobustnessCell {
  double direction_percent;    ///< of trials that end within 1.5 deg of the direction wanted
  double bearing_percent;      ///< of trials that end within 1.5 deg of the target's bearing
  double miss_median_mm;       ///< across the line to the target
  double miss_95_mm;           ///< 95 % of trials miss by no more
  double felt_error_deg;       ///< mean absolute difference of what is felt from the virtual direction
  double unreachable_percent;  ///< of trials in which the controller says so at the end
};

struct RobustnessRow {
  const Factor* factor;
  double value;
  /// People whose w_T can't hold the gap with the plate in its bound, and the median over these of how far
  /// the nearest direction that can be held misses (0 without any).
  double beyond_authority_percent;
  double least_miss_median_mm;
  std::array<RobustnessCell, controllers.size()> cells;  ///< in the order of `controllers`

  std::string label() const;
};

struct RobustnessOptions {
  std::uint64_t trials = 500;  ///< of each row, the same for each controller
  std::uint64_t seed = 1;
  std::uint64_t threads = 1;
};

/// Every value of `factors`. Trial i has the same person and the same random numbers in every row and with
/// every controller. The same for any number of threads. `progress` is called on this thread.
std::vector<RobustnessRow> simulate_robustness(
    std::span<const Factor> factors, const RobustnessOptions& options,
    const std::function<void(std::uint64_t done, std::uint64_t total)>& progress = {});

}  // namespace hrt::study
