// The class without the engine: a frame of a reach takes no memory.

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <new>

#include "../../../plugin/bindings/godot/plate_node.h"

namespace {
int64_t allocations = 0;
}

void* operator new(size_t size) {
  ++allocations;
  void* memory = std::malloc(size);
  if (!memory) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
  std::free(memory);
}

namespace {

using namespace hrt_godot;

class StillEngine : public Engine {
 public:
  Pose node_pose() override { return pose; }
  void move_node(const Pose& to) override { pose = to; }
  void emit(const Signal&, const Value&) override { ++signals; }
  void push_error(const char* text) override { FAIL() << text; }
  int64_t signals = 0;
  Pose pose{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
};

const Method& method(std::string_view name) {
  for (const Method& each : methods())
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
    node.call(update, std::array<Value, 2>{Vector3{0, 0, 0.05 - 0.1 * static_cast<double>(frame) / 270},
                                           frame * 11'111'111});
  EXPECT_EQ(allocations, before);
  EXPECT_GT(engine.signals, 200);
}

}  // namespace
