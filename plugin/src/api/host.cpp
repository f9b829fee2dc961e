// Allocator and log of the host. The operators below allocate the memory of the library, including that of containers
// and of nlohmann-json. The shared library does not export them; in a program that links the static library, they
// replace the operators of the program.
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <new>

#include "haptic_retargeting/host.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/entry.h"
#include "plugin/src/abi/host.h"
#include "plugin/src/api/recorded_session.h"

namespace hrt::plugin {
namespace {

void* c_allocate(void*, std::size_t size, std::size_t alignment) {
  if (alignment <= alignof(std::max_align_t)) return std::malloc(size);
#if defined(_WIN32)
  return nullptr;  // free() of Windows cannot release over-aligned memory; the library does not request any
#else
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
#endif
}

void c_release(void*, void* memory) { std::free(memory); }

constexpr hrt_host c_library{
    .struct_size = sizeof(hrt_host),
    .reserved = 0,
    .context = nullptr,
    .allocate = c_allocate,
    .release = c_release,
    .log = nullptr,
};

constinit hrt_host host_callbacks = c_library;
constinit std::atomic<std::int64_t> blocks_held{0};

void* allocate(std::size_t size, std::size_t alignment) noexcept {
  void* memory = host_callbacks.allocate(host_callbacks.context, size > 0 ? size : 1, alignment);
  if (memory) blocks_held.fetch_add(1, std::memory_order_relaxed);
  return memory;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  if (void* memory = allocate(size, alignment)) return memory;
  throw std::bad_alloc();
}

void release(void* memory) noexcept {
  if (!memory) return;
  blocks_held.fetch_sub(1, std::memory_order_relaxed);
  host_callbacks.release(host_callbacks.context, memory);
}

std::mutex log_mutex;  // held while the log is called

// Fails if the allocator changes while blocks are in use, which only the present allocator can release.
hrt_result check_allocator(const hrt_host& next) {
  const std::int64_t held = blocks_held.load();
  const bool same_functions = next.allocate == host_callbacks.allocate && next.release == host_callbacks.release;
  const bool reads_context = next.allocate != c_allocate;
  if (held == 0 || (same_functions && (!reads_context || next.context == host_callbacks.context))) return HRT_OK;
  return fail(HRT_ERROR_WRONG_STATE, "the allocator cannot be changed while the library holds ", held,
              " blocks of memory; destroy its sessions, people and scenes first");
}

hrt_result read_host(const hrt_host* given, hrt_host* host) {
  *host = {.struct_size = sizeof(hrt_host)};
  if (!given) return HRT_OK;
  HRT_RETURN_IF_FAILED(read_struct("host", given, host));
  return check_zero("reserved", host->reserved);
}

constexpr std::size_t plain = alignof(std::max_align_t);

}  // namespace

void write_log(std::uint32_t level, const char* text, const SessionLog& of_session) {
  const std::lock_guard lock(log_mutex);
  if (of_session.log) return of_session.log(of_session.context, level, text);
  if (host_callbacks.log) host_callbacks.log(host_callbacks.context, level, text);
}

void set_log(SessionLog* of_session, const hrt_host& host) {
  const std::lock_guard lock(log_mutex);
  *of_session = {host.context, host.log};
}

void reset_log_mutex_after_fork() { std::construct_at(&log_mutex); }

}  // namespace hrt::plugin

using namespace hrt::plugin;

void* operator new(std::size_t size) { return allocate_or_throw(size, plain); }
void* operator new[](std::size_t size) { return allocate_or_throw(size, plain); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size, plain); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size, plain); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

hrt_result hrt_host_set(const hrt_host* given) noexcept {
  return guarded("hrt_host_set", [&]() -> hrt_result {
    hrt_host next;
    HRT_RETURN_IF_FAILED(read_host(given, &next));
    if (!next.allocate != !next.release)
      return fail(HRT_ERROR_NULL_ARGUMENT, "host: ", next.allocate ? "release" : "allocate",
                  " is null; set allocate and release, or neither");
    if (!next.allocate) {
      next.allocate = c_allocate;
      next.release = c_release;
    }
    HRT_RETURN_IF_FAILED(check_allocator(next));
    const std::lock_guard lock(log_mutex);
    host_callbacks = next;
    return HRT_OK;
  });
}

hrt_result hrt_host_set_log(hrt_session session, const hrt_host* given) noexcept {
  return sessions.with("hrt_host_set_log", session.value, [&](RecordedSession& s) -> hrt_result {
    hrt_host host;
    HRT_RETURN_IF_FAILED(read_host(given, &host));
    if (host.allocate || host.release)
      return fail(HRT_ERROR_OUT_OF_RANGE,
                  "host has an allocator, which only hrt_host_set() can set; allowed: a log and its context");
    s.set_log(host);
    s.log_findings(session.value);
    return HRT_OK;
  });
}
