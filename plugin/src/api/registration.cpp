#include "haptic_retargeting/registration.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "core/math/linear_algebra.h"
#include "core/math/time.h"
#include "core/plate/frame_error.h"
#include "core/plate/registration.h"
#include "core/tracker/tracker_latency.h"
#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/sessions.h"
#include "plugin/src/session/finger_sample.h"
#include "plugin/src/session/session_config.h"
#include "plugin/src/session/triangle.h"

namespace hrt::plugin {
namespace {

constexpr double deg_per_rad = 57.29577951308232;
using SetupFields = Fields<hrt_registration_config>;

struct VerdictText {
  RegistrationVerdict core;
  std::uint32_t verdict;
  const char* advice;
};
constexpr VerdictText verdicts[] = {
    {RegistrationVerdict::holds, HRT_REGISTRATION_HOLDS,
     "The touches fit. Touch a mark before a reach to check that the plate has not moved."},
    {RegistrationVerdict::too_few, HRT_REGISTRATION_TOO_FEW,
     "Touch at least 3 marks, better 5 or more: with 5 a bad touch can be found."},
    {RegistrationVerdict::degenerate, HRT_REGISTRATION_DEGENERATE,
     "The marks lie on a line. Touch another one at least some centimetres beside it."},
    {RegistrationVerdict::inconsistent, HRT_REGISTRATION_INCONSISTENT,
     "The touches do not fit the marks. Touch them again, each in its turn, with the finger held the same "
     "way, "
     "and keep the plate still."},
    {RegistrationVerdict::upside_down, HRT_REGISTRATION_UPSIDE_DOWN,
     "By the touches the plate lies upside down: left and right were confused. Touch the marks again."},
};

Eigen::Vector3d vector_of(const double (&values)[3]) {
  return {values[0], values[1], values[2]};
}

Eigen::Matrix3d rotation_of(const double (&q)[4]) {
  return Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
}

hrt_result read_config(const hrt_registration_config* given, RegistrationConfig* out) {
  hrt_registration_config config;
  HRT_RETURN_IF_FAILED(read_configuration("config", given, &config));
  HRT_RETURN_IF_FAILED(check_field(config, SetupFields::flags));
  HRT_RETURN_IF_FAILED(check_field(config, SetupFields::touch_sd_m));
  *out = {.touch_sd_m = config.touch_sd_m, .fit_scale = (config.flags & HRT_REGISTER_SCALE) != 0};
  if ((config.flags & HRT_REGISTER_UP) == 0) return HRT_OK;
  HRT_RETURN_IF_FAILED(check_field(config, SetupFields::up));
  out->up = vector_of(config.up);
  if (!(out->up.norm() > 0.0)) return fail(HRT_ERROR_OUT_OF_RANGE, "up is (0, 0, 0); it must have a length");
  return HRT_OK;
}

template <class Touch>
hrt_result check_touches(const Touch* touches, std::uint64_t count) {
  if (count > HRT_TOUCHES_MAX)
    return fail(HRT_ERROR_OUT_OF_RANGE, "touch_count is ", count, "; allowed: up to ", HRT_TOUCHES_MAX);
  if (count > 0 && !touches) return fail(HRT_ERROR_NULL_ARGUMENT, "touches is null");
  return HRT_OK;
}

// `where` is put before the names of the fields.
hrt_result read_touch(const char* where, const hrt_mark_touch& given, MarkTouch* out) {
  Text<64> mark, touched;
  mark << where << "mark_m";
  touched << where << "touched_m";
  using F = Fields<hrt_mark_touch>;
  HRT_RETURN_IF_FAILED(check_value(mark.c_str(), F::mark_m, given.mark_m));
  HRT_RETURN_IF_FAILED(check_value(touched.c_str(), F::touched_m, given.touched_m));
  *out = {vector_of(given.mark_m), vector_of(given.touched_m)};
  return HRT_OK;
}

hrt_result read_touch(const char* where, const hrt_joint_touch& given, TurnedTouch* out) {
  Text<64> position, rotation;
  position << where << "position_m";
  rotation << where << "rotation";
  HRT_RETURN_IF_FAILED(check_value(position.c_str(), Fields<hrt_joint_touch>::position_m, given.position_m));
  HRT_RETURN_IF_FAILED(check_rotation(rotation.c_str(), given.rotation));
  *out = {rotation_of(given.rotation), vector_of(given.position_m)};
  return HRT_OK;
}

template <class Given, class Touch>
hrt_result read_touches(const Given* given, std::uint64_t count, std::vector<Touch>* out) {
  HRT_RETURN_IF_FAILED(check_touches(given, count));
  out->resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    Text<32> where;
    where << "touches[" << i << "].";
    HRT_RETURN_IF_FAILED(read_touch(where.c_str(), given[i], &(*out)[i]));
  }
  return HRT_OK;
}

hrt_registration to_abi(const Registration& found, std::uint32_t touches) {
  const auto* text = std::find_if(std::begin(verdicts), std::end(verdicts),
                                  [&](const VerdictText& v) { return v.core == found.verdict; });
  Eigen::Quaterniond q(found.rotation);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  hrt_registration result{
      .struct_size = sizeof(hrt_registration),
      .verdict = text->verdict,
      .touches = touches,
      .left_out = found.left_out.value_or(-1),
      .plate_position_m = {found.position_m.x(), found.position_m.y(), found.position_m.z()},
      .plate_rotation = {q.x(), q.y(), q.z(), q.w()},
      .plate_scale = found.scale,
      .covariance = {},
      .touch_sd_m = found.touch_sd_m,
      .residual_m = found.residual_m,
      .turn_sd_deg = deg_per_rad * std::sqrt(std::max(0.0, found.covariance(1, 1))),
  };
  write_triangle<7>(found.covariance, result.covariance);
  return result;
}

// True if no direction has a negative variance, within rounding.
bool is_covariance(const Square<7>& matrix) {
  const double rounding = 1e-9 * std::max(1e-12, matrix.trace());
  return is_positive_definite(matrix + rounding * Square<7>::Identity());
}

// A registration that holds, of any version.
hrt_result read_registration(const hrt_registration* given, Registration* out) {
  hrt_registration known{};
  HRT_RETURN_IF_FAILED(read_struct("registration", given, &known));
  if (known.verdict != HRT_REGISTRATION_HOLDS)
    return fail(HRT_ERROR_OUT_OF_RANGE, "verdict is ", known.verdict, "; allowed: HRT_REGISTRATION_HOLDS, ",
                HRT_REGISTRATION_HOLDS);
  using F = Fields<hrt_session_config>;
  HRT_RETURN_IF_FAILED(check_value("plate_position_m", F::plate_position_m, known.plate_position_m));
  HRT_RETURN_IF_FAILED(check_rotation("plate_rotation", known.plate_rotation));
  HRT_RETURN_IF_FAILED(check_value("plate_scale", F::plate_scale, known.plate_scale));
  HRT_RETURN_IF_FAILED(check_range("touch_sd_m", known.touch_sd_m, 1e-9, 1.0));
  *out = {.verdict = RegistrationVerdict::holds,
          .rotation = rotation_of(known.plate_rotation),
          .position_m = vector_of(known.plate_position_m),
          .scale = known.plate_scale,
          .touch_sd_m = known.touch_sd_m};
  for (const double covariance : known.covariance)
    HRT_RETURN_IF_FAILED(check_range("covariance", covariance, -1.0, 1.0));
  out->covariance = from_triangle<7>(known.covariance);
  if (is_covariance(out->covariance)) return HRT_OK;
  return fail(
      HRT_ERROR_OUT_OF_RANGE,
      "covariance is not positive semidefinite; allowed: the lower triangle, row by row, of a positive "
      "semidefinite matrix");
}

// Whether the session's plate is where the registration has it.
bool is_of(const hrt_registration& registration, const hrt_session_config& config) {
  return std::equal(std::begin(registration.plate_position_m), std::end(registration.plate_position_m),
                    config.plate_position_m) &&
         std::equal(std::begin(registration.plate_rotation), std::end(registration.plate_rotation),
                    config.plate_rotation) &&
         registration.plate_scale == config.plate_scale;
}

hrt_touch_check to_abi(const RegistrationCheck& check) {
  return {.struct_size = sizeof(hrt_touch_check),
          .holds = check.holds ? 1u : 0u,
          .distance_m = check.distance_m,
          .allowed_m = check.allowed_m};
}

// A registration and a touch of a mark, compared.
hrt_result check_touch(const hrt_registration* registration, const hrt_mark_touch* touch,
                       RegistrationCheck* out) {
  Registration known;
  HRT_RETURN_IF_FAILED(read_registration(registration, &known));
  if (!touch) return fail(HRT_ERROR_NULL_ARGUMENT, "touch is null");
  MarkTouch seen;
  HRT_RETURN_IF_FAILED(read_touch("touch.", *touch, &seen));
  *out = check_registration(known, seen);
  return HRT_OK;
}

hrt_session_config registered(hrt_session_config config, const hrt_registration& given,
                              const Registration& registration, std::int64_t time_ns) {
  std::copy(std::begin(given.plate_position_m), std::end(given.plate_position_m), config.plate_position_m);
  std::copy(std::begin(given.plate_rotation), std::end(given.plate_rotation), config.plate_rotation);
  config.plate_scale = given.plate_scale;
  write_frame_covariance(frame_covariance(registration), &config);
  config.registration_time_ns = time_ns;
  config.flags |= HRT_SESSION_REGISTERED;
  return config;
}

// The samples of a finger that is carried; in any frame, but all in one.
hrt_result read_carried(const hrt_sample* given, std::uint64_t count, std::vector<CarriedSample>* out) {
  if (count > HRT_LATENCY_SAMPLES_MAX)
    return fail(HRT_ERROR_OUT_OF_RANGE, "sample_count is ", count, "; allowed: up to ",
                HRT_LATENCY_SAMPLES_MAX);
  if (count == 0) return HRT_OK;
  HRT_RETURN_IF_FAILED(check_output("samples[0]", given));
  const std::uint32_t size = given->struct_size;
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  constexpr std::uint32_t places = HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION;
  std::uint32_t place = 0;
  std::int64_t first_ns = 0, last_ns = 0;
  out->reserve(static_cast<std::size_t>(count));
  for (std::uint64_t i = 0; i < count; ++i, bytes += size) {
    Text<32> name;
    name << "samples[" << i << "]";
    hrt_sample sample{};
    HRT_RETURN_IF_FAILED(read_struct(name.c_str(), reinterpret_cast<const hrt_sample*>(bytes), &sample));
    if (const hrt_result result = check_sample(sample); result != HRT_OK)
      return fail(result, name.view(), ".", last_failure().view());
    if (i > 0 && sample.time_ns < last_ns)
      return fail(HRT_ERROR_TIME_REVERSED, name.view(), ": time_ns is ", sample.time_ns,
                  "; allowed: from the last sample's, ", last_ns);
    if (i == 0) first_ns = sample.time_ns;
    last_ns = sample.time_ns;
    if ((sample.flags & places) == 0 || (sample.flags & HRT_SAMPLE_PLATE_ORIENTATION) == 0 ||
        (sample.flags & HRT_SAMPLE_LIFTED) != 0)
      continue;
    if (place != 0 && place != (sample.flags & places))
      return fail(HRT_ERROR_OUT_OF_RANGE, name.view(), ": flags is ", sample.flags,
                  "; allowed: the kind of position that the samples before have");
    place = sample.flags & places;
    out->push_back({.time_s = 1e-9 * static_cast<double>(elapsed_ns(first_ns, sample.time_ns)),
                    .finger_m = vector_of(sample.finger_position_m),
                    .plate_orientation_deg = sample.plate_orientation_deg});
  }
  return HRT_OK;
}

hrt_latency to_abi(const TrackerLatency& found) {
  const auto to_ns = [](double seconds) { return static_cast<std::int64_t>(std::llround(1e9 * seconds)); };
  hrt_latency result{};
  result.struct_size = sizeof result;
  if (!found.known) return result;
  result.known = 1;
  result.latency_ns = std::max<std::int64_t>(0, to_ns(found.latency_s));
  result.lower_ns = to_ns(found.lower_s);
  result.upper_ns = to_ns(found.upper_s);
  result.residual_m = found.residual_m;
  result.radius_m = found.radius_m;
  return result;
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_registration_fit(const hrt_registration_config* config, const hrt_mark_touch* touches,
                                uint64_t touch_count, uint64_t capacity, double* out_residuals_m,
                                hrt_registration* out_registration) noexcept {
  return guarded("hrt_registration_fit", [&]() -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_registration", out_registration));
    hrt::RegistrationConfig checked;
    HRT_RETURN_IF_FAILED(read_config(config, &checked));
    std::vector<hrt::MarkTouch> known;
    HRT_RETURN_IF_FAILED(read_touches(touches, touch_count, &known));
    if (capacity > 0 && !out_residuals_m) return fail(HRT_ERROR_NULL_ARGUMENT, "out_residuals_m is null");
    if (capacity > 0 && capacity < touch_count)
      return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; there are ", touch_count,
                  " touches");
    const hrt::Registration found = hrt::fit_registration(checked, known);
    const bool fitted = found.touch_sd_m > 0.0;
    for (std::size_t i = 0; capacity > 0 && i < known.size(); ++i)
      out_residuals_m[i] = fitted ? hrt::residual_m(found, known[i]) : 0.0;
    write_struct(to_abi(found, static_cast<std::uint32_t>(touch_count)), out_registration);
    return HRT_OK;
  });
}

const char* hrt_registration_advice(uint32_t verdict) noexcept {
  for (const VerdictText& text : verdicts)
    if (text.verdict == verdict) return text.advice;
  return "unknown verdict";
}

hrt_result hrt_registration_apply(hrt_session session, const hrt_registration* registration,
                                  int64_t time_ns) noexcept {
  return with_session("hrt_registration_apply", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.session().check_no_reach());
    s.log_findings(session.value);
    hrt::Registration known;
    HRT_RETURN_IF_FAILED(read_registration(registration, &known));
    const hrt_session_config config = registered(s.session().config(), *registration, known, time_ns);
    HRT_RETURN_IF_FAILED(check_session_config(config));
    return s.set_config(config);
  });
}

hrt_result hrt_registration_check(const hrt_registration* registration, const hrt_mark_touch* touch,
                                  hrt_touch_check* out_check) noexcept {
  return guarded("hrt_registration_check", [&]() -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_check", out_check));
    hrt::RegistrationCheck check{};
    HRT_RETURN_IF_FAILED(check_touch(registration, touch, &check));
    write_struct(to_abi(check), out_check);
    return HRT_OK;
  });
}

hrt_result hrt_registration_confirm(hrt_session session, const hrt_registration* registration,
                                    const hrt_mark_touch* touch, int64_t time_ns,
                                    hrt_touch_check* out_check) noexcept {
  return with_session("hrt_registration_confirm", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.session().check_no_reach());
    HRT_RETURN_IF_FAILED(check_output("out_check", out_check));
    hrt::RegistrationCheck check{};
    HRT_RETURN_IF_FAILED(check_touch(registration, touch, &check));
    hrt_session_config config = s.session().config();
    if (!is_of(*registration, config))
      return fail(HRT_ERROR_OUT_OF_RANGE,
                  "registration is not that of the session: its pose or scale differs; allowed: the one that "
                  "hrt_registration_apply() got");
    if (check.holds) {
      config.registration_time_ns = time_ns;
      config.flags |= HRT_SESSION_REGISTERED;
    } else {
      config.flags &= ~HRT_SESSION_REGISTERED;
    }
    HRT_RETURN_IF_FAILED(s.set_config(config));
    write_struct(to_abi(check), out_check);
    return HRT_OK;
  });
}

hrt_result hrt_fingertip_fit(const hrt_registration_config* config, const hrt_joint_touch* touches,
                             uint64_t touch_count, hrt_fingertip* out_fingertip) noexcept {
  return guarded("hrt_fingertip_fit", [&]() -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_fingertip", out_fingertip));
    hrt::RegistrationConfig checked;
    HRT_RETURN_IF_FAILED(read_config(config, &checked));
    std::vector<hrt::TurnedTouch> known;
    HRT_RETURN_IF_FAILED(read_touches(touches, touch_count, &known));
    const hrt::FingertipOffset found = hrt::fit_fingertip(checked, known);
    hrt_fingertip result{
        .struct_size = sizeof(hrt_fingertip), .known = found.known ? 1u : 0u, .offset_m = {}, .sd_m = {}};
    for (int i = 0; i < 3 && found.known; ++i) {
      result.offset_m[i] = found.offset_m(i);
      result.sd_m[i] = found.sd_m(i);
    }
    write_struct(result, out_fingertip);
    return HRT_OK;
  });
}

hrt_result hrt_fingertip_place(const hrt_fingertip* fingertip, const hrt_joint_touch* joint,
                               hrt_sample* out_sample) noexcept {
  return guarded("hrt_fingertip_place", [&]() -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_sample", out_sample));
    hrt_fingertip known{};
    HRT_RETURN_IF_FAILED(read_struct("fingertip", fingertip, &known));
    HRT_RETURN_IF_FAILED(check_range("known", known.known, 1u, 1u));
    HRT_RETURN_IF_FAILED(check_value("offset_m", Fields<hrt_joint_touch>::position_m, known.offset_m));
    if (!joint) return fail(HRT_ERROR_NULL_ARGUMENT, "joint is null");
    hrt::TurnedTouch held;
    HRT_RETURN_IF_FAILED(read_touch("joint.", *joint, &held));
    const Eigen::Vector3d skin_m = held.joint_m + held.joint_rotation * vector_of(known.offset_m);
    out_sample->flags &= ~(HRT_SAMPLE_DIRECTION | HRT_SAMPLE_PLATE_POSITION);
    out_sample->flags |= HRT_SAMPLE_WORLD_POSITION;
    for (int i = 0; i < 3; ++i) out_sample->finger_position_m[i] = skin_m(i);
    return HRT_OK;
  });
}

hrt_result hrt_latency_fit(const hrt_sample* samples, uint64_t sample_count,
                           hrt_latency* out_latency) noexcept {
  return guarded("hrt_latency_fit", [&]() -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_latency", out_latency));
    std::vector<hrt::CarriedSample> carried;
    HRT_RETURN_IF_FAILED(read_carried(samples, sample_count, &carried));
    write_struct(to_abi(hrt::fit_tracker_latency(carried)), out_latency);
    return HRT_OK;
  });
}
