#include "plugin/src/session/contact.h"

#include <algorithm>
#include <cmath>

#include "core/learning.h"
#include "plugin/src/abi/error.h"

namespace hrt::plugin {
namespace {

constexpr double unknown_radius_mm = 10.0;
// A contact nearer to the start hardly shows a rotation of the tracker's frame.
constexpr double min_contact_mm = 10.0;
// Largest plausible distance between contact and tracked finger: max_share of the contact's distance from the start,
// plus max_sds SDs of the difference between the two positions.
constexpr double max_share = 0.25;
constexpr double max_sds = 3.0;

}  // namespace

hrt_result check_contact(const SessionModel& model, const ContactReport& report, const PlatePoint& start,
                         const TargetPlace& real, const FingerPosition& finger, Contact* out) {
  const TargetView seen = view_from(start, model.mount, report.place.value_or(real));
  const double radius_mm = mm_per_m * real.radius_m;
  const PlatePoint place =
      report.place ? seen.point : point_ahead(start, seen.direction_deg, std::max(0.0, seen.distance_mm - radius_mm));
  const double sd_mm = report.sd_mm > 0.0 ? report.sd_mm : radius_mm > 0.0 ? radius_mm : unknown_radius_mm;
  const double far_mm = distance_mm(start_of(model), place);
  if (far_mm < min_contact_mm)
    return fail(HRT_ERROR_OUT_OF_RANGE, "the position of contact is ", far_mm / mm_per_m,
                " m from start_position_m; allowed: at least ", min_contact_mm / mm_per_m,
                ". Report contacts with targets that are farther away");
  *out = {.finger = finger.place, .place = place, .variance_mm2 = sd_mm * sd_mm + finger.variance_mm2};
  const double off_mm = distance_mm(finger.place, place);
  const double max_mm = max_share * far_mm + max_sds * std::sqrt(out->variance_mm2);
  if (off_mm <= max_mm) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, "the position of contact is ", off_mm / mm_per_m,
              " m from the tracked finger; allowed: up to ", max_mm / mm_per_m,
              ". Check that the finger touched the real target");
}

void learn_contact(const Contact& contact, SessionModel* model) {
  const RetargeterConfig learnt = carried(model->control, contact, model->knows_person);
  if (is_valid(learnt.touched)) model->control = learnt;
}

}  // namespace hrt::plugin
