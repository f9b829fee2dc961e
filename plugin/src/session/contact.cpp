#include "plugin/src/session/contact.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

#include "core/learning.h"
#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/session/session_config.h"
#include "plugin/src/session/targets.h"
#include "plugin/src/session/triangle.h"

namespace hrt::plugin {
namespace {

constexpr double unknown_radius_mm = 10.0;
// Nearer to the start a place shows the start rather than a turn.
constexpr double min_contact_mm = 10.0;
// Of a frame that is off: 25 mm at 100 mm.
constexpr double max_share = 0.25;
constexpr double max_deviations = 3.0;

template <std::size_t size>
bool are_same(const double (&one)[size], const double (&other)[size]) {
  return std::equal(std::begin(one), std::end(one), std::begin(other));
}

bool have_same_pose(const hrt_session_config& one, const hrt_session_config& other) {
  return are_same(one.plate.position_m, other.plate.position_m) && are_same(one.plate.rotation, other.plate.rotation) &&
         one.plate.scale == other.plate.scale;
}

hrt_target_config placed_at(const hrt_contact& contact) {
  hrt_target_config place = defaults<hrt_target_config>;
  place.place = (contact.flags & HRT_CONTACT_WORLD_POSITION) != 0 ? HRT_PLACE_WORLD_POSITION : HRT_PLACE_PLATE_POSITION;
  std::copy(std::begin(contact.position_m), std::end(contact.position_m), place.position_m);
  return place;
}

}  // namespace

bool knows_contacts(const hrt_session_config& config) {
  return (config.flags & HRT_SESSION_REGISTERED) != 0 && is_not_zero(config.registration.contact_covariance);
}

void forget_contacts(hrt_session_config* config) { write_touched({}, config); }

TouchedFrame touched_of(const hrt_session_config& config) {
  TouchedFrame frame{.home = start_of(config)};
  if (!knows_contacts(config)) return frame;
  const double(&d)[4] = config.registration.contact_correction;
  frame.stretch << d[0], d[1], d[2], d[3];
  frame.covariance = from_triangle<4>(config.registration.contact_covariance);
  return frame;
}

void write_touched(const TouchedFrame& frame, hrt_session_config* config) {
  for (int i = 0; i < 4; ++i) config->registration.contact_correction[i] = frame.stretch(i / 2, i % 2);
  write_triangle<4>(frame.covariance, config->registration.contact_covariance);
}

hrt_result check_contacts(const hrt_session_config& config) {
  hrt_session_config registered = config;
  registered.flags |= HRT_SESSION_REGISTERED;
  if (is_valid(touched_of(registered))) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE,
              "contact_covariance is not positive definite; allowed: the lower triangle, row by row, of a "
              "positive definite matrix, or all 0");
}

void forget_contacts_elsewhere(const hrt_session_config& before, hrt_session_config* next) {
  if (!have_same_pose(before, *next) &&
      are_same(before.registration.contact_correction, next->registration.contact_correction) &&
      are_same(before.registration.contact_covariance, next->registration.contact_covariance))
    forget_contacts(next);
}

void take_contacts_of_profile(const hrt_session_config& session, hrt_session_config* profile) {
  if (!is_not_zero(profile->registration.contact_covariance)) {  // the session's are of its plate, and stay
    const auto& kept = session.registration;
    std::copy(std::begin(kept.contact_correction), std::end(kept.contact_correction),
              profile->registration.contact_correction);
    std::copy(std::begin(kept.contact_covariance), std::end(kept.contact_covariance),
              profile->registration.contact_covariance);
  } else if (have_same_pose(session, *profile)) {
    write_touched(drifted(touched_of(*profile)), profile);
  } else {
    forget_contacts(profile);
  }
  std::copy(std::begin(session.plate.position_m), std::end(session.plate.position_m), profile->plate.position_m);
  std::copy(std::begin(session.plate.rotation), std::end(session.plate.rotation), profile->plate.rotation);
  profile->plate.scale = session.plate.scale;
}

hrt_result read_contact(const hrt_session_config& config, const hrt_contact& given, const PlatePoint& start,
                        const hrt_target_config& real, TouchedPlace* out) {
  using F = Fields<hrt_contact>;
  constexpr std::uint32_t either = HRT_CONTACT_PLATE_POSITION | HRT_CONTACT_WORLD_POSITION;
  HRT_RETURN_IF_FAILED(check_field(given, F::flags));
  if (given.flags == either)
    return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", given.flags,
                "; allowed: one of PLATE_POSITION and WORLD_POSITION, or none");
  const bool is_placed = given.flags != 0;
  if (is_placed) HRT_RETURN_IF_FAILED(check_field(given, F::position_m));
  HRT_RETURN_IF_FAILED(check_field(given, F::sd_m));
  const TargetView at = view_from(start, config, is_placed ? placed_at(given) : real);
  const double radius_mm = mm_per_m * real.radius_m;
  const double near_mm = is_placed ? at.distance_mm : std::max(0.0, at.distance_mm - radius_mm);
  const double usual_sd_mm = radius_mm > 0.0 ? radius_mm : unknown_radius_mm;
  *out = {point_ahead(start, at.direction_deg, near_mm), given.sd_m > 0.0 ? mm_per_m * given.sd_m : usual_sd_mm};
  return HRT_OK;
}

hrt_result check_contact(const hrt_session_config& config, const TouchedPlace& touched, const SeenFinger& finger,
                         Contact* out) {
  const double far_mm = distance_mm(start_of(config), touched.place);
  if (far_mm < min_contact_mm)
    return fail(HRT_ERROR_OUT_OF_RANGE, "the place that was touched is ", far_mm / mm_per_m,
                " m from start_position_m; at least ", min_contact_mm / mm_per_m, " is needed");
  *out = {.finger = finger.place,
          .place = touched.place,
          .variance_mm2 = touched.sd_mm * touched.sd_mm + finger.variance_mm2};
  const double off_mm = distance_mm(finger.place, touched.place);
  const double max_mm = max_share * far_mm + max_deviations * std::sqrt(out->variance_mm2);
  if (off_mm <= max_mm) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, "the place that was touched is ", off_mm / mm_per_m,
              " m from where the finger was seen; allowed: up to ", max_mm / mm_per_m, ". Was it another object?");
}

hrt_session_config after_contact(const hrt_session_config& config, const Contact& contact) {
  const RetargeterConfig learnt = carried(to_core(config), contact, knows_person(config));
  if (!is_valid(learnt.touched)) return config;
  hrt_session_config next = config;
  write_touched(learnt.touched, &next);
  if (knows_person(config)) next.person.mean[HRT_PERSON_BIAS] = learnt.person.mean(PersonTrait::bias);
  return next;
}

}  // namespace hrt::plugin
