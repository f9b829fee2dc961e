// Every function with handles that are none and with null pointers; scripts with random mistakes.
#include <algorithm>
#include <random>

#include "samples/mock_runtime/extensions.h"
#include "tests/samples/mock_runtime/negotiation.h"
#include "tests/samples/process.h"

namespace hrt::mock {
namespace {

template <typename T>
concept has_size = requires { sizeof(T); };

class MockHostile : public MockNegotiation {
 protected:
  void SetUp() override {
    MockNegotiation::SetUp();
    ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
    std::vector<const char*> names;
    for (std::size_t i = first_extension; i < extensions.size(); ++i)
      if (i != static_cast<std::size_t>(Extension::timespec)) names.push_back(extensions[i].name);
    ASSERT_XR(XR_SUCCESS, create_direct(names, XR_MAKE_VERSION(1, 1, 41)));
  }
  void TearDown() override {
    destroy_direct();
    MockNegotiation::TearDown();
  }

  // Calls a function with this handle, and with zeros and null pointers for the rest.
  template <typename Handle, typename... Rest>
  static XrResult call(XrResult(XRAPI_PTR* function)(Handle, Rest...), std::uint64_t handle) {
    return function(reinterpret_cast<Handle>(handle), Rest{}...);
  }

  // Calls `each(name, function)` for every function that takes a handle first.
  template <typename Each>
  void for_each_function(Each each) {
#define HRT_TEST_FUNCTION(name, implementation, extension, returned) \
  if (Extension::extension != Extension::timespec) visit<PFN_##name>(#name, each);
    HRT_MOCK_FUNCTIONS(HRT_TEST_FUNCTION)
#undef HRT_TEST_FUNCTION
  }
  template <typename Function, typename Each>
  void visit(const char* name, Each& each) {
    if constexpr (takes_handle<Function>()) each(name, fetch_direct<Function>(instance, name));
  }

  template <typename Function>
  static constexpr bool takes_handle() {
    return first_is_handle(static_cast<Function>(nullptr));
  }
  template <typename First, typename... Rest>
  static constexpr bool first_is_handle(XrResult(XRAPI_PTR*)(First, Rest...)) {
    return std::is_pointer_v<First> && !has_size<std::remove_pointer_t<First>>;
  }

  template <typename First, typename... Rest>
  static First first_of(XrResult(XRAPI_PTR*)(First, Rest...));
};

// "XR_ERROR_HANDLE_INVALID": null, foreign and future handles, before anything else is looked at.
TEST_F(MockHostile, EveryFunctionRefusesHandlesThatAreNone) {
  int functions = 0;
  for_each_function([&](const std::string& name, auto function) {
    if (name == "xrGetInstanceProcAddr") return;  // null is allowed
    ++functions;
    for (const std::uint64_t handle : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0x77},
                                       ~std::uint64_t{0}, reinterpret_cast<std::uint64_t>(instance) + 1000})
      EXPECT_XR(XR_ERROR_HANDLE_INVALID, call(function, handle)) << name << ' ' << handle;
  });
  EXPECT_GE(functions, 60);
}

// Of every function with a handle of the right type: none crashes, none succeeds without its outputs.
TEST_F(MockHostile, EveryFunctionOfAnInstanceRefusesNullPointers) {
  for_each_function([&](const std::string& name, auto function) {
    using First = decltype(first_of(function));
    if constexpr (std::is_same_v<First, XrInstance>) {
      if (name == "xrDestroyInstance" || name == "xrAdvanceTimeHRTX") return;  // without pointers
      EXPECT_LT(call(function, reinterpret_cast<std::uint64_t>(instance)), XR_SUCCESS) << name;
    }
  });
}

// A script with a mistake is refused with a reason, or is another script; nothing else happens.
class MockBrokenScript : public MockRuntime {};

std::string readme_script() {
  const std::string readme = read_file(HRT_MOCK_DOCUMENTS "/SCRIPTS.md");
  const std::size_t begin = readme.find("```json\n") + 8;
  std::string script = readme.substr(begin, readme.find("```", begin) - begin);
  // Without the calls: some wait in real time.
  return script.substr(0, script.find(",\n  \"calls\"")) + "\n}\n";
}

TEST_F(MockBrokenScript, MistakesAreRefusedWithAReasonOrHarmless) {
  const std::string whole = readme_script();
  ASSERT_XR(XR_SUCCESS, functions->apply_script(instance, whole.c_str())) << call_log().back().reason;
  std::mt19937 random(1);
  const std::string letters = "{}[]\",:0123456789.-eE truefalsn\\\n\x01\xff";
  int refused = 0, taken = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string script = whole;
    for (std::uint32_t change = 0; change <= random() % 3; ++change) {
      const std::size_t at = random() % script.size();
      switch (random() % 4) {
        case 0:
          script.erase(at, random() % 20 + 1);
          break;
        case 1:
          script.insert(at, 1, letters[random() % letters.size()]);
          break;
        case 2:
          script[at] = letters[random() % letters.size()];
          break;
        default:
          script.insert(at, script.substr(random() % script.size(), random() % 40));
      }
    }
    const XrResult result = functions->apply_script(instance, script.c_str());
    if (result == XR_SUCCESS) {
      ++taken;
      begin_session();
      EXPECT_XR(XR_SUCCESS, xrDestroySession(session));
    } else {
      ++refused;
      EXPECT_XR(XR_ERROR_VALIDATION_FAILURE, result) << script;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(taken, 10);
}

}  // namespace
}  // namespace hrt::mock
