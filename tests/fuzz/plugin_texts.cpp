// Loads arbitrary bytes as profiles and recordings. A saved profile that is loaded again is saved with the same text,
// and two replays of a recording have the same hash.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "haptic_retargeting/gap.h"
#include "haptic_retargeting/haptic_retargeting.h"
#include "haptic_retargeting/host.h"
#include "haptic_retargeting/person.h"
#include "haptic_retargeting/profile.h"
#include "haptic_retargeting/recording.h"
#include "haptic_retargeting/scene.h"
#include "haptic_retargeting/setup.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

hrt_session new_session() {
  hrt_session session{};
  require(hrt_session_create(HRT_VERSION, nullptr, &session) == HRT_OK);
  return session;
}

std::string saved(hrt_session session) {
  char text[4096];
  uint64_t length = 0;
  require(hrt_profile_save(session, sizeof text, text, &length) == HRT_OK);
  return {text, length};
}

void try_profile(const char* text, std::size_t size) {
  const hrt_session session = new_session();
  if (hrt_profile_load(session, text, size) == HRT_OK) {
    const std::string once = saved(session);
    require(hrt_profile_load(session, once.data(), once.size()) == HRT_OK);
    require(saved(session) == once);
  }
  require(hrt_session_destroy(session) == HRT_OK);
}

void try_recording(const char* text, std::size_t size) {
  hrt_replay_report first = hrt_replay_report_init(), second = hrt_replay_report_init();
  const hrt_result result = hrt_recording_replay(nullptr, text, size, &first);
  require(hrt_recording_replay(nullptr, text, size, &second) == result);
  require(first.hash == second.hash && first.rows == second.rows);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto* text = reinterpret_cast<const char*>(data);
  if (size == 0) return 0;
  text[0] == '{' ? try_profile(text, size) : try_recording(text, size);
  return 0;
}
