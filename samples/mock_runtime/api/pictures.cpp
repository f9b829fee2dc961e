// Pictures of frames that a script orders, as files and as lines of the call log.
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "samples/mock_runtime/api/swapchain.h"
#include "samples/mock_runtime/graphics/world_picture.h"

namespace hrt::mock {
namespace {

constexpr std::int64_t unasked_every = 30;

const char* picture_folder() {
  const char* folder = std::getenv("HRT_MOCK_PICTURES");
  return folder == nullptr || *folder == '\0' ? nullptr : folder;
}

// An application is not to fail for want of a disk.
void write_files(const Picture& picture, const std::string& name, const std::string& line) {
  const char* folder = picture_folder();
  if (folder == nullptr) return;
  const std::string path = std::string(folder) + "/" + name;
  try {
    write_png(picture, path);
    std::ofstream list(std::string(folder) + "/pictures.txt", std::ios::app);
    if (!(list << line << '\n' << std::flush)) throw Error{XR_ERROR_RUNTIME_FAILURE, path + ": pictures.txt"};
  } catch (const Error& error) {
    std::fprintf(stderr, "mock runtime: HRT_MOCK_PICTURES: %s\n", error.why.c_str());
  }
}

bool is_due(Session& session) {
  const Script& script = runtime().script;
  const std::int64_t frame = session.frames.begun_number;
  const bool unasked = script.pictures == 0 && picture_folder() != nullptr && !script.has_picture_events();
  const std::int64_t every = unasked ? unasked_every : script.pictures;
  if (every > 0 && (frame - 1) % every == 0) return true;
  if (session.picture_from == 0 || frame < session.picture_from) return false;
  session.picture_from = 0;
  return true;
}

}  // namespace

void keep_pictures(const XrFrameEndInfo& info, Session& session) {
  if (!is_due(session)) return;
  char frame[32];
  std::snprintf(frame, sizeof frame, "%06lld", static_cast<long long>(session.frames.begun_number));
  std::string& remark = runtime().remark;
  for (const Script::View view : runtime().script.views) {
    if (view != Script::View::world && session.graphics == nullptr) continue;
    const std::string name = view == Script::View::left ? "left" : view == Script::View::right ? "right" : "world";
    const Picture picture = view == Script::View::world ? picture_of_world(session.world(), runtime().now())
                                                        : picture_of_eye(info, view == Script::View::left ? 0 : 1);
    const std::string what =
        name + " " + std::to_string(picture.width) + "x" + std::to_string(picture.height) + " " + hash_of(picture);
    remark += (remark.empty() ? std::string("picture of frame ") + frame + ": " : ", ") + what;
    write_files(picture, std::string(frame) + "_" + name + ".png",
                std::string(frame) + " " + std::to_string(info.displayTime) + " " + what);
  }
}

}  // namespace hrt::mock
