// Built on a newer glibc, the library would ask for symbol versions that glibc 2.31 does not have. These
// definitions, hidden in the library, stand in front of those that its parts and the C++ runtime linked into
// it refer to.
#include <fcntl.h>
#include <link.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>

#if defined(__x86_64__)
#define HRT_FIRST_GLIBC "GLIBC_2.2.5"
#elif defined(__aarch64__)
#define HRT_FIRST_GLIBC "GLIBC_2.17"
#else
#error "name the first glibc of this architecture"
#endif

extern "C" {

// Since 2.32. False is always right: it only chooses atomic reference counts.
char __libc_single_threaded = 0;

// Functions since 2.33; the kernel fills the struct as glibc declares it on these architectures.
int stat(const char* path, struct stat* out) noexcept {
  return static_cast<int>(syscall(SYS_newfstatat, AT_FDCWD, path, out, 0));
}
int fstat(int file, struct stat* out) noexcept { return static_cast<int>(syscall(SYS_fstat, file, out)); }
int fstat64(int file, struct stat64* out) noexcept { return static_cast<int>(syscall(SYS_fstat, file, out)); }

// In libc.so.6 since 2.32 to 2.34, in libpthread.so.0 before; both know them by their first version.
int hrt_first_pthread_create(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
int hrt_first_pthread_join(pthread_t, void**);
int hrt_first_pthread_once(pthread_once_t*, void (*)());
int hrt_first_pthread_sigmask(int, const sigset_t*, sigset_t*);
__asm__(".symver hrt_first_pthread_create, pthread_create@" HRT_FIRST_GLIBC);
__asm__(".symver hrt_first_pthread_join, pthread_join@" HRT_FIRST_GLIBC);
__asm__(".symver hrt_first_pthread_sigmask, pthread_sigmask@" HRT_FIRST_GLIBC);
__asm__(".symver hrt_first_pthread_once, pthread_once@" HRT_FIRST_GLIBC);

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                   void* argument) noexcept {
  return hrt_first_pthread_create(thread, attributes, start, argument);
}
int pthread_join(pthread_t thread, void** out) { return hrt_first_pthread_join(thread, out); }
int pthread_sigmask(int how, const sigset_t* mask, sigset_t* out) noexcept {
  return hrt_first_pthread_sigmask(how, mask, out);
}
int pthread_once(pthread_once_t* once, void (*run)()) { return hrt_first_pthread_once(once, run); }
// libgcc only asks whether there is one.
int __pthread_key_create(pthread_key_t*, void (*)(void*)) noexcept { return -1; }

#if defined(DLFO_EH_SEGMENT_TYPE)
// Since 2.35, for libgcc: the table of functions around an instruction. Always the library's, whose header has the
// linker's name: no exception leaves it, and of other functions the table has none.
__attribute__((visibility("hidden"))) extern const ElfW(Ehdr) __ehdr_start;
int _dl_find_object(void*, dl_find_object* out) noexcept {
  char* const begin = const_cast<char*>(reinterpret_cast<const char*>(&__ehdr_start));
  const auto* segment = reinterpret_cast<const ElfW(Phdr)*>(begin + __ehdr_start.e_phoff);
  while (segment->p_type != DLFO_EH_SEGMENT_TYPE) ++segment;
  *out = {};
  out->dlfo_eh_frame = begin + segment->p_vaddr;
  return 0;
}
#endif
}
