// Picture files of the frames that a script selects.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "samples/mock_runtime/api/swapchain.h"

namespace hrt::mock {
namespace {

constexpr std::int64_t unasked_every = 30;

// Prints write errors and continues: an application must not fail because of a full disk.
void write_files(const Picture& picture, const std::string& folder, const std::string& name, const std::string& line) {
  try {
    write_png(picture, folder + "/" + name);
    std::ofstream list(folder + "/pictures.txt", std::ios::app);
    if (!(list << line << '\n' << std::flush)) throw Error{XR_ERROR_RUNTIME_FAILURE, folder + "/pictures.txt"};
  } catch (const Error& error) {
    std::fprintf(stderr, "mock runtime: HRT_MOCK_PICTURES: %s\n", error.why.c_str());
  }
}

bool is_due(Session& session) {
  const Script& script = runtime().script;
  const std::int64_t frame = session.frames.begun_number;
  const bool unasked = script.pictures == 0 && !script.has_picture_events();
  const std::int64_t every = unasked ? unasked_every : script.pictures;
  if (every > 0 && (frame - 1) % every == 0) return true;
  if (session.picture_from == 0 || frame < session.picture_from) return false;
  session.picture_from = 0;
  return true;
}

}  // namespace

void keep_pictures(const XrFrameEndInfo& info, Session& session) {
  const char* folder = std::getenv("HRT_MOCK_PICTURES");
  if (folder == nullptr || *folder == '\0' || session.graphics == nullptr || !is_due(session)) return;
  char frame[32];
  std::snprintf(frame, sizeof frame, "%06lld", static_cast<long long>(session.frames.begun_number));
  for (const std::uint32_t eye : {0U, 1U}) {
    const std::string name = eye == 0 ? "left" : "right";
    const Picture picture = picture_of_eye(info, eye);
    std::ostringstream line;
    line << frame << ' ' << info.displayTime << ' ' << name << ' ' << picture.width << 'x' << picture.height << ' '
         << hash_of(picture);
    write_files(picture, folder, frame + ("_" + name + ".png"), line.str());
  }
}

}  // namespace hrt::mock
