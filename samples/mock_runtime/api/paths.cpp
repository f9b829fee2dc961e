#include "samples/mock_runtime/input/paths.h"

#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/instance.h"

namespace hrt::mock {

void string_to_path(XrInstance handle, const char* text, XrPath* path) {
  auto& instance = runtime().registry.get<Instance>(handle);
  require_pointer(text, "pathString");
  require_pointer(path, "path");
  *path = instance.paths.intern(text);
}

void path_to_string(XrInstance handle, XrPath path, std::uint32_t capacity, std::uint32_t* count,
                    char* buffer) {
  const auto& instance = runtime().registry.get<Instance>(handle);
  std::string text = instance.paths.text(path);
  text.push_back('\0');
  two_call(text, capacity, count, buffer);
}

}  // namespace hrt::mock
