// The class without the engine: a frame of a reach takes no memory.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>

#include "../../../plugin/bindings/godot/plate_node.h"
#include "tests/plugin/plate/pty_device.h"

namespace {
int64_t allocations = 0;
}

void* operator new(size_t size) {
  ++allocations;
  void* memory = std::malloc(size);
  if (!memory) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }

namespace {

using namespace hrt_godot;

class StillEngine : public Engine {
 public:
  Pose node_pose() override { return pose; }
  void move_node(const Pose& to) override { pose = to; }
  void emit(const Signal&, const Value&) override { ++signals; }
  void push_error(const char* text) override { FAIL() << text; }
  void update_warnings() override { ++warnings; }
  int64_t signals = 0, warnings = 0;
  Pose pose;
};

const Method& method(std::string_view name) {
  for (const Method& each : methods)
    if (each.name == name) return each;
  throw std::out_of_range("no such method");
}

TEST(GodotNode, UpdatesWithoutTakingMemory) {
  StillEngine engine;
  PlateNode node(engine);
  const Value real = node.call(method("add_real_target"), std::array<Value, 3>{"cylinder", -5.0, 0.1});
  const Value felt = node.call(method("add_virtual_target"), std::array<Value, 3>{"cup", 5.0, 0.1});
  node.call(method("begin"), std::array{real, felt});
  const Method& update = method("update");
  const int64_t before = allocations;
  for (int64_t frame = 0; frame <= 270; ++frame)
    node.call(update,
              std::array<Value, 2>{Vector3{0, 0, 0.05 - 0.1 * static_cast<double>(frame) / 270}, frame * 11'111'111});
  EXPECT_EQ(allocations, before);
  EXPECT_GT(engine.signals, 200);
}

TEST(GodotNode, WarnsOfItsPropertiesAndPlace) {
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

TEST(GodotNode, TakesWhatItsDeviceReports) {
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
