/* Files of the module: what the C library's functions come down to. WASI's own ways to files are not in this
 * C library. What is written index.mjs keeps in memory; there is nothing to read. */
#include <errno.h>
#include <fcntl.h>

struct stat;

/* Returns a descriptor, or an error's negative number. */
__attribute__((import_module("env"), import_name("hrt_web_open"))) long hrt_web_open(const char* path, int writes);

/* In place of the C library's, which is weak. */
long __syscall_open(const char* path, long flags, ...);
long __syscall_open(const char* path, long flags, ...) { return hrt_web_open(path, (flags & O_ACCMODE) != O_RDONLY); }

/* The C library's are for JavaScript to give. */
#define NOT_THERE(name, ...) \
  long name(__VA_ARGS__);    \
  long name(__VA_ARGS__) { return -ENOENT; }
NOT_THERE(__syscall_stat64, const char* path, struct stat* out)
NOT_THERE(__syscall_lstat64, const char* path, struct stat* out)
NOT_THERE(__syscall_fstat64, int file, struct stat* out)
NOT_THERE(__syscall_fstatat64, int folder, const char* path, struct stat* out, int flags)
