#include "haptic_retargeting/base.h"
#include "plugin/src/abi/error.h"

const char* hrt_result_string(hrt_result result) noexcept {
#define HRT_CASE(code) \
  case code:           \
    return #code
  switch (result) {
    HRT_CASE(HRT_OK);
    HRT_CASE(HRT_ERROR_NULL_ARGUMENT);
    HRT_CASE(HRT_ERROR_INVALID_HANDLE);
    HRT_CASE(HRT_ERROR_STRUCT_SIZE);
    HRT_CASE(HRT_ERROR_OUT_OF_RANGE);
    HRT_CASE(HRT_ERROR_WRONG_STATE);
    HRT_CASE(HRT_ERROR_BUSY);
    HRT_CASE(HRT_ERROR_TIME_REVERSED);
    HRT_CASE(HRT_ERROR_OUT_OF_MEMORY);
    HRT_CASE(HRT_ERROR_LIMIT_REACHED);
    HRT_CASE(HRT_ERROR_BUFFER_TOO_SMALL);
    HRT_CASE(HRT_ERROR_NAME_TAKEN);
    HRT_CASE(HRT_ERROR_SYSTEM);
    HRT_CASE(HRT_ERROR_BAD_FORMAT);
    HRT_CASE(HRT_ERROR_INSUFFICIENT_DATA);
    HRT_CASE(HRT_ERROR_INTERNAL);
    default:
      return "unknown result";
  }
#undef HRT_CASE
}

const char* hrt_last_error() noexcept { return hrt::plugin::thread_error.text.c_str(); }

void hrt_get_version(uint32_t* out_major, uint32_t* out_minor, uint32_t* out_patch) noexcept {
  if (out_major) *out_major = HRT_VERSION_MAJOR;
  if (out_minor) *out_minor = HRT_VERSION_MINOR;
  if (out_patch) *out_patch = HRT_VERSION_PATCH;
}
