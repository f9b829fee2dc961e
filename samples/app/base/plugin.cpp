#include "samples/app/base/plugin.h"

#include <dlfcn.h>

#include <string>

#include "samples/app/base/exit_code.h"

namespace hrt::app {
namespace {

template <class Function>
void load(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr)
    throw Failure(ExitCode::plugin, "the library has no function " + std::string(name) +
                                        ": it is not the plugin, or an older one; install version " +
                                        std::to_string(HRT_VERSION_MAJOR) + "." + std::to_string(HRT_VERSION_MINOR) +
                                        ", or select another plugin (hrt-reach: --plugin)");
}

}  // namespace

// RTLD_NODELETE: dlclose() does not unload the plugin. Unloading would leak memory of the plugin's own C++ runtime.
Plugin::Plugin(const std::filesystem::path& library)
    : library_(dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE), dlclose) {
  if (library_ == nullptr)
    throw Failure(ExitCode::plugin, std::string("the plugin cannot be opened: ") + dlerror() +
                                        ": install it, or select another one (hrt-reach: --plugin)");
#define HRT_LOAD(name) load(library_.get(), #name, this->name);
  HRT_REACH_PLUGIN_FUNCTIONS(HRT_LOAD)
#undef HRT_LOAD
  std::uint32_t major = 0, minor = 0;
  hrt_get_version(&major, &minor, nullptr);
  // While the major version is 0, every minor version may change the interface (base.h).
  if (major != HRT_VERSION_MAJOR || (major == 0 ? minor != HRT_VERSION_MINOR : minor < HRT_VERSION_MINOR))
    throw Failure(ExitCode::plugin, "the plugin has version " + std::to_string(major) + "." + std::to_string(minor) +
                                        ", but this program needs " + std::to_string(HRT_VERSION_MAJOR) + "." +
                                        std::to_string(HRT_VERSION_MINOR) +
                                        ": install this version, or select another plugin (hrt-reach: --plugin)");
}

void Plugin::check(hrt_result result) const {
  if (result != HRT_OK)
    throw Failure(ExitCode::plugin,
                  "a call of the plugin failed (" + std::string(hrt_result_string(result)) + "): " + hrt_last_error());
}

}  // namespace hrt::app
