// Scripts with random mistakes.
#include <random>

#include "tests/samples/mock_runtime/support.h"
#include "tests/samples/process.h"

namespace hrt::mock {
namespace {

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
  ASSERT_XR(XR_SUCCESS, XR(xrApplyScriptHRTX)(instance, whole.c_str())) << call_log().back().reason;
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
    const XrResult result = XR(xrApplyScriptHRTX)(instance, script.c_str());
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
