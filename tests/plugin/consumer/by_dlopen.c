/* An engine that has the headers and finds the library when it runs. */
#include <dlfcn.h>
#include <haptic_retargeting/haptic_retargeting.h>
#include <stdio.h>
#include <string.h>

static void* library;

/* ISO C has no conversion from an object pointer to a function pointer; POSIX has this one. */
static int find(const char* name, void* out_function) {
  void* symbol = dlsym(library, name);
  if (!symbol) fprintf(stderr, "%s\n", dlerror());
  memcpy(out_function, &symbol, sizeof symbol);
  return symbol != NULL;
}

int main(int argc, char** argv) {
  hrt_result (*config_default)(hrt_session_config*, uint32_t);
  hrt_result (*create)(const hrt_session_config*, hrt_session*);
  hrt_result (*destroy)(hrt_session);
  const char* (*last_error)(void);
  hrt_session_config config;
  hrt_session session = {0};
  library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  if (!library) return 1;
  if (!find("hrt_session_config_default", &config_default) || !find("hrt_session_create", &create) ||
      !find("hrt_session_destroy", &destroy) || !find("hrt_last_error", &last_error))
    return 2;
  if (config_default(&config, sizeof config) != HRT_OK || create(&config, &session) != HRT_OK) return 3;
  if (destroy(session) != HRT_OK || destroy(session) != HRT_ERROR_INVALID_HANDLE) return 4;
  if (strstr(last_error(), "hrt_session_destroy: session ") != last_error()) return 5;
  if (dlclose(library) != 0) return 6;
  puts("opened, used and closed");
  return 0;
}
