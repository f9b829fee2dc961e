// Runs the scenario of all hosts (../scenario.txt) by the Unreal component: in centimetres, with positive directions to the
// right.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "HapticRetargetingComponent.h"

namespace {

using Words = std::map<std::string, std::string>;

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

/** Converts a position from plate coordinates: x right, y up, z towards the user. */
FVector place(const std::string& text) {
  double x = 0, y = 0, z = 0;
  std::sscanf(text.c_str(), "%lf,%lf,%lf", &x, &y, &z);
  return FVector(-100 * z, 100 * x, 100 * y);
}

/** Returns the text before and after the separator. */
std::pair<std::string, std::string> split(const std::string& text, const char* separator) {
  const size_t at = text.find(separator);
  return {text.substr(0, at), at == std::string::npos ? "" : text.substr(at + std::strlen(separator))};
}

Words pairs(const std::string& words) {
  Words found;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) found.insert(split(word, "="));
  return found;
}

class UnrealScenario : public testing::Test {
 protected:
  void TearDown() override { component_.BeginDestroy(); }

  bool add(Words& a) {
    const auto role = a["role"] == "real" ? EHapticTargetRole::Real : EHapticTargetRole::Virtual;
    FHapticTarget target;
    const bool added = component_.AddTarget(role, Stub::ToUtf16(a["name"]).c_str(), -number(a["direction_deg"]),
                                            100 * number(a["distance_m"]), target);
    if (added) targets_[a["name"]] = target;
    return added;
  }

  bool gap(Words& a) {
    FHapticGap found;
    const bool done = component_.GetGap(targets_[a["real"]], targets_[a["virtual"]], found);
    values_ = {{"gap_deg", -found.GapYaw},
               {"max_gap_deg", found.MaxGap},
               {"margin_deg", found.Margin},
               {"reachable", found.bReachable}};
    return done;
  }

  bool lost(Words& a) {
    const bool done = component_.UpdateLost(1e-9 * number(a["time_ns"]));
    values_["flags"] = component_.GetCommand().Flags;
    return done;
  }

  bool slide(Words& a) {
    const Words usual{{"from", "0,0,0.05"}, {"begin_ns", "0"}, {"every_ns", "11111111"}, {"copies", "1"}};
    a.insert(usual.begin(), usual.end());
    const FVector from = place(a["from"]), to = place(a["to"]);
    const int frames = std::stoi(a["frames"]), copies = std::stoi(a["copies"]);
    for (int i = 0; i < frames; ++i) {
      const FVector at = from + (to + from * -1.0) * ((i - i % copies) / (frames - 1.0));
      const double time_s = 1e-9 * (number(a["begin_ns"]) + i * number(a["every_ns"]));
      if (a.contains("real") && !component_.RetargetReach(targets_[a["real"]], targets_[a["virtual"]])) return false;
      if (!component_.UpdateFinger(at, time_s)) return false;
    }
    values_["flags"] = component_.GetCommand().Flags;
    return true;
  }

  bool set_up(Words& a) {
    if (!component_.BeginSetup(std::stoi(a["what"])) || !component_.BeginSimulatedFinger({}, 1)) return false;
    component_.OnSetupFinished.Add([&](const FHapticSetupResult& found) {
      values_ = {{"done", found.Done}, {"left", found.Left}, {"dropped", found.Dropped}};
    });
    FVector finger;
    for (int i = 0; component_.IsSettingUp() && i < std::stoi(a["frames"]); ++i)
      if (!component_.UpdateSimulatedFinger(0.011111111 * i, finger)) return false;
    return true;
  }

  bool end(Words&) {
    FHapticSummary summary;
    const bool done = component_.EndReach(summary);
    values_["samples"] = static_cast<double>(summary.Samples);
    return done;
  }

  std::map<std::string, std::function<bool(Words&)>> calls() {
    UHapticRetargetingComponent& c = component_;
    return {
        {"configure", [&](Words& a) { return c.Settings.TactileWeight = number(a["tactile_weight"]), true; }},
        {"target", [&](Words& a) { return add(a); }},
        {"remove", [&](Words& a) { return c.RemoveTarget(targets_[a["name"]]); }},
        {"gap", [&](Words& a) { return gap(a); }},
        {"begin", [&](Words& a) { return c.BeginReach(targets_[a["real"]], targets_[a["virtual"]]); }},
        {"retarget", [&](Words& a) { return c.RetargetReach(targets_[a["real"]], targets_[a["virtual"]]); }},
        {"touched", [&](Words& a) { return c.ReachTouched(place(a["at"]), 100 * number(a["sd_m"])); }},
        {"cancel", [&](Words&) { return c.CancelReach(); }},
        {"update", [&](Words& a) { return c.UpdateFinger(place(a["at"]), 1e-9 * number(a["time_ns"])); }},
        {"lost", [&](Words& a) { return lost(a); }},
        {"slide", [&](Words& a) { return slide(a); }},
        {"set_up", [&](Words& a) { return set_up(a); }},
        {"end", [&](Words& a) { return end(a); }},
        {"save_profile", [&](Words&) { return c.SaveProfile(profile_); }},
        {"load_profile",
         [&](Words& a) { return c.LoadProfile(a.contains("text") ? FString(Stub::ToUtf16(a["text"]).c_str()) : profile_); }},
    };
  }

  UHapticRetargetingComponent component_;
  std::map<std::string, FHapticTarget> targets_;
  FString profile_;
  std::map<std::string, double> values_;
};

TEST_F(UnrealScenario, GivesTheExpectedResults) {
  auto host = calls();
  int played = 0;
  std::ifstream file(HRT_SCENARIO);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    SCOPED_TRACE(line);
    ++played;
    const auto [before, refused] = split(line, " ! ");
    const auto [call, gives] = split(before, " -> ");
    const auto [name, arguments] = split(call, " ");
    Words words = pairs(arguments);
    EXPECT_EQ(host.at(name)(words), refused.empty());
    if (!refused.empty()) {
      EXPECT_NE(FLogCategory::Lines.back().find(split(refused, " ").second), std::string::npos);
    }
    for (const auto& [key, text] : pairs(gives)) {
      const bool is_flag = key == "flags";  // one flag must be set, others may be
      const double value = is_flag ? static_cast<int>(values_.at(key)) & std::stoi(text) : values_.at(key);
      EXPECT_NEAR(value, number(text), 1e-4);
    }
  }
  EXPECT_GT(played, 30);
}

}  // namespace
