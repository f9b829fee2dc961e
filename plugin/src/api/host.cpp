// What the host lends. All of the library's memory, that of the containers and of nlohmann-json included: the
// operators below serve this library alone, which exports neither them nor the C++ runtime it is linked with.
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <new>

#include "haptic_retargeting/host.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/host.h"

namespace hrt::plugin {
namespace {

void* c_allocate(void*, std::size_t size, std::size_t alignment) {
  if (alignment <= alignof(std::max_align_t)) return std::malloc(size);
#if defined(_WIN32)
  return nullptr;  // its C library could not release such memory with free(); nothing here asks for it
#else
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
#endif
}

void c_release(void*, void* memory) {
  std::free(memory);
}

constexpr hrt_allocator c_library{
    .struct_size = sizeof(hrt_allocator),
    .reserved = 0,
    .context = nullptr,
    .allocate = c_allocate,
    .release = c_release,
};

constinit hrt_allocator allocator = c_library;
constinit std::atomic<std::int64_t> blocks_held{0};

void* allocate(std::size_t size, std::size_t alignment) noexcept {
  void* memory = allocator.allocate(allocator.context, size > 0 ? size : 1, alignment);
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
  allocator.release(allocator.context, memory);
}

struct Log {
  hrt_log_callback callback;
  void* context;
};
constinit Log host_log{};
std::mutex log_mutex;  // of all logs, and held while a callback runs

hrt_result check_nothing_held() {
  const std::int64_t held = blocks_held.load();
  if (held == 0) return HRT_OK;
  return fail(HRT_ERROR_WRONG_STATE, "the library holds ", held,
              " blocks of memory; destroy its sessions, scenes and calibrations first");
}

constexpr std::size_t plain = alignof(std::max_align_t);

}  // namespace

void SessionLog::set(hrt_log_callback callback, void* context) {
  const std::lock_guard lock(log_mutex);
  callback_ = callback;
  context_ = context;
}

void SessionLog::write(std::uint32_t level, const char* text) const {
  const std::lock_guard lock(log_mutex);
  const Log log = callback_ ? Log{callback_, context_} : host_log;
  if (log.callback) log.callback(log.context, level, text);
}

void unlock_log_of_parent() {
  std::construct_at(&log_mutex);
}

}  // namespace hrt::plugin

using namespace hrt::plugin;

void* operator new(std::size_t size) {
  return allocate_or_throw(size, plain);
}
void* operator new[](std::size_t size) {
  return allocate_or_throw(size, plain);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, plain);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, plain);
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete[](void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  release(memory);
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory, std::align_val_t) noexcept {
  release(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}

hrt_result hrt_set_allocator(const hrt_allocator* given) noexcept {
  return guarded("hrt_set_allocator", [&]() -> hrt_result {
    hrt_allocator checked = c_library;
    if (given) {
      HRT_RETURN_IF_FAILED(read_struct("allocator", given, &checked));
      HRT_RETURN_IF_FAILED(check_zero("reserved", checked.reserved));
      if (!checked.allocate) return fail(HRT_ERROR_NULL_ARGUMENT, "allocator: allocate is null");
      if (!checked.release) return fail(HRT_ERROR_NULL_ARGUMENT, "allocator: release is null");
    }
    HRT_RETURN_IF_FAILED(check_nothing_held());
    allocator = checked;
    return HRT_OK;
  });
}

hrt_result hrt_set_log_callback(hrt_log_callback callback, void* context) noexcept {
  return guarded("hrt_set_log_callback", [&]() -> hrt_result {
    const std::lock_guard lock(log_mutex);
    host_log = {callback, context};
    return HRT_OK;
  });
}
