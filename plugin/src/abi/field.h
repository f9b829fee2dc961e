// Properties of the fields of C structs: name, range, use in profiles. The header generated/fields.h, which
// plugin/bindings/generate writes, specialises Fields for each struct, and `defaults` for configurations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace hrt::plugin {

enum class FieldKind : std::uint8_t { free, number, flags, reserved };

template <class S, class T>
struct Field {
  using Element = std::remove_extent_t<T>;
  using Number = std::conditional_t<std::is_arithmetic_v<Element>, Element, int>;
  const char* name;
  std::size_t offset;
  FieldKind kind = FieldKind::free;
  Number low = 0, high = 0;  ///< range of a number, or of each element of an array; of flags, `high` has all known bits
  bool zero = false;         ///< 0 is allowed in addition to the range
  bool (*in_profile)(const S&) = nullptr;  ///< true if profiles contain the field; null: they never do
  bool optional = false;                   ///< a profile without this field sets it to its default

  T& of(S& values) const { return *reinterpret_cast<T*>(reinterpret_cast<char*>(&values) + offset); }
  const T& of(const S& values) const { return of(const_cast<S&>(values)); }
};

/// Name and range of one element of an array.
struct Element {
  const char* name;
  double low, high;
};

/// A function of the C interface, and the names of its parameters.
struct Call {
  const char* name;
  std::string_view parameters;
};

/// Has a constant of type Field for each field of S except `struct_size`, and the tuple `all` of these constants.
template <class S>
struct Fields;
template <class S>
inline constexpr S defaults{};

template <class S>
bool always(const S&) {
  return true;
}

template <class T>
bool is_not_zero(const T& value) {
  if constexpr (std::is_array_v<T>) {
    for (const auto& element : value)
      if (element != 0) return true;
    return false;
  } else {
    return value != 0;
  }
}

template <class S, class T, std::size_t offset>
bool is_set(const S& values) {
  return is_not_zero(Field<S, T>{.name = "", .offset = offset}.of(values));
}

/// Calls `visit` for every field of the struct S, except reserved fields.
template <class S, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... field) { ((field.kind == FieldKind::reserved ? void() : visit(field)), ...); },
             Fields<S>::all);
}

}  // namespace hrt::plugin
