/* An engine that is compiled with the headers and loads the library at run time. */
#include <dlfcn.h>
#include <haptic_retargeting/functions.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

/* Does what dlsym() does for a library that lacks two functions. */
static void* find_most(void* library, const char* name) {
  if (!strcmp(name, "hrt_reach_retarget") || !strcmp(name, "hrt_reach_cancel")) return NULL;
  return dlsym(library, name);
}

int main(int argc, char** argv) {
  hrt_functions hrt;
  hrt_session_config config = hrt_session_config_init();
  hrt_session session = {0};
  const char* missing;
  pid_t child;
  int status = 1;
  void* library = argc == 3 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  if (!library) return 1;
  missing = hrt_functions_load(find_most, library, &hrt);
  if (!missing || strcmp(missing, "hrt_reach_retarget") != 0 || hrt.reach_cancel || !hrt.reach_end) return 2;
  if (hrt_functions_load(dlsym, library, &hrt)) return 3;
  if (hrt.session_create(300, &config, &session) != HRT_ERROR_OUT_OF_RANGE) return 4;
  if (hrt.session_create(HRT_VERSION, &config, &session) != HRT_OK) return 5;
  if (hrt.session_destroy(session) != HRT_OK || hrt.session_destroy(session) != HRT_ERROR_INVALID_HANDLE) return 6;
  if (strstr(hrt.last_error(), "hrt_session_destroy: session ") != hrt.last_error()) return 7;
  /* dlclose() ends the recording. A later fork must not call code of the unloaded library. */
  if (hrt.session_create(HRT_VERSION, &config, &session) != HRT_OK) return 8;
  if (hrt.recording_start(session, argv[2]) != HRT_OK) return 8;
  if (dlclose(library) != 0) return 9;
  if (dlopen(argv[1], RTLD_NOW | RTLD_NOLOAD)) return 10;
  child = fork();
  if (child == 0) _exit(0);
  if (waitpid(child, &status, 0) != child || status != 0) return 11;
  puts("opened, used and closed");
  return 0;
}
