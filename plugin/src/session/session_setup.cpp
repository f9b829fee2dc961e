#include "plugin/src/session/session_setup.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "core/person/traits.h"
#include "core/plate/plate_limits.h"
#include "core/setup/setup_fit.h"
#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/session/contact.h"
#include "plugin/src/session/finger_sample.h"
#include "plugin/src/session/found_config.h"
#include "plugin/src/session/session_config.h"

namespace hrt::plugin {
namespace {

constexpr std::uint32_t all_parts = 63;
constexpr std::uint32_t slide_parts_asked = HRT_SETUP_CALIBRATION | HRT_SETUP_RETEST;
constexpr double min_range_deg = 40.0;
constexpr double max_slide_mm = 100.0;
constexpr double min_slide_room_mm = 50.0;
constexpr double rim_margin_mm = 10.0;

static_assert(setup_fingertip == HRT_SETUP_FINGERTIP && setup_registration == HRT_SETUP_REGISTRATION &&
              setup_check == HRT_SETUP_CHECK && setup_guides == HRT_SETUP_GUIDES &&
              setup_calibration == HRT_SETUP_CALIBRATION && setup_retest == HRT_SETUP_RETEST);
static_assert(static_cast<std::uint32_t>(Instruction::finish) == HRT_STEP_FINISH &&
              static_cast<std::uint32_t>(Instruction::slide) == HRT_STEP_SLIDE &&
              static_cast<std::uint32_t>(SetupProblem::undetermined) == HRT_PROBLEM_UNDETERMINED &&
              static_cast<std::uint32_t>(SetupProblem::left_plate) == HRT_PROBLEM_LEFT_PLATE);
static_assert(static_cast<std::uint32_t>(SlideVerdict::along_ridges) == HRT_SLIDE_ALONG_RIDGES);
static_assert(SetupConfig::max_marks == HRT_MARKS_MAX && 3 * HRT_MARKS_MAX == HRT_MARK_NUMBERS &&
              MarkTouches::max_touches >= 5 * HRT_MARKS_MAX);

std::uint32_t missing(const hrt_session_config& session) {
  return (is_not_zero(session.fingertip_offset_m) ? 0 : HRT_SETUP_FINGERTIP) |
         ((session.flags & HRT_SESSION_REGISTERED) != 0 ? 0 : HRT_SETUP_REGISTRATION) |
         (knows_person(session) ? 0 : HRT_SETUP_CALIBRATION);
}

// Straight ahead, on the plate.
double room_ahead_mm(const hrt_session_config& session) {
  const PlatePoint start = start_of(session);
  const double radius_mm = mm_per_m * session.plate.radius_m;
  const double square_mm2 = radius_mm * radius_mm - start.right_mm * start.right_mm;
  return std::sqrt(std::max(0.0, square_mm2)) - start.away_mm - rim_margin_mm;
}

// The start, and places on the rim a third of a right angle from the line across: none opposite the start.
void set_marks(const hrt_session_config& session, const hrt_setup_config& given, SetupConfig* config) {
  const double(&start_m)[3] = session.start_position_m;
  const double r = session.plate.radius_m;
  const double x = r * std::sqrt(0.75);
  const double usual_m[][3] = {{start_m[0], start_m[1], start_m[2]},
                               {0.0, 0.0, r},
                               {x, 0.0, 0.5 * r},
                               {x, 0.0, -0.5 * r},
                               {-x, 0.0, -0.5 * r},
                               {-x, 0.0, 0.5 * r}};
  config->mark_count = static_cast<int>(given.mark_count == 0 ? std::size(usual_m) : given.mark_count);
  for (int i = 0; i < config->mark_count; ++i) {
    const double* mark_m = given.mark_count == 0 ? usual_m[i] : given.marks_m + std::ptrdiff_t{3} * i;
    config->marks_mm[static_cast<std::size_t>(i)] = mm_per_m * Eigen::Vector3d(mark_m[0], mark_m[1], mark_m[2]);
  }
  config->check_mark = std::min(static_cast<int>(given.check_mark), config->mark_count - 1);
}

// From the start to each real target's nearer side, in the order in which they were added. Fails if one cannot be
// slid along.
hrt_result find_guides(const hrt_session_config& session, const Targets& targets, SetupConfig* config) {
  config->start = start_of(session);
  config->guide_count = 0;
  for (const auto& [id, target] : targets.all()) {
    if (target.role != HRT_TARGET_REAL) continue;
    const TargetView at = view(session, target);
    const double length_mm = at.distance_mm - mm_per_m * target.radius_m;
    if (length_mm < GuidedSlides::min_guide_mm)
      return fail(HRT_ERROR_OUT_OF_RANGE, "real target \"", target.name, "\" is ", length_mm / mm_per_m,
                  " m from start_position_m; allowed for a guide: at least ", GuidedSlides::min_guide_mm / mm_per_m);
    if (config->guide_count == GuidedSlides::max_objects) break;
    config->guides[static_cast<std::size_t>(config->guide_count++)] =
        point_ahead(config->start, at.direction_deg, length_mm);
  }
  if (config->guide_count > 0) return HRT_OK;
  return fail(HRT_ERROR_WRONG_STATE, "the session has no real target, to which a guide would lead");
}

SetupConfig to_setup(const hrt_session_config& session, const Targets& targets, std::uint32_t what,
                     const hrt_setup_config& given, double plate_orientation_deg) {
  SetupConfig config;
  config.only_possible = what == HRT_SETUP_ALL_MISSING;
  config.parts = config.only_possible ? missing(session) : what;
  set_marks(session, given, &config);
  config.touches_per_mark = static_cast<int>(given.touches_per_mark);
  config.registration = {.touch_sd_mm = mm_per_m * given.touch_sd_m,
                         .fit_scale = given.fit_scale != 0,
                         .up = {given.up[0], given.up[1], given.up[2]}};
  if ((what & HRT_SETUP_GUIDES) != 0) static_cast<void>(find_guides(session, targets, &config));  // checked before
  config.start = start_of(session);
  config.slide_distance_mm = std::min(max_slide_mm, room_ahead_mm(session));
  if (config.only_possible && config.slide_distance_mm < min_slide_room_mm)
    config.parts &= ~std::uint32_t{HRT_SETUP_CALIBRATION};
  config.lower_plate_deg = given.lower_plate_deg;
  config.upper_plate_deg = given.upper_plate_deg;
  config.enough_weight_width = given.enough_weight_width;
  config.max_slides = static_cast<int>(given.max_slides);
  config.plate_orientation_deg = plate_orientation_deg;
  return config;
}

hrt_interval as_found(const Interval& interval) {
  return {interval.value, interval.lower, interval.upper, interval.known ? 1u : 0u, 0};
}

void describe(const Calibration& calibration, hrt_setup_result* result) {
  result->slides_used = static_cast<std::uint32_t>(calibration.count(SlideVerdict::used));
  const LackOfFit& lack = calibration.lack_of_fit;
  result->lack_of_fit = (lack.angle_p < min_fit_p ? HRT_LACK_OF_FIT_ANGLE : 0) |
                        (lack.order_p < min_fit_p ? HRT_LACK_OF_FIT_ORDER : 0) |
                        (lack.path_p < min_fit_p ? HRT_LACK_OF_FIT_PATH : 0);
  result->tactile_weight = as_found(calibration.tactile_weight);
  result->bias_deg = as_found(calibration.bias_deg);
  result->max_gap_deg = as_found(calibration.max_gap_deg);
}

// Allocates nothing if `*residuals` has room.
void write_residuals(const Calibration& calibration, std::vector<hrt_setup_residual>* residuals) {
  for (const CalibratedSlide& slide : calibration.slides) {
    const double seen_deg = settled_direction_deg(slide.parts_deg);
    const double fitted_deg = settled_direction_deg(slide.fitted_deg);
    residuals->push_back({.struct_size = sizeof(hrt_setup_residual),
                          .verdict = static_cast<std::uint32_t>(slide.verdict),
                          .plate_deg = slide.plate_deg,
                          .direction_deg = seen_deg,
                          .fitted_deg = fitted_deg,
                          .residual_deg = seen_deg - fitted_deg});
  }
}

// What had been learnt as the person's bias moves to the frame, as far as the frame turns.
void take_guides(const TouchedFrame& found, const SetupConfig& config, hrt_session_config* session) {
  double turned = 0.0;
  for (int i = 0; i < config.guide_count; ++i)
    turned += turned_deg(touched_of(*session), found, config.guides[static_cast<std::size_t>(i)]) / config.guide_count;
  const Trait& bias = person_traits[PersonTrait::bias];
  double& believed_deg = session->person.mean[HRT_PERSON_BIAS];
  if (knows_person(*session)) believed_deg = std::clamp(believed_deg + turned, bias.min, bias.max);
  write_touched(found, session);
  session->flags |= HRT_SESSION_START_FELT;
}

// What the fit found, described and written into the configuration. False if it is nothing to be applied.
bool take(const SetupFit& fit, const SetupConfig& config, hrt_session_config* session, hrt_setup_result* result) {
  if (fit.fingertip) {
    for (int i = 0; i < 3; ++i) session->fingertip_offset_m[i] = fit.fingertip->offset_mm(i) / mm_per_m;
    result->fingertip_sd_m = fit.fingertip->sd_mm.maxCoeff() / mm_per_m;
  } else if (fit.registration) {
    write_registration(*fit.registration, fit.touched_ns, session);
    result->registration_residual_m = fit.registration->residual_mm / mm_per_m;
    constexpr double deg_per_radian = 57.29577951308232;
    result->registration_turn_sd_deg = deg_per_radian * std::sqrt(std::max(0.0, fit.registration->covariance(1, 1)));
  } else if (fit.check) {
    result->check_distance_m = fit.check->distance_mm / mm_per_m;
    if (fit.check->holds) {
      session->registration.time_ns = fit.touched_ns;
    } else {
      session->flags &= ~HRT_SESSION_REGISTERED;
      forget_contacts(session);
    }
    return fit.check->holds;
  } else if (fit.guided) {
    take_guides(*fit.guided, config, session);
  } else if (fit.calibration) {
    describe(*fit.calibration, result);
    if (fit.part == setup_retest) result->differing = differing_from(*session, *fit.calibration);
    write_calibration(*fit.calibration, session);
    return fit.calibration->tactile_weight.known;
  } else {
    return false;
  }
  return true;
}

}  // namespace

hrt_result check_setup_config(const hrt_setup_config& config) {
  HRT_RETURN_IF_FAILED(check_fields(config));
  if (config.upper_plate_deg - config.lower_plate_deg < min_range_deg)
    return fail(HRT_ERROR_OUT_OF_RANGE, "upper_plate_deg is ", config.upper_plate_deg,
                "; allowed: at least 40 above lower_plate_deg, ", config.lower_plate_deg);
  if (config.mark_count > 0 && config.check_mark >= config.mark_count)
    return fail(HRT_ERROR_OUT_OF_RANGE, "check_mark is ", config.check_mark, "; allowed: less than mark_count, ",
                config.mark_count);
  return HRT_OK;
}

hrt_result SessionSetup::check(const hrt_session_config& session, const Targets& targets, std::uint32_t what) {
  constexpr std::uint32_t either[] = {slide_parts_asked, HRT_SETUP_REGISTRATION | HRT_SETUP_CHECK,
                                      HRT_SETUP_REGISTRATION | HRT_SETUP_GUIDES};
  const bool both =
      std::any_of(std::begin(either), std::end(either), [&](std::uint32_t parts) { return (what & parts) == parts; });
  if (what != HRT_SETUP_ALL_MISSING && (what == 0 || (what & ~all_parts) != 0 || both))
    return fail(HRT_ERROR_OUT_OF_RANGE, "what is ", what,
                "; allowed: bits of HRT_SETUP_*, without CALIBRATION and RETEST, or REGISTRATION and CHECK or "
                "GUIDES, together, or ALL_MISSING");
  if ((what & (HRT_SETUP_CHECK | HRT_SETUP_GUIDES)) != 0 && (session.flags & HRT_SESSION_REGISTERED) == 0)
    return fail(HRT_ERROR_WRONG_STATE, "the plate is not registered, so there is nothing to check or to refine");
  if ((what & HRT_SETUP_GUIDES) != 0) {
    SetupConfig guides;
    HRT_RETURN_IF_FAILED(find_guides(session, targets, &guides));
  }
  if ((what & slide_parts_asked) != 0 && room_ahead_mm(session) < min_slide_room_mm)
    return fail(HRT_ERROR_OUT_OF_RANGE, "start_position_m leaves ", room_ahead_mm(session) / mm_per_m,
                " m for a slide straight ahead; allowed: at least ", min_slide_room_mm / mm_per_m);
  return HRT_OK;
}

SessionSetup::SessionSetup(const hrt_session_config& session, const Targets& targets, std::uint32_t what,
                           const hrt_setup_config& checked_config, double plate_orientation_deg)
    : touch_sd_mm_(mm_per_m * checked_config.touch_sd_m),
      setup_(to_setup(session, targets, what, checked_config, plate_orientation_deg)),
      plate_orientation_deg_(plate_orientation_deg) {
  result_.struct_size = sizeof result_;
}

SetupSample SessionSetup::seen(const hrt_session_config& session, const hrt_sample& sample) const {
  hrt_session_config config = session;
  if (setup_.part() == setup_guides) forget_contacts(&config);
  if (setup_.part() == setup_fingertip) std::memset(config.fingertip_offset_m, 0, sizeof config.fingertip_offset_m);
  std::uint32_t flags = 0;
  SetupSample seen{.time_ns = sample.time_ns,
                   .tracked_mm = {},
                   .in_plate = (sample.flags & HRT_SAMPLE_PLATE_POSITION) != 0,
                   .joint_rotation = {},
                   .on_plate = observe(config, sample, &flags)};
  seen.off_plate = (flags & HRT_COMMAND_OFF_PLATE) != 0;
  if ((sample.flags & finger_flags) != 0 && (sample.flags & HRT_SAMPLE_LIFTED) == 0) {
    const Vec3 at_m = skin_m(config, sample);
    seen.tracked_mm = mm_per_m * Eigen::Vector3d(at_m.x, at_m.y, at_m.z);
  }
  if (sample.flags & HRT_SAMPLE_JOINT_ROTATION) {
    const double(&q)[4] = sample.joint_rotation;
    seen.joint_rotation = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
  }
  return seen;
}

hrt_result SessionSetup::check_shown(const hrt_sample& sample, const SetupSample& seen) const {
  if (sample.flags & HRT_SAMPLE_DIRECTION)
    return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", sample.flags,
                "; allowed: PLATE_POSITION or WORLD_POSITION, or none");
  if (setup_.config().only_possible || setup_.left() == 0 || !seen.tracked_mm || setup_.can_show(seen)) return HRT_OK;
  const char* needed = setup_.part() == setup_fingertip ? "WORLD_POSITION with JOINT_ROTATION" : "WORLD_POSITION";
  return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", sample.flags, "; allowed in this part of the set-up: ", needed);
}

hrt_setup_step SessionSetup::to_c(const SetupStep& step, const hrt_session_config& session) {
  const PlateStops stops = to_core(session).plate.stops;
  plate_orientation_deg_ = nearest_equivalent_deg(step.plate_orientation_deg, plate_orientation_deg_, stops);
  hrt_setup_step out{.struct_size = sizeof(hrt_setup_step),
                     .instruction = static_cast<std::uint32_t>(step.instruction),
                     .part = step.part,
                     .problem = static_cast<std::uint32_t>(step.problem),
                     .done = static_cast<std::uint32_t>(step.done),
                     .of = static_cast<std::uint32_t>(step.of),
                     .number = static_cast<std::uint32_t>(step.number),
                     .reserved = 0,
                     .place_m = {step.place_mm.x() / mm_per_m, step.place_mm.y() / mm_per_m, step.place_mm.z() / mm_per_m},
                     .plate_orientation_deg = plate_orientation_deg_,
                     .text = {}};
  write_step_text(step, out.text);
  return out;
}

hrt_result SessionSetup::update(const hrt_session_config& session, const hrt_sample& sample, hrt_setup_step* out) {
  HRT_RETURN_IF_FAILED(check_sample(sample));
  if (sampled_ && sample.time_ns < last_time_ns_)
    return fail(HRT_ERROR_TIME_REVERSED, "time_ns is ", sample.time_ns, "; allowed: from the last sample's, ",
                last_time_ns_);
  const SetupSample shown = seen(session, sample);
  HRT_RETURN_IF_FAILED(check_shown(sample, shown));
  setup_.update(shown);
  sampled_ = true;
  last_time_ns_ = sample.time_ns;
  *out = to_c(setup_.step(), session);
  return HRT_OK;
}

hrt_result SessionSetup::finish(hrt_session_config* session, std::vector<hrt_setup_residual>* residuals,
                                hrt_setup_result* out) {
  const SetupStep step = setup_.step();
  if (!setup_.finish_is_due())
    return fail(HRT_ERROR_WRONG_STATE, step.done, " of ", step.of,
                " are done; allowed once a step says HRT_STEP_FINISH");
  if (setup_.left() != 0) {
    std::vector<hrt_setup_residual> slides;  // memory is taken before anything changes
    if (setup_.part() & slide_parts_asked) slides.reserve(static_cast<std::size_t>(setup_.config().max_slides));
    const SetupFit fit = finish_part(&setup_, registration_of(*session, touch_sd_mm_));
    if (fit.calibration) {
      write_residuals(*fit.calibration, &slides);
      residuals->swap(slides);
    }
    if (fit.slides > 0) result_.slides = static_cast<std::uint32_t>(fit.slides);
    hrt_session_config next = *session;
    const ThreadError before = thread_error;
    const bool found = take(fit, setup_.config(), &next, &result_);
    if (check_session_config(next) == HRT_OK) {
      *session = next;
      if (found) result_.done |= fit.part;
    } else {
      thread_error = before;  // people who cannot be: nothing was found
    }
  }
  result_.left = setup_.left();
  *out = result_;
  return HRT_OK;
}

}  // namespace hrt::plugin
