// What a loadable library changes of the C++ runtime inside it.
#include <cstdlib>

namespace __gnu_cxx {
// Of libsupc++, for tools that look for leaks. NOLINTBEGIN(*-reserved-identifier, *-identifier-naming)
void __freeres();

// In place of libsupc++'s, which prints an exception's name by a large demangler: no exception leaves a call.
void __verbose_terminate_handler() { std::abort(); }
// NOLINTEND(*-reserved-identifier, *-identifier-naming)
}  // namespace __gnu_cxx

namespace {

constexpr int earliest_priority = 101;  // of those that programs may use

// The runtime reserves memory for exceptions when memory has run out, and leaves it when the library is unloaded. What
// is constructed first here is destroyed last, and frees it.
struct EmergencyPool {
  EmergencyPool() = default;
  EmergencyPool(const EmergencyPool&) = delete;
  EmergencyPool& operator=(const EmergencyPool&) = delete;
  ~EmergencyPool() { __gnu_cxx::__freeres(); }
};
__attribute__((init_priority(earliest_priority), used)) EmergencyPool emergency_pool;

}  // namespace
