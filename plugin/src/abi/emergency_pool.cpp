// The C++ runtime inside a loadable library reserves memory for exceptions when memory has run out, and
// leaves it when the library is unloaded. What is constructed first here is destroyed last, and frees it.
namespace __gnu_cxx {
// Of libsupc++, for tools that look for leaks. NOLINTNEXTLINE(*-reserved-identifier, *-identifier-naming)
void __freeres();
}  // namespace __gnu_cxx

namespace {

constexpr int earliest_priority = 101;  // of those that programs may use

struct EmergencyPool {
  EmergencyPool() = default;
  EmergencyPool(const EmergencyPool&) = delete;
  EmergencyPool& operator=(const EmergencyPool&) = delete;
  ~EmergencyPool() { __gnu_cxx::__freeres(); }
};
__attribute__((init_priority(earliest_priority), used)) EmergencyPool emergency_pool;

}  // namespace
