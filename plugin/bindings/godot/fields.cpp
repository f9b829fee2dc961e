#include "fields.h"

#include <cstring>
#include <limits>

namespace hrt_godot {
namespace {

constexpr size_t size_of(FieldKind kind) {
  switch (kind) {
    case FieldKind::kInt32:
    case FieldKind::kUint32:
      return 4;
    case FieldKind::kVector3:
      return 24;
    default:
      return 8;
  }
}

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

/** False, and nothing is written, if the number is not one of T. */
template <typename T>
bool write_as(void* object, const Field& field, int64_t number) {
  if (number < std::numeric_limits<T>::min() || number > std::numeric_limits<T>::max()) return false;
  write(object, field, static_cast<T>(number));
  return true;
}

}  // namespace

Type type_of(const Field& field) {
  switch (field.kind) {
    case FieldKind::kDouble:
      return Type::kReal;
    case FieldKind::kVector3:
      return Type::kVector3;
    case FieldKind::kText:
      return Type::kString;
    default:
      return Type::kInt;
  }
}

Value get_field(const void* object, const Field& field) {
  switch (field.kind) {
    case FieldKind::kInt32:
      return int64_t{read<int32_t>(object, field)};
    case FieldKind::kUint32:
      return int64_t{read<uint32_t>(object, field)};
    case FieldKind::kDouble:
      return read<double>(object, field);
    case FieldKind::kVector3:
      return read<Vector3>(object, field);
    case FieldKind::kInt64:
      return read<int64_t>(object, field);
    case FieldKind::kText:
      return std::string(static_cast<const char*>(object) + field.offset);
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
  if (field.kind == FieldKind::kInt32) return write_as<int32_t>(object, field, *integer);
  if (field.kind == FieldKind::kUint32) return write_as<uint32_t>(object, field, *integer);
  write(object, field, *integer);
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
    if (const std::string* text = std::get_if<std::string>(&value)) record.emplace_back(field.name, *text);
    if (const int64_t* integer = std::get_if<int64_t>(&value)) record.emplace_back(field.name, *integer);
    if (const Vector3* vector = std::get_if<Vector3>(&value)) record.emplace_back(field.name, *vector);
  }
  return record;
}

}  // namespace hrt_godot
