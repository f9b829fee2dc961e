#include "plugin/src/session/conditions.h"

#include <cstring>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"

namespace hrt::plugin {
namespace {

bool differ(const char* one, const char* other) {
  return *one != '\0' && *other != '\0' && std::strcmp(one, other) != 0;
}

}  // namespace

hrt_result check_conditions(hrt_conditions* conditions) {
  HRT_RETURN_IF_FAILED(check_field(*conditions, Fields<hrt_conditions>::time_s));
  HRT_RETURN_IF_FAILED(check_name("plate", conditions->plate));
  HRT_RETURN_IF_FAILED(check_name("tracker", conditions->tracker));
  conditions->differing = 0;
  return HRT_OK;
}

hrt_conditions Conditions::measured() const {
  hrt_conditions measured = measured_;
  measured.struct_size = sizeof measured;
  measured.differing = (differ(measured_.plate, now_.plate) ? HRT_CONDITION_PLATE : 0) |
                       (differ(measured_.tracker, now_.tracker) ? HRT_CONDITION_TRACKER : 0);
  return measured;
}

}  // namespace hrt::plugin
