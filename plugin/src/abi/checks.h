#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "haptic_retargeting/reach.h"
#include "plugin/src/abi/error.h"
#include "plugin/src/abi/field.h"
#include "plugin/src/abi/utf8.h"

namespace hrt::plugin {

/// Largest accepted struct_size, in bytes: every version of a struct is smaller.
inline constexpr std::uint32_t max_struct_size = 4096;

inline hrt_result fail_of_null(const char* name) {
  return fail(HRT_ERROR_NULL_ARGUMENT, name, " is null; pass a valid pointer");
}

template <class Struct>
hrt_result check_struct_size(const char* name, std::uint32_t size) {
  constexpr std::uint32_t alignment = alignof(Struct);
  if (size >= sizeof(Struct) && size <= max_struct_size && size % alignment == 0) return HRT_OK;
  return fail(HRT_ERROR_STRUCT_SIZE, name, ": struct_size is ", size, "; allowed: multiples of ", alignment, " from ",
              sizeof(Struct), ", the size in this library, to ", max_struct_size,
              ". Build with the headers of this library, and set struct_size by the _init() function of the struct");
}

/// Copies a struct of this version, or of a later version whose additional bytes are 0, into `*known`.
template <class Struct>
hrt_result read_struct(const char* name, const Struct* given, Struct* known) {
  if (!given) return fail_of_null(name);
  std::uint32_t size;
  std::memcpy(&size, given, sizeof size);
  HRT_RETURN_IF_FAILED(check_struct_size<Struct>(name, size));
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  for (std::uint32_t i = sizeof(Struct); i < size; ++i) {
    if (bytes[i] != 0)
      return fail(HRT_ERROR_STRUCT_SIZE, name, ": byte ", i, " is not 0, but this library knows only ", sizeof(Struct),
                  " bytes; set all further bytes to 0, or update the library");
  }
  std::memcpy(known, given, sizeof(Struct));
  known->struct_size = sizeof(Struct);
  return HRT_OK;
}

/// Reads a configuration like read_struct(). A null pointer means the defaults.
template <class Struct>
hrt_result read_configuration(const char* name, const Struct* given, Struct* known) {
  *known = defaults<Struct>;
  return given ? read_struct(name, given, known) : HRT_OK;
}

template <class Struct>
hrt_result check_output(const char* name, const Struct* out) {
  return out ? check_struct_size<Struct>(name, out->struct_size) : fail_of_null(name);
}

/// Sets the bytes after the known fields of a struct of `size` bytes to 0, and struct_size to `size`.
template <class Struct>
void end_struct(std::uint32_t size, Struct* out) {
  std::memset(reinterpret_cast<char*>(out) + sizeof(Struct), 0, size - sizeof(Struct));
  std::memcpy(reinterpret_cast<char*>(out), &size, sizeof size);
}

template <class Struct>
void write_struct_of(std::uint32_t size, const Struct& known, void* out) {
  std::memcpy(out, &known, sizeof(Struct));
  end_struct(size, static_cast<Struct*>(out));
}

template <class Struct>
void write_struct(const Struct& known, Struct* out) {
  write_struct_of(out->struct_size, known, out);
}

template <class Number>
hrt_result check_range(const char* field, Number value, Number low, Number high, const char* besides = "") {
  if (value >= low && value <= high) return HRT_OK;  // false for NaN
  return fail(HRT_ERROR_OUT_OF_RANGE, field, " is ", value, "; allowed: ", besides, low, " to ", high);
}

inline hrt_result check_zero(const char* field, std::uint32_t value) {
  if (value == 0) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, field, " is ", value, "; allowed: 0");
}

/// Writes a text into a caller's buffer; if `capacity` is 0, only its length. `what` names the text in the error for a
/// buffer that is too small.
inline hrt_result write_text(const char* what, std::string_view text, std::uint64_t capacity, char* out_text,
                             std::uint64_t* out_length) {
  if (!out_length) return fail_of_null("out_length");
  if (capacity > 0) {
    if (!out_text) return fail_of_null("out_text");
    if (capacity <= text.size())
      return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; allowed: at least ", text.size() + 1,
                  " for ", what, " with its terminating zero, or 0 for its length only");
    std::memcpy(out_text, text.data(), text.size());
    out_text[text.size()] = '\0';
  }
  *out_length = text.size();
  return HRT_OK;
}

inline hrt_result check_flags(std::uint32_t flags, std::uint32_t known) {
  if ((flags & ~known) == 0) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", flags, "; allowed: the bits of ", known, ". Clear the others, ",
              flags & ~known);
}

template <class S, class T>
hrt_result check_value(const char* name, const Field<S, T>& field, const T& value) {
  if constexpr (std::is_array_v<T>) {
    if (field.kind == FieldKind::free) return HRT_OK;
    for (std::size_t i = 0; i < std::size(value); ++i) {
      if (value[i] >= field.low && value[i] <= field.high) continue;  // false for NaN
      return fail(HRT_ERROR_OUT_OF_RANGE, name, "[", i, "] is ", value[i], "; allowed: ", field.low, " to ",
                  field.high);
    }
    return HRT_OK;
  } else if constexpr (std::is_arithmetic_v<T>) {
    if (field.kind == FieldKind::free || (field.zero && value == 0)) return HRT_OK;
    if constexpr (std::is_same_v<T, std::uint32_t>) {
      if (field.kind == FieldKind::flags) return check_flags(value, field.high);
      if (field.kind == FieldKind::reserved) return check_zero(name, value);
    }
    return check_range(name, value, field.low, field.high, field.zero ? "0, or " : "");
  } else {
    return HRT_OK;
  }
}

template <class S, class T>
hrt_result check_field(const S& values, const Field<S, T>& field) {
  return check_value(field.name, field, field.of(values));
}

template <class S>
hrt_result check_fields(const S& values) {
  hrt_result result = HRT_OK;
  const auto is_fine = [&](const auto& field) { return (result = check_field(values, field)) == HRT_OK; };
  std::apply([&](const auto&... field) { (void)(is_fine(field) && ...); }, Fields<S>::all);
  return result;
}

/// Checks a name in a struct of the host: UTF-8 without control characters. Sets the bytes after the name to 0.
inline hrt_result check_name(const char* field, char (&name)[HRT_NAME_SIZE]) {
  const auto* end = static_cast<const char*>(std::memchr(name, '\0', sizeof name));
  if (!end)
    return fail(HRT_ERROR_OUT_OF_RANGE, field, " has no terminating zero; allowed: up to ", sizeof name - 1, " bytes");
  const auto length = static_cast<std::size_t>(end - name);
  std::memset(name + length, 0, sizeof name - length);
  const std::string_view text(name, length);
  if (!is_utf8(text)) return fail(HRT_ERROR_OUT_OF_RANGE, field, " is not UTF-8; convert it to UTF-8");
  for (std::size_t i = 0; i < length; ++i) {
    if (begins_with_control_character(text.substr(i)))
      return fail(HRT_ERROR_OUT_OF_RANGE, field, " has a control character at byte ", i, "; remove it");
  }
  return HRT_OK;
}

}  // namespace hrt::plugin
