// What went wrong: a code for the caller, and a text for hrt_last_error(). No heap, no lock, no locale:
// real-time calls report errors too.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>
#include <type_traits>

#include "haptic_retargeting/base.h"

namespace hrt::plugin {

/// One line, cut off at the end of its buffer.
class ErrorText {
 public:
  void clear() { text_[length_ = 0] = '\0'; }
  const char* c_str() const { return text_; }

  void append(std::string_view part) {
    const std::size_t room = sizeof text_ - 1 - length_;
    const std::size_t taken = part.size() < room ? part.size() : room;
    std::memcpy(text_ + length_, part.data(), taken);
    text_[length_ += taken] = '\0';
  }

  template <class Number>
  requires std::is_arithmetic_v<Number>
  void append(Number number) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
    if (error == std::errc()) append({digits, static_cast<std::size_t>(end - digits)});
  }

 private:
  char text_[240] = "";
  std::size_t length_ = 0;
};

struct ThreadError {
  const char* call = "";  // the entry point that this thread is in
  ErrorText text;
};

extern thread_local constinit ThreadError thread_error;

/// Sets the text of hrt_last_error() to the call and `parts`, and returns `code`.
template <class... Parts>
hrt_result fail(hrt_result code, const Parts&... parts) {
  thread_error.text.clear();
  thread_error.text.append(std::string_view(thread_error.call));
  thread_error.text.append(std::string_view(": "));
  (thread_error.text.append(parts), ...);
  return code;
}

/// Runs the body of an entry point. Nothing it throws gets past here.
template <class Body>
hrt_result guarded(const char* call, Body&& body) noexcept {
  thread_error.call = call;
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return fail(HRT_ERROR_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return fail(HRT_ERROR_INTERNAL, std::string_view(error.what()));
  } catch (...) {
    return fail(HRT_ERROR_INTERNAL, "an exception of unknown type");
  }
}

}  // namespace hrt::plugin

#define HRT_RETURN_IF_FAILED(expression)                                    \
  do {                                                                      \
    if (const hrt_result hrt_failed = (expression); hrt_failed != HRT_OK) { \
      return hrt_failed;                                                    \
    }                                                                       \
  } while (false)
