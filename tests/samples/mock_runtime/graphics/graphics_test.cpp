// Sessions with Vulkan: devices, swapchains, layers and pictures. Quotations above the tests are from the OpenXR
// specification. The tests need a Vulkan driver, such as Mesa's lavapipe.
#include <fcntl.h>
#include <png.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <semaphore>
#include <thread>

#include "samples/mock_runtime/graphics/picture.h"
#include "tests/samples/mock_runtime/graphics/vulkan_application.h"
#include "tests/samples/process.h"

namespace hrt::mock {
namespace {

Picture read_png(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
    ADD_FAILURE() << path << ": " << image.message;
    return {1, 1};
  }
  image.format = PNG_FORMAT_RGBA;
  Picture picture(image.width, image.height);
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr), 0) << path;
  return picture;
}

const std::vector<const char*> drawing_extensions = [] {
  std::vector<const char*> names = default_extensions();
  names.push_back(XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME);
  return names;
}();

constexpr std::array<float, 4> red{1.0F, 0.0F, 0.0F, 1.0F}, green{0.0F, 1.0F, 0.0F, 1.0F}, blue{0.0F, 0.0F, 1.0F, 1.0F};

class MockGraphics : public MockRuntime {
 protected:
  MockGraphics() : MockRuntime(drawing_extensions) {}
  void SetUp() override {
    MockRuntime::SetUp();
    setenv("HRT_MOCK_PICTURES", folder.path.c_str(), 1);
  }
  void TearDown() override {
    if (session != XR_NULL_HANDLE) {
      EXPECT_XR(XR_SUCCESS, xrDestroySession(session));
    }
    application.reset();
    unsetenv("HRT_MOCK_PICTURES");
    MockRuntime::TearDown();
  }

  XrResult create_drawing_session(const void* binding) {
    const XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO, binding, 0, system};
    return xrCreateSession(instance, &info, &session);
  }
  void begin_drawing(const std::string& script = "{}") {
    apply(script);
    application.emplace(instance, system);
    application->request_requirements();
    application->create_device();
    const XrGraphicsBindingVulkanKHR binding = application->binding();
    ASSERT_XR(XR_SUCCESS, create_drawing_session(&binding));
    focus();
    local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  }

  static XrSwapchainCreateInfo swapchain_info(std::int64_t format = VK_FORMAT_R8G8B8A8_SRGB) {
    constexpr auto usage = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT;
    return {XR_TYPE_SWAPCHAIN_CREATE_INFO, nullptr, 0, usage, format, 1, 64, 48, 1, 1, 1};
  }
  XrSwapchain make_swapchain(const XrSwapchainCreateInfo& info) { return output(xrCreateSwapchain, session, info); }
  static XrResult wait_image(XrSwapchain swapchain) {
    const XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO, nullptr, XR_INFINITE_DURATION};
    return xrWaitSwapchainImage(swapchain, &wait);
  }
  // Fills the next image of a swapchain: layer i with colours[i].
  void draw(XrSwapchain swapchain, const std::vector<std::array<float, 4>>& colours) {
    std::uint32_t index = 0, count = 0;
    ASSERT_XR(XR_SUCCESS, xrAcquireSwapchainImage(swapchain, nullptr, &index));
    ASSERT_XR(XR_SUCCESS, wait_image(swapchain));
    std::array<XrSwapchainImageVulkanKHR, 3> images{};
    images.fill({XR_TYPE_SWAPCHAIN_IMAGE_VULKAN_KHR});
    ASSERT_XR(XR_SUCCESS, xrEnumerateSwapchainImages(swapchain, 3, &count,
                                                     reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())));
    for (std::uint32_t layer = 0; layer < colours.size(); ++layer)
      application->fill(images[index].image, layer, colours[layer]);
    ASSERT_XR(XR_SUCCESS, xrReleaseSwapchainImage(swapchain, nullptr));
  }

  // A projection layer of two views of a swapchain; the right view uses array layer `right`.
  struct Projection {
    Projection(XrSpace space, XrSwapchain swapchain, std::uint32_t right = 0) {
      for (std::uint32_t eye = 0; eye < 2; ++eye) {
        views[eye] = {XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW};
        views[eye].pose = identity_pose;
        views[eye].fov = {-0.7F, 0.7F, 0.7F, -0.7F};
        views[eye].subImage = {swapchain, {{0, 0}, {64, 48}}, eye == 0 ? 0 : right};
      }
      layer.space = space;
      layer.viewCount = 2;
      layer.views = views.data();
    }
    ~Projection() = default;
    Projection(const Projection&) = delete;
    Projection& operator=(const Projection&) = delete;
    std::array<XrCompositionLayerProjectionView, 2> views{};
    XrCompositionLayerProjection layer{XR_TYPE_COMPOSITION_LAYER_PROJECTION};
  };
  XrResult end_frame(const std::vector<const void*>& layers) {
    XrFrameState state{XR_TYPE_FRAME_STATE};
    EXPECT_XR(XR_SUCCESS, xrWaitFrame(session, nullptr, &state));
    EXPECT_TRUE(state.shouldRender);
    EXPECT_GE(xrBeginFrame(session, nullptr), XR_SUCCESS);
    return submit(state.predictedDisplayTime, layers);
  }
  XrResult submit(XrTime time, const std::vector<const void*>& layers) {
    const auto count = static_cast<std::uint32_t>(layers.size());
    const auto* const given = reinterpret_cast<const XrCompositionLayerBaseHeader* const*>(layers.data());
    const XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO, nullptr, time, XR_ENVIRONMENT_BLEND_MODE_OPAQUE, count, given};
    return xrEndFrame(session, &end);
  }
  Picture picture(const std::string& name) { return read_png(folder / name); }

  std::optional<VulkanApplication> application;
};

std::array<int, 3> colour(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  const std::uint8_t* at = picture.at(x, y);
  return {at[0], at[1], at[2]};
}
constexpr std::array red_pixel{255, 0, 0}, green_pixel{0, 255, 0};

TEST(MockGraphicsRequirements, SessionFailsUnlessRequirementsWereRequestedOrWithoutABinding) {
  const std::vector<const char*> names{XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME};
  const XrInstanceCreateInfo info = instance_info(names);
  XrInstance instance = XR_NULL_HANDLE;
  ASSERT_XR(XR_SUCCESS, xrCreateInstance(&info, &instance));
  const XrGraphicsBindingVulkanKHR binding{XR_TYPE_GRAPHICS_BINDING_VULKAN_KHR};
  XrSessionCreateInfo create{XR_TYPE_SESSION_CREATE_INFO, &binding, 0, 1};
  EXPECT_XR(XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING, result_of(xrCreateSession, instance, create));
  create.next = nullptr;
  EXPECT_XR(XR_ERROR_GRAPHICS_DEVICE_INVALID, result_of(xrCreateSession, instance, create));
  EXPECT_XR(XR_SUCCESS, xrDestroyInstance(instance));
}

TEST_F(MockGraphics, SessionGainsFocusWithItsFirstFrame) {
  begin_drawing();
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_READY}));
  EXPECT_XR(XR_SUCCESS, end_frame({}));
  EXPECT_EQ(all_states(),
            (std::vector{XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED}));
}

TEST_F(MockGraphics, ExitRequestBeforeTheFirstFrameStopsTheSession) {
  begin_drawing();
  EXPECT_XR(XR_SUCCESS, xrRequestExitSession(session));
  EXPECT_EQ(all_states(), (std::vector{XR_SESSION_STATE_IDLE, XR_SESSION_STATE_READY, XR_SESSION_STATE_SYNCHRONIZED,
                                       XR_SESSION_STATE_STOPPING}));
  EXPECT_XR(XR_SUCCESS, xrEndSession(session));
}

// "XR_ERROR_CALL_ORDER_INVALID" if all images are acquired; "if no image has been acquired", or the application has
// waited for it already; "if [an] image has not been waited for".
TEST_F(MockGraphics, ImagesMustBeAcquiredWaitedForAndReleasedInThisOrder) {
  begin_drawing();
  const XrSwapchain swapchain = make_swapchain(swapchain_info());
  std::uint32_t index = 99;
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, wait_image(swapchain));
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrReleaseSwapchainImage(swapchain, nullptr));
  std::vector<std::uint32_t> acquired;
  while (xrAcquireSwapchainImage(swapchain, nullptr, &index) == XR_SUCCESS) acquired.push_back(index);
  EXPECT_EQ(acquired, (std::vector{0U, 1U, 2U}));
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrAcquireSwapchainImage(swapchain, nullptr, &index));
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrReleaseSwapchainImage(swapchain, nullptr));
  EXPECT_XR(XR_SUCCESS, wait_image(swapchain));
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, wait_image(swapchain));
  EXPECT_XR(XR_SUCCESS, xrReleaseSwapchainImage(swapchain, nullptr));
  EXPECT_XR(XR_SUCCESS, xrAcquireSwapchainImage(swapchain, nullptr, &index));
  EXPECT_EQ(index, 0U);
  EXPECT_XR(XR_SUCCESS, xrDestroySwapchain(swapchain));
  EXPECT_XR(XR_ERROR_HANDLE_INVALID, wait_image(swapchain));

  // "XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT [...] the application must only acquire and release one image".
  XrSwapchainCreateInfo info = swapchain_info();
  info.createFlags = XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT;
  const XrSwapchain still = make_swapchain(info);
  draw(still, {red});
  EXPECT_XR(XR_ERROR_CALL_ORDER_INVALID, xrAcquireSwapchainImage(still, nullptr, &index));
}

TEST_F(MockGraphics, UnsupportedSwapchainsAreRejected) {
  begin_drawing();
  const auto expect = [&](XrResult result, auto change) {
    XrSwapchainCreateInfo info = swapchain_info();
    change(info);
    EXPECT_XR(result, result_of(xrCreateSwapchain, session, info));
  };
  expect(XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, [](auto& info) { info.format = VK_FORMAT_R8_SRGB; });
  expect(XR_ERROR_FEATURE_UNSUPPORTED, [](auto& info) { info.faceCount = 6; });
  expect(XR_ERROR_FEATURE_UNSUPPORTED, [](auto& info) { info.sampleCount = 4; });
  expect(XR_ERROR_FEATURE_UNSUPPORTED, [](auto& info) { info.mipCount = 20; });
  expect(XR_ERROR_FEATURE_UNSUPPORTED,
         [](auto& info) { info.createFlags = XR_SWAPCHAIN_CREATE_PROTECTED_CONTENT_BIT; });
  expect(XR_ERROR_FEATURE_UNSUPPORTED,
         [](auto& info) { info.usageFlags = XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT; });
  expect(XR_ERROR_VALIDATION_FAILURE, [](auto& info) { info.faceCount = 2; });
  expect(XR_ERROR_VALIDATION_FAILURE, [](auto& info) { info.width = 0; });
  expect(XR_ERROR_VALIDATION_FAILURE, [](auto& info) { info.height = 5000; });
  expect(XR_ERROR_VALIDATION_FAILURE, [](auto& info) { info.usageFlags = 0x100; });
}

// "XR_ERROR_LAYER_INVALID [...] if [a] swapchain image has not been released"; then one invalid field after another.
TEST_F(MockGraphics, InvalidLayersAreRejected) {
  begin_drawing();
  const XrSwapchain colours = make_swapchain(swapchain_info());
  Projection projection(local, colours);
  EXPECT_XR(XR_ERROR_LAYER_INVALID, end_frame({&projection.layer}));
  draw(colours, {red});
  EXPECT_XR(XR_SUCCESS, end_frame({&projection.layer}));
  const auto expect = [&](XrResult result, auto& member, auto bad) {
    const auto good = std::exchange(member, bad);
    EXPECT_XR(result, end_frame({&projection.layer}));
    member = good;
  };
  expect(XR_ERROR_SWAPCHAIN_RECT_INVALID, projection.views[1].subImage.imageRect.offset.x, 1);
  expect(XR_ERROR_SWAPCHAIN_RECT_INVALID, projection.views[0].subImage.imageRect.extent.height, 0);
  expect(XR_ERROR_VALIDATION_FAILURE, projection.views[0].subImage.imageArrayIndex, 1U);
  expect(XR_ERROR_HANDLE_INVALID, projection.views[0].subImage.swapchain, XrSwapchain{XR_NULL_HANDLE});
  expect(XR_ERROR_POSE_INVALID, projection.views[0].pose.orientation.w, 0.5F);
  expect(XR_ERROR_VALIDATION_FAILURE, projection.layer.viewCount, 1U);
  XrCompositionLayerQuad quad{XR_TYPE_COMPOSITION_LAYER_QUAD};
  quad.space = local;
  quad.subImage = projection.views[0].subImage;
  EXPECT_XR(XR_ERROR_POSE_INVALID, end_frame({&quad}));
  quad.pose = identity_pose;
  quad.eyeVisibility = static_cast<XrEyeVisibility>(3);
  EXPECT_XR(XR_ERROR_VALIDATION_FAILURE, end_frame({&quad}));
}

TEST_F(MockGraphics, PicturesShowBothEyesOfTheFirstProjectionAndNoQuad) {
  begin_drawing(R"({"events": [{"frame": 2, "do": "take_picture"}]})");
  XrSwapchainCreateInfo info = swapchain_info();
  info.arraySize = 2;
  info.mipCount = 3;
  const XrSwapchain both = make_swapchain(info), board = make_swapchain(swapchain_info(VK_FORMAT_B8G8R8A8_SRGB));
  draw(both, {red, green});
  draw(board, {blue});
  const Projection projection(local, both, 1);
  XrCompositionLayerQuad quad{XR_TYPE_COMPOSITION_LAYER_QUAD};
  quad.space = local;
  quad.subImage = {board, {{0, 0}, {64, 48}}, 0};
  quad.pose = identity_pose;
  EXPECT_XR(XR_SUCCESS, end_frame({&quad, &projection.layer}));
  EXPECT_EQ(read_file(folder / "pictures.txt"), "") << "the script selects frame 2";
  EXPECT_XR(XR_SUCCESS, end_frame({&quad, &projection.layer}));
  const Picture left = picture("000002_left.png"), right = picture("000002_right.png");
  ASSERT_EQ(left.width, 64U);
  ASSERT_EQ(left.height, 48U);
  EXPECT_EQ(colour(left, 60, 40), red_pixel);
  EXPECT_EQ(colour(right, 60, 40), green_pixel);
  EXPECT_TRUE(has(read_file(folder / "pictures.txt"), "left 64x48 " + hash_of(left) + "\n"));
}

// Some engines wait and render on two threads. The format has blue in the first byte of a pixel.
TEST_F(MockGraphics, PictureIsCorrectIfOneThreadWaitsAndAnotherRenders) {
  begin_drawing(R"({"picture_every_frames": 5})");
  const XrSwapchain swapchain = make_swapchain(swapchain_info(VK_FORMAT_B8G8R8A8_SRGB));
  const Projection projection(local, swapchain);
  std::array<XrTime, 20> times{};
  std::counting_semaphore waited(0);
  std::thread waiter([&] {
    for (XrTime& time : times) {
      XrFrameState state{XR_TYPE_FRAME_STATE};
      EXPECT_XR(XR_SUCCESS, xrWaitFrame(session, nullptr, &state));
      time = state.predictedDisplayTime;
      waited.release();
    }
  });
  for (const XrTime& time : times) {
    waited.acquire();
    EXPECT_XR(XR_SUCCESS, xrBeginFrame(session, nullptr));
    draw(swapchain, {red});
    EXPECT_XR(XR_SUCCESS, submit(time, {&projection.layer}));
  }
  waiter.join();
  EXPECT_EQ(colour(picture("000016_left.png"), 60, 40), red_pixel);
}

// Godot begins no session without a depth format.
TEST_F(MockGraphics, DepthImagesCanBeAcquiredAndReleased) {
  begin_drawing();
  XrSwapchainCreateInfo info = swapchain_info(VK_FORMAT_D32_SFLOAT);
  info.usageFlags = XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  draw(make_swapchain(info), {});
}

// Headless applications run without Vulkan.
TEST(MockGraphicsLibraries, RuntimeIsNotLinkedToVulkan) {
  const Outcome needed = Process({"/usr/bin/readelf", "-d", HRT_MOCK_LIBRARY}, {}).wait();
  EXPECT_TRUE(has(needed.out, "libpng"));
  EXPECT_FALSE(has(needed.out, "libvulkan"));
}

// Khronos' sample hello_xr, unmodified, from Debian's package.
class MockHelloXr : public ::testing::Test {
 protected:
  static Outcome run_hello_xr(const std::string& script, const std::string& pictures) {
    const std::vector<std::string> words{HRT_MOCK_RUN, "--script",          script, "--frames", pictures,
                                         "--",         "/usr/bin/hello_xr", "-g",   "Vulkan2"};
    // With some C libraries hello_xr waits for a key after the session has ended. Then its input is closed; not
    // earlier, because hello_xr exits when its input ends.
    int input[2];
    EXPECT_EQ(pipe2(input, O_CLOEXEC), 0);
    const Process process(words, {"PATH=/usr/bin:/bin", "HOME=" + pictures}, -1, input[0]);
    for (int waits = 0; waits < 6000 && !has(process.out(), "_EXITING"); ++waits) usleep(10'000);
    for (const int end : input) close(end);
    return process.wait();
  }
};

TEST_F(MockHelloXr, ThreeRunsHaveTheSamePixels) {
  const TemporaryFolder folder;
  std::ofstream(folder / "script.json") << R"({"hands": {"left": {"tracked": true}},
    "head": {"path": [{"time_ms": 0, "position_m": [0, 0, 0]}, {"time_ms": 400, "position_m": [0.1, 0.05, 0.3]}]},
    "events": [{"frame": 5, "do": "take_picture"}, {"frame": 20, "do": "take_picture"},
               {"frame": 25, "do": "session_state", "state": "EXITING"}]})";
  std::string first;
  for (const std::string run : {"1", "2", "3"}) {
    std::filesystem::create_directory(folder / run);
    const Outcome outcome = run_hello_xr(folder / "script.json", folder / run);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    const std::string list = read_file(folder / run + "/pictures.txt");
    ASSERT_EQ(occurrences(list, "\n"), 4U) << outcome.out << outcome.err;
    if (first.empty()) first = list;
    EXPECT_EQ(list, first);
  }
  // The pictures show cubes of several colours, in different positions for both eyes, on the same background.
  const Picture left = read_png(folder / "1/000020_left.png"), right = read_png(folder / "1/000020_right.png");
  std::map<std::array<int, 3>, int> colours;
  for (std::uint32_t y = 0; y < left.height; ++y)
    for (std::uint32_t x = 0; x < left.width; ++x) ++colours[colour(left, x, y)];
  EXPECT_GE(colours.size(), 4U);
  EXPECT_NE(hash_of(left), hash_of(right));
  EXPECT_EQ(colour(left, 2, 2), colour(right, 1020, 1020));
}

TEST(MockRun, ExitCodeIsThatOfTheApplicationOr2WithAMessageForInvalidOptions) {
  const TemporaryFolder folder;
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.begin(), HRT_MOCK_RUN);
    return Process(words, {"PATH=/usr/bin:/bin"}).wait();
  };
  EXPECT_EQ(run({"--", "/bin/sh", "-c", "exit 7"}).exit_code, 7);
  EXPECT_EQ(run({"--", "/no/such/program"}).exit_code, 127);
  const Outcome set =
      run({"--log", folder / "calls.log", "--", "/bin/sh", "-c", "echo $XR_RUNTIME_JSON $HRT_MOCK_CALL_LOG"});
  EXPECT_TRUE(has(set.out, "/hrtx_mock_runtime.json " + folder.path.string()));
  EXPECT_TRUE(has(set.err, "0 calls returned an error"));
  const std::string missing = folder / "none.json";
  for (const auto& words : std::vector<std::vector<std::string>>{
           {"--dance", "--", "true"}, {"--script", missing, "--", "true"}, {"--script"}, {"--"}})
    EXPECT_TRUE(has(expect_exit(2, run(words)).err, "hrtx-run: "));
  EXPECT_TRUE(has(run({"--help"}).out, "--frames DIR"));
}

}  // namespace
}  // namespace hrt::mock
