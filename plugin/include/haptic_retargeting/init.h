/*
 * Written by plugin/bindings/generate from the C headers.
 *
 * Each struct by value, ready for use: with its defaults, or zero with its size.
 *
 *   hrt_session_config config = hrt_session_config_init();
 */
/* clang-format off */
#ifndef HAPTIC_RETARGETING_INIT_H
#define HAPTIC_RETARGETING_INIT_H

#include "authority.h"
#include "base.h"
#include "calibration.h"
#include "host.h"
#include "profile.h"
#include "reach.h"
#include "recording.h"
#include "registration.h"
#include "scene.h"
#include "session.h"
#include "target.h"

#if defined(__cplusplus)
#define HRT_EMPTY {}
#else
#define HRT_EMPTY {0}
#endif

/** All zero, with its size. [any-thread] */
static inline hrt_allocator hrt_allocator_init(void) {
  hrt_allocator value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** hrt_session_config_default() by value. [any-thread] */
static inline hrt_session_config hrt_session_config_init(void) {
  hrt_session_config value = HRT_EMPTY;
  if (hrt_session_config_default(&value, sizeof value) != HRT_OK) value.struct_size = 0;
  return value;
}

/** hrt_target_config_default() by value. [any-thread] */
static inline hrt_target_config hrt_target_config_init(void) {
  hrt_target_config value = HRT_EMPTY;
  if (hrt_target_config_default(&value, sizeof value) != HRT_OK) value.struct_size = 0;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_authority hrt_authority_init(void) {
  hrt_authority value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** hrt_reach_config_default() by value. [any-thread] */
static inline hrt_reach_config hrt_reach_config_init(void) {
  hrt_reach_config value = HRT_EMPTY;
  if (hrt_reach_config_default(&value, sizeof value) != HRT_OK) value.struct_size = 0;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_sample hrt_sample_init(void) {
  hrt_sample value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_command hrt_command_init(void) {
  hrt_command value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_reach_summary hrt_reach_summary_init(void) {
  hrt_reach_summary value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** hrt_calibration_config_default() by value. [any-thread] */
static inline hrt_calibration_config hrt_calibration_config_init(void) {
  hrt_calibration_config value = HRT_EMPTY;
  if (hrt_calibration_config_default(&value, sizeof value) != HRT_OK) value.struct_size = 0;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_calibration_result hrt_calibration_result_init(void) {
  hrt_calibration_result value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_calibration_slide hrt_calibration_slide_init(void) {
  hrt_calibration_slide value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_calibration_comparison hrt_calibration_comparison_init(void) {
  hrt_calibration_comparison value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_conditions hrt_conditions_init(void) {
  hrt_conditions value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_recording_status hrt_recording_status_init(void) {
  hrt_recording_status value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_replay_report hrt_replay_report_init(void) {
  hrt_replay_report value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** hrt_registration_config_default() by value. [any-thread] */
static inline hrt_registration_config hrt_registration_config_init(void) {
  hrt_registration_config value = HRT_EMPTY;
  if (hrt_registration_config_default(&value, sizeof value) != HRT_OK) value.struct_size = 0;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_registration hrt_registration_init(void) {
  hrt_registration value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_touch_check hrt_touch_check_init(void) {
  hrt_touch_check value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_fingertip hrt_fingertip_init(void) {
  hrt_fingertip value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_latency hrt_latency_init(void) {
  hrt_latency value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_scene_info hrt_scene_info_init(void) {
  hrt_scene_info value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

/** All zero, with its size. [any-thread] */
static inline hrt_scene_target hrt_scene_target_init(void) {
  hrt_scene_target value = HRT_EMPTY;
  value.struct_size = sizeof value;
  return value;
}

#undef HRT_EMPTY

#endif
