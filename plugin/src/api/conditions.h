// The plate and the tracker with which a user was measured, and their comparison with the present ones.
#pragma once

#include <cstdint>
#include <cstring>

#include "generated/fields.h"
#include "haptic_retargeting/profile.h"
#include "plugin/src/abi/checks.h"

namespace hrt::plugin {

/// Checks the values that a host or a profile gives. Sets `differing` and the bytes after the names to 0.
inline hrt_result check_conditions(hrt_conditions* conditions) {
  HRT_RETURN_IF_FAILED(check_field(*conditions, Fields<hrt_conditions>::time_s));
  HRT_RETURN_IF_FAILED(check_name("plate", conditions->plate));
  HRT_RETURN_IF_FAILED(check_name("tracker", conditions->tracker));
  conditions->differing = 0;
  return HRT_OK;
}

class Conditions {
 public:
  void set_now(const hrt_conditions& checked) { now_ = checked; }
  void set_measured(const hrt_conditions& checked) { measured_ = checked; }
  void set_measured_to_now() { measured_ = now_; }

  /// Returns the conditions of the measurement; `differing` compares them with the present conditions.
  hrt_conditions measured() const {
    hrt_conditions measured = measured_;
    measured.struct_size = sizeof measured;
    measured.differing = (differ(measured_.plate, now_.plate) ? HRT_CONDITION_PLATE : 0) |
                         (differ(measured_.tracker, now_.tracker) ? HRT_CONDITION_TRACKER : 0);
    return measured;
  }

 private:
  static bool differ(const char* one, const char* other) {
    return *one != '\0' && *other != '\0' && std::strcmp(one, other) != 0;
  }

  hrt_conditions now_{};
  hrt_conditions measured_{};
};

}  // namespace hrt::plugin
