#include "plugin/src/session/session_setup.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/plate/plate_limits.h"
#include "plugin/src/abi/error.h"

namespace hrt::plugin {
namespace {

constexpr std::uint32_t all_parts =
    setup_fingertip | setup_registration | setup_check | setup_calibration | setup_retest | setup_guides;
constexpr std::uint32_t slide_parts = setup_calibration | setup_retest;
constexpr double max_slide_mm = 100.0;
constexpr double min_slide_room_mm = 50.0;
constexpr double rim_margin_mm = 10.0;

bool is_zero(const Vec3& v) { return v.x == 0.0 && v.y == 0.0 && v.z == 0.0; }

std::uint32_t missing(const SessionModel& model) {
  std::uint32_t parts = 0;
  if (is_zero(model.mount.fingertip_offset_m)) parts |= setup_fingertip;
  if (!model.registration.made) parts |= setup_registration;
  if (!model.knows_person) parts |= setup_calibration;
  return parts;
}

// Distance from the start, parallel to the mid-line, to rim_margin_mm before the rim.
double room_ahead_mm(const SessionModel& model) {
  const PlatePoint& start = start_of(model);
  const double radius_mm = mm_per_m * model.mount.surface.radius_m;
  const double half_chord_mm = std::sqrt(std::max(0.0, radius_mm * radius_mm - start.right_mm * start.right_mm));
  return half_chord_mm - rim_margin_mm - start.away_mm;
}

// Sets the default marks for touches: the start, and the corners of a hexagon on the rim except the farthest one.
void set_usual_marks(const SessionModel& model, SetupConfig* config) {
  using Mark = Eigen::Vector3d;
  const double r = mm_per_m * model.mount.surface.radius_m;
  const double x = r * std::sqrt(0.75);
  config->marks_mm = {mm_per_m * Mark(model.start_m.x, model.start_m.y, model.start_m.z),
                      Mark(0.0, 0.0, r),
                      Mark(x, 0.0, 0.5 * r),
                      Mark(x, 0.0, -0.5 * r),
                      Mark(-x, 0.0, -0.5 * r),
                      Mark(-x, 0.0, 0.5 * r)};
  config->mark_count = 6;
}

// Sets the guides, along which the finger slides from the start to the near sides of the first real targets. Fails if
// there is no real target, or if one is too near for a slide.
hrt_result find_guides(const SessionModel& model, const Targets& targets, SetupConfig* config) {
  const PlatePoint& start = start_of(model);
  for (const auto& [id, target] : targets.all()) {
    if (config->guide_count == GuidedSlides::max_objects) break;
    if (target.role != TargetRole::real) continue;
    const TargetView seen = view(model, target.place);
    const double length_mm = seen.distance_mm - mm_per_m * target.place.radius_m;
    if (length_mm < GuidedSlides::min_guide_mm) {
      const auto too_near = [&](const auto&... name_or_id) {
        return fail(HRT_ERROR_OUT_OF_RANGE, "the near side of real target ", name_or_id..., " is ",
                    length_mm / mm_per_m, " m from start_position_m; allowed for a guide: at least ",
                    GuidedSlides::min_guide_mm / mm_per_m, ". Move the target or the start");
      };
      const std::string_view name = target.name.data();
      return name.empty() ? too_near(id) : too_near("\"", name, "\"");
    }
    config->guides[static_cast<std::size_t>(config->guide_count++)] = point_ahead(start, seen.direction_deg, length_mm);
  }
  if (config->guide_count > 0) return HRT_OK;
  return fail(HRT_ERROR_WRONG_STATE, "the session has no real target for a guide; add one first");
}

SetupConfig completed(SetupConfig config, const SessionModel& model, const Targets& targets, std::uint32_t parts,
                      double plate_orientation_deg) {
  config.only_possible = parts == setup_all_missing;
  config.parts = config.only_possible ? missing(model) : parts;
  if (config.mark_count == 0) set_usual_marks(model, &config);
  config.check_mark = std::min(config.check_mark, config.mark_count - 1);
  if ((parts & setup_guides) != 0) static_cast<void>(find_guides(model, targets, &config));  // succeeded in check()
  config.start = start_of(model);
  config.slide_distance_mm = std::min(max_slide_mm, room_ahead_mm(model));
  if (config.only_possible && config.slide_distance_mm < min_slide_room_mm)
    config.parts &= ~std::uint32_t{setup_calibration};
  config.plate_orientation_deg = plate_orientation_deg;
  return config;
}

}  // namespace

hrt_result SessionSetup::check(const SessionModel& model, const Targets& targets, std::uint32_t parts,
                               const SetupConfig& asked) {
  constexpr std::uint32_t either[] = {slide_parts, setup_registration | setup_check, setup_registration | setup_guides};
  const bool both =
      std::any_of(std::begin(either), std::end(either), [&](std::uint32_t pair) { return (parts & pair) == pair; });
  if (parts != setup_all_missing && (parts == 0 || (parts & ~all_parts) != 0 || both))
    return fail(HRT_ERROR_OUT_OF_RANGE, "what is ", parts,
                "; allowed: ALL_MISSING alone, or other flags HRT_SETUP_*, but not CALIBRATION with RETEST, and not "
                "REGISTRATION with CHECK or GUIDES");
  if ((parts & (setup_check | setup_guides)) != 0 && !model.registration.made)
    return fail(HRT_ERROR_WRONG_STATE,
                "the plate is not registered; run HRT_SETUP_REGISTRATION before CHECK or GUIDES");
  if ((parts & setup_guides) != 0) {
    SetupConfig guides;
    HRT_RETURN_IF_FAILED(find_guides(model, targets, &guides));
  }
  std::vector<MarkTouch> marks;
  for (int i = 0; i < asked.mark_count; ++i)
    marks.push_back({asked.marks_mm[static_cast<std::size_t>(i)], asked.marks_mm[static_cast<std::size_t>(i)]});
  const bool registers = parts == setup_all_missing || (parts & setup_registration) != 0;
  if (registers && !marks.empty() && fit_registration({}, marks).verdict == RegistrationVerdict::degenerate)
    return fail(HRT_ERROR_OUT_OF_RANGE,
                "marks_m: the marks are less than 10 mm (root mean square) from one line; give marks that form a wide "
                "triangle");
  if ((parts & slide_parts) != 0 && room_ahead_mm(model) < min_slide_room_mm)
    return fail(HRT_ERROR_OUT_OF_RANGE, "start_position_m leaves ", room_ahead_mm(model) / mm_per_m,
                " m for a slide straight ahead; allowed: at least ", min_slide_room_mm / mm_per_m,
                ". Move the start towards the user, or use a larger plate");
  return HRT_OK;
}

SessionSetup::SessionSetup(const SessionModel& model, const Targets& targets, std::uint32_t parts,
                           const SetupConfig& asked, double plate_orientation_deg)
    : setup_(completed(asked, model, targets, parts, plate_orientation_deg)),
      plate_orientation_deg_(plate_orientation_deg) {}

hrt_result SessionSetup::check_shown(const SetupSample& sample) const {
  if (setup_.config().only_possible || is_over() || !sample.tracked_mm || setup_.can_show(sample)) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, "flags: this part of the set-up needs ",
              part() == setup_fingertip ? "WORLD_POSITION and JOINT_ROTATION; set both flags, and their fields"
                                        : "positions in the world; set WORLD_POSITION instead of PLATE_POSITION");
}

hrt_result SessionSetup::update(const SessionModel& model, const SetupSample& sample, SetupStep* out) {
  if (last_time_ns_ && sample.time_ns < *last_time_ns_)
    return fail(HRT_ERROR_TIME_REVERSED, "time_ns is ", sample.time_ns, ", earlier than ", *last_time_ns_,
                " of the last sample; times must not decrease");
  HRT_RETURN_IF_FAILED(check_shown(sample));
  if (!sample.tracked_mm || !repeated_.is_copy(sample.time_ns, *sample.tracked_mm)) setup_.update(sample);
  last_time_ns_ = sample.time_ns;
  *out = setup_.step();
  out->plate_orientation_deg = plate_orientation_deg_ =
      nearest_equivalent_deg(out->plate_orientation_deg, plate_orientation_deg_, model.control.plate.stops);
  return HRT_OK;
}

hrt_result SessionSetup::finish(SessionModel* model, SetupReport* report) {
  const SetupStep step = setup_.step();
  if (!setup_.finish_is_due())
    return fail(HRT_ERROR_WRONG_STATE, step.done, " of ", step.of,
                " touches or slides are done; call hrt_setup_finish() when a step has the instruction HRT_STEP_FINISH");
  if (!is_over()) {
    // While step() runs, fit_ is null: after an exception, the next call begins the fit again.
    std::unique_ptr<PartFit> fitting = std::move(fit_);
    if (!fitting)
      fitting = std::make_unique<PartFit>(setup_, registration_of(*model, setup_.config().registration.touch_sd_mm));
    if (!fitting->step()) {
      fit_ = std::move(fitting);
      report->left = setup_.left();
      return HRT_OK;
    }
    SetupFit& fit = fitting->result();
    if (fit.slides > 0) report->slides = fit.slides;
    if (fit.part == setup_retest && fit.calibration) report->differing = difference(*model, *fit.calibration);
    SessionModel next = *model;
    const bool is_known = apply(fit, setup_.config(), &next);
    const bool found = is_known && is_valid(next);
    if (is_known && !found) fit.reason = "the fitted parameters are outside the range of the model";
    if (is_valid(next)) *model = next;
    if (found) report->done |= fit.part;
    move_on(fit, found, &setup_);
    if (fit.fingertip) report->fingertip = fit.fingertip;
    if (fit.registration) report->registration = fit.registration;
    if (fit.check) report->check = fit.check;
    if (fit.calibration) report->calibration = std::move(fit.calibration);
  }
  report->left = setup_.left();
  report->dropped = setup_.dropped();
  if (report->dropped == 0) return HRT_OK;
  report->drop = setup_.last_drop();
  report->drop_reason = report->drop.reason;
  return HRT_OK;
}

}  // namespace hrt::plugin
