#include "core/person/person_reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/exponential.h"
#include "core/math/time.h"
#include "core/math/trigonometry.h"

namespace hrt {
namespace {

constexpr double max_ns = 9e18;  // of an std::int64_t
// Beyond this share of the time nothing that the plate does is answered any more.
constexpr double last_phase = 0.97;
// Before this share of the time a prediction of the miss says little.
constexpr double first_judged_phase = 0.5;
// The gap counts as out of reach once the margin is below 0.3 degrees less 0.9 of its standard deviations:
// few who can hold it are then said not to (hrt-study robustness counts both).
constexpr double min_margin_deg = 0.3;
constexpr double margin_deviations = 0.9;
constexpr double given_duration_log_sd = 0.12;
// Below this share of the time a reach teaches nothing.
constexpr double min_taught_phase = 0.7;

PersonBelief person_of(const PersonReachConfig& config, const Reach& reach) {
  PersonBelief belief = config.person;
  if (reach.duration_s <= 0.0) return belief;
  know(belief, PersonTrait::log_rate, -logarithm(reach.duration_s), given_duration_log_sd);
  return belief;
}

double deviation(double variance) { return std::sqrt(std::max(0.0, variance)); }

// A plate that turns freely takes the short way round; between stops it keeps to one half turn.
PlateLimits limits_of(const PersonReachConfig& config, const Reach& reach, double stands_deg) {
  const PlateStops& stops = config.plate.stops;
  const double goal_deg = reach.virtual_direction_deg;
  if (std::isinf(stops.lower_deg) && std::isinf(stops.upper_deg)) return {stops, goal_deg};
  const Illusion illusion{config.person.mean(PersonTrait::weight), config.person.mean(PersonTrait::curve)};
  const double holding_deg = reach.real_direction_deg + offset_for_shift(illusion, goal_deg - reach.real_direction_deg,
                                                                         max_shift(illusion, config.control.bound_deg));
  return {stops, goal_deg, config.control.bound_deg, holding_deg, stands_deg};
}

}  // namespace

PersonReach::PersonReach(const PersonReachConfig& config, const Reach& reach,
                         const std::optional<PlateHandover>& handover)
    : config_(config),
      reach_(reach),
      target_(point_ahead(reach.start, reach.real_direction_deg, reach.real_distance_mm)),
      aimed_direction_deg_(reach.real_direction_deg),
      frame_sd_deg_(bearing_sd_deg(config.touched, config.frame, reach.start, target_)),
      estimator_(person_of(config, reach), reach.virtual_direction_deg, reach.real_distance_mm, reach.start,
                 config.noise),
      plate_(handover ? handover->plate
                      : PlateModel(config.plate, clamped(reach.plate_orientation_deg, config.plate.stops))),
      limits_(limits_of(config, reach, plate_.orientation_deg())) {
  decision_.plate.orientation_deg = handover ? handover->commanded_deg : plate_.orientation_deg();
  if (handover) {
    counts_.samples = handover->samples;
    counts_.dropped_samples = handover->dropped_samples;
  }
  stand_ready();
  command_ = publish({}, 0.0, false);
}

// Where the first moment of the motion wants the plate.
void PersonReach::stand_ready() {
  if (config_.plate_waits) return;
  const double ready_deg = ready_orientation_deg(config_.control, estimator_.filter(), aim());
  decision_.plate = limits_.limit({ready_deg + limits_.centre_deg() - reach_.virtual_direction_deg, ActiveBound::none},
                                  plate_.orientation_deg());
  plate_.command(decision_.plate.orientation_deg);
  turned_ready_ = true;
}

void PersonReach::retarget(const PlatePoint& real, const Reach& now) {
  const double longer_mm = (now.real_distance_mm - distance_mm(now.start, target_));
  limits_.turn_goal(now.virtual_direction_deg - reach_.virtual_direction_deg);
  reach_.virtual_direction_deg = now.virtual_direction_deg;
  settled_ = command_.arrived = false;
  // The short way round.
  reach_.real_direction_deg =
      now.real_direction_deg + wrap_deg(bearing_deg(reach_.start, real) - now.real_direction_deg, 360.0);
  reach_.real_distance_mm = distance_mm(reach_.start, real);
  target_ = real;
  frame_sd_deg_ = bearing_sd_deg(config_.touched, config_.frame, reach_.start, target_);
  aimed_from_ = now.start;
  aimed_direction_deg_ = now.real_direction_deg;
  miss_share_ = cos_deg(now.real_direction_deg - reach_.real_direction_deg);
  estimator_.retarget(seen_s_, now.virtual_direction_deg, longer_mm);
  if (estimator_.motion() == FingerMotion::resting) {
    aimed_from_.reset();
    stand_ready();
  }
}

// A finger that feels the start is there when it rests, wherever it is seen.
PlatePoint PersonReach::on_plate(const PlatePoint& seen) const {
  if (!config_.start_is_felt) return seen;
  return seen - estimator_.origin() + reach_.start;
}

std::optional<PlatePoint> PersonReach::place() const {
  if (estimator_.motion() == FingerMotion::resting) return std::nullopt;
  return on_plate(estimator_.place());
}

double PersonReach::place_variance_mm2() const {
  const PersonFilter& filter = estimator_.filter();
  return 0.5 * (filter.place_variance_mm2(1.0, 0.0) + filter.place_variance_mm2(0.0, 1.0));
}

double PersonReach::speed_mm_s() const {
  if (estimator_.motion() != FingerMotion::moving) return 0.0;
  return estimator_.filter().now().speed_mm_s;
}

const PlateCommand& PersonReach::update(const FingerSample& sample, bool arrived) {
  ++counts_.samples;
  if (!origin_ns_) origin_ns_ = sample.time_ns;
  plate_.advance(sample.time_ns);
  if (sample.plate_orientation_deg) plate_.report(*sample.plate_orientation_deg);
  const double now_s = elapsed_s(*origin_ns_, sample.time_ns);
  seen_s_ = now_s;
  trace_.add(now_s, plate_.orientation_deg());

  const bool observed = observe(sample, now_s - 1e-9 * static_cast<double>(config_.tracker_latency_ns));
  settled_ = settled_ && sample.observation == Observation::position && estimator_.merged();
  const bool decides = observed && estimator_.motion() == FingerMotion::moving && estimator_.caught_up() &&
                       estimator_.filter().state().phase < last_phase;
  if (decides) {
    decision_ = decide(now_s);
    plate_.command(decision_.plate.orientation_deg);
  }
  const bool turned_ready = std::exchange(turned_ready_, false);
  command_ = publish(sample, now_s, decides || turned_ready);
  command_.arrived = arrived;
  settled_ = true;
  count(command_, observed);
  return command_;
}

bool PersonReach::observe(const FingerSample& sample, double time_s) {
  switch (sample.observation) {
    case Observation::lifted:
      estimator_.lift(time_s, trace_);
      return false;
    case Observation::position:
      if (position_ns_ != sample.time_ns) {  // else the tracker has sent it twice
        position_ns_ = sample.time_ns;
        if (estimator_.observe(time_s, sample.position, trace_)) return true;
      }
      break;
    case Observation::none:
    case Observation::direction:
      estimator_.predict(time_s, trace_);
      break;
  }
  ++counts_.dropped_samples;
  return false;
}

PersonReach::Decision PersonReach::decide(double now_s) {
  const double latency_s = 1e-9 * static_cast<double>(config_.plate.latency_ns);
  const double later_deg = plate_.orientation_at_deg(later_ns(*position_ns_, config_.plate.latency_ns));
  const std::optional<PersonFilter> retargeted = estimator_.after_retarget();
  const ReachPlan plan = plan_reach(config_.control, retargeted ? *retargeted : estimator_.filter(),
                                    estimator_.time_s(), aim(), {trace_, now_s, latency_s, later_deg});
  const ActiveBound bound = !plan.at_bound               ? ActiveBound::none
                            : plan.plate_deg < later_deg ? ActiveBound::lower
                                                         : ActiveBound::upper;
  return {.plate = limits_.limit({plan.plate_deg + limits_.centre_deg() - reach_.virtual_direction_deg, bound},
                                 plate_.orientation_deg()),
          .predicted_miss_deg = atan2_deg(miss_share_ * plan.miss_mm, reach_.real_distance_mm)};
}

ReachAim PersonReach::aim() const {
  const PlatePoint origin = on_plate(estimator_.origin());
  return {.target = target_ - origin, .from = aimed_from_ ? *aimed_from_ - origin : PlatePoint{}};
}

// By the filter, which may stand at an earlier time.
double PersonReach::time_to_go_s(double now_s) const {
  const std::optional<PersonFilter> retargeted = estimator_.after_retarget();
  const PersonFilter& filter = retargeted ? *retargeted : estimator_.filter();
  const double left_s = (1.0 - filter.state().phase) / filter.rate();
  return std::max(0.0, left_s - (now_s - estimator_.time_s()));
}

// The largest gap less the one that is to be held, to first order in w, b, d and the frame's error.
bool PersonReach::can_be_held() const {
  const PersonFilter& filter = estimator_.filter();
  const Illusion illusion = filter.mean_illusion();
  const MaxShift max = max_shift(illusion, config_.control.bound_deg);
  const double gap_deg = reach_.virtual_direction_deg + filter.state().bias_deg - aimed_direction_deg_;
  const double variance =
      frame_sd_deg_ * frame_sd_deg_ + filter.shift_variance_deg2(max.felt, gap_deg > 0.0 ? -1.0 : 1.0);
  return max.felt.shift_deg - std::abs(gap_deg) > min_margin_deg - margin_deviations * deviation(variance);
}

// Of the finger across the line to the target: as the filter knows its place, and as the frame is known.
double PersonReach::bearing_error_sd_deg() const {
  if (estimator_.motion() == FingerMotion::resting) return frame_sd_deg_;
  const SinCos ahead = sin_cos_deg(reach_.real_direction_deg);
  const double variance_mm2 = estimator_.filter().place_variance_mm2(-ahead.cosine, -ahead.sine);
  const double place_sd_deg = atan2_deg(deviation(variance_mm2), reach_.real_distance_mm);
  return std::sqrt(frame_sd_deg_ * frame_sd_deg_ + place_sd_deg * place_sd_deg);
}

PlateCommand PersonReach::publish(const FingerSample& sample, double now_s, bool decided) {
  const PersonNow now = estimator_.filter().now();
  const PersonState& x = now.mean;
  const PlatePoint place = on_plate(estimator_.place());
  const bool begun = estimator_.motion() != FingerMotion::resting;
  const bool moving = estimator_.motion() == FingerMotion::moving;
  const double to_go_mm = begun || counts_.samples > 0 ? distance_mm(place, target_) : reach_.real_distance_mm;
  const double felt_deg =
      x.direction_deg + felt_shift(now.illusion, plate_.orientation_deg() - x.direction_deg).shift_deg;
  const bool ends = begun && (!moving || x.phase >= last_phase);
  const double miss_deg = ends ? wrap_deg(bearing_deg(reach_.start, place) - reach_.real_direction_deg, 360.0)
                               : decision_.predicted_miss_deg;
  const LinearIllusion linear = estimator_.filter().linear_illusion();
  return {
      .plate_orientation_deg = decision_.plate.orientation_deg,
      .finger_direction_deg = x.direction_deg,
      .perceived_direction_deg = felt_deg,
      .aimed_direction_deg = to_go_mm > 0.1 * reach_.real_distance_mm && !(settled_ && begun)
                                 ? bearing_deg(place, target_)
                                 : command_.aimed_direction_deg,
      .tactile_weight = linear.weight,
      .tactile_weight_sd = linear.weight_sd,
      .distance_to_go_mm = to_go_mm,
      .time_to_go_s = begun && x.phase >= last_phase ? 0.0
                      : moving                       ? time_to_go_s(now_s)
                                                     : -1.0,
      .felt_error_deg = begun ? felt_deg - now.goal_deg : 0.0,
      .predicted_miss_deg = miss_deg,
      .bearing_error_sd_deg = settled_ ? command_.bearing_error_sd_deg : bearing_error_sd_deg(),
      .nis = estimator_.fit().nis,
      .step = begun ? static_cast<std::int64_t>(std::min(1e9 * (now_s - estimator_.onset_s()), max_ns)) /
                          config_.step_period_ns
                    : -1,
      .active = decision_.plate.active,
      .held = !decided,
      .predicted = begun && sample.observation == Observation::none,
      .unreachable = settled_ ? command_.unreachable : begun && !can_be_held(),
      .misfit = begun && !estimator_.fit().holds(),
      .off_target = begun && x.phase > first_judged_phase && std::abs(miss_deg) > near_deg,
      .resting = estimator_.motion() == FingerMotion::paused,
  };
}

void PersonReach::count(const PlateCommand& command, bool observed) {
  counts_.misfit = counts_.misfit || command.misfit;
  if (command.step < 0) return;
  counts_.nis = std::max(counts_.nis, command.nis);
  if (estimator_.motion() == FingerMotion::moving) {
    counts_.peak_felt_error_deg = std::max(counts_.peak_felt_error_deg, std::abs(command.felt_error_deg));
    square_felt_sum_deg2_ += command.felt_error_deg * command.felt_error_deg;
    ++felt_samples_;
  }
  if (!observed || command.step == counted_step_) return;
  counted_step_ = command.step;
  ++counts_.steps;
  counts_.saturated_steps += command.active != ActiveBound::none;
}

ReachSummary PersonReach::summary() const {
  ReachSummary summary = counts_;
  const PersonFilter& filter = estimator_.filter();
  const PersonState x = filter.state(), sd = filter.deviation();
  const PlatePoint ended = on_plate(estimator_.place());
  const bool begun = estimator_.motion() != FingerMotion::resting;
  summary.predicted_steps = command_.step + 1 - counts_.steps;
  summary.final_direction_deg = command_.finger_direction_deg;
  summary.final_miss_deg = command_.finger_direction_deg - reach_.real_direction_deg;
  summary.perceived_direction_deg = command_.perceived_direction_deg;
  summary.perceived_error_deg =
      command_.perceived_direction_deg - reach_.virtual_direction_deg - config_.person.mean(PersonTrait::bias);
  summary.distance_to_target_mm = distance_mm(ended, target_);
  summary.bearing_error_deg =
      begun ? wrap_deg(bearing_deg(reach_.start, ended) - reach_.real_direction_deg, 360.0) : 0.0;
  summary.bearing_error_sd_deg = command_.bearing_error_sd_deg;
  summary.rms_felt_error_deg =
      felt_samples_ > 0 ? std::sqrt(square_felt_sum_deg2_ / static_cast<double>(felt_samples_)) : 0.0;
  summary.unreachable = command_.unreachable;
  summary.off_target = begun && std::abs(summary.bearing_error_deg) > near_deg;
  summary.estimate = {.position = ended,
                      .speed_mm_s = 0.0,
                      .direction_deg = command_.finger_direction_deg,
                      .tactile_weight = command_.tactile_weight,
                      .tactile_weight_sd = command_.tactile_weight_sd,
                      .tracker_noise_mm = std::sqrt(estimator_.noise().variance_mm2())};
  summary.person = {.curve = x.curve,
                    .curve_sd = sd.curve,
                    .gain_s = x.gain_s,
                    .gain_sd_s = sd.gain_s,
                    .bias_deg = x.bias_deg,
                    .bias_sd_deg = sd.bias_deg,
                    .habit_deg = x.habit_deg,
                    .habit_sd_deg = sd.habit_deg,
                    .duration_s = exponential(-x.log_rate)};
  return summary;
}

PlateHandover PersonReach::handover() const {
  return {plate_, decision_.plate.orientation_deg, counts_.samples, counts_.dropped_samples};
}

std::optional<PersonBelief> PersonReach::learnt() const {
  const bool ended =
      estimator_.motion() != FingerMotion::resting && estimator_.filter().state().phase > min_taught_phase;
  if (!ended || counts_.misfit) return std::nullopt;
  return estimator_.filter().belief();
}

}  // namespace hrt
