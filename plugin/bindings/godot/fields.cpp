#include "fields.h"

#include <array>
#include <cstring>
#include <limits>

namespace hrt_godot {
namespace {

template <typename Member>
constexpr FieldKind kind_of() {
  if constexpr (std::is_same_v<Member, uint32_t>) return FieldKind::kUint32;
  if constexpr (std::is_same_v<Member, int64_t>) return FieldKind::kInt64;
  if constexpr (std::is_same_v<Member, double>) return FieldKind::kDouble;
  if constexpr (std::is_same_v<Member, hrt_target>) return FieldKind::kTarget;
  if constexpr (std::is_same_v<Member, double[3]>) return FieldKind::kVector3;
}

constexpr size_t size_of(FieldKind kind) {
  switch (kind) {
    case FieldKind::kUint32:
      return 4;
    case FieldKind::kVector3:
      return 24;
    default:
      return 8;
  }
}

/** Whether the fields and `left_out` bytes are all of a struct, which has no padding, but its struct_size. */
template <size_t N>
constexpr bool complete(const std::array<Field, N>& fields, size_t left_out, size_t struct_size) {
  size_t size = sizeof(uint32_t) + left_out;
  for (const Field& field : fields) size += size_of(field.kind);
  return size == struct_size;
}

template <typename Member>
constexpr Field make_field(const char* name, size_t offset, const char* choices = nullptr) {
  return {name, kind_of<Member>(), offset, choices};
}

#define FIELD(type, member) make_field<decltype(type::member)>(#member, offsetof(type, member))
#define CHOICE(type, member, choices) \
  make_field<decltype(type::member)>(#member, offsetof(type, member), choices)

using Config = hrt_session_config;
constexpr std::array kConfig{
    FIELD(Config, horizon),
    FIELD(Config, step_period_ns),
    CHOICE(Config, control, "MPC,Fixed Plate"),
    CHOICE(Config, guidance, "Fixed Direction,Arrival"),
    CHOICE(Config, adaptation, "Off,Reach,Carried"),
    FIELD(Config, flags),
    FIELD(Config, perceived_weight),
    FIELD(Config, actual_weight),
    FIELD(Config, plate_bound_deg),
    FIELD(Config, plate_max_speed_deg_s),
    FIELD(Config, plate_max_acceleration_deg_s2),
    FIELD(Config, plate_latency_ns),
    FIELD(Config, plate_lower_stop_deg),
    FIELD(Config, plate_upper_stop_deg),
    FIELD(Config, fixed_plate_orientation_deg),
    FIELD(Config, tactile_weight),
    FIELD(Config, tactile_weight_sd),
    FIELD(Config, bias_deg),
    FIELD(Config, motor_variance_deg2),
    FIELD(Config, motor_variance_sd_deg2),
    FIELD(Config, sensory_variance_deg2),
    FIELD(Config, initial_variance_deg2),
    FIELD(Config, tracker_noise_m),
    FIELD(Config, start_position_m),
    FIELD(Config, plate_radius_m),
    FIELD(Config, lift_height_m),
    FIELD(Config, max_felt_error_deg),
    FIELD(Config, motion_bound_deg),
    FIELD(Config, tracker_latency_ns),
};
static_assert(complete(kConfig,
                       sizeof(Config::plate_position_m) + sizeof(Config::plate_rotation) +
                           sizeof(Config::person_mean) + sizeof(Config::person_covariance),
                       sizeof(Config)));

using Command = hrt_command;
constexpr std::array kCommand{
    FIELD(Command, flags),
    FIELD(Command, step),
    FIELD(Command, plate_orientation_deg),
    FIELD(Command, finger_direction_deg),
    FIELD(Command, perceived_direction_deg),
    FIELD(Command, aimed_direction_deg),
    FIELD(Command, distance_to_go_m),
    FIELD(Command, tactile_weight),
    FIELD(Command, tactile_weight_sd),
    FIELD(Command, time_to_go_s),
    FIELD(Command, felt_error_deg),
    FIELD(Command, predicted_miss_deg),
    FIELD(Command, normalised_innovation),
};
static_assert(complete(kCommand, 0, sizeof(Command)));

using Summary = hrt_reach_summary;
constexpr std::array kSummary{
    FIELD(Summary, flags),
    FIELD(Summary, samples),
    FIELD(Summary, dropped_samples),
    FIELD(Summary, steps),
    FIELD(Summary, predicted_steps),
    FIELD(Summary, saturated_steps),
    FIELD(Summary, rate_limited_steps),
    FIELD(Summary, final_direction_deg),
    FIELD(Summary, final_miss_deg),
    FIELD(Summary, perceived_direction_deg),
    FIELD(Summary, perceived_error_deg),
    FIELD(Summary, distance_to_target_m),
    FIELD(Summary, tactile_weight),
    FIELD(Summary, tactile_weight_sd),
    FIELD(Summary, tracker_noise_m),
    FIELD(Summary, motor_variance_deg2),
    FIELD(Summary, motor_variance_sd_deg2),
    FIELD(Summary, bearing_error_deg),
    FIELD(Summary, peak_felt_error_deg),
    FIELD(Summary, rms_felt_error_deg),
    FIELD(Summary, normalised_innovation),
    FIELD(Summary, illusion_curve),
    FIELD(Summary, illusion_curve_sd),
    FIELD(Summary, gain_per_s),
    FIELD(Summary, gain_sd_per_s),
    FIELD(Summary, bias_deg),
    FIELD(Summary, bias_sd_deg),
    FIELD(Summary, habit_deg),
    FIELD(Summary, habit_sd_deg),
    FIELD(Summary, duration_s),
};
static_assert(complete(kSummary, 0, sizeof(Summary)));

using Authority = hrt_authority;
constexpr std::array kAuthority{
    FIELD(Authority, reachable),
    FIELD(Authority, real_target),
    FIELD(Authority, virtual_target),
    FIELD(Authority, gap_deg),
    FIELD(Authority, largest_gap_deg),
    FIELD(Authority, margin_deg),
    FIELD(Authority, plate_orientation_deg),
    FIELD(Authority, settling_direction_deg),
    FIELD(Authority, paper_largest_gap_deg),
};
static_assert(complete(kAuthority, 0, sizeof(Authority)));

#define PART(type, member, part, suffix)                   \
  make_field<decltype(hrt_interval::part)>(#member suffix, \
                                           offsetof(type, member) + offsetof(hrt_interval, part))
#define INTERVAL(type, member)                                                                             \
  PART(type, member, value, ""), PART(type, member, lower, "_lower"), PART(type, member, upper, "_upper"), \
      PART(type, member, known, "_known")

using Calibration = hrt_calibration_result;
constexpr std::array kCalibration{
    FIELD(Calibration, trials),
    FIELD(Calibration, trials_used),
    INTERVAL(Calibration, tactile_weight),
    INTERVAL(Calibration, bias_deg),
    INTERVAL(Calibration, motor_variance_deg2),
    INTERVAL(Calibration, sensory_variance_deg2),
    INTERVAL(Calibration, tracker_noise_m),
};
static_assert(complete(kCalibration, sizeof(Calibration::reserved) + 5 * sizeof(hrt_interval::reserved),
                       sizeof(Calibration)));

#undef INTERVAL
#undef PART
#undef FIELD
#undef CHOICE

template <typename T>
T read(const void* object, const Field& field) {
  T value;
  std::memcpy(&value, static_cast<const char*>(object) + field.offset, sizeof value);
  return value;
}

template <typename T>
void write(void* object, const Field& field, const T& value) {
  std::memcpy(static_cast<char*>(object) + field.offset, &value, sizeof value);
}

}  // namespace

std::span<const Field> config_fields() {
  return kConfig;
}
std::span<const Field> command_fields() {
  return kCommand;
}
std::span<const Field> summary_fields() {
  return kSummary;
}
std::span<const Field> authority_fields() {
  return kAuthority;
}

std::span<const Field> calibration_fields() {
  return kCalibration;
}

Type type_of(const Field& field) {
  switch (field.kind) {
    case FieldKind::kDouble:
      return Type::kReal;
    case FieldKind::kVector3:
      return Type::kVector3;
    default:
      return Type::kInt;
  }
}

Value get_field(const void* object, const Field& field) {
  switch (field.kind) {
    case FieldKind::kUint32:
      return int64_t{read<uint32_t>(object, field)};
    case FieldKind::kDouble:
      return read<double>(object, field);
    case FieldKind::kVector3:
      return read<Vector3>(object, field);
    case FieldKind::kInt64:
    case FieldKind::kTarget:
      return read<int64_t>(object, field);
  }
  return {};
}

bool set_field(void* object, const Field& field, const Value& value) {
  if (field.kind == FieldKind::kVector3) {
    const Vector3* vector = std::get_if<Vector3>(&value);
    if (vector) write(object, field, *vector);
    return vector;
  }
  const int64_t* integer = std::get_if<int64_t>(&value);
  if (field.kind == FieldKind::kDouble) {
    const double* real = std::get_if<double>(&value);
    if (!real && !integer) return false;
    write(object, field, real ? *real : static_cast<double>(*integer));
    return true;
  }
  if (!integer) return false;
  if (field.kind == FieldKind::kUint32) {
    if (*integer < 0 || *integer > std::numeric_limits<uint32_t>::max()) return false;
    write(object, field, static_cast<uint32_t>(*integer));
  } else {
    write(object, field, *integer);
  }
  return true;
}

bool is_different(const void* object, const void* other, const Field& field) {
  return std::memcmp(static_cast<const char*>(object) + field.offset,
                     static_cast<const char*>(other) + field.offset, size_of(field.kind)) != 0;
}

Record to_record(const void* object, std::span<const Field> fields) {
  Record record;
  record.reserve(fields.size());
  for (const Field& field : fields) {
    const Value value = get_field(object, field);
    if (const double* real = std::get_if<double>(&value)) record.emplace_back(field.name, *real);
    if (const int64_t* integer = std::get_if<int64_t>(&value)) record.emplace_back(field.name, *integer);
  }
  return record;
}

}  // namespace hrt_godot
