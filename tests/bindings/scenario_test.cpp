// The scenario of all hosts through the C interface itself.
#include "tests/bindings/scenario.h"

#include <array>

#include "haptic_retargeting/haptic_retargeting.h"
#include "haptic_retargeting/init.h"
#include "haptic_retargeting/setup.h"

namespace {

using scenario::Answer;
using scenario::Call;

class Caller {
 public:
  Caller() {
    const hrt_session_config config = hrt_session_config_init();
    EXPECT_EQ(hrt_session_create(HRT_VERSION, &config, &session_), HRT_OK);
  }
  ~Caller() { hrt_session_destroy(session_); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  Answer call(const Call& call) {
    values_.clear();
    const hrt_result result = made(call);
    if (result == HRT_OK) return {false, "", values_};
    return {true, hrt_result_string(result) + std::string(" ") + hrt_last_error(), {}};
  }

 private:
  hrt_result made(const Call& call) {
    if (call.name == "configure") return configure(call);
    if (call.name == "target") return add(call);
    if (call.name == "remove") return hrt_target_remove(session_, targets_[call.text("name")]);
    if (call.name == "gap") return gap(call);
    if (call.name == "begin" || call.name == "retarget") return reach(call);
    if (call.name == "touched") return touched(call);
    if (call.name == "cancel") return hrt_reach_cancel(session_);
    if (call.name == "end") return end();
    if (call.name == "lost") return update(0, call.number("time_ns"), {});
    if (call.name == "update")
      return update(HRT_SAMPLE_PLATE_POSITION, call.number("time_ns"),
                    {call.part("at", 0), call.part("at", 1), call.part("at", 2)});
    if (call.name == "slide") return slide(call);
    if (call.name == "save_profile") return save();
    if (call.name == "load_profile") return load(call.arguments.contains("text") ? call.text("text") : profile_);
    ADD_FAILURE() << call.name << " is no call of the scenario";
    return HRT_OK;
  }

  hrt_result configure(const Call& call) {
    hrt_session_config config = hrt_session_config_init();
    if (hrt_session_get(session_, &config, nullptr) != HRT_OK) return HRT_ERROR_INTERNAL;
    config.paper.tactile_weight = call.number("tactile_weight");
    return hrt_session_set(session_, &config);
  }

  hrt_result add(const Call& call) {
    hrt_target_config config = hrt_target_config_init();
    config.role = call.text("role") == "real" ? HRT_TARGET_REAL : HRT_TARGET_VIRTUAL;
    config.direction_deg = call.number("direction_deg");
    config.distance_m = call.number("distance_m");
    call.text("name").copy(config.name, sizeof config.name - 1);
    hrt_target target;
    const hrt_result result = hrt_target_add(session_, &config, &target);
    if (result == HRT_OK) targets_[call.text("name")] = target;
    return result;
  }

  hrt_result gap(const Call& call) {
    hrt_gap gap = hrt_gap_init();
    const hrt_result result =
        hrt_gap_query(session_, targets_[call.text("real")], targets_[call.text("virtual")], &gap);
    values_ = {{"gap_deg", gap.gap_deg},
               {"max_gap_deg", gap.max_gap_deg},
               {"margin_deg", gap.margin_deg},
               {"reachable", gap.reachable}};
    return result;
  }

  hrt_result reach(const Call& call) {
    hrt_reach_config config = hrt_reach_config_init();
    config.real_target = targets_[call.text("real")];
    config.virtual_target = targets_[call.text("virtual")];
    return call.name == "begin" ? hrt_reach_begin(session_, &config)
                                : hrt_reach_retarget(session_, config.real_target, config.virtual_target);
  }

  hrt_result touched(const Call& call) {
    hrt_contact contact = hrt_contact_init();
    contact.flags = HRT_CONTACT_PLATE_POSITION;
    for (int i = 0; i < 3; ++i) contact.position_m[i] = call.part("at", i);
    contact.sd_m = call.number("sd_m");
    return hrt_reach_touched(session_, &contact);
  }

  hrt_result update(std::uint32_t flags, double time_ns, std::array<double, 3> position_m) {
    hrt_sample sample = hrt_sample_init();
    sample.flags = flags;
    sample.time_ns = static_cast<std::int64_t>(time_ns);
    std::copy(position_m.begin(), position_m.end(), sample.finger_position_m);
    hrt_command command = hrt_command_init();
    const hrt_result result = hrt_reach_update(session_, &sample, &command);
    values_["flags"] = command.flags;
    return result;
  }

  hrt_result slide(const Call& call) {
    const int frames = static_cast<int>(call.number("frames"));
    hrt_result result = HRT_OK;
    for (int i = 0; i < frames && result == HRT_OK; ++i) {
      const double share = i / (frames - 1.0);
      result =
          update(HRT_SAMPLE_PLATE_POSITION, 11'111'111.0 * i,
                 {share * call.part("to", 0), share * call.part("to", 1), 0.05 + share * (call.part("to", 2) - 0.05)});
    }
    return result;
  }

  hrt_result end() {
    hrt_reach_summary summary = hrt_reach_summary_init();
    const hrt_result result = hrt_reach_end(session_, &summary);
    values_["samples"] = static_cast<double>(summary.counts.samples);
    return result;
  }

  hrt_result save() {
    std::uint64_t length = 0;
    profile_.resize(10'000);
    const hrt_result result = hrt_profile_save(session_, profile_.size(), profile_.data(), &length);
    profile_.resize(static_cast<std::size_t>(length));
    return result;
  }

  hrt_result load(const std::string& text) { return hrt_profile_load(session_, text.data(), text.size()); }

  hrt_session session_{};
  std::map<std::string, hrt_target> targets_;
  std::string profile_;
  std::map<std::string, double> values_;
};

TEST(Scenario, IsThatOfTheCInterface) {
  Caller caller;
  scenario::play(HRT_SCENARIO, true, [&](const Call& call) { return caller.call(call); });
}

}  // namespace
