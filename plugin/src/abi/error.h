// Errors: a code for the caller, and a text for hrt_last_error(). Setting an error uses no heap and no lock, because
// real-time calls report errors too.
#pragma once

#include <algorithm>
#include <string_view>

#include "haptic_retargeting/base.h"
#include "plugin/src/abi/text.h"

namespace hrt::plugin {

struct ThreadError {
  const char* call = "";  // name of the entry point that this thread is in, or was in last
  Text<240> text;
};

extern thread_local constinit ThreadError thread_error;

/// Sets the text of hrt_last_error(): the name of the call, then `parts`.
template <class... Parts>
void set_error(const Parts&... parts) {
  thread_error.text.clear();
  thread_error.text << thread_error.call << ": ";
  (thread_error.text << ... << parts);
  thread_error.text.make_printable();
}

template <class... Parts>
hrt_result fail(hrt_result code, const Parts&... parts) {
  set_error(parts...);
  return code;
}

/// Returns the text of the last failure without the name of the call.
inline Text<240> last_failure() {
  const std::string_view text = thread_error.text.view();
  Text<240> parts;
  parts << text.substr(std::min(text.size(), std::string_view(thread_error.call).size() + 2));
  return parts;
}

}  // namespace hrt::plugin

#define HRT_RETURN_IF_FAILED(expression)                                    \
  do {                                                                      \
    if (const hrt_result hrt_failed = (expression); hrt_failed != HRT_OK) { \
      return hrt_failed;                                                    \
    }                                                                       \
  } while (false)
