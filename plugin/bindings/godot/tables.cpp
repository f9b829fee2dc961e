// Written by plugin/bindings/generate from the C headers.
// clang-format off
#include "fields.h"

#include <haptic_retargeting/plate.h>

#include <cstring>

#define INTERVAL(type, name)                                        \
  {#name, FieldKind::kDouble, offsetof(type, name.value)},          \
  {#name "_lower", FieldKind::kDouble, offsetof(type, name.lower)}, \
  {#name "_upper", FieldKind::kDouble, offsetof(type, name.upper)}, \
  {#name "_known", FieldKind::kUint32, offsetof(type, name.known)}

namespace hrt_godot {
namespace {

constexpr Field kConfig[] = {
    {"horizon", FieldKind::kUint32, offsetof(hrt_session_config, horizon)},
    {"step_period_ns", FieldKind::kInt64, offsetof(hrt_session_config, step_period_ns)},
    {"control", FieldKind::kUint32, offsetof(hrt_session_config, control), "MPC,Fixed Plate"},
    {"guidance", FieldKind::kUint32, offsetof(hrt_session_config, guidance), "Fixed Direction,Arrival"},
    {"adaptation", FieldKind::kUint32, offsetof(hrt_session_config, adaptation), "Off,Reach,Carried"},
    {"flags", FieldKind::kUint32, offsetof(hrt_session_config, flags)},
    {"perceived_weight", FieldKind::kDouble, offsetof(hrt_session_config, perceived_weight)},
    {"actual_weight", FieldKind::kDouble, offsetof(hrt_session_config, actual_weight)},
    {"plate_bound_deg", FieldKind::kDouble, offsetof(hrt_session_config, plate_bound_deg)},
    {"plate_max_speed_deg_s", FieldKind::kDouble, offsetof(hrt_session_config, plate_max_speed_deg_s)},
    {"plate_max_acceleration_deg_s2", FieldKind::kDouble, offsetof(hrt_session_config, plate_max_acceleration_deg_s2)},
    {"plate_latency_ns", FieldKind::kInt64, offsetof(hrt_session_config, plate_latency_ns)},
    {"plate_lower_stop_deg", FieldKind::kDouble, offsetof(hrt_session_config, plate_lower_stop_deg)},
    {"plate_upper_stop_deg", FieldKind::kDouble, offsetof(hrt_session_config, plate_upper_stop_deg)},
    {"fixed_plate_orientation_deg", FieldKind::kDouble, offsetof(hrt_session_config, fixed_plate_orientation_deg)},
    {"tactile_weight", FieldKind::kDouble, offsetof(hrt_session_config, tactile_weight)},
    {"tactile_weight_sd", FieldKind::kDouble, offsetof(hrt_session_config, tactile_weight_sd)},
    {"motor_variance_deg2", FieldKind::kDouble, offsetof(hrt_session_config, motor_variance_deg2)},
    {"sensory_variance_deg2", FieldKind::kDouble, offsetof(hrt_session_config, sensory_variance_deg2)},
    {"initial_variance_deg2", FieldKind::kDouble, offsetof(hrt_session_config, initial_variance_deg2)},
    {"tracker_noise_m", FieldKind::kDouble, offsetof(hrt_session_config, tracker_noise_m)},
    {"start_position_m", FieldKind::kVector3, offsetof(hrt_session_config, start_position_m)},
    {"plate_radius_m", FieldKind::kDouble, offsetof(hrt_session_config, plate_radius_m)},
    {"lift_height_m", FieldKind::kDouble, offsetof(hrt_session_config, lift_height_m)},
    {"bias_deg", FieldKind::kDouble, offsetof(hrt_session_config, bias_deg)},
    {"motor_variance_sd_deg2", FieldKind::kDouble, offsetof(hrt_session_config, motor_variance_sd_deg2)},
    {"max_felt_error_deg", FieldKind::kDouble, offsetof(hrt_session_config, max_felt_error_deg)},
    {"motion_bound_deg", FieldKind::kDouble, offsetof(hrt_session_config, motion_bound_deg)},
    {"tracker_latency_ns", FieldKind::kInt64, offsetof(hrt_session_config, tracker_latency_ns)},
    {"plate_scale", FieldKind::kDouble, offsetof(hrt_session_config, plate_scale)},
    {"registration_time_ns", FieldKind::kInt64, offsetof(hrt_session_config, registration_time_ns)},
    {"max_registration_age_ns", FieldKind::kInt64, offsetof(hrt_session_config, max_registration_age_ns)},
    {"max_registration_sd_deg", FieldKind::kDouble, offsetof(hrt_session_config, max_registration_sd_deg)},
    {"tracker_correlated_noise_m", FieldKind::kDouble, offsetof(hrt_session_config, tracker_correlated_noise_m)},
    {"tracker_correlation_s", FieldKind::kDouble, offsetof(hrt_session_config, tracker_correlation_s)},
    {"steering_rate_per_s", FieldKind::kDouble, offsetof(hrt_session_config, steering_rate_per_s)},
    {"steering_delay_s", FieldKind::kDouble, offsetof(hrt_session_config, steering_delay_s)},
};

constexpr Field kCommand[] = {
    {"flags", FieldKind::kUint32, offsetof(hrt_command, flags)},
    {"step", FieldKind::kInt64, offsetof(hrt_command, step)},
    {"plate_orientation_deg", FieldKind::kDouble, offsetof(hrt_command, plate_orientation_deg)},
    {"finger_direction_deg", FieldKind::kDouble, offsetof(hrt_command, finger_direction_deg)},
    {"perceived_direction_deg", FieldKind::kDouble, offsetof(hrt_command, perceived_direction_deg)},
    {"aimed_direction_deg", FieldKind::kDouble, offsetof(hrt_command, aimed_direction_deg)},
    {"distance_to_go_m", FieldKind::kDouble, offsetof(hrt_command, distance_to_go_m)},
    {"tactile_weight", FieldKind::kDouble, offsetof(hrt_command, tactile_weight)},
    {"tactile_weight_sd", FieldKind::kDouble, offsetof(hrt_command, tactile_weight_sd)},
    {"time_to_go_s", FieldKind::kDouble, offsetof(hrt_command, time_to_go_s)},
    {"felt_error_deg", FieldKind::kDouble, offsetof(hrt_command, felt_error_deg)},
    {"predicted_miss_deg", FieldKind::kDouble, offsetof(hrt_command, predicted_miss_deg)},
    {"normalised_innovation", FieldKind::kDouble, offsetof(hrt_command, normalised_innovation)},
    {"bearing_error_sd_deg", FieldKind::kDouble, offsetof(hrt_command, bearing_error_sd_deg)},
};

constexpr Field kSummary[] = {
    {"flags", FieldKind::kUint32, offsetof(hrt_reach_summary, flags)},
    {"samples", FieldKind::kInt64, offsetof(hrt_reach_summary, samples)},
    {"dropped_samples", FieldKind::kInt64, offsetof(hrt_reach_summary, dropped_samples)},
    {"steps", FieldKind::kInt64, offsetof(hrt_reach_summary, steps)},
    {"predicted_steps", FieldKind::kInt64, offsetof(hrt_reach_summary, predicted_steps)},
    {"saturated_steps", FieldKind::kInt64, offsetof(hrt_reach_summary, saturated_steps)},
    {"rate_limited_steps", FieldKind::kInt64, offsetof(hrt_reach_summary, rate_limited_steps)},
    {"final_direction_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, final_direction_deg)},
    {"final_miss_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, final_miss_deg)},
    {"perceived_direction_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, perceived_direction_deg)},
    {"perceived_error_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, perceived_error_deg)},
    {"distance_to_target_m", FieldKind::kDouble, offsetof(hrt_reach_summary, distance_to_target_m)},
    {"tactile_weight", FieldKind::kDouble, offsetof(hrt_reach_summary, tactile_weight)},
    {"tactile_weight_sd", FieldKind::kDouble, offsetof(hrt_reach_summary, tactile_weight_sd)},
    {"tracker_noise_m", FieldKind::kDouble, offsetof(hrt_reach_summary, tracker_noise_m)},
    {"motor_variance_deg2", FieldKind::kDouble, offsetof(hrt_reach_summary, motor_variance_deg2)},
    {"motor_variance_sd_deg2", FieldKind::kDouble, offsetof(hrt_reach_summary, motor_variance_sd_deg2)},
    {"bearing_error_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, bearing_error_deg)},
    {"peak_felt_error_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, peak_felt_error_deg)},
    {"rms_felt_error_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, rms_felt_error_deg)},
    {"normalised_innovation", FieldKind::kDouble, offsetof(hrt_reach_summary, normalised_innovation)},
    {"illusion_curve", FieldKind::kDouble, offsetof(hrt_reach_summary, illusion_curve)},
    {"illusion_curve_sd", FieldKind::kDouble, offsetof(hrt_reach_summary, illusion_curve_sd)},
    {"gain_per_s", FieldKind::kDouble, offsetof(hrt_reach_summary, gain_per_s)},
    {"gain_sd_per_s", FieldKind::kDouble, offsetof(hrt_reach_summary, gain_sd_per_s)},
    {"bias_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, bias_deg)},
    {"bias_sd_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, bias_sd_deg)},
    {"habit_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, habit_deg)},
    {"habit_sd_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, habit_sd_deg)},
    {"duration_s", FieldKind::kDouble, offsetof(hrt_reach_summary, duration_s)},
    {"bearing_error_sd_deg", FieldKind::kDouble, offsetof(hrt_reach_summary, bearing_error_sd_deg)},
};

constexpr Field kAuthority[] = {
    {"reachable", FieldKind::kUint32, offsetof(hrt_authority, reachable)},
    {"real_target", FieldKind::kInt64, offsetof(hrt_authority, real_target)},
    {"virtual_target", FieldKind::kInt64, offsetof(hrt_authority, virtual_target)},
    {"gap_deg", FieldKind::kDouble, offsetof(hrt_authority, gap_deg)},
    {"max_gap_deg", FieldKind::kDouble, offsetof(hrt_authority, max_gap_deg)},
    {"margin_deg", FieldKind::kDouble, offsetof(hrt_authority, margin_deg)},
    {"plate_orientation_deg", FieldKind::kDouble, offsetof(hrt_authority, plate_orientation_deg)},
    {"settling_direction_deg", FieldKind::kDouble, offsetof(hrt_authority, settling_direction_deg)},
    {"paper_max_gap_deg", FieldKind::kDouble, offsetof(hrt_authority, paper_max_gap_deg)},
};

constexpr Field kCalibration[] = {
    {"slides_turning", FieldKind::kUint32, offsetof(hrt_calibration_result, slides_turning)},
    {"trials", FieldKind::kUint32, offsetof(hrt_calibration_result, trials)},
    {"trials_used", FieldKind::kUint32, offsetof(hrt_calibration_result, trials_used)},
    INTERVAL(hrt_calibration_result, tactile_weight),
    INTERVAL(hrt_calibration_result, bias_deg),
    INTERVAL(hrt_calibration_result, motor_variance_deg2),
    INTERVAL(hrt_calibration_result, sensory_variance_deg2),
    INTERVAL(hrt_calibration_result, tracker_noise_m),
    {"illusion", FieldKind::kUint32, offsetof(hrt_calibration_result, illusion), "Linear,Saturating,Sine,Tanh,Dead Band,Unequal,Cubic,None"},
    {"lack_of_fit", FieldKind::kUint32, offsetof(hrt_calibration_result, lack_of_fit)},
    {"slides_outlying", FieldKind::kUint32, offsetof(hrt_calibration_result, slides_outlying)},
    {"slides_along_ridges", FieldKind::kUint32, offsetof(hrt_calibration_result, slides_along_ridges)},
    {"illusion_scale_deg", FieldKind::kDouble, offsetof(hrt_calibration_result, illusion_scale_deg)},
    {"peak_offset_deg", FieldKind::kDouble, offsetof(hrt_calibration_result, peak_offset_deg)},
    INTERVAL(hrt_calibration_result, person_weight),
    INTERVAL(hrt_calibration_result, person_curve),
    {"weight_curve_correlation", FieldKind::kDouble, offsetof(hrt_calibration_result, weight_curve_correlation)},
    INTERVAL(hrt_calibration_result, max_gap_deg),
    INTERVAL(hrt_calibration_result, habit_deg),
    INTERVAL(hrt_calibration_result, correlated_noise_m),
    INTERVAL(hrt_calibration_result, noise_correlation_s),
    {"angle_p", FieldKind::kDouble, offsetof(hrt_calibration_result, angle_p)},
    {"order_p", FieldKind::kDouble, offsetof(hrt_calibration_result, order_p)},
    {"path_p", FieldKind::kDouble, offsetof(hrt_calibration_result, path_p)},
    INTERVAL(hrt_calibration_result, steering_rate_per_s),
    INTERVAL(hrt_calibration_result, steering_delay_s),
    {"steering_p", FieldKind::kDouble, offsetof(hrt_calibration_result, steering_p)},
};

constexpr Field kSlide[] = {
    {"verdict", FieldKind::kUint32, offsetof(hrt_calibration_slide, verdict), "Used,Outlying,Along Ridges"},
    {"trial", FieldKind::kUint32, offsetof(hrt_calibration_slide, trial)},
    {"plate_deg", FieldKind::kDouble, offsetof(hrt_calibration_slide, plate_deg)},
    {"direction_deg", FieldKind::kDouble, offsetof(hrt_calibration_slide, direction_deg)},
    {"fitted_deg", FieldKind::kDouble, offsetof(hrt_calibration_slide, fitted_deg)},
    {"residual_deg", FieldKind::kDouble, offsetof(hrt_calibration_slide, residual_deg)},
};

constexpr Field kComparison[] = {
    {"differing", FieldKind::kUint32, offsetof(hrt_calibration_comparison, differing)},
    INTERVAL(hrt_calibration_comparison, tactile_weight),
    INTERVAL(hrt_calibration_comparison, max_gap_deg),
    INTERVAL(hrt_calibration_comparison, bias_deg),
    INTERVAL(hrt_calibration_comparison, habit_deg),
    INTERVAL(hrt_calibration_comparison, tracker_noise_m),
    INTERVAL(hrt_calibration_comparison, steering_rate_per_s),
    INTERVAL(hrt_calibration_comparison, steering_delay_s),
};

constexpr Field kRegistration[] = {
    {"verdict", FieldKind::kUint32, offsetof(hrt_registration, verdict), "Holds:1,Too Few:2,Degenerate:3,Inconsistent:4,Upside Down:5"},
    {"touches", FieldKind::kUint32, offsetof(hrt_registration, touches)},
    {"left_out", FieldKind::kInt32, offsetof(hrt_registration, left_out)},
    {"plate_position_m", FieldKind::kVector3, offsetof(hrt_registration, plate_position_m)},
    {"plate_scale", FieldKind::kDouble, offsetof(hrt_registration, plate_scale)},
    {"touch_sd_m", FieldKind::kDouble, offsetof(hrt_registration, touch_sd_m)},
    {"residual_m", FieldKind::kDouble, offsetof(hrt_registration, residual_m)},
    {"turn_sd_deg", FieldKind::kDouble, offsetof(hrt_registration, turn_sd_deg)},
};

constexpr Field kTouch[] = {
    {"holds", FieldKind::kUint32, offsetof(hrt_touch_check, holds)},
    {"distance_m", FieldKind::kDouble, offsetof(hrt_touch_check, distance_m)},
    {"allowed_m", FieldKind::kDouble, offsetof(hrt_touch_check, allowed_m)},
};

constexpr Field kFingertip[] = {
    {"known", FieldKind::kUint32, offsetof(hrt_fingertip, known)},
    {"offset_m", FieldKind::kVector3, offsetof(hrt_fingertip, offset_m)},
    {"sd_m", FieldKind::kVector3, offsetof(hrt_fingertip, sd_m)},
};

constexpr Field kRecording[] = {
    {"system_error", FieldKind::kInt32, offsetof(hrt_recording_status, system_error)},
    {"rows_written", FieldKind::kInt64, offsetof(hrt_recording_status, rows_written)},
    {"rows_lost", FieldKind::kInt64, offsetof(hrt_recording_status, rows_lost)},
};

constexpr Field kDevice[] = {
    {"state", FieldKind::kUint32, offsetof(hrt_plate_report, state), "Opening:1,Ready:2,Failed:3"},
    {"fault", FieldKind::kUint32, offsetof(hrt_plate_report, fault), "None,Line,No Answer,Unplugged,Silent,No Report,Limits,Stuck,Restarted,Emergency,Device,Protocol,Internal"},
    {"flags", FieldKind::kUint32, offsetof(hrt_plate_report, flags)},
    {"orientation_deg", FieldKind::kDouble, offsetof(hrt_plate_report, orientation_deg)},
    {"command_deg", FieldKind::kDouble, offsetof(hrt_plate_report, command_deg)},
    {"age_ns", FieldKind::kInt64, offsetof(hrt_plate_report, age_ns)},
    {"latency_ns", FieldKind::kInt64, offsetof(hrt_plate_report, latency_ns)},
    {"round_trip_ns", FieldKind::kInt64, offsetof(hrt_plate_report, round_trip_ns)},
    {"max_speed_deg_s", FieldKind::kDouble, offsetof(hrt_plate_report, max_speed_deg_s)},
    {"lower_stop_deg", FieldKind::kDouble, offsetof(hrt_plate_report, lower_stop_deg)},
    {"upper_stop_deg", FieldKind::kDouble, offsetof(hrt_plate_report, upper_stop_deg)},
    {"refused_messages", FieldKind::kInt64, offsetof(hrt_plate_report, refused_messages)},
};

constexpr Constant kConstants[] = {
    {"Assign", "ASSIGN_EXCLUSIVE", 1, true},
    {"Illusion", "ILLUSION_LINEAR", 0, false},
    {"Illusion", "ILLUSION_SATURATING", 1, false},
    {"Illusion", "ILLUSION_SINE", 2, false},
    {"Illusion", "ILLUSION_TANH", 3, false},
    {"Illusion", "ILLUSION_DEAD_BAND", 4, false},
    {"Illusion", "ILLUSION_UNEQUAL", 5, false},
    {"Illusion", "ILLUSION_CUBIC", 6, false},
    {"Illusion", "ILLUSION_NONE", 7, false},
    {"LackOfFit", "LACK_OF_FIT_ANGLE", 1, true},
    {"LackOfFit", "LACK_OF_FIT_ORDER", 2, true},
    {"LackOfFit", "LACK_OF_FIT_PATH", 4, true},
    {"Slide", "SLIDE_USED", 0, false},
    {"Slide", "SLIDE_OUTLYING", 1, false},
    {"Slide", "SLIDE_ALONG_RIDGES", 2, false},
    {"Differs", "DIFFERS_TACTILE_WEIGHT", 1, true},
    {"Differs", "DIFFERS_MAX_GAP", 2, true},
    {"Differs", "DIFFERS_BIAS", 4, true},
    {"Differs", "DIFFERS_HABIT", 8, true},
    {"Differs", "DIFFERS_TRACKER_NOISE", 16, true},
    {"Differs", "DIFFERS_STEERING_RATE", 32, true},
    {"Differs", "DIFFERS_STEERING_DELAY", 64, true},
    {"Condition", "CONDITION_PLATE", 1, true},
    {"Condition", "CONDITION_TRACKER", 2, true},
    {"Reach", "REACH_PLATE_ORIENTATION", 1, true},
    {"Reach", "REACH_START_AT_FINGER", 2, true},
    {"Sample", "SAMPLE_DIRECTION", 1, true},
    {"Sample", "SAMPLE_PLATE_POSITION", 2, true},
    {"Sample", "SAMPLE_PLATE_ORIENTATION", 4, true},
    {"Sample", "SAMPLE_LIFTED", 8, true},
    {"Sample", "SAMPLE_WORLD_POSITION", 16, true},
    {"Sample", "SAMPLE_PLATE_POSE", 32, true},
    {"Command", "COMMAND_HELD", 1, true},
    {"Command", "COMMAND_PREDICTED", 2, true},
    {"Command", "COMMAND_SATURATED", 4, true},
    {"Command", "COMMAND_RATE_LIMITED", 8, true},
    {"Command", "COMMAND_UNREACHABLE", 16, true},
    {"Command", "COMMAND_LIFTED", 32, true},
    {"Command", "COMMAND_OFF_PLATE", 64, true},
    {"Command", "COMMAND_MISFIT", 128, true},
    {"Command", "COMMAND_OFF_TARGET", 256, true},
    {"Command", "COMMAND_RESTING", 512, true},
    {"Command", "COMMAND_APPROXIMATE", 1024, true},
    {"Command", "COMMAND_FAULT", 2048, true},
    {"Command", "COMMAND_REGISTRATION", 4096, true},
    {"Ending", "ENDING_COMPLETE", 0, false},
    {"Ending", "ENDING_CUT", 1, false},
    {"Ending", "ENDING_LOST_ROWS", 2, false},
    {"Ending", "ENDING_ALTERED", 3, false},
    {"Register", "REGISTER_SCALE", 1, true},
    {"Register", "REGISTER_UP", 2, true},
    {"Registration", "REGISTRATION_HOLDS", 1, false},
    {"Registration", "REGISTRATION_TOO_FEW", 2, false},
    {"Registration", "REGISTRATION_DEGENERATE", 3, false},
    {"Registration", "REGISTRATION_INCONSISTENT", 4, false},
    {"Registration", "REGISTRATION_UPSIDE_DOWN", 5, false},
    {"Control", "CONTROL_MPC", 0, false},
    {"Control", "CONTROL_FIXED_PLATE", 1, false},
    {"Guidance", "GUIDANCE_FIXED_DIRECTION", 0, false},
    {"Guidance", "GUIDANCE_ARRIVAL", 1, false},
    {"Guidance", "GUIDANCE_LINE_OF_SIGHT", 1, false},
    {"Adaptation", "ADAPTATION_OFF", 0, false},
    {"Adaptation", "ADAPTATION_REACH", 1, false},
    {"Adaptation", "ADAPTATION_CARRIED", 2, false},
    {"Session", "SESSION_PLATE_WAITS", 1, true},
    {"Session", "SESSION_REGISTERED", 2, true},
    {"State", "STATE_READY", 1, true},
    {"State", "STATE_REACHING", 2, true},
    {"State", "STATE_CALIBRATING", 4, true},
    {"State", "STATE_RECORDING", 8, true},
    {"Target", "TARGET_REAL", 1, false},
    {"Target", "TARGET_VIRTUAL", 2, false},
    {"Place", "PLACE_DIRECTION", 1, false},
    {"Place", "PLACE_PLATE_POSITION", 2, false},
    {"Place", "PLACE_WORLD_POSITION", 3, false},
    {"PlateState", "PLATE_STATE_OPENING", 1, false},
    {"PlateState", "PLATE_STATE_READY", 2, false},
    {"PlateState", "PLATE_STATE_FAILED", 3, false},
    {"PlateFault", "PLATE_FAULT_NONE", 0, false},
    {"PlateFault", "PLATE_FAULT_LINE", 1, false},
    {"PlateFault", "PLATE_FAULT_NO_ANSWER", 2, false},
    {"PlateFault", "PLATE_FAULT_UNPLUGGED", 3, false},
    {"PlateFault", "PLATE_FAULT_SILENT", 4, false},
    {"PlateFault", "PLATE_FAULT_NO_REPORT", 5, false},
    {"PlateFault", "PLATE_FAULT_LIMITS", 6, false},
    {"PlateFault", "PLATE_FAULT_STUCK", 7, false},
    {"PlateFault", "PLATE_FAULT_RESTARTED", 8, false},
    {"PlateFault", "PLATE_FAULT_EMERGENCY", 9, false},
    {"PlateFault", "PLATE_FAULT_DEVICE", 10, false},
    {"PlateFault", "PLATE_FAULT_PROTOCOL", 11, false},
    {"PlateFault", "PLATE_FAULT_INTERNAL", 12, false},
    {"PlateReport", "PLATE_REPORT_ORIENTATION", 1, true},
    {"PlateReport", "PLATE_REPORT_MEASURED", 2, true},
    {"PlateReport", "PLATE_REPORT_ROUND_TRIP", 4, true},
    {"PlateReport", "PLATE_REPORT_COMMANDED", 8, true},
    {"PlateReport", "PLATE_REPORT_HOST_SILENT", 16, true},
};

}  // namespace

constinit const std::span<const Field> config_fields = kConfig;
constinit const std::span<const Field> command_fields = kCommand;
constinit const std::span<const Field> summary_fields = kSummary;
constinit const std::span<const Field> authority_fields = kAuthority;
constinit const std::span<const Field> calibration_fields = kCalibration;
constinit const std::span<const Field> slide_fields = kSlide;
constinit const std::span<const Field> comparison_fields = kComparison;
constinit const std::span<const Field> registration_fields = kRegistration;
constinit const std::span<const Field> touch_fields = kTouch;
constinit const std::span<const Field> fingertip_fields = kFingertip;
constinit const std::span<const Field> recording_fields = kRecording;
constinit const std::span<const Field> device_fields = kDevice;
constinit const std::span<const Constant> constants = kConstants;

void copy_hidden(const hrt_session_config& from, hrt_session_config& to) {
  std::memcpy(to.person_mean, from.person_mean, sizeof to.person_mean);
  std::memcpy(to.person_covariance, from.person_covariance, sizeof to.person_covariance);
  std::memcpy(to.plate_covariance, from.plate_covariance, sizeof to.plate_covariance);
}

}  // namespace hrt_godot
