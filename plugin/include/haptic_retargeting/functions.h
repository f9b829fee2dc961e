/*
 * Written by plugin/bindings/generate from the C headers.
 *
 * All functions as a table, for hosts that open the library when they run: the headers, and no linking.
 *
 *   hrt_functions hrt;
 *   void* library = dlopen("libhaptic_retargeting.so.0", RTLD_NOW | RTLD_LOCAL);
 *   const char* missing = hrt_functions_load(dlsym, library, &hrt);
 *   if (!missing) hrt.session_create(&config, &session);
 */
/* clang-format off */
#ifndef HAPTIC_RETARGETING_FUNCTIONS_H
#define HAPTIC_RETARGETING_FUNCTIONS_H

#include <string.h>

#include "haptic_retargeting.h"

typedef const char* (*PFN_hrt_result_string)(int32_t result);
typedef const char* (*PFN_hrt_last_error)(void);
typedef void (*PFN_hrt_get_version)(uint32_t* out_major, uint32_t* out_minor, uint32_t* out_patch);
typedef hrt_result (*PFN_hrt_set_allocator)(const hrt_allocator* allocator);
typedef hrt_result (*PFN_hrt_set_log_callback)(hrt_log_callback callback, void* context);
typedef hrt_result (*PFN_hrt_session_config_default)(hrt_session_config* out_config, uint32_t struct_size);
typedef hrt_result (*PFN_hrt_session_create)(const hrt_session_config* config, hrt_session* out_session);
typedef uint32_t (*PFN_hrt_session_is_valid)(hrt_session session);
typedef hrt_result (*PFN_hrt_session_get_state)(hrt_session session, uint32_t* out_state);
typedef hrt_result (*PFN_hrt_session_destroy)(hrt_session session);
typedef hrt_result (*PFN_hrt_session_set_log_callback)(hrt_session session, hrt_log_callback callback, void*
                                                       context);
typedef hrt_result (*PFN_hrt_session_get_config)(hrt_session session, hrt_session_config* out_config);
typedef hrt_result (*PFN_hrt_session_set_config)(hrt_session session, const hrt_session_config* config);
typedef hrt_result (*PFN_hrt_target_config_default)(hrt_target_config* out_config, uint32_t struct_size);
typedef hrt_result (*PFN_hrt_target_add)(hrt_session session, const hrt_target_config* config, hrt_target*
                                         out_target);
typedef hrt_result (*PFN_hrt_target_set)(hrt_session session, hrt_target target, const hrt_target_config*
                                         config);
typedef hrt_result (*PFN_hrt_target_get)(hrt_session session, hrt_target target, hrt_target_config*
                                         out_config);
typedef hrt_result (*PFN_hrt_target_remove)(hrt_session session, hrt_target target);
typedef hrt_result (*PFN_hrt_target_find)(hrt_session session, const char* name, hrt_target* out_target);
typedef hrt_result (*PFN_hrt_target_list)(hrt_session session, uint32_t role, uint64_t capacity, hrt_target*
                                          out_targets, uint64_t* out_count);
typedef hrt_result (*PFN_hrt_authority_query)(hrt_session session, hrt_target real_target, hrt_target
                                              virtual_target, hrt_authority* out_authority);
typedef hrt_result (*PFN_hrt_authority_query_all)(hrt_session session, uint64_t capacity, hrt_authority*
                                                  out_authorities, uint64_t* out_count);
typedef hrt_result (*PFN_hrt_authority_query_best)(hrt_session session, hrt_target virtual_target,
                                                   hrt_authority* out_authority);
typedef hrt_result (*PFN_hrt_target_assign)(hrt_session session, const hrt_target* virtual_targets, uint64_t
                                            virtual_count, const hrt_target* real_targets, uint64_t
                                            real_count, uint32_t flags, uint64_t capacity, hrt_authority*
                                            out_authorities);
typedef hrt_result (*PFN_hrt_reach_config_default)(hrt_reach_config* out_config, uint32_t struct_size);
typedef hrt_result (*PFN_hrt_reach_begin)(hrt_session session, const hrt_reach_config* config);
typedef hrt_result (*PFN_hrt_reach_update)(hrt_session session, const hrt_sample* sample, hrt_command*
                                           out_command);
typedef hrt_result (*PFN_hrt_reach_retarget)(hrt_session session, hrt_target real_target, hrt_target
                                             virtual_target);
typedef hrt_result (*PFN_hrt_reach_cancel)(hrt_session session);
typedef hrt_result (*PFN_hrt_reach_end)(hrt_session session, hrt_reach_summary* out_summary);
typedef hrt_result (*PFN_hrt_calibration_config_default)(hrt_calibration_config* out_config, uint32_t
                                                         struct_size);
typedef hrt_result (*PFN_hrt_calibration_create)(hrt_session session, const hrt_calibration_config* config,
                                                 hrt_calibration* out_calibration);
typedef hrt_result (*PFN_hrt_calibration_destroy)(hrt_calibration calibration);
typedef hrt_result (*PFN_hrt_calibration_begin_trial)(hrt_calibration calibration, double
                                                      plate_orientation_deg);
typedef hrt_result (*PFN_hrt_calibration_add_sample)(hrt_calibration calibration, const hrt_sample* sample);
typedef hrt_result (*PFN_hrt_calibration_end_trial)(hrt_calibration calibration);
typedef hrt_result (*PFN_hrt_calibration_cancel_trial)(hrt_calibration calibration);
typedef hrt_result (*PFN_hrt_calibration_next_angle)(hrt_calibration calibration, double*
                                                     out_plate_orientation_deg, uint32_t* out_enough);
typedef hrt_result (*PFN_hrt_calibration_solve)(hrt_calibration calibration, hrt_calibration_result*
                                                out_result);
typedef hrt_result (*PFN_hrt_calibration_get_residual)(hrt_calibration calibration, uint32_t slide,
                                                       hrt_calibration_slide* out_slide);
typedef hrt_result (*PFN_hrt_calibration_compare)(const hrt_calibration_result* first, const
                                                  hrt_calibration_result* second, hrt_calibration_comparison*
                                                  out_comparison);
typedef hrt_result (*PFN_hrt_calibration_apply)(hrt_session session, const hrt_calibration_result* result);
typedef hrt_result (*PFN_hrt_profile_set_conditions)(hrt_session session, const hrt_conditions* conditions);
typedef hrt_result (*PFN_hrt_profile_get_conditions)(hrt_session session, hrt_conditions* out_conditions);
typedef hrt_result (*PFN_hrt_profile_save)(hrt_session session, uint64_t capacity, char* out_text, uint64_t*
                                           out_length);
typedef hrt_result (*PFN_hrt_profile_load)(hrt_session session, const char* text, uint64_t length);
typedef hrt_result (*PFN_hrt_recording_start)(hrt_session session, const char* path);
typedef hrt_result (*PFN_hrt_recording_get_status)(hrt_session session, hrt_recording_status* out_status);
typedef hrt_result (*PFN_hrt_recording_stop)(hrt_session session, hrt_recording_status* out_status);
typedef hrt_result (*PFN_hrt_replay_text)(const char* text, uint64_t length, hrt_replay_report* out_report);
typedef hrt_result (*PFN_hrt_replay_file)(const char* path, hrt_replay_report* out_report);
typedef hrt_result (*PFN_hrt_registration_config_default)(hrt_registration_config* out_config, uint32_t
                                                          struct_size);
typedef hrt_result (*PFN_hrt_registration_fit)(const hrt_registration_config* config, const hrt_mark_touch*
                                               touches, uint64_t touch_count, uint64_t capacity, double*
                                               out_residuals_m, hrt_registration* out_registration);
typedef const char* (*PFN_hrt_registration_advice)(uint32_t verdict);
typedef hrt_result (*PFN_hrt_registration_apply)(hrt_session session, const hrt_registration* registration,
                                                 int64_t time_ns);
typedef hrt_result (*PFN_hrt_registration_check)(const hrt_registration* registration, const hrt_mark_touch*
                                                 touch, hrt_touch_check* out_check);
typedef hrt_result (*PFN_hrt_registration_confirm)(hrt_session session, const hrt_registration* registration,
                                                   const hrt_mark_touch* touch, int64_t time_ns,
                                                   hrt_touch_check* out_check);
typedef hrt_result (*PFN_hrt_fingertip_fit)(const hrt_registration_config* config, const hrt_joint_touch*
                                            touches, uint64_t touch_count, hrt_fingertip* out_fingertip);
typedef hrt_result (*PFN_hrt_fingertip_place)(const hrt_fingertip* fingertip, const hrt_joint_touch* joint,
                                              hrt_sample* out_sample);
typedef hrt_result (*PFN_hrt_latency_fit)(const hrt_sample* samples, uint64_t sample_count, hrt_latency*
                                          out_latency);
typedef hrt_result (*PFN_hrt_scene_load_file)(const char* path, hrt_scene* out_scene);
typedef hrt_result (*PFN_hrt_scene_load_memory)(const void* bytes, uint64_t length, const char* name,
                                                hrt_scene* out_scene);
typedef hrt_result (*PFN_hrt_scene_destroy)(hrt_scene scene);
typedef hrt_result (*PFN_hrt_scene_get_info)(hrt_scene scene, hrt_scene_info* out_info);
typedef hrt_result (*PFN_hrt_scene_get_target)(hrt_scene scene, uint32_t index, hrt_scene_target* out_target);
typedef hrt_result (*PFN_hrt_scene_register)(hrt_scene scene, hrt_session session, uint64_t capacity,
                                             hrt_target* out_targets);

/** Every function, without hrt_. */
typedef struct hrt_functions {
  PFN_hrt_result_string result_string;
  PFN_hrt_last_error last_error;
  PFN_hrt_get_version get_version;
  PFN_hrt_set_allocator set_allocator;
  PFN_hrt_set_log_callback set_log_callback;
  PFN_hrt_session_config_default session_config_default;
  PFN_hrt_session_create session_create;
  PFN_hrt_session_is_valid session_is_valid;
  PFN_hrt_session_get_state session_get_state;
  PFN_hrt_session_destroy session_destroy;
  PFN_hrt_session_set_log_callback session_set_log_callback;
  PFN_hrt_session_get_config session_get_config;
  PFN_hrt_session_set_config session_set_config;
  PFN_hrt_target_config_default target_config_default;
  PFN_hrt_target_add target_add;
  PFN_hrt_target_set target_set;
  PFN_hrt_target_get target_get;
  PFN_hrt_target_remove target_remove;
  PFN_hrt_target_find target_find;
  PFN_hrt_target_list target_list;
  PFN_hrt_authority_query authority_query;
  PFN_hrt_authority_query_all authority_query_all;
  PFN_hrt_authority_query_best authority_query_best;
  PFN_hrt_target_assign target_assign;
  PFN_hrt_reach_config_default reach_config_default;
  PFN_hrt_reach_begin reach_begin;
  PFN_hrt_reach_update reach_update;
  PFN_hrt_reach_retarget reach_retarget;
  PFN_hrt_reach_cancel reach_cancel;
  PFN_hrt_reach_end reach_end;
  PFN_hrt_calibration_config_default calibration_config_default;
  PFN_hrt_calibration_create calibration_create;
  PFN_hrt_calibration_destroy calibration_destroy;
  PFN_hrt_calibration_begin_trial calibration_begin_trial;
  PFN_hrt_calibration_add_sample calibration_add_sample;
  PFN_hrt_calibration_end_trial calibration_end_trial;
  PFN_hrt_calibration_cancel_trial calibration_cancel_trial;
  PFN_hrt_calibration_next_angle calibration_next_angle;
  PFN_hrt_calibration_solve calibration_solve;
  PFN_hrt_calibration_get_residual calibration_get_residual;
  PFN_hrt_calibration_compare calibration_compare;
  PFN_hrt_calibration_apply calibration_apply;
  PFN_hrt_profile_set_conditions profile_set_conditions;
  PFN_hrt_profile_get_conditions profile_get_conditions;
  PFN_hrt_profile_save profile_save;
  PFN_hrt_profile_load profile_load;
  PFN_hrt_recording_start recording_start;
  PFN_hrt_recording_get_status recording_get_status;
  PFN_hrt_recording_stop recording_stop;
  PFN_hrt_replay_text replay_text;
  PFN_hrt_replay_file replay_file;
  PFN_hrt_registration_config_default registration_config_default;
  PFN_hrt_registration_fit registration_fit;
  PFN_hrt_registration_advice registration_advice;
  PFN_hrt_registration_apply registration_apply;
  PFN_hrt_registration_check registration_check;
  PFN_hrt_registration_confirm registration_confirm;
  PFN_hrt_fingertip_fit fingertip_fit;
  PFN_hrt_fingertip_place fingertip_place;
  PFN_hrt_latency_fit latency_fit;
  PFN_hrt_scene_load_file scene_load_file;
  PFN_hrt_scene_load_memory scene_load_memory;
  PFN_hrt_scene_destroy scene_destroy;
  PFN_hrt_scene_get_info scene_get_info;
  PFN_hrt_scene_get_target scene_get_target;
  PFN_hrt_scene_register scene_register;
} hrt_functions;

/** Returns the address of a symbol, or null: dlsym() as it is; on Windows, what calls GetProcAddress(). */
typedef void* (*hrt_get_proc)(void* library, const char* name);

/** Fills the table. Returns null, or the name of the first function that the library lacks; those that
 *  it lacks are null in the table. [any-thread] */
static inline const char* hrt_functions_load(hrt_get_proc get_proc, void* library,
                                             hrt_functions* out_functions) {
  const char* missing = NULL;
  void* address = NULL;
#define HRT_LOAD(name)                                         \
  address = get_proc(library, "hrt_" #name);                   \
  memcpy(&out_functions->name, &address, sizeof address);      \
  if (address == NULL && missing == NULL) missing = "hrt_" #name;
  HRT_LOAD(result_string)
  HRT_LOAD(last_error)
  HRT_LOAD(get_version)
  HRT_LOAD(set_allocator)
  HRT_LOAD(set_log_callback)
  HRT_LOAD(session_config_default)
  HRT_LOAD(session_create)
  HRT_LOAD(session_is_valid)
  HRT_LOAD(session_get_state)
  HRT_LOAD(session_destroy)
  HRT_LOAD(session_set_log_callback)
  HRT_LOAD(session_get_config)
  HRT_LOAD(session_set_config)
  HRT_LOAD(target_config_default)
  HRT_LOAD(target_add)
  HRT_LOAD(target_set)
  HRT_LOAD(target_get)
  HRT_LOAD(target_remove)
  HRT_LOAD(target_find)
  HRT_LOAD(target_list)
  HRT_LOAD(authority_query)
  HRT_LOAD(authority_query_all)
  HRT_LOAD(authority_query_best)
  HRT_LOAD(target_assign)
  HRT_LOAD(reach_config_default)
  HRT_LOAD(reach_begin)
  HRT_LOAD(reach_update)
  HRT_LOAD(reach_retarget)
  HRT_LOAD(reach_cancel)
  HRT_LOAD(reach_end)
  HRT_LOAD(calibration_config_default)
  HRT_LOAD(calibration_create)
  HRT_LOAD(calibration_destroy)
  HRT_LOAD(calibration_begin_trial)
  HRT_LOAD(calibration_add_sample)
  HRT_LOAD(calibration_end_trial)
  HRT_LOAD(calibration_cancel_trial)
  HRT_LOAD(calibration_next_angle)
  HRT_LOAD(calibration_solve)
  HRT_LOAD(calibration_get_residual)
  HRT_LOAD(calibration_compare)
  HRT_LOAD(calibration_apply)
  HRT_LOAD(profile_set_conditions)
  HRT_LOAD(profile_get_conditions)
  HRT_LOAD(profile_save)
  HRT_LOAD(profile_load)
  HRT_LOAD(recording_start)
  HRT_LOAD(recording_get_status)
  HRT_LOAD(recording_stop)
  HRT_LOAD(replay_text)
  HRT_LOAD(replay_file)
  HRT_LOAD(registration_config_default)
  HRT_LOAD(registration_fit)
  HRT_LOAD(registration_advice)
  HRT_LOAD(registration_apply)
  HRT_LOAD(registration_check)
  HRT_LOAD(registration_confirm)
  HRT_LOAD(fingertip_fit)
  HRT_LOAD(fingertip_place)
  HRT_LOAD(latency_fit)
  HRT_LOAD(scene_load_file)
  HRT_LOAD(scene_load_memory)
  HRT_LOAD(scene_destroy)
  HRT_LOAD(scene_get_info)
  HRT_LOAD(scene_get_target)
  HRT_LOAD(scene_register)
#undef HRT_LOAD
  return missing;
}

#endif
