#include "plugin/src/api/write.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "core/math/distributions.h"
#include "generated/fields.h"

namespace hrt::plugin {
namespace {

static_assert(static_cast<std::uint32_t>(Instruction::finish) == HRT_STEP_FINISH &&
              static_cast<std::uint32_t>(Instruction::slide) == HRT_STEP_SLIDE &&
              static_cast<std::uint32_t>(SetupProblem::undetermined) == HRT_PROBLEM_UNDETERMINED &&
              static_cast<std::uint32_t>(SetupProblem::left_plate) == HRT_PROBLEM_LEFT_PLATE &&
              static_cast<std::uint32_t>(Observed::Kind::no_rest) == HRT_OBSERVED_NO_REST &&
              static_cast<std::uint32_t>(Observed::Kind::far_away) == HRT_OBSERVED_FAR);
static_assert(static_cast<std::uint32_t>(SlideVerdict::along_ridges) == HRT_SLIDE_ALONG_RIDGES);

// A flag HRT_COMMAND_*, and the members of commands and of summaries that set it; null: the flag is not set there.
struct OutcomeFlag {
  std::uint32_t bit;
  bool PlateCommand::* of_command;
  bool ReachSummary::* of_summary;
};
constexpr OutcomeFlag outcome_flags[] = {
    {HRT_COMMAND_HELD, &PlateCommand::held, nullptr},
    {HRT_COMMAND_PREDICTED, &PlateCommand::predicted, nullptr},
    {HRT_COMMAND_UNREACHABLE, &PlateCommand::unreachable, &ReachSummary::unreachable},
    {HRT_COMMAND_LIFTED, &PlateCommand::lifted, nullptr},
    {HRT_COMMAND_OFF_PLATE, &PlateCommand::off_plate, nullptr},
    {HRT_COMMAND_MISFIT, &PlateCommand::misfit, &ReachSummary::misfit},
    {HRT_COMMAND_OFF_TARGET, &PlateCommand::off_target, &ReachSummary::off_target},
    {HRT_COMMAND_RESTING, &PlateCommand::resting, nullptr},
    {HRT_COMMAND_REGISTRATION, &PlateCommand::registration_doubtful, &ReachSummary::registration_doubtful},
    {HRT_COMMAND_ARRIVED, &PlateCommand::arrived, nullptr},
    {HRT_COMMAND_CONTACTS, &PlateCommand::contacts_disagree, &ReachSummary::contacts_disagree},
    {HRT_COMMAND_NOT_AT_START, &PlateCommand::not_at_start, &ReachSummary::not_at_start},
    {HRT_COMMAND_MISS_UNKNOWN, &PlateCommand::miss_unknown, &ReachSummary::miss_unknown},
    {HRT_COMMAND_IMPLAUSIBLE, &PlateCommand::implausible, &ReachSummary::implausible},
    {HRT_COMMAND_FAULT, &PlateCommand::fault, nullptr},
};
constexpr std::uint32_t bound_flags[] = {0, HRT_COMMAND_SATURATED, HRT_COMMAND_SATURATED, HRT_COMMAND_RATE_LIMITED,
                                         HRT_COMMAND_RATE_LIMITED};
static_assert(static_cast<int>(ActiveBound::none) == 0 && static_cast<int>(ActiveBound::lower) == 1 &&
              static_cast<int>(ActiveBound::upper) == 2 && static_cast<int>(ActiveBound::rate_down) == 3 &&
              static_cast<int>(ActiveBound::rate_up) == 4);

// Adds the flags of `outcome` to those of `out`. Replaces infinite numbers and NaN by 0, which is a fault.
template <class Outcome, class Struct>
void add_flags(const Outcome& outcome, bool Outcome::* OutcomeFlag::* member, Struct* out) {
  for (const OutcomeFlag& flag : outcome_flags)
    if (flag.*member && outcome.*(flag.*member)) out->flags |= flag.bit;
  for_each_field<Struct>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.of(*out)), double&>) {
      if (std::isfinite(field.of(*out))) return;
      field.of(*out) = 0.0;
      out->flags |= HRT_COMMAND_FAULT;
    }
  });
}

hrt_interval to_c(const Interval& interval) {
  return {interval.value, interval.lower, interval.upper, interval.known ? 1u : 0u, 0};
}

std::uint32_t flag_if(bool is, std::uint32_t flag) { return is ? flag : 0; }

}  // namespace

void write(const Vec3& from, double (&to)[3]) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}

hrt_target_config to_c(const Target& target) {
  hrt_target_config config{};
  config.struct_size = sizeof config;
  config.role = static_cast<std::uint32_t>(target.role);
  config.place = static_cast<std::uint32_t>(target.place.kind);
  config.direction_deg = target.place.direction_deg;
  config.distance_m = target.place.distance_m;
  write(target.place.position_m, config.position_m);
  std::memcpy(config.name, target.name.data(), sizeof config.name);
  config.radius_m = target.place.radius_m;
  config.served_by = {target.served_by};
  return config;
}

hrt_command to_c(const PlateCommand& command) {
  hrt_command out{
      .struct_size = sizeof out,
      .flags = bound_flags[static_cast<int>(command.active)] | flag_if(!command.optimal, HRT_COMMAND_APPROXIMATE),
      .plate_orientation_deg = command.plate_orientation_deg,
      .bearing_deg = command.bearing_deg,
      .perceived_direction_deg = command.perceived_direction_deg,
      .felt_error_deg = command.felt_error_deg,
      .predicted_miss_deg = command.predicted_miss_deg,
      .miss_sd_deg = command.bearing_error_sd_deg,
      .distance_to_go_m = command.distance_to_go_mm / mm_per_m,
      .time_to_go_s = command.time_to_go_s,
      .tactile_weight = command.tactile_weight,
      .tactile_weight_sd = command.tactile_weight_sd,
      .misfit = command.nis,
      .paper = {.step = -1, .finger_direction_deg = 0.0, .aimed_direction_deg = 0.0},
  };
  if (!command.for_people)
    out.paper = {.step = command.step,
                 .finger_direction_deg = command.finger_direction_deg,
                 .aimed_direction_deg = command.aimed_direction_deg};
  add_flags(command, &OutcomeFlag::of_command, &out);
  out.flags |= flag_if((out.flags & HRT_COMMAND_FAULT) != 0, HRT_COMMAND_HELD);
  return out;
}

hrt_reach_summary to_c(const ReachSummary& summary) {
  const FingerEstimate& estimate = summary.estimate;
  const PersonEstimate person = summary.person.value_or(PersonEstimate{});
  hrt_reach_summary out{
      .struct_size = sizeof out,
      .flags = 0,
      .bearing_deg = summary.bearing_deg,
      .miss_deg = summary.bearing_error_deg,
      .miss_sd_deg = summary.bearing_error_sd_deg,
      .distance_to_target_m = summary.distance_to_target_mm / mm_per_m,
      .peak_felt_error_deg = summary.peak_felt_error_deg,
      .rms_felt_error_deg = summary.rms_felt_error_deg,
      .misfit = summary.nis,
      .duration_s = person.duration_s,
      .counts = {.samples = summary.samples,
                 .dropped_samples = summary.dropped_samples,
                 .steps = summary.steps,
                 .saturated_steps = summary.saturated_steps},
      .learnt = {.tactile_weight = estimate.tactile_weight,
                 .tactile_weight_sd = estimate.tactile_weight_sd,
                 .illusion_curve = person.curve,
                 .illusion_curve_sd = person.curve_sd,
                 .bias_deg = person.bias_deg,
                 .bias_sd_deg = person.bias_sd_deg,
                 .tracker_noise_m = estimate.tracker_noise_mm / mm_per_m},
      .paper = {},
  };
  if (!summary.person)
    out.paper = {.final_direction_deg = summary.final_direction_deg,
                 .miss_deg = summary.final_miss_deg,
                 .perceived_direction_deg = summary.perceived_direction_deg,
                 .perceived_error_deg = summary.perceived_error_deg,
                 .motor_variance_deg2 = estimate.motor_variance_deg2,
                 .motor_variance_sd_deg2 = estimate.motor_variance_sd_deg2,
                 .predicted_steps = summary.predicted_steps,
                 .rate_limited_steps = summary.rate_limited_steps};
  add_flags(summary, &OutcomeFlag::of_summary, &out);
  return out;
}

hrt_setup_step to_c(const SetupStep& step) {
  hrt_setup_step out{
      .struct_size = sizeof out,
      .instruction = static_cast<std::uint32_t>(step.instruction),
      .part = step.part,
      .problem = static_cast<std::uint32_t>(step.problem),
      .done = static_cast<std::uint32_t>(step.done),
      .of = static_cast<std::uint32_t>(step.of),
      .number = static_cast<std::uint32_t>(step.number),
      .observed = static_cast<std::uint32_t>(step.observed.kind),
      .place_m = {step.place_mm.x() / mm_per_m, step.place_mm.y() / mm_per_m, step.place_mm.z() / mm_per_m},
      .plate_orientation_deg = step.plate_orientation_deg,
      .text = {}};
  write_step_text(step, out.text);
  return out;
}

hrt_setup_result to_c(const SetupReport& report) {
  hrt_setup_result out{};
  out.struct_size = sizeof out;
  out.done = report.done;
  out.left = report.left;
  out.differing = flag_if(report.differing.tactile_weight, HRT_RETEST_TACTILE_WEIGHT) |
                  flag_if(report.differing.bias, HRT_RETEST_BIAS) | flag_if(report.differing.habit, HRT_RETEST_HABIT);
  out.slides = static_cast<std::uint32_t>(report.slides);
  out.dropped = report.dropped;
  if (report.dropped != 0) write_drop_text(report, out.reason);
  if (report.registration) {
    constexpr double deg_per_radian = 57.29577951308232;
    const Registration& registration = *report.registration;
    out.registration_residual_m = registration.residual_mm / mm_per_m;
    out.registration_turn_sd_deg = deg_per_radian * std::sqrt(std::max(0.0, registration.covariance(1, 1)));
  }
  if (report.check) out.check_distance_m = report.check->distance_mm / mm_per_m;
  if (report.fingertip) out.fingertip_sd_m = report.fingertip->sd_mm.maxCoeff() / mm_per_m;
  if (report.calibration) {
    const Calibration& calibration = *report.calibration;
    const LackOfFit& lack = calibration.lack_of_fit;
    out.slides_used = static_cast<std::uint32_t>(calibration.count(SlideVerdict::used));
    out.lack_of_fit = flag_if(lack.angle_p < min_fit_p, HRT_LACK_OF_FIT_ANGLE) |
                      flag_if(lack.order_p < min_fit_p, HRT_LACK_OF_FIT_ORDER) |
                      flag_if(lack.path_p < min_fit_p, HRT_LACK_OF_FIT_PATH);
    out.tactile_weight = to_c(calibration.tactile_weight);
    out.bias_deg = to_c(calibration.bias_deg);
    out.max_gap_deg = to_c(calibration.max_gap_deg);
  }
  return out;
}

hrt_setup_residual to_c(const CalibratedSlide& slide) {
  const double seen_deg = settled_direction_deg(slide.parts_deg);
  const double fitted_deg = settled_direction_deg(slide.fitted_deg);
  return {.struct_size = sizeof(hrt_setup_residual),
          .verdict = static_cast<std::uint32_t>(slide.verdict),
          .plate_deg = slide.plate_deg,
          .direction_deg = seen_deg,
          .fitted_deg = fitted_deg,
          .residual_deg = seen_deg - fitted_deg};
}

hrt_gap to_c(const Gap& gap, hrt_target real_target, hrt_target virtual_target) {
  const double sd_deg = gap.bearing_sd_deg;
  return {
      .struct_size = sizeof(hrt_gap),
      .reachable = gap.feasibility.reachable ? 1u : 0u,
      .real_target = real_target,
      .virtual_target = virtual_target,
      .gap_deg = gap.feasibility.gap_deg,
      .max_gap_deg = gap.feasibility.max_gap_deg,
      .margin_deg = gap.feasibility.margin_deg,
      .plate_orientation_deg = gap.feasibility.plate_orientation_deg,
      .settling_direction_deg = gap.feasibility.settling_direction_deg,
      .paper_max_gap_deg = gap.paper_max_gap_deg,
      .bearing_sd_deg = sd_deg,
      .miss_share = sd_deg > 0.0 ? 2.0 * normal_cdf(-near_deg / sd_deg) : 0.0,
  };
}

void write_point(const PlatePoint& point, double (&out_m)[3]) {
  write({point.right_mm / mm_per_m, 0.0, -point.away_mm / mm_per_m}, out_m);
}

}  // namespace hrt::plugin
