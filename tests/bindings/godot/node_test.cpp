#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "../../../plugin/bindings/godot/plate_node.h"
#include "samples/app/emulator/pty_device.h"
#include "tests/plugin/plate/eventually.h"

namespace {
std::int64_t allocations = 0;
}  // namespace

// Replaces operator new of the whole program, to count allocations by the class.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using namespace hrt_godot;

class StillEngine : public Engine {
 public:
  Pose node_pose() override { return pose; }
  void move_node(const Pose& to) override { pose = to; }
  void emit(const Signal& signal, const Value&) override {
    ++signals;
    arrivals += signal.name == std::string_view("arrived");
  }
  void push_error(const char* text) override {
    if (!errors) FAIL() << text;
    errors->push_back(text);
  }
  void push_warning(const char*) override {}
  std::string system_path(std::string path) override {
    return path.starts_with("user://") ? "/nowhere/" + path.substr(7) : path;
  }
  void update_warnings() override { ++warnings; }
  int64_t signals = 0, warnings = 0, arrivals = 0;
  std::vector<std::string>* errors = nullptr;  // null: an error fails the test
  Pose pose;
};

const Method& method(std::string_view name) {
  for (const Method& each : methods)
    if (each.name == name) return each;
  throw std::out_of_range("no such method");
}

void begin_reach(PlateNode& node) {
  const Value real = node.call(method("add_real_target"), std::array<Value, 3>{"cylinder", -5.0, 0.1});
  const Value felt = node.call(method("add_virtual_target"), std::array<Value, 3>{"cup", 5.0, 0.1});
  node.call(method("begin"), std::array{real, felt});
}

TEST(GodotNode, UpdatesWithoutAllocatingMemoryAndArrives) {
  StillEngine engine;
  PlateNode node(engine);
  begin_reach(node);
  const Method& update = method("update");
  const auto move = [&](int64_t frame, const Vector3& finger) {
    const std::int64_t before = allocations;
    node.call(update, std::array<Value, 2>{finger, frame * 11'111'111});
    EXPECT_EQ(allocations, before);
  };
  for (int64_t frame = 0; frame <= 270; ++frame) move(frame, {0, 0, 0.05 - 0.1 * static_cast<double>(frame) / 270});
  EXPECT_GT(engine.signals, 200);
  EXPECT_EQ(engine.arrivals, 0);
  for (int64_t frame = 271; frame <= 330; ++frame)  // the finger rests; equal positions would be dropouts
    move(frame, {1e-5 * static_cast<double>(frame % 2), 0, -0.05});
  EXPECT_EQ(engine.arrivals, 1);
  EXPECT_NE(node.get_command_flags() & HRT_COMMAND_ARRIVED, 0);
  EXPECT_LT(node.get_command_distance_to_go_m(), 0.02);
}

TEST(GodotNode, ErrorsUseTheNamesOfScripts) {
  StillEngine engine;
  std::vector<std::string> errors;
  engine.errors = &errors;
  PlateNode node(engine);
  const auto error = [&](std::string_view name, std::span<const Value> arguments) {
    errors.clear();
    node.call(method(name), arguments);
    return errors.empty() ? std::string() : errors.front();
  };
  EXPECT_EQ(error("remove_target", std::array<Value, 1>{int64_t{5}}).find("remove_target: "), 0u);
  begin_reach(node);
  EXPECT_EQ(error("update", std::array<Value, 2>{Vector3{0, 0, 0.05}, 0.5}),
            "called with (Vector3, float); allowed: update(world_position: Vector3, time_ns: int)");
  EXPECT_EQ(error("end", {}), "end: the reach has had no sample; cancel() ends it");
  node.call(method("update"), std::array<Value, 2>{Vector3{0, 0, 0.05}, int64_t{5}});
  EXPECT_NE(error("touched_real_target", {}).find("the plate is not registered (SESSION_REGISTERED)"),
            std::string::npos);
  node.cancel();
  EXPECT_NE(error("load_scene", std::array<Value, 1>{"user://desk.gltf"}).find("load_scene: /nowhere/desk.gltf"),
            std::string::npos);
}

TEST(GodotNode, WarnsOfInvalidPropertiesAndPose) {
  StillEngine engine;
  PlateNode node(engine);
  EXPECT_EQ(node.warning(), "");
  const auto bound = std::ranges::find(properties, std::string_view("plate_bound_deg"), &Property::name);
  node.set(*bound, 91.0);
  EXPECT_EQ(engine.warnings, 1);
  EXPECT_NE(node.warning().find("plate_bound_deg is 91; allowed: 0.1 to 90"), std::string::npos);
  node.set(*bound, 84.5);
  engine.pose.basis(0, 0) = 2;
  EXPECT_EQ(node.warning(), kNotRigid);
}

TEST(GodotNode, UsesTheOrientationThatItsDeviceReports) {
  const hrt::plate::PtyDynamixel servo;
  StillEngine engine;
  PlateNode node(engine);
  EXPECT_EQ(node.take_device(), Error::kUnavailable);
  ASSERT_EQ(node.open_device("dynamixel:" + servo.device() + "?speed=200"), Error::kOk);
  EXPECT_TRUE(hrt::plate::eventually([&] { return node.take_device() == Error::kOk; }));
  const auto speed = std::ranges::find(properties, std::string_view("plate_max_speed_deg_s"), &Property::name);
  EXPECT_NEAR(std::get<double>(node.get(*speed)), 200.0, 0.7);
}

TEST(GodotNode, EditorExplainsEveryMethodAndSignal) {
  const std::string_view reference = class_reference;
  const auto explains = [&](const std::string& kind, const char* name) {
    return reference.find('<' + kind + " name=\"" + name + "\"><description>") != std::string_view::npos;
  };
  for (const Method& each : methods) EXPECT_TRUE(explains("method", each.name)) << each.name;
  for (const Signal& each : kSignals) EXPECT_TRUE(explains("signal", each.name)) << each.name;
}

}  // namespace
