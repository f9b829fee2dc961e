// A recording that the plugin could not write whole.
#include "samples/reach/base/files.h"

#include <gtest/gtest.h>

#include "samples/reach/base/exit_code.h"

namespace hrt::reach {
namespace {

TEST(ReachRecordingFile, LostRowsFailTheRun) {
  Plugin plugin(HRT_PLUGIN);
  plugin.hrt_recording_start = [](hrt_session, const char*) noexcept { return HRT_OK; };
  plugin.hrt_recording_stop = [](hrt_session, hrt_recording_status* status) noexcept {
    status->rows_lost = 3;
    return HRT_OK;
  };
  RecordingFile file(plugin, {}, "reach.csv");
  try {
    file.finish();
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::output);
    EXPECT_STREQ(failure.what(), "reach.csv is not complete: 3 rows could not be written");
  }
}

}  // namespace
}  // namespace hrt::reach
