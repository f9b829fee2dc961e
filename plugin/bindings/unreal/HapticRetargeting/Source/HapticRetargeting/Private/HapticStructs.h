// Written by plugin/bindings/generate from the C headers.
#pragma once

#include "HapticRetargetingTypes.h"
#include "haptic_retargeting/haptic_retargeting.h"

namespace HapticConversions
{
	/** What the settings do not show is as in `Before`. */
	hrt_session_config ToConfig(const FHapticSettings& S, const FTransform& Plate, const hrt_session_config& Before);
	/** Takes what differs from `Before` into the settings; others may have been set and wait. */
	void TakeChanges(const hrt_session_config& Before, const hrt_session_config& C, FHapticSettings& S);
	FHapticCommand FromCommand(const hrt_command& C);
	FHapticSummary FromSummary(const hrt_reach_summary& C);
	FHapticAuthority FromAuthority(const hrt_authority& C);
	FHapticCalibration FromCalibration(const hrt_calibration_result& C);
	FHapticSlide FromSlide(const hrt_calibration_slide& C);
	FHapticCalibrationComparison FromCalibrationComparison(const hrt_calibration_comparison& C);
	FHapticRegistration FromRegistration(const hrt_registration& C);
	FHapticTouchCheck FromTouchCheck(const hrt_touch_check& C);
	FHapticFingertip FromFingertip(const hrt_fingertip& C);
	FHapticSceneTarget FromSceneTarget(const hrt_scene_target& C);
}
