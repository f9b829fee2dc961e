// The extension for Godot 4 in a double of the engine; see engine_double.h for what that shows and what not.

#include <gtest/gtest.h>
#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/plate.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cinttypes>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include "engine_double.h"
#include "tests/bindings/scenario.h"

namespace {

using godot4_double::Any;
using godot4_double::Dictionary;
using godot4_double::Engine;
using godot4_double::Object;
using godot4_double::Vector3;

const std::string kClass = "HapticRetargeting";
constexpr int64_t kOk = 0;

class Extension : public testing::Test {
 protected:
  void SetUp() override {
    const char* other = std::getenv("HRT_EXTENSION");
    ASSERT_TRUE(engine_.load(other != nullptr ? other : HRT_EXTENSION));
    node_ = engine_.create(kClass);
  }
  void TearDown() override {
    engine_.free(node_);
    engine_.unload();
    EXPECT_TRUE(engine_.classes.empty());
    EXPECT_EQ(engine_.live_values, 0) << "strings, variants or Dictionaries of the engine's leak";
  }

  Any call(const std::string& method, const std::vector<Any>& arguments = {}) {
    return engine_.call(node_, method, arguments);
  }
  int64_t call_int(const std::string& method, const std::vector<Any>& arguments = {}) {
    return std::get<int64_t>(call(method, arguments));
  }
  std::string last_error() const { return engine_.errors.empty() ? "" : engine_.errors.back(); }
  void begin() {
    const Any real = call("add_real_target", {"cylinder", -5.0, 0.1});
    const Any felt = call("add_virtual_target", {"cup", 5.0, 0.1});
    targets_ = {real, felt};
    ASSERT_EQ(call_int("begin", targets_), kOk);
  }

  Engine engine_;
  Object* node_ = nullptr;
  std::vector<Any> targets_;
};

TEST_F(Extension, RegistersTheClass) {
  const godot4_double::Class& registered = engine_.classes.at(kClass);
  EXPECT_EQ(registered.parent, "Node3D");
  EXPECT_TRUE(registered.info.is_exposed);
  EXPECT_GE(registered.properties.size(), 29u);  // and whatever the headers have added
  EXPECT_EQ(registered.properties.at("control").hint_string, "MPC,Fixed Plate");
  EXPECT_EQ(registered.properties.at("tactile_weight").type, GDE_FLOAT);
  EXPECT_EQ(registered.properties.at("start_position_m").type, GDE_VECTOR3);
  EXPECT_EQ(registered.methods.at("update").arguments.at(1).name, "time_ns");
  EXPECT_EQ(registered.methods.at("get_command").return_type, GDE_DICTIONARY);
  ASSERT_EQ(registered.signals.size(), 3u);
  EXPECT_EQ(registered.signals.at("plate_commanded").at(0).name, "orientation_deg");
}

TEST_F(Extension, BindsTheConstantsOfTheHeaders) {
  const auto& constants = engine_.classes.at(kClass).constants;
  EXPECT_EQ(constants.at("COMMAND_SATURATED"),
            std::pair(std::string("Command"), int64_t{HRT_COMMAND_SATURATED}));
  EXPECT_EQ(constants.at("GUIDANCE_ARRIVAL").second, HRT_GUIDANCE_ARRIVAL);
  EXPECT_FALSE(constants.contains("ERROR_BUSY"));  // methods return Godot's own errors
}

// The name of a node is a StringName; variants reach the extension as they are.
TEST_F(Extension, TakesStringNamesAsStrings) {
  const Any real = call("add_real_target", {godot4_double::StringName{"cylinder"}, -5.0, 0.1});
  EXPECT_NE(std::get<int64_t>(real), 0) << last_error();
  EXPECT_EQ(call_int("add_real_target", {"cylinder", -4.0, 0.1}), 0);  // the name is taken
  EXPECT_NE(last_error().find("cylinder"), std::string::npos) << last_error();
}

// The plate's device: the firmware on an emulated board (with_plate). A busy machine gets 30 s.
TEST_F(Extension, TurnsADevice) {
  const char* device = std::getenv("HRT_PLATE_DEVICE");
  ASSERT_NE(device, nullptr) << "no emulated plate: run by with_plate";
  EXPECT_TRUE(std::get<Dictionary>(call("get_device_report"))->values.empty());
  ASSERT_EQ(call_int("open_device", {device}), kOk) << last_error();
  const auto eventually = [&](const std::string& key, auto wanted) {
    for (int i = 0; i < 3000; ++i) {
      const Dictionary report = std::get<Dictionary>(call("get_device_report"));
      if (std::get<decltype(wanted)>(report->at(key)) == wanted) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  };
  ASSERT_TRUE(eventually("state", int64_t{HRT_PLATE_STATE_READY}))
      << std::get<std::string>(call("get_device_message"));
  EXPECT_EQ(std::get<std::string>(call("get_device_description")),
            "protocol 2, firmware 1.0.0, serial number 000000");
  EXPECT_EQ(call_int("turn_device", {30.0}), kOk);
  EXPECT_TRUE(eventually("command_deg", 30.0));
  EXPECT_EQ(std::get<int64_t>(engine_.ptrcall(node_, "stop_device", {})), kOk);
  EXPECT_EQ(call_int("close_device"), kOk);
  EXPECT_NE(call_int("open_device", {"usb:0"}), kOk);
  EXPECT_NE(last_error().find("hrt_plate_open: device is of kind \"usb\""), std::string::npos)
      << last_error();
  EXPECT_EQ(engine_.classes.at(kClass).constants.at("PLATE_STATE_READY").second, HRT_PLATE_STATE_READY);
}

TEST_F(Extension, PropertiesHoldWhatTheyAreSetTo) {
  EXPECT_EQ(std::get<double>(engine_.get(node_, "tactile_weight")), 0.2);
  engine_.set(node_, "tactile_weight", 0.25);
  engine_.set(node_, "horizon", int64_t{7});
  engine_.set(node_, "start_position_m", Vector3{0, 0, 0.0625f});
  EXPECT_EQ(std::get<double>(engine_.get(node_, "tactile_weight")), 0.25);
  EXPECT_EQ(std::get<int64_t>(engine_.get(node_, "horizon")), 7);
  EXPECT_EQ(std::get<Vector3>(engine_.get(node_, "start_position_m")), (Vector3{0, 0, 0.0625f}));
  engine_.set(node_, "horizon", "three");
  EXPECT_EQ(last_error(), "horizon was given a value of type String; allowed: int from 0 to 4294967295");
}

TEST_F(Extension, TypedCallsDoWhatUntypedOnesDo) {
  const Any real = engine_.ptrcall(node_, "add_real_target", {"cylinder", -5.0, 0.1});
  const Any felt = engine_.ptrcall(node_, "add_virtual_target", {"cup", 5.0, 0.1});
  const Dictionary typed = std::get<Dictionary>(engine_.ptrcall(node_, "get_authority", {real, felt}));
  const Dictionary untyped = std::get<Dictionary>(call("get_authority", {real, felt}));
  EXPECT_EQ(std::get<double>(typed->at("gap_deg")), 10);
  EXPECT_EQ(std::get<int64_t>(typed->at("reachable")), 1);
  EXPECT_EQ(std::get<double>(untyped->at("margin_deg")), std::get<double>(typed->at("margin_deg")));
  EXPECT_EQ(std::get<int64_t>(engine_.ptrcall(node_, "begin", {real, felt})), kOk);
  EXPECT_EQ(std::get<bool>(engine_.ptrcall(node_, "is_reaching", {})), true);
  EXPECT_EQ(std::get<int64_t>(engine_.ptrcall(node_, "update", {Vector3{0, 0, 0.05f}, int64_t{0}})), kOk);
  EXPECT_EQ(std::get<int64_t>(engine_.ptrcall(node_, "end", {})), kOk);
  EXPECT_EQ(std::get<std::string>(engine_.ptrcall(node_, "save_profile", {})),
            std::get<std::string>(call("save_profile")));
  engine_.ptrcall(node_, "set_tactile_weight", {0.25});
  EXPECT_EQ(std::get<double>(engine_.ptrcall(node_, "get_tactile_weight", {})), 0.25);
}

TEST_F(Extension, EmitsSignals) {
  begin();
  ASSERT_EQ(call_int("update_sample", {int64_t{HRT_SAMPLE_DIRECTION}, int64_t{0}, 0.0, 0.0, 0.0, 0.0, 0.0}),
            kOk);
  ASSERT_EQ(node_->emitted.size(), 1u);
  EXPECT_EQ(node_->emitted[0].first, "plate_commanded");
  EXPECT_EQ(std::get<double>(node_->emitted[0].second),
            std::get<double>(std::get<Dictionary>(call("get_command"))->at("plate_orientation_deg")));
  ASSERT_EQ(call_int("update_lost", {int64_t{250'000'000}}), kOk);
  EXPECT_EQ(node_->emitted[1].first, "flags_changed");
  ASSERT_EQ(call_int("end"), kOk);
  EXPECT_EQ(node_->emitted.back().first, "reach_ended");
}

// A quarter turn about y takes the plate's x to the world's -z: the rows of its basis are the world's x, y
// and z.
TEST_F(Extension, TakesTheNodesPlaceAsThePlates) {
  node_->transform = {0, 0, 1, 0, 1, 0, -1, 0, 0, 1, 2, 3};
  const auto world = [](float x, float y, float z) { return Vector3{1 + z, 2 + y, 3 - x}; };
  const Any left = call("add_real_target_at", {"left", world(-0.1f, 0, 0.05f)});
  const Any ahead = call("add_virtual_target_at", {"ahead", world(0, 0, -0.05f)});
  const Dictionary authority = std::get<Dictionary>(call("get_authority", {left, ahead}));
  EXPECT_NEAR(std::get<double>(authority->at("gap_deg")), -90, 1e-3);

  node_->inside_tree = false;  // then its transform is all that there is
  EXPECT_NE(call_int("add_real_target_at", {"again", world(0, 0, -0.05f)}), 0);
  node_->transform[0] = 2;
  EXPECT_EQ(call_int("add_real_target_at", {"scaled", Vector3{}}), 0);
  EXPECT_NE(last_error().find("scaled"), std::string::npos) << last_error();
}

TEST_F(Extension, RefusesWhatIsWrong) {
  EXPECT_EQ(call_int("update", {Vector3{}, int64_t{0}}), 33);  // ERR_DOES_NOT_EXIST: no session yet
  begin();
  EXPECT_EQ(call_int("update", {Vector3{}, int64_t{1000}}), kOk);
  EXPECT_EQ(call_int("update", {Vector3{}, int64_t{999}}), 30);  // ERR_INVALID_DATA
  EXPECT_NE(last_error().find("time_ns is 999"), std::string::npos) << last_error();
  EXPECT_EQ(call_int("update", {Vector3{}}), 31);  // ERR_INVALID_PARAMETER
  EXPECT_EQ(last_error(), "called with (Vector3); it is update(world_position: Vector3, time_ns: int)");
  EXPECT_EQ(call_int("update", {node_, int64_t{2000}}), 31);
  EXPECT_TRUE(std::get<Dictionary>(call("get_authority", {int64_t{1}, int64_t{2}}))->values.empty());
}

TEST_F(Extension, NamesARefusalOfSamplesOnceAReach) {
  for (int reach = 1; reach <= 2; ++reach) {
    begin();
    ASSERT_EQ(call_int("update", {Vector3{}, int64_t{1'000'000}}), kOk);
    for (int64_t frame = 0; frame < 90; ++frame) ASSERT_EQ(call_int("update", {Vector3{}, frame}), 30);
    for (int frame = 0; frame < 90; ++frame)
      ASSERT_NE(call_int("update", {Vector3{2000, 0, 0}, int64_t{2'000'000}}), kOk);
    EXPECT_EQ(engine_.errors.size(), size_t(2 * reach)) << last_error();
    ASSERT_EQ(call_int("end"), kOk);
    ASSERT_EQ(call_int("remove_target", {targets_[0]}), kOk);
    ASSERT_EQ(call_int("remove_target", {targets_[1]}), kOk);
  }
}

TEST_F(Extension, RefusesACalibrationWithTooFewData) {
  ASSERT_EQ(call_int("begin_calibration", {0.0}), kOk);
  ASSERT_EQ(call_int("begin_trial", {30.0}), kOk);
  ASSERT_EQ(call_int("add_trial_sample", {Vector3{0, 0, 0.05f}, int64_t{0}}), kOk);
  ASSERT_EQ(call_int("end_trial"), kOk);
  const Dictionary next = std::get<Dictionary>(call("get_next_angle"));
  EXPECT_EQ(next->values.size(), 2u);
  EXPECT_TRUE(std::get<Dictionary>(call("get_slide", {int64_t{0}}))->values.empty());
  EXPECT_NE(last_error().find("has no solution"), std::string::npos) << last_error();
  EXPECT_EQ(call_int("set_conditions", {std::string("desk 1"), std::string("Ultraleap"), int64_t{5}}), kOk);
  EXPECT_EQ(call_int("set_conditions", {std::string(64, 'x'), std::string(), int64_t{5}}),
            5);  // ERR_PARAMETER_RANGE_ERROR
  EXPECT_NE(last_error().find("plate is not ended by a zero"), std::string::npos) << last_error();
  EXPECT_EQ(std::get<Dictionary>(call("get_conditions"))->values.size(), 2u);
  EXPECT_TRUE(std::get<Dictionary>(call("get_recording_status"))->values.empty());
  ASSERT_EQ(call_int("begin_calibration_within", {0.0, -30.0, 0.0, 0.02}), 5);
  EXPECT_NE(last_error().find("upper_plate_deg is 0"), std::string::npos) << last_error();
  EXPECT_TRUE(std::get<Dictionary>(call("solve_calibration"))->values.empty());
  EXPECT_NE(last_error().find("hrt_calibration_solve"), std::string::npos) << last_error();
  EXPECT_EQ(call_int("apply_calibration"), 2);  // ERR_UNAVAILABLE; and the node ends its calibration
}

// The apparatus of the desk stands at (0.12, 0.75, -0.32), turned by 20 degrees to the left.
TEST_F(Extension, LoadsASceneAndAssignsItsTargets) {
  node_->transform = {0, 0, 1, 0, 1, 0, -1, 0, 0, 1, 2, 3};
  ASSERT_EQ(call_int("load_scene", {std::string(HRT_DESK)}), kOk) << last_error();
  const float cos = std::cos(20 * M_PIf / 180), sin = std::sin(20 * M_PIf / 180);
  const float expected[] = {cos, 0, sin, 0, 1, 0, -sin, 0, cos, 0.12f, 0.75f, -0.32f};
  for (size_t i = 0; i < 12; ++i) EXPECT_NEAR(node_->transform[i], expected[i], 1e-6f) << i;
  EXPECT_EQ(std::get<double>(engine_.get(node_, "plate_max_speed_deg_s")), 400);

  const Any cylinder = call("find_target", {"cylinder"}), bottle = call("find_target", {"bottle"});
  EXPECT_EQ(call_int("find_target", {"teapot"}), 0);
  ASSERT_EQ(call_int("assign_targets", {false}), kOk) << last_error();
  const auto assigned = [&](const Any& target) {
    return std::get<Dictionary>(call("get_assigned", {target}));
  };
  EXPECT_EQ(std::get<int64_t>(assigned(bottle)->at("real_target")), std::get<int64_t>(cylinder));
  EXPECT_NEAR(std::get<double>(assigned(bottle)->at("gap_deg")), 6, 1e-6);
  EXPECT_TRUE(assigned(cylinder)->values.empty());
  EXPECT_NE(last_error().find("call assign_targets() first"), std::string::npos) << last_error();
  ASSERT_EQ(call_int("assign_targets", {true}), kOk) << last_error();
  int64_t served = 0;
  for (const char* name : {"bottle", "goblet", "pawn"})
    served += std::get<int64_t>(assigned(call("find_target", {name}))->at("reachable"));
  EXPECT_EQ(served, 1);

  ASSERT_EQ(call_int("begin", {cylinder, bottle}), kOk) << last_error();
  EXPECT_EQ(call_int("load_scene", {std::string(HRT_DESK)}), 2) << last_error();  // ERR_UNAVAILABLE
  ASSERT_EQ(call_int("cancel"), kOk);
  EXPECT_EQ(call_int("load_scene", {std::string("/nowhere.gltf")}), 43) << last_error();  // ERR_PARSE_ERROR
  EXPECT_EQ(call_int("load_scene", {std::string(HRT_DESK)}), 32) << last_error();  // ERR_ALREADY_EXISTS
}

// A plate at (0.3, 0.75, -0.4) that faces the world's -x, so that its x axis points to -z and its z axis to
// x.
constexpr godot4_double::Transform3D kPlate{0, 0, 1, 0, 1, 0, -1, 0, 0, 0.3f, 0.75f, -0.4f};
Vector3 on_plate(const Vector3& mark) {
  return {0.3f + mark[2], 0.75f + mark[1], -0.4f - mark[0]};
}

TEST_F(Extension, IsRegisteredByTouchesOfMarks) {
  EXPECT_EQ(call_int("apply_registration", {int64_t{0}}), 2);  // ERR_UNAVAILABLE
  EXPECT_NE(last_error().find("call fit_registration() first"), std::string::npos) << last_error();
  const Vector3 marks[] = {
      {0, 0, 0.05f}, {0.076f, 0, 0.044f}, {0.076f, 0, -0.044f}, {-0.076f, 0, -0.044f}, {-0.076f, 0, 0.044f}};
  const auto fit = [&] { return std::get<Dictionary>(call("fit_registration")); };
  EXPECT_EQ(std::get<int64_t>(fit()->at("verdict")), HRT_REGISTRATION_TOO_FEW);
  EXPECT_FALSE(std::get<std::string>(call("get_registration_advice")).empty());
  ASSERT_EQ(call_int("add_mark_touch", {marks[0], Vector3{9, 9, 9}}), kOk);
  ASSERT_EQ(call_int("clear_touches"), kOk);
  for (const Vector3& mark : marks) ASSERT_EQ(call_int("add_mark_touch", {mark, on_plate(mark)}), kOk);
  const Dictionary found = fit();
  ASSERT_EQ(std::get<int64_t>(found->at("verdict")), HRT_REGISTRATION_HOLDS);
  EXPECT_NEAR(std::get<Vector3>(found->at("plate_position_m"))[2], -0.4f, 1e-6f);

  const auto registered = [&] {
    return (std::get<int64_t>(engine_.get(node_, "flags")) & HRT_SESSION_REGISTERED) != 0;
  };
  ASSERT_EQ(call_int("apply_registration", {int64_t{5'000'000}}), kOk) << last_error();
  EXPECT_TRUE(registered());
  for (size_t i = 0; i < 12; ++i) EXPECT_NEAR(node_->transform[i], kPlate[i], 1e-6f) << i;
  const auto confirm = [&](const Vector3& touched, int64_t time_ns) {
    return std::get<Dictionary>(call("confirm_registration", {marks[0], touched, time_ns}));
  };
  EXPECT_EQ(std::get<int64_t>(confirm(on_plate(marks[0]), 7'000'000)->at("holds")), 1) << last_error();
  EXPECT_EQ(std::get<int64_t>(engine_.get(node_, "registration_time_ns")), 7'000'000);
  // The session's plate is the registration's to the last bit, though the node has floats.
  begin();
  ASSERT_EQ(call_int("update", {on_plate({0, 0, 0.05f}), int64_t{8'000'000}}), kOk) << last_error();
  ASSERT_EQ(call_int("cancel"), kOk);
  EXPECT_EQ(std::get<int64_t>(confirm({0.3f, 0.85f, -0.4f}, 9'000'000)->at("holds")), 0) << last_error();
  EXPECT_FALSE(registered());

  ASSERT_EQ(call_int("apply_registration", {int64_t{10'000'000}}), kOk) << last_error();
  node_->transform[9] += 0.01f;
  EXPECT_TRUE(confirm(on_plate(marks[0]), 11'000'000)->values.empty());
  EXPECT_NE(last_error().find("registration is not that of the session"), std::string::npos) << last_error();
  EXPECT_FALSE(registered());
}

TEST_F(Extension, PlacesTheSkinByItsOffsetFromTheJoint) {
  const Any joint = godot4_double::Transform3D{1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3f, 0.758f, -0.395f};
  EXPECT_TRUE(std::isnan(std::get<Vector3>(call("place_fingertip", {joint}))[0]));
  EXPECT_NE(last_error().find("call fit_fingertip() first"), std::string::npos) << last_error();
  // A joint 8 mm above the skin and 5 mm behind it: upright, and turned by quarters about each axis.
  using Rows = std::array<float, 9>;
  constexpr Rows kTurns[] = {{1, 0, 0, 0, 1, 0, 0, 0, 1},
                             {1, 0, 0, 0, 0, -1, 0, 1, 0},
                             {0, 0, 1, 0, 1, 0, -1, 0, 0},
                             {0, -1, 0, 1, 0, 0, 0, 0, 1},
                             {1, 0, 0, 0, 0, 1, 0, -1, 0}};
  constexpr float kOffset[] = {0, -0.008f, -0.005f};
  constexpr float kMark[] = {0.3f, 0.75f, -0.4f};
  std::vector<Any> joints;
  for (const Rows& rows : kTurns) {
    godot4_double::Transform3D turned{};
    for (size_t i = 0; i < 3; ++i) {
      std::copy_n(rows.begin() + 3 * i, 3, turned.begin() + 3 * i);
      turned[9 + i] = kMark[i];
      for (size_t j = 0; j < 3; ++j) turned[9 + i] -= rows[3 * i + j] * kOffset[j];
    }
    joints.push_back(turned);
    ASSERT_EQ(call_int("add_joint_touch", {joints.back()}), kOk);
  }
  const Dictionary fingertip = std::get<Dictionary>(call("fit_fingertip"));
  ASSERT_EQ(std::get<int64_t>(fingertip->at("known")), 1);
  EXPECT_NEAR(std::get<Vector3>(fingertip->at("offset_m"))[1], -0.008f, 1e-6f);
  for (const Any& each : joints) {
    const Vector3 skin = std::get<Vector3>(call("place_fingertip", {each}));
    EXPECT_EQ(std::get<Vector3>(engine_.ptrcall(node_, "place_fingertip", {each})), skin);
    for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(skin[i], kMark[i], 1e-6f);
  }
}

TEST_F(Extension, ComparesOnlySolvedCalibrations) {
  ASSERT_EQ(call_int("begin_calibration", {0.0}), kOk);
  EXPECT_TRUE(std::get<Dictionary>(call("compare_calibrations"))->values.empty());
  EXPECT_NE(last_error().find("two calibrations of this node"), std::string::npos) << last_error();
}

TEST(ExtensionEntry, RefusesAnEngineThatLacksAFunction) {
  Engine engine;
  engine.lacking = "classdb_register_extension_class2";
  EXPECT_FALSE(engine.load(HRT_EXTENSION));
  ASSERT_EQ(engine.errors.size(), 1u);
  EXPECT_EQ(engine.errors[0],
            "this Godot lacks classdb_register_extension_class2; Godot 4.2 or later has it");
}

// What scenario.txt calls, by the node's methods. It has floats, and no code of the library's.
class NodeCaller {
 public:
  NodeCaller(Engine& engine, Object* node) : engine_(engine), node_(node) {}

  scenario::Answer call(const scenario::Call& call) {
    const std::size_t errors = engine_.errors.size();
    const Any gave = made(call);
    scenario::Answer answer{false, "", {}};
    const int64_t* code = std::get_if<int64_t>(&gave);  // an Error, or the id of a target
    answer.failed =
        engine_.errors.size() > errors || (call.name != "target" && code != nullptr && *code != kOk);
    if (answer.failed) answer.error = engine_.errors.back();
    if (const Dictionary* fields = std::get_if<Dictionary>(&gave))
      for (const auto& [name, value] : (*fields)->values) add(answer.values, name, (*fields)->at(name));
    return answer;
  }

 private:
  static void add(std::map<std::string, double>& values, const std::string& name, const Any& value) {
    if (const double* number = std::get_if<double>(&value)) values[name] = *number;
    if (const int64_t* whole = std::get_if<int64_t>(&value)) values[name] = static_cast<double>(*whole);
    if (const Vector3* place = std::get_if<Vector3>(&value); place && name == "plate_position_m")
      values.insert({{"x", (*place)[0]}, {"y", (*place)[1]}, {"z", (*place)[2]}});
  }
  static Vector3 place(const scenario::Call& call, const std::string& key) {
    const auto part = [&](int i) { return static_cast<float>(call.part(key, i)); };
    return {part(0), part(1), part(2)};
  }

  Any made(const scenario::Call& call) {
    const auto target = [&](const char* key) { return targets_[call.text(key)]; };
    const auto time = [&] { return static_cast<int64_t>(call.number("time_ns")); };
    const std::string& name = call.name;
    if (name == "configure")
      return engine_.set(node_, "tactile_weight", call.number("tactile_weight")), Any{};
    if (name == "target") {
      const Any id =
          engine_.call(node_, "add_" + call.text("role") + "_target",
                       {call.text("name"), call.number("direction_deg"), call.number("distance_m")});
      if (std::get<int64_t>(id) != 0) targets_[call.text("name")] = id;
      return id;
    }
    if (name == "remove") return engine_.call(node_, "remove_target", {target("name")});
    if (name == "authority") return engine_.call(node_, "get_authority", {target("real"), target("virtual")});
    if (name == "best") return engine_.call(node_, "get_best_authority", {target("virtual")});
    if (name == "begin" || name == "retarget")
      return engine_.call(node_, name, {target("real"), target("virtual")});
    if (name == "update") return engine_.call(node_, "update", {place(call, "at"), time()});
    if (name == "slide") return slide(place(call, "to"), static_cast<int>(call.number("frames")));
    if (name == "lost")
      return engine_.call(node_, "update_lost", {time()}), engine_.call(node_, "get_command", {});
    if (name == "end") return engine_.call(node_, "end", {}), engine_.call(node_, "get_summary", {});
    if (name == "save_profile") return profile_ = engine_.call(node_, "save_profile", {});
    if (name == "load_profile")
      return engine_.call(node_, "load_profile",
                          {call.arguments.contains("text") ? Any{call.text("text")} : profile_});
    if (name == "touch")
      return engine_.call(node_, "add_mark_touch", {place(call, "mark"), place(call, "at")});
    if (name == "register") return engine_.call(node_, "fit_registration", {});
    return engine_.call(node_, name, {});
  }

  Any slide(const Vector3& to, int frames) {
    for (int i = 0; i < frames; ++i) {
      const float share = static_cast<float>(i) / static_cast<float>(frames - 1);
      engine_.call(
          node_, "update",
          {Vector3{share * to[0], share * to[1], 0.05f + share * (to[2] - 0.05f)}, int64_t{11'111'111} * i});
    }
    return {};
  }

  Engine& engine_;
  Object* node_;
  std::map<std::string, Any> targets_;
  Any profile_;
};

TEST_F(Extension, PlaysTheScenarioOfAllHosts) {
  NodeCaller caller(engine_, node_);
  scenario::play(HRT_SCENARIO, false, [&](const scenario::Call& call) { return caller.call(call); });
}

uint64_t hash_words(uint64_t hash, const Any& value) {
  uint64_t word = 0;
  if (const double* number = std::get_if<double>(&value))
    std::memcpy(&word, number, sizeof word);
  else
    word = static_cast<uint64_t>(std::get<int64_t>(value));
  for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (word >> (8 * byte) & 0xff)) * 0x100000001b3u;
  return hash;
}

// The reach that every host runs: plugin/bindings/README.md.
TEST_F(Extension, RunsTheReachOfAllHosts) {
  engine_.set(node_, "horizon", int64_t{20});
  engine_.set(node_, "guidance", int64_t{HRT_GUIDANCE_ARRIVAL});
  engine_.set(node_, "adaptation", int64_t{HRT_ADAPTATION_REACH});
  engine_.set(node_, "plate_max_speed_deg_s", 200.0);
  engine_.set(node_, "plate_max_acceleration_deg_s2", 20000.0);
  engine_.set(node_, "plate_latency_ns", int64_t{30'000'000});
  engine_.set(node_, "plate_lower_stop_deg", -360.0);
  engine_.set(node_, "plate_upper_stop_deg", 360.0);
  begin();

  std::ifstream recording(HRT_REACH);
  std::map<std::string, size_t> columns;
  uint64_t hash = 0xcbf29ce484222325u;
  for (std::string line; std::getline(recording, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    cells.resize(64);
    if (columns.empty())
      for (size_t i = 0; i < cells.size(); ++i) columns.emplace(cells[i], i);
    if (cells[columns.at("call")] != "update") continue;
    const auto real = [&](const char* name) { return std::strtod(cells[columns.at(name)].c_str(), nullptr); };
    const auto whole = [&](const char* name) {
      return int64_t{std::strtoll(cells[columns.at(name)].c_str(), nullptr, 10)};
    };
    ASSERT_EQ(call_int("update_sample", {whole("sample_flags"), whole("time_ns"), 0.0, real("sample_x_m"),
                                         real("sample_y_m"), real("sample_z_m"), real("measured_plate_deg")}),
              kOk)
        << last_error();
    const Dictionary command = std::get<Dictionary>(call("get_command"));
    for (const char* field :
         {"flags", "step", "plate_orientation_deg", "finger_direction_deg", "perceived_direction_deg",
          "aimed_direction_deg", "distance_to_go_m", "tactile_weight", "tactile_weight_sd", "time_to_go_s",
          "felt_error_deg", "predicted_miss_deg", "normalised_innovation"})
      hash = hash_words(hash, command->at(field));
  }
  ASSERT_EQ(call_int("end"), kOk);

  std::string expected;
  std::ifstream(HRT_REACH_HASH) >> expected;
  char found[32];
  std::snprintf(found, sizeof found, "0x%016" PRIx64, hash);
  std::printf("hash %s\n", found);
  EXPECT_EQ(found, expected);
}

}  // namespace
