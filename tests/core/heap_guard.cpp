#include "tests/core/heap_guard.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HRT_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HRT_SANITIZED
#endif

namespace {
#if defined(__GLIBC__)
thread_local std::int64_t allocations = 0;
#else
std::atomic<std::int64_t> allocations{0};  // thread-local variables may need the heap themselves
#endif
}  // namespace

namespace hrt {
std::int64_t heap_allocations() { return allocations; }
}  // namespace hrt

#ifdef HRT_SANITIZED

// The sanitizers have replaced malloc themselves, and call back instead.
// (Declared in sanitizer/allocator_interface.h, which gcc does not ship.)
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*malloc_hook)(const volatile void*, std::size_t),
                                                         void (*free_hook)(const volatile void*));

namespace {
const int installed = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { ++allocations; }, [](const volatile void*) {});
}  // namespace

#elif defined(__GLIBC__)

// In place of the C library's functions, which operator new and Eigen end up in, for the whole program. They
// hand on to what the GNU C library calls its own.
#define HRT_REPLACES extern "C" __attribute__((visibility("default")))

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

HRT_REPLACES void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}

HRT_REPLACES void* calloc(std::size_t count, std::size_t size) noexcept {
  ++allocations;
  return __libc_calloc(count, size);
}

HRT_REPLACES void* realloc(void* memory, std::size_t size) noexcept {
  ++allocations;
  return __libc_realloc(memory, size);
}

HRT_REPLACES void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  return __libc_memalign(alignment, size);
}

HRT_REPLACES int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  *memory = __libc_memalign(alignment, size);
  return *memory ? 0 : ENOMEM;
}

#else

// The linker has whatever asks for malloc() get __wrap_malloc() (CMakeLists.txt); the C and C++ libraries are
// linked statically, so that this goes for them too.
extern "C" {
void* __real_malloc(std::size_t);
void* __real_calloc(std::size_t, std::size_t);
void* __real_realloc(void*, std::size_t);

void* __wrap_malloc(std::size_t size) {
  ++allocations;
  return __real_malloc(size);
}

void* __wrap_calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __real_calloc(count, size);
}

void* __wrap_realloc(void* memory, std::size_t size) {
  ++allocations;
  return __real_realloc(memory, size);
}
}

#endif
