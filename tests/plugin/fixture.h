// Fixture of the tests of the C interface: a session, and functions that make its calls.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "core/math/elementary.h"
#include "haptic_retargeting/gap.h"
#include "haptic_retargeting/haptic_retargeting.h"
#include "haptic_retargeting/host.h"
#include "haptic_retargeting/person.h"
#include "haptic_retargeting/profile.h"
#include "haptic_retargeting/recording.h"
#include "haptic_retargeting/scene.h"
#include "haptic_retargeting/setup.h"
#include "tests/times.h"

namespace hrt::test {

inline constexpr std::int64_t step_ns = 100 * ms;  ///< step of the paper's model

#define ASSERT_OK(call) ASSERT_EQ((call), HRT_OK) << hrt_last_error()
#define EXPECT_OK(call) EXPECT_EQ((call), HRT_OK) << hrt_last_error()

/// Expects an error whose text contains `part`.
inline void expect_error(hrt_result result, hrt_result expected, const std::string& part = "") {
  EXPECT_EQ(result, expected) << hrt_result_string(result) << ": " << hrt_last_error();
  EXPECT_NE(std::string(hrt_last_error()).find(part), std::string::npos)
      << '"' << hrt_last_error() << "\" does not mention \"" << part << '"';
}

template <class Output>
Output output() {
  Output out{};
  out.struct_size = sizeof out;
  return out;
}

template <class Struct>
bool same(const Struct& a, const Struct& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

inline void expect_same(const std::vector<hrt_command>& a, const std::vector<hrt_command>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_TRUE(same(a[i], b[i])) << i;
}

inline hrt_session_config session_config() { return hrt_session_config_init(); }

inline hrt_session_config config_of(hrt_session session) {
  auto config = output<hrt_session_config>();
  EXPECT_OK(hrt_session_get(session, &config, nullptr));
  return config;
}

/// Returns a configuration of the paper's controller, without estimation of the user's parameters.
inline hrt_session_config paper_config() {
  hrt_session_config config = session_config();
  config.guidance = HRT_GUIDANCE_FIXED_DIRECTION;
  config.adaptation = HRT_ADAPTATION_OFF;
  config.person.tactile_weight = 0.15;
  return config;
}

/// Sets the person to these means, and to independent traits with this variance.
inline void know_person(hrt_session_config* config, const std::vector<double>& mean, double variance = 0.01) {
  std::copy(mean.begin(), mean.end(), config->person.mean);
  for (int i = 0; i < HRT_PERSON_TRAITS; ++i) config->person.covariance[i * (i + 3) / 2] = variance;
}

/// During its lifetime, collects the lines of the library's log, or of the session's: "LEVEL text".
class Log {
 public:
  explicit Log(hrt_session session = {}) : session_(session) {
    hrt_host host = hrt_host_init();
    host.context = this;
    host.log = [](void* context, std::uint32_t level, const char* line) {
      static_cast<Log*>(context)->text += std::to_string(level) + " " + line + "\n";
    };
    set(&host);
  }
  ~Log() { set(nullptr); }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  std::string text;  // the thread of a recording may add lines until the recording has stopped

 private:
  void set(const hrt_host* host) { EXPECT_OK(session_.value ? hrt_host_set_log(session_, host) : hrt_host_set(host)); }
  hrt_session session_;
};

inline hrt_target_config target_config(std::uint32_t role, double direction_deg, const char* name = "") {
  hrt_target_config config = hrt_target_config_init();
  config.role = role;
  config.direction_deg = direction_deg;
  std::snprintf(config.name, sizeof config.name, "%s", name);
  return config;
}

/// Returns a target on the plate, `forward_m` ahead of its centre and `right_m` to the right.
inline hrt_target_config placed(std::uint32_t role, double right_m, double forward_m) {
  hrt_target_config config = target_config(role, 0.0);
  config.place = HRT_PLACE_PLATE_POSITION;
  config.position_m[0] = right_m;
  config.position_m[2] = -forward_m;
  return config;
}

inline hrt_reach_config reach_config(hrt_target real_target, hrt_target virtual_target, std::uint32_t flags = 0) {
  hrt_reach_config config = hrt_reach_config_init();
  config.real_target = real_target;
  config.virtual_target = virtual_target;
  config.flags = flags;
  return config;
}

inline hrt_sample direction_sample(std::int64_t time_ns, double direction_deg) {
  auto sample = output<hrt_sample>();
  sample.flags = HRT_SAMPLE_DIRECTION;
  sample.time_ns = time_ns;
  sample.finger_direction_deg = direction_deg;
  return sample;
}

/// Returns a sample of a finger on the plate, `forward_m` ahead of its centre and `right_m` to the right.
inline hrt_sample position_sample(std::int64_t time_ns, double right_m, double forward_m) {
  auto sample = output<hrt_sample>();
  sample.flags = HRT_SAMPLE_PLATE_POSITION;
  sample.time_ns = time_ns;
  sample.finger_position_m[0] = right_m;
  sample.finger_position_m[2] = -forward_m;
  return sample;
}

/// Returns the distance that a finger has slid at `time_ms`: it slides 10 cm in 1.5 s, from 300 ms on.
inline double slid_m(std::int64_t time_ms) {
  const double u = std::clamp(static_cast<double>(time_ms - 300) / 1500.0, 0.0, 1.0);
  return 0.1 * u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
}

/// Returns a profile with additional fields, for example `,"plate":"desk 1"`.
inline std::string profile_with(const std::string& fields) {
  return R"({"format":"haptic retargeting profile","version":1)" + fields + "}";
}

class SessionTest : public ::testing::Test {
 protected:
  void SetUp() override { create(session_config()); }
  void TearDown() override { destroy(); }

  void destroy() {
    if (session.value != 0) {
      EXPECT_OK(hrt_session_destroy(session));
    }
    session.value = 0;
  }

  void create(const hrt_session_config& config) {
    destroy();
    ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &session));
  }

  template <class Change>
  void create(hrt_session_config config, Change change) {
    change(config);
    create(config);
  }

  hrt_target add(std::uint32_t role, double direction_deg, const char* name = "") {
    return add(target_config(role, direction_deg, name));
  }
  hrt_target add(const hrt_target_config& config) {
    hrt_target target{};
    EXPECT_OK(hrt_target_add(session, &config, &target));
    return target;
  }

  void change(hrt_target target, const hrt_target_config& config) {
    EXPECT_OK(hrt_target_set(session, target, &config));
  }

  hrt_gap gap_of(hrt_target real_target, hrt_target virtual_target) const {
    auto gap = output<hrt_gap>();
    EXPECT_OK(hrt_gap_query(session, real_target, virtual_target, &gap));
    return gap;
  }

  hrt_result begin(hrt_target real_target, hrt_target virtual_target, std::uint32_t flags = 0) {
    const hrt_reach_config config = reach_config(real_target, virtual_target, flags);
    return hrt_reach_begin(session, &config);
  }

  /// Begins a reach with the real target 5 degrees to the right and the virtual one 5 degrees to the left.
  void begin_reach() { ASSERT_OK(begin(add(HRT_TARGET_REAL, -5.0), add(HRT_TARGET_VIRTUAL, 5.0))); }

  hrt_command update(const hrt_sample& sample) {
    auto command = output<hrt_command>();
    EXPECT_OK(hrt_reach_update(session, &sample, &command));
    return command;
  }

  /// Passes samples of a finger that slides straight ahead from the start, at the times of slid_m().
  hrt_command slide(std::int64_t from_ms = 0, std::int64_t until_ms = 2210) {
    hrt_command command{};
    for (std::int64_t t = from_ms; t < until_ms; t += 10)
      command = update(position_sample(t * ms, 0.0, slid_m(t) - 0.05));
    return command;
  }

  hrt_reach_summary end() {
    auto summary = output<hrt_reach_summary>();
    EXPECT_OK(hrt_reach_end(session, &summary));
    return summary;
  }

  std::string save_profile() const {
    std::uint64_t length = 0;
    EXPECT_OK(hrt_profile_save(session, 0, nullptr, &length));
    std::string text(static_cast<std::size_t>(length) + 1, '?');
    EXPECT_OK(hrt_profile_save(session, text.size(), text.data(), &length));
    EXPECT_EQ(text.back(), '\0');
    text.pop_back();
    EXPECT_EQ(text.size(), length);
    return text;
  }

  hrt_result load_profile(const std::string& text) { return hrt_profile_load(session, text.data(), text.size()); }

  hrt_session session{0};
};

class PaperTest : public SessionTest {
 protected:
  void SetUp() override { create(paper_config()); }
};

}  // namespace hrt::test
