// How far a calibration can be trusted: simulated people of many kinds are calibrated, and the intervals
// compared with the truth.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/simulation/people.h"
#include "samples/study/numbers/statistics.h"

namespace hrt::study {

/// A kind of people: a family of core/simulation/people.h, or that of `family` with something added to the
/// session.
struct CoverageKind {
  const char* name;
  const char* says;
  const char* family;
  double weight_trend = 0.0;    ///< w changes by this, to either side, from the first slide to the last
  double outlying_share = 0.0;  ///< of slides that go 15 to 40 degrees off
  void (*change)(PersonCondition& condition, Draws& draws) = nullptr;  ///< of the person, before the session
};
std::span<const CoverageKind> coverage_kinds();

/// Slides at the angles of a set-up (core/setup).
struct CoverageSession {
  int slides = 32;
  double duration_s = 2.0;
  std::uint64_t seed = 1;
};

enum Quantity { weight, bias, habit, max_gap, quantities };
inline constexpr const char* quantity_name[quantities] = {"weight", "bias", "habit", "max_gap"};

/// One person: truth and interval of each quantity.
struct CoveragePerson {
  bool refused = false;  ///< no calibration: there are no intervals
  std::array<double, quantities> truth{};
  std::array<Interval, quantities> found{};
  LackOfFit lack_of_fit;
};

/// The slides of person `index` of a kind, in order, and the truth about them.
std::vector<CalibrationTrial> coverage_slides(const CoverageKind& kind, const CoverageSession& session,
                                              std::uint32_t index, std::array<double, quantities>* truth);

CoveragePerson coverage_person(const CoverageKind& kind, const CoverageSession& session, std::uint32_t index);

/// One quantity of many people: how often its intervals hold the truth.
struct Tally {
  Share known;
  Share covered;       ///< of the known
  double error = 0.0;  ///< sum over the known
  double width = 0.0;  ///< sum over the known

  /// `error_of_value` counts if the value is known.
  void add(const Interval& found, double truth, double error_of_value);
  /// Means over the known; NaN without any.
  double mean_error() const { return error / static_cast<double>(known.hits); }
  double mean_width() const { return width / static_cast<double>(known.hits); }
  /// The percentage covered, in `columns` characters, and its 95 % interval in 9: " 98 (77-99) ".
  std::string covered_text(std::size_t columns) const;
};

/// Coverage for people of one kind.
struct Coverage {
  Share refused;
  Share angle, order, path;  ///< with lack of fit of each sort
  std::array<Tally, quantities> of;

  void add(const CoveragePerson& person);
};

}  // namespace hrt::study
