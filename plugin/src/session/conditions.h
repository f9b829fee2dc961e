// Under which conditions a person was measured, and whether they are those of now.
#pragma once

#include <cstdint>

#include "haptic_retargeting/profile.h"

namespace hrt::plugin {

/// Fails naming the field; what is behind the names' zeros is cleared.
hrt_result check_conditions(hrt_conditions* conditions);

class Conditions {
 public:
  void set_now(const hrt_conditions& checked) { now_ = checked; }
  /// Of a profile; all 0 and empty if it names none.
  void set_measured(const hrt_conditions& checked) { measured_ = checked; }
  void measured_now() { measured_ = now_; }

  /// With what differs from now.
  hrt_conditions measured() const;

 private:
  hrt_conditions now_{};
  hrt_conditions measured_{};
};

}  // namespace hrt::plugin
