#include "core/setup/guided_slides.h"

#include <algorithm>
#include <cmath>

#include "core/math/time.h"

namespace hrt {
namespace {

constexpr double guide_rest_s = 1.4;
constexpr double guide_stop_s = 2.0;
constexpr double max_unseen_s = 0.5;
constexpr double max_raised_s = 0.1;
// Largest distance of a rest from the end of its guide, as a fraction of the guide's length and in mm: the smaller one
// applies.
constexpr double near_share = 0.3;
constexpr double max_near_mm = 30.0;
// Largest distance of a measured vector from the mean of the three vectors to its object.
constexpr double max_deviation_mm = 4.8;
// Prior SD of a coordinate of a measured vector, and the number of observations that the prior counts as.
constexpr double expected_sd_mm = 1.0;
constexpr double expected_count = 6.0;
// SD of the errors that all slides to an object share: position of the finger at the guide's end, and tracker.
constexpr double hold_sd_mm = 0.8;
// Prior SD, in this fit, of the entries of the matrix that corrects the tracker's frame.
constexpr double stretch_sd = 0.05;

}  // namespace

GuidedSlides::GuidedSlides(const PlatePoint& start, const std::array<PlatePoint, max_objects>& ends, int count)
    : start_(start), ends_(ends), count_(count) {}

void GuidedSlides::restart() {
  object_ = failed_ = 0;
  again(SetupProblem::none);
}

void GuidedSlides::again(SetupProblem problem) {
  problem_ = problem;
  if (problem != SetupProblem::none) ++failed_;
  rests_ = 0;
  finger_.lift();
}

const PlatePoint& GuidedSlides::next() const {
  return rests_ % 2 == 0 || complete() ? start_ : ends_[static_cast<std::size_t>(object_)];
}

void GuidedSlides::observe(const SetupSample& sample) {
  if (complete()) return;
  const Observation observation = sample.on_plate.observation;
  if (observation != Observation::position || sample.off_plate) {
    const bool lost = observation == Observation::none;
    if (elapsed_s(seen_ns_, sample.time_ns) <= (lost ? max_unseen_s : max_raised_s)) return;
    // A finger that leaves before the first rest is not a failed attempt.
    if (rests_ > 0) again(lost ? SetupProblem::lost : SetupProblem::left_plate);
    finger_.lift();
    return;
  }
  seen_ns_ = sample.time_ns;
  finger_.observe(sample.time_ns, sample.on_plate.position);
  if (finger_.rest_s() >= guide_rest_s) come_to_rest(finger_.rest_place(), finger_.rest_s() >= guide_stop_s);
}

void GuidedSlides::come_to_rest(const PlatePoint& place, bool long_since) {
  const PlatePoint& end = ends_[static_cast<std::size_t>(object_)];
  const double near_mm = std::min(max_near_mm, near_share * distance_mm(start_, end));
  const PlatePoint& last = rests_ % 2 == 0 ? end : start_;
  if (distance_mm(place, next()) > near_mm) {
    const bool stays = distance_mm(place, last) <= near_mm;
    if (rests_ > 0 && !stays && long_since) again(SetupProblem::stopped);
    return;
  }
  problem_ = SetupProblem::none;
  seen_[static_cast<std::size_t>(object_)][static_cast<std::size_t>(rests_++)] = place;
  if (rests_ < rests_an_object) return;
  rests_ = failed_ = 0;
  ++object_;
}

std::optional<GuidedSlides::MeasuredObject> GuidedSlides::measured(const Rests& rests) const {
  constexpr int count = slides_an_object / 2;
  Eigen::Matrix<double, 2, count> to_mm;
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(2 * i);
    to_mm.col(i) =
        Eigen::Vector2d(rests[at + 1].right_mm, rests[at + 1].away_mm) -
        0.5 * Eigen::Vector2d(rests[at].right_mm + rests[at + 2].right_mm, rests[at].away_mm + rests[at + 2].away_mm);
  }
  const Eigen::Vector2d mean_mm = to_mm.rowwise().mean();
  to_mm.colwise() -= mean_mm;
  if (to_mm.colwise().norm().maxCoeff() > max_deviation_mm) return std::nullopt;
  return MeasuredObject{mean_mm, to_mm.squaredNorm()};
}

std::optional<TouchedFrame> GuidedSlides::fit() const {
  constexpr int means = slides_an_object / 2;
  std::array<Eigen::Vector2d, max_objects> from_start_mm;
  double square_mm2 = expected_count * expected_sd_mm * expected_sd_mm;
  double freedom = expected_count;
  for (int i = 0; i < count_; ++i) {
    const std::optional<MeasuredObject> object = measured(seen_[static_cast<std::size_t>(i)]);
    if (!object) return std::nullopt;
    from_start_mm[static_cast<std::size_t>(i)] = object->from_start_mm;
    square_mm2 += object->square_mm2;
    freedom += 2.0 * (means - 1);
  }
  const double variance_mm2 = square_mm2 / freedom / means + hold_sd_mm * hold_sd_mm;
  TouchedFrame frame{.home = start_};
  frame.covariance.diagonal().setConstant(stretch_sd * stretch_sd);
  for (int i = 0; i < count_; ++i) {
    const Eigen::Vector2d& r = from_start_mm[static_cast<std::size_t>(i)];
    const Contact contact{.finger = corrected(frame, {start_.right_mm + r.x(), start_.away_mm + r.y()}),
                          .place = ends_[static_cast<std::size_t>(i)],
                          .variance_mm2 = variance_mm2};
    if (is_elsewhere(frame, contact)) return std::nullopt;
    frame = after_contact(frame, FrameCovariance::Zero(), contact);
  }
  return frame;
}

}  // namespace hrt
