// The scenario of all hosts (../scenario.txt) through the Unreal component.
#include "tests/bindings/scenario.h"

#include <gtest/gtest.h>

#include "HapticRetargetingComponent.h"

namespace {

// What scenario.txt calls, in Unreal's terms: centimetres, and right of the mid-line is positive.
class ComponentCaller {
 public:
  explicit ComponentCaller(UHapticRetargetingComponent& component) : component_(component) {}

  scenario::Answer call(const scenario::Call& call) {
    values_.clear();
    const size_t logged = FLogCategory::Lines.size();
    const bool done = made(call);
    if (done) return {false, "", values_};
    return {true, FLogCategory::Lines.size() > logged ? FLogCategory::Lines.back() : "refused without a word", {}};
  }

 private:
  /** Of plate coordinates: x right, y up, z towards the user. */
  static FVector place(const scenario::Call& call, const char* key) {
    return FVector(-100 * call.part(key, 2), 100 * call.part(key, 0), 100 * call.part(key, 1));
  }

  bool made(const scenario::Call& call) {
    const std::string& name = call.name;
    FHapticSummary summary;
    if (name == "configure") return component_.Settings.TactileWeight = call.number("tactile_weight"), true;
    if (name == "target") {
      FHapticTarget target;
      const bool added = component_.AddTarget(call.text("role") == "real" ? EHapticTargetRole::Real : EHapticTargetRole::Virtual, Stub::ToUtf16(call.text("name")).c_str(),
                                              -call.number("direction_deg"), 100 * call.number("distance_m"), target);
      if (added) targets_[call.text("name")] = target;
      return added;
    }
    if (name == "remove") return component_.RemoveTarget(targets_[call.text("name")]);
    if (name == "gap") return gap(call);
    if (name == "begin") return component_.BeginReach(targets_[call.text("real")], targets_[call.text("virtual")]);
    if (name == "retarget") return component_.RetargetReach(targets_[call.text("real")], targets_[call.text("virtual")]);
    if (name == "touched") return component_.ReachTouched(place(call, "at"), 100 * call.number("sd_m"));
    if (name == "cancel") return component_.CancelReach();
    if (name == "update") return component_.UpdateFinger(place(call, "at"), 1e-9 * call.number("time_ns"));
    if (name == "lost") {
      const bool done = component_.UpdateLost(1e-9 * call.number("time_ns"));
      values_["flags"] = component_.GetCommand().Flags;
      return done;
    }
    if (name == "slide") return slide(place(call, "to"), static_cast<int>(call.number("frames")));
    if (name == "end") {
      const bool done = component_.EndReach(summary);
      values_["samples"] = static_cast<double>(summary.Samples);
      return done;
    }
    if (name == "save_profile") return component_.SaveProfile(profile_);
    if (name == "load_profile")
      return component_.LoadProfile(call.arguments.contains("text") ? FString(Stub::ToUtf16(call.text("text")).c_str()) : profile_);
    ADD_FAILURE() << name << " is no call of the scenario";
    return false;
  }

  bool gap(const scenario::Call& call) {
    FHapticGap found;
    const bool done = component_.GetGap(targets_[call.text("real")], targets_[call.text("virtual")], found);
    values_ = {{"gap_deg", -found.GapYaw}, {"max_gap_deg", found.MaxGap}, {"margin_deg", found.Margin}, {"reachable", found.bReachable}};
    return done;
  }

  bool slide(const FVector& to, int frames) {
    const FVector from(-5, 0, 0);
    for (int i = 0; i < frames; ++i)
      if (!component_.UpdateFinger(from + (to + from * -1.0) * (i / (frames - 1.0)), 0.011111111 * i)) return false;
    return true;
  }

  UHapticRetargetingComponent& component_;
  std::map<std::string, FHapticTarget> targets_;
  FString profile_;
  std::map<std::string, double> values_;
};

TEST(UnrealScenario, IsThatOfAllHosts) {
  UHapticRetargetingComponent component;
  ComponentCaller caller(component);
  scenario::play(HRT_SCENARIO, false, [&](const scenario::Call& call) { return caller.call(call); });
  component.BeginDestroy();
}

}  // namespace
