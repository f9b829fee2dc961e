// The one place where tinygltf is compiled.
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <fstream>  // its writer needs it

// The C++ library's own brings its locales, a quarter of what would be loaded. tinygltf writes its errors by it; the
// implementation, and nothing declared above, finds this one first.
namespace tinygltf::std {
using namespace ::std;
constexpr char endl = '\n';
struct stringstream {  // NOLINT(readability-identifier-naming): that name
  template <class Part>
  stringstream& operator<<(const Part& part) {
    text += fmt::format("{}", part);
    return *this;
  }
  const string& str() const { return text; }
  string text;
};
}  // namespace tinygltf::std

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
