// The texts of hrt_last_error() are one line of UTF-8 with the reason, for any input.
#include <cerrno>
#include <fstream>

#include "plugin/src/abi/utf8.h"
#include "tests/plugin/fixture.h"

namespace hrt::test {
namespace {

class ErrorTextTest : public SessionTest {
 protected:
  static void expect_line(hrt_result result, hrt_result expected, const std::string& part) {
    expect_error(result, expected, part);
    const std::string text = hrt_last_error();
    EXPECT_TRUE(plugin::is_utf8(text)) << text;
    for (const char c : text) EXPECT_FALSE(static_cast<unsigned char>(c) < 0x20 || c == 0x7f) << text;
    EXPECT_EQ(text.find("\u0085"), std::string::npos) << "a line break";
  }

  static std::string long_text() {
    std::string text = "x";
    for (int i = 0; i < 300; ++i) text += "\u00e4";
    return text;
  }
};

TEST_F(ErrorTextTest, ControlCharactersInProfileKeysAreReplaced) {
  expect_line(load_profile(R"({"a\nb\u001b[31m\u0085c":1})"), HRT_ERROR_BAD_FORMAT, "is not a field of a profile");
  expect_line(load_profile("{\"" + long_text() + "\":1}"), HRT_ERROR_BAD_FORMAT, "is not a field of a profile");
}

TEST_F(ErrorTextTest, LongTargetNamesAreTruncated) {
  const std::string name = long_text().substr(0, HRT_NAME_SIZE - 1);
  add(HRT_TARGET_REAL, 0.0, name.c_str());
  const hrt_target_config again = target_config(HRT_TARGET_REAL, 0.0, name.c_str());
  hrt_target target{};
  expect_line(hrt_target_add(session, &again, &target), HRT_ERROR_NAME_TAKEN, "name");
}

TEST_F(ErrorTextTest, LongPathsAreTruncatedBeforeTheReason) {
#if defined(_WIN32)  // names of files cannot contain line breaks
  const char* reason = std::strerror(EINVAL);
#else
  const char* reason = std::strerror(ENOENT);
#endif
  std::string path = "no_such_folder\n";
  for (int i = 0; i < 10; ++i) path += "/\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4";
  expect_line(hrt_recording_start(session, path.c_str()), HRT_ERROR_SYSTEM, reason);
  auto report = output<hrt_replay_report>();
  expect_line(hrt_recording_replay(path.c_str(), nullptr, 0, &report), HRT_ERROR_SYSTEM, reason);
  hrt_scene scene{};
  const std::string name = long_text();
  expect_line(hrt_scene_load(name.c_str(), "x", 1, &scene), HRT_ERROR_BAD_FORMAT, "...: ");
}

TEST_F(ErrorTextTest, SuccessfulReplayKeepsTheLastError) {
  expect_error(hrt_target_remove(session, {7}), HRT_ERROR_INVALID_HANDLE, "target 7");
  const std::string before = hrt_last_error();
  std::ifstream file(HRT_GOLDEN_RECORDING);
  std::string text, line;
  while (std::getline(file, line)) text += line + (line.starts_with("begin") ? "\n" + line + "\n" : "\n");
  auto report = output<hrt_replay_report>();
  ASSERT_OK(hrt_recording_replay(nullptr, text.data(), text.size(), &report));
  EXPECT_NE(report.first_different_line, 0u) << "a reach that begins in a reach is refused";
  EXPECT_EQ(hrt_last_error(), before);
}

}  // namespace
}  // namespace hrt::test
