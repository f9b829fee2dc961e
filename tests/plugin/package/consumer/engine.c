/* A shared library of an engine, which contains the static library. */
#include <haptic_retargeting/haptic_retargeting.h>

hrt_result engine_start(hrt_session* out_session) {
  const hrt_session_config config = hrt_session_config_init();
  return hrt_session_create(HRT_VERSION, &config, out_session);
}
