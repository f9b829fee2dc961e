// The library allocates by the functions of the host, and any allocation may fail.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/plugin/counting_allocator.h"
#include "tests/plugin/guided_person.h"

namespace hrt::test {
namespace {

// Creates a session with two targets, and begins a reach. Returns the result of the first call that fails.
hrt_result live(hrt_session* session) {
  const hrt_session_config config = session_config();
  if (const auto result = hrt_session_create(HRT_VERSION, &config, session); result != HRT_OK) return result;
  hrt_target real{}, virtual_target{};
  const hrt_target_config real_config = target_config(HRT_TARGET_REAL, -5.0, "a name too long for its string");
  const hrt_target_config virtual_config = target_config(HRT_TARGET_VIRTUAL, 5.0, "another such long name");
  if (const auto result = hrt_target_add(*session, &real_config, &real); result != HRT_OK) return result;
  if (const auto result = hrt_target_add(*session, &virtual_config, &virtual_target); result != HRT_OK) return result;
  const hrt_target_config renamed = target_config(HRT_TARGET_REAL, -5.0, "a third name, no shorter than those");
  if (const auto result = hrt_target_set(*session, real, &renamed); result != HRT_OK) return result;
  const hrt_reach_config reach = reach_config(real, virtual_target);
  EXPECT_OK(hrt_reach_begin(*session, &reach));
  return HRT_OK;
}

// Fails each allocation of an operation in turn, alone and with all later ones. Each time, the operation must return an
// error and release what it allocated. After the first 1000 allocations, only every 101st and the last ones are tested.
template <class Operation>
void fail_each_allocation(CountingAllocator& allocator, Operation&& operation) {
  allocator.requests = 0;
  ASSERT_OK(operation());
  const long requests = allocator.requests, held = allocator.held;
  ASSERT_GT(requests, 0);
  for (const bool fail_on : {false, true}) {
    allocator.fail_on = fail_on;
    for (long n = 1; n <= requests; n += n > 1000 && n + 101 < requests ? 101 : 1) {
      allocator.requests = 0;
      allocator.fail_at = n;
      ASSERT_EQ(operation(), HRT_ERROR_OUT_OF_MEMORY) << "refusing request " << n << " of " << requests;
      allocator.fail_at = 0;
      ASSERT_EQ(allocator.held, held) << "after refusing request " << n << " of " << requests;
    }
  }
  allocator.fail_on = false;
}

TEST(Memory, SessionSurvivesFailureOfAnyAllocation) {
  CountingAllocator allocator;
  fail_each_allocation(allocator, [] {
    hrt_session session{};
    const hrt_result result = live(&session);
    if (session.value == 0) return result;
    std::uint64_t count = 0;
    EXPECT_OK(hrt_target_list(session, 0, 0, nullptr, &count));
    EXPECT_LE(count, 2u);
    EXPECT_OK(hrt_session_destroy(session));
    return result;
  });
  EXPECT_EQ(allocator.held, 0);
}

class SessionMemory : public SessionTest {
 protected:
  void TearDown() override {
    SessionTest::TearDown();
    EXPECT_EQ(allocator.held, 0);
  }
  CountingAllocator allocator;
};

TEST_F(SessionMemory, ProfilesSurviveFailureOfAnyAllocation) {
  fail_each_allocation(allocator, [&] { return load_profile(profile_with(",\"tactile_weight\":0.2")); });
}

constexpr std::uint32_t setup_parts[] = {HRT_SETUP_FINGERTIP, HRT_SETUP_REGISTRATION, HRT_SETUP_CALIBRATION};

TEST_F(SessionMemory, BeginOfASetupSurvivesFailureOfAnyAllocation) {
  for (const std::uint32_t part : setup_parts)
    fail_each_allocation(allocator, [&] {
      const hrt_result result = hrt_setup_begin(session, part, nullptr);
      if (result == HRT_OK) {
        EXPECT_OK(hrt_setup_cancel(session));
      }
      return result;
    });
}

// Fails each of the first fifty allocations of hrt_setup_finish(), and every 211th after them.
TEST(Memory, FinishOfASetupSurvivesFailureOfAnyAllocation) {
  CountingAllocator allocator;
  const hrt_session_config config = session_config();
  hrt_setup_config setup = hrt_setup_config_init();
  setup.max_slides = 16;
  for (const std::uint32_t part : setup_parts) {
    hrt_session session{};
    ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &session));
    GuidedPerson person = quiet_person(part == HRT_SETUP_CALIBRATION);
    ASSERT_OK(hrt_setup_begin(session, part, &setup));
    auto step = output<hrt_setup_step>();
    for (int frame = 0; frame < 20'000 && step.instruction != HRT_STEP_FINISH; ++frame) {
      const hrt_sample sample = person.follow(step);
      if (part == HRT_SETUP_CALIBRATION && frame % 3 != 0) continue;  // at 30 Hz, because the fit takes time
      ASSERT_OK(hrt_setup_update(session, &sample, &step));
    }
    const long held = allocator.held;
    auto result = output<hrt_setup_result>();
    hrt_result finished = HRT_ERROR_OUT_OF_MEMORY;
    long n = 0;
    while (finished == HRT_ERROR_OUT_OF_MEMORY) {
      n += n < 50 ? 1 : 211;
      for (const bool fail_on : {true, false}) {
        allocator.fail_on = fail_on;
        allocator.requests = 0;
        allocator.fail_at = n;
        do finished = hrt_setup_finish(session, &result);
        while (finished == HRT_OK && result.left != 0);
        allocator.fail_at = 0;
        if (finished == HRT_OK) break;
        ASSERT_EQ(finished, HRT_ERROR_OUT_OF_MEMORY) << "refusing request " << n << " of part " << part;
        ASSERT_EQ(allocator.held, held) << "after refusing request " << n << " of part " << part;
      }
    }
    allocator.fail_on = false;
    EXPECT_GT(n, 1);
    EXPECT_EQ(result.done, part);
    ASSERT_OK(hrt_session_destroy(session));
    EXPECT_EQ(allocator.held, 0);
  }
}

TEST_F(SessionMemory, RecordingsSurviveFailureOfAnyAllocation) {
  auto status = output<hrt_recording_status>();
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("hrt_memory" + std::to_string(getpid()) + ".csv");
  fail_each_allocation(allocator, [&] {
    const hrt_result result = hrt_recording_start(session, path.string().c_str());
    if (result == HRT_OK) {
      EXPECT_OK(hrt_recording_stop(session, &status));
    }
    return result;
  });
  std::filesystem::remove(path);
  auto report = output<hrt_replay_report>();
  std::ifstream file(HRT_GOLDEN_RECORDING);
  std::string text, line;
  for (int i = 0; i < 16 && std::getline(file, line); ++i) text += line + "\n";
  fail_each_allocation(allocator, [&] { return hrt_recording_replay(nullptr, text.data(), text.size(), &report); });
  EXPECT_GT(report.rows, 0u);
}

TEST_F(SessionMemory, RecordingWithoutMemoryLeavesTheFileUnchanged) {
  const std::string path = testing::TempDir() + "hrt_memory_kept" + std::to_string(getpid()) + ".csv";
  std::ofstream(path) << "kept";
  allocator.budget = allocator.bytes + 1'000'000;
  expect_error(hrt_recording_start(session, path.c_str()), HRT_ERROR_OUT_OF_MEMORY, "memory");
  std::string text;
  std::ifstream(path) >> text;
  EXPECT_EQ(text, "kept");
  std::filesystem::remove(path);
}

TEST_F(SessionMemory, SceneSurvivesFailureOfAnyAllocation) {
  const std::string gltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,2]}],"nodes":[
    {"name":"plate","extras":{"haptic":{"role":"plate","radius_m":0.1}}},
    {"name":"cylinder","translation":[0,0,-0.05],"extras":{"haptic":{"role":"real","name":"cylinder"}}},
    {"name":"cup","translation":[-0.01,0,-0.05],
     "extras":{"haptic":{"role":"virtual","name":"cup","served_by":"cylinder"}}}]})";
  hrt_scene scene{};
  ASSERT_OK(hrt_scene_load("memory", gltf.data(), gltf.size(), &scene));
  hrt_target ids[2];
  fail_each_allocation(allocator, [&] {
    const hrt_result result = hrt_scene_register(scene, session, 2, ids);
    if (result == HRT_OK) {
      for (const hrt_target id : ids) EXPECT_OK(hrt_target_remove(session, id));
    }
    return result;
  });
  ASSERT_OK(hrt_scene_destroy(scene));
}

TEST(Memory, AllocatorCannotChangeWhileMemoryIsInUse) {
  const hrt_session_config config = session_config();
  hrt_session session{};
  ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &session));
  EXPECT_OK(hrt_host_set(nullptr)) << "nothing changes";
  hrt_host host = hrt_host_init();
  host.log = [](void*, std::uint32_t, const char*) {};
  host.context = &host;
  EXPECT_OK(hrt_host_set(&host)) << "the allocator is unchanged";
  host.allocate = [](void*, std::size_t size, std::size_t) { return std::malloc(size); };
  host.release = [](void*, void* memory) { std::free(memory); };
  expect_error(hrt_host_set(&host), HRT_ERROR_WRONG_STATE);
  ASSERT_OK(hrt_session_destroy(session));
  EXPECT_OK(hrt_host_set(&host));
  ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &session));
  EXPECT_OK(hrt_host_set(&host));
  host.context = &session;
  expect_error(hrt_host_set(&host), HRT_ERROR_WRONG_STATE);
  ASSERT_OK(hrt_session_destroy(session));
  EXPECT_OK(hrt_host_set(nullptr));
}

TEST(Memory, IncompleteAllocatorIsRejected) {
  hrt_host host{};
  expect_error(hrt_host_set(&host), HRT_ERROR_STRUCT_SIZE, "host");
  host = hrt_host_init();
  host.allocate = [](void*, std::size_t, std::size_t) -> void* { return nullptr; };
  expect_error(hrt_host_set(&host), HRT_ERROR_NULL_ARGUMENT, "release");
  host.release = [](void*, void*) {};
  host.allocate = nullptr;
  expect_error(hrt_host_set(&host), HRT_ERROR_NULL_ARGUMENT, "allocate");
  hrt_session session{};
  ASSERT_OK(hrt_session_create(HRT_VERSION, nullptr, &session));
  expect_error(hrt_host_set_log(session, &host), HRT_ERROR_OUT_OF_RANGE, "allocator");
  ASSERT_OK(hrt_session_destroy(session));
}

}  // namespace
}  // namespace hrt::test
