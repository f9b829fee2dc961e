/* Connects the module to JavaScript: the library's log, and the calls of the file system that Emscripten's C library
 * does not pass to WASI. memory.mjs keeps written files in memory. No file can be read. */
#include <errno.h>
#include <fcntl.h>
#include <haptic_retargeting/host.h>

/* Receives a line of the library's log. Defined in memory.mjs. */
__attribute__((import_module("env"), import_name("hrt_web_log"))) void hrt_web_log(void* context, hrt_log_level level,
                                                                                   const char* text);

/* Runs when the module starts. */
__attribute__((constructor)) static void take_log(void) {
  hrt_host host = hrt_host_init();
  host.log = hrt_web_log;
  if (hrt_host_set(&host) != HRT_OK) __builtin_trap();
}

struct stat;

/* Opens a file. Returns a descriptor, or the negative number of an error. Defined in memory.mjs. */
__attribute__((import_module("env"), import_name("hrt_web_open"))) long hrt_web_open(const char* path, int writes);

/* Replaces the weak function of the C library. */
long __syscall_open(const char* path, long flags, ...);
long __syscall_open(const char* path, long flags, ...) { return hrt_web_open(path, (flags & O_ACCMODE) != O_RDONLY); }

/* Functions that the C library would import from JavaScript. They report that no file exists. */
#define NOT_THERE(name, ...) \
  long name(__VA_ARGS__);    \
  long name(__VA_ARGS__) { return -ENOENT; }
NOT_THERE(__syscall_stat64, const char* path, struct stat* out)
NOT_THERE(__syscall_lstat64, const char* path, struct stat* out)
NOT_THERE(__syscall_fstat64, int file, struct stat* out)
NOT_THERE(__syscall_fstatat64, int folder, const char* path, struct stat* out, int flags)
