// What a set-up has found, in a session's configuration.
#pragma once

#include "core/calibrate/calibration.h"
#include "core/plate/registration.h"
#include "haptic_retargeting/setup.h"

namespace hrt::plugin {

/// The pose, scale and uncertainty of a registration that holds, made at `time_ns`.
void write_registration(const Registration& registration, std::int64_t time_ns, hrt_session_config* config);

/// The registration that the configuration has, with touches of `touch_sd_mm`. The uncertainty that it does
/// not keep, of tilt and height, is taken to be as large as that in the plane.
Registration registration_of(const hrt_session_config& config, double touch_sd_mm);

/// What is known of a person and of the tracker's noise; the rest stays. A known weight or bias replaces what
/// reaches have learnt of the person; with curve and habit known they become what is believed of them.
void write_calibration(const Calibration& calibration, hrt_session_config* config);

/// Which of the person's values differ from what `believed` says of them: HRT_RETEST_*.
std::uint32_t differing_from(const hrt_session_config& believed, const Calibration& calibration);

}  // namespace hrt::plugin
