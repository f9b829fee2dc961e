// An entry point on what a handle stands for.
#pragma once

#include <cstdint>

#include "plugin/src/abi/error.h"

namespace hrt::plugin {

/// Why a HandleTable gave no `what`.
inline hrt_result no_lease(hrt_result reason, const char* what, std::uint64_t handle) {
  if (reason == HRT_ERROR_BUSY) return fail(reason, "another thread is in a call on this ", what);
  return fail(reason, what, " ", handle, " does not exist");
}

/// Runs the body of an entry point on the `what` of `table` that the handle stands for.
template <class Table, class Body>
hrt_result with_lease(const char* call, const char* what, Table& table, std::uint64_t handle, Body&& body) noexcept {
  return guarded(call, [&]() -> hrt_result {
    const typename Table::Lease lease = table.lease(handle);
    return lease.result() == HRT_OK ? body(*lease) : no_lease(lease.result(), what, handle);
  });
}

/// Destroys the `what` of `table` that the handle stands for.
template <class Table>
hrt_result destroy(const char* call, const char* what, Table& table, std::uint64_t handle) noexcept {
  return guarded(call, [&]() -> hrt_result {
    const hrt_result result = table.destroy(handle);
    return result == HRT_OK ? HRT_OK : no_lease(result, what, handle);
  });
}

}  // namespace hrt::plugin
