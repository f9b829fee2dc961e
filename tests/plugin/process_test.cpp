// Checks the statements of plugin/PROCESS.md about floating-point modes, memory and stack.
#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif
#if defined(HRT_MEASURES_MEMORY)
#include <pthread.h>
#include <sys/mman.h>

#include "tests/plugin/counting_allocator.h"
#endif

#include "tests/plugin/recording/recording_fixture.h"

namespace hrt::test {
namespace {

TEST(Process, RoundingModeOfTheHostIsRestoredAndChangesNoResult) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
    SCOPED_TRACE(mode);
    ASSERT_EQ(std::fesetround(mode), 0);
    const volatile double one = 1.0, three = 3.0;
    const double third = one / three;
    expect_golden_bits();
    EXPECT_EQ(std::fegetround(), mode);
    EXPECT_EQ(one / three, third);
    EXPECT_EQ(hrt_session_destroy({42}), HRT_ERROR_INVALID_HANDLE);
    EXPECT_EQ(std::fegetround(), mode);
    EXPECT_EQ(one / three, third);
  }
  ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);
}

#if defined(__SSE2__)
TEST(Process, FlushToZeroIsKeptAndChangesNoResult) {
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | flush_to_zero | denormals_are_zero);
  expect_golden_bits();
  EXPECT_EQ(_mm_getcsr() & (flush_to_zero | denormals_are_zero), flush_to_zero | denormals_are_zero);
  _mm_setcsr(before);
}
TEST(Process, FloatingPointTrapsAreKeptAndNotTriggered) {
  constexpr unsigned masks = _MM_MASK_MASK, flags = _MM_EXCEPT_MASK;
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before & ~(masks | flags));  // each inexact result would terminate the process
  hrt_session session{};
  const hrt_result created = hrt_session_create(HRT_VERSION, nullptr, &session);
  const hrt_result destroyed = hrt_session_destroy(session);
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(created, HRT_OK);
  EXPECT_EQ(destroyed, HRT_OK);
  EXPECT_EQ(after & masks, 0U);
}
#endif

#if defined(HRT_MEASURES_MEMORY)

// Limits on 64-bit machines, in bytes. plugin/PROCESS.md states them, rounded.
constexpr long max_of_session = 31'000;
constexpr long max_of_target = 320;
constexpr long max_of_recording = 9'700'000;
constexpr std::size_t max_real_time_stack = 32'000;
constexpr std::size_t max_stack = 66'000;

TEST(Process, MemoryIsAsDocumented) {
  const CountingAllocator memory;
  const hrt_session_config config = session_config();
  hrt_session session{};
  ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &session));
  RecordProperty("session", static_cast<int>(memory.bytes));
  EXPECT_LE(memory.bytes, max_of_session);
  const long before_target = memory.bytes;
  const hrt_target_config target = target_config(HRT_TARGET_REAL, 1.0, "a name too long for its string");
  hrt_target id{};
  ASSERT_OK(hrt_target_add(session, &target, &id));
  RecordProperty("target", static_cast<int>(memory.bytes - before_target));
  EXPECT_LE(memory.bytes - before_target, max_of_target);
  const long before_recording = memory.bytes;
  const std::string path = testing::TempDir() + "hrt_process.csv";
  ASSERT_OK(hrt_recording_start(session, path.c_str()));
  RecordProperty("recording", static_cast<int>(memory.bytes - before_recording));
  EXPECT_LE(memory.bytes - before_recording, max_of_recording);
  ASSERT_OK(hrt_session_destroy(session));
  std::remove(path.c_str());
  EXPECT_EQ(memory.bytes, 0);
}

constexpr unsigned char paint = 0xa5;
constexpr std::size_t stack_size = std::size_t{1} << 20;

// Returns the bytes of stack that a thread uses for the body.
std::size_t stack_of(void* (*body)(void*), void* argument) {
  auto* stack = static_cast<unsigned char*>(
      mmap(nullptr, stack_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0));
  std::fill(stack, stack + stack_size, paint);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  EXPECT_EQ(pthread_attr_setstack(&attributes, stack, stack_size), 0);
  pthread_t thread{};
  EXPECT_EQ(pthread_create(&thread, &attributes, body, argument), 0);
  EXPECT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
  const auto untouched =
      static_cast<std::size_t>(std::find_if(stack, stack + stack_size, [](auto b) { return b != paint; }) - stack);
  munmap(stack, stack_size);
  return stack_size - untouched;
}

class Stack : public SessionTest {
 protected:
  /// Returns the stack that the body uses in addition to that of an empty thread.
  template <class Body>
  static std::size_t used(Body body) {
    const std::size_t nothing = stack_of([](void*) -> void* { return nullptr; }, nullptr);
    return stack_of(
               [](void* argument) -> void* {
                 (*static_cast<Body*>(argument))();
                 return nullptr;
               },
               &body) -
           nothing;
  }
};

TEST_F(Stack, RealTimeCallsUseAtMostTheDocumentedStack) {
  hrt_session_config config = session_config();
  config.paper.horizon = 20;
  std::size_t max = 0;
  for (const std::uint32_t guidance : {HRT_GUIDANCE_ARRIVAL, HRT_GUIDANCE_FIXED_DIRECTION}) {
    config.guidance = guidance;
    create(config);
    const hrt_reach_config reach = reach_config(add(HRT_TARGET_REAL, -5.0), add(HRT_TARGET_VIRTUAL, 5.0));
    max = std::max(max, used([&] {
                     (void)hrt_reach_begin(session, &reach);
                     auto command = output<hrt_command>();
                     for (int i = 0; i < 200; ++i) {
                       const hrt_sample sample = position_sample(std::int64_t{i} * 11'111'111, 0.0, -0.05 + 0.0005 * i);
                       (void)hrt_reach_update(session, &sample, &command);
                       if (i % 20 == 0) (void)hrt_reach_retarget(session, reach.real_target, reach.virtual_target);
                     }
                     auto summary = output<hrt_reach_summary>();
                     (void)hrt_reach_end(session, &summary);
                   }));
  }
  RecordProperty("bytes", static_cast<int>(max));
  EXPECT_LE(max, max_real_time_stack);
}

TEST_F(Stack, OtherCallsUseAtMostTheDocumentedStack) {
  const std::string text = read(HRT_GOLDEN_RECORDING);
  const std::string path = testing::TempDir() + "hrt_stack.csv";
  const std::size_t max = used([&] {
    auto report = output<hrt_replay_report>();
    (void)hrt_recording_replay(nullptr, text.data(), text.size(), &report);
    hrt_scene scene{};
    (void)hrt_scene_load(HRT_DESK_SCENE, nullptr, 0, &scene);
    hrt_target ids[8];
    (void)hrt_scene_register(scene, session, 8, ids);
    hrt_scene_destroy(scene);
    char profile[4096];
    std::uint64_t length = 0;
    (void)hrt_profile_save(session, sizeof profile, profile, &length);
    (void)hrt_profile_load(session, profile, length);
    (void)hrt_recording_start(session, path.c_str());
    auto status = output<hrt_recording_status>();
    (void)hrt_recording_stop(session, &status);
    (void)hrt_recording_replay(path.c_str(), nullptr, 0, &report);
  });
  std::remove(path.c_str());
  RecordProperty("bytes", static_cast<int>(max));
  EXPECT_LE(max, max_stack);
}

#endif

}  // namespace
}  // namespace hrt::test
