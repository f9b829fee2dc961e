// The script `instructions` runs this program under callgrind. For each row of the table, callgrind dumps its counts
// with the text "name of the row|number of operations".
#include <dlfcn.h>
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/paper_simulation/participant.h"
#include "core/setup/setup.h"
#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"
#include "haptic_retargeting/functions.h"
#include "tests/core/paper/mpc_random_problem.h"

namespace hrt {
namespace {

hrt_functions api;

void require(bool holds, const char* call) {
  if (holds) return;
  std::fprintf(stderr, "instructions: %s: %s\n", call, api.last_error ? api.last_error() : dlerror());
  std::exit(1);
}

template <class Work>
auto counted(const Work& work) {
  CALLGRIND_TOGGLE_COLLECT;
  auto result = work();
  CALLGRIND_TOGGLE_COLLECT;
  return result;
}

void end_row(const std::string& row, std::uint64_t count) {
  const std::string name = row + '|' + std::to_string(count);
  CALLGRIND_DUMP_STATS_AT(name.c_str());
}

void load(const char* path) {
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  require(library, path);
  require(!hrt_functions_load(dlsym, library, &api), path);
}

class Frames {
 public:
  Frames(const hrt_session_config& config, double real_deg, double virtual_deg) {
    require(api.session_create(HRT_VERSION, &config, &session_) == HRT_OK, "hrt_session_create");
    hrt_reach_config reach = hrt_reach_config_init();
    hrt_target_config target = hrt_target_config_init();
    target.direction_deg = real_deg;
    require(api.target_add(session_, &target, &reach.real_target) == HRT_OK, "hrt_target_add");
    target.role = HRT_TARGET_VIRTUAL;
    target.direction_deg = virtual_deg;
    require(api.target_add(session_, &target, &reach.virtual_target) == HRT_OK, "hrt_target_add");
    require(api.reach_begin(session_, &reach) == HRT_OK, "hrt_reach_begin");
  }
  ~Frames() { api.session_destroy(session_); }
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;

  hrt_result update(const hrt_sample& sample) { return api.reach_update(session_, &sample, &command_); }
  double plate_deg() const { return command_.plate_orientation_deg; }

 private:
  hrt_session session_{};
  hrt_command command_ = hrt_command_init();
};

void count_sessions() {
  constexpr int sessions = 20;
  const hrt_session_config config = hrt_session_config_init();
  for (int i = 0; i < sessions; ++i) {
    require(counted([&] {
              hrt_session session;
              return api.session_create(HRT_VERSION, &config, &session) == HRT_OK &&
                     api.session_destroy(session) == HRT_OK;
            }),
            "hrt_session_create");
  }
  end_row("session, created and destroyed", sessions);
}

// Counts updates of a simulated person's first reach, while the finger moves, after half a second of rest.
std::uint64_t count_updates(std::uint32_t person, int period_ms) {
  const PersonCondition condition = draw_person(people_families()[0], 1.5, 1, person);
  Frames frames(hrt_session_config_init(), condition.real_direction_deg, condition.virtual_direction_deg);
  SlidingPerson finger(condition.person, {}, condition.virtual_direction_deg, condition.distance_mm, {1, 0, person, 0});
  Draws noise(1, 1, person, 0);
  std::uint64_t updates = 0;
  for (int t = 0; !finger.done(); ++t) {
    const bool moves = t >= 500;
    if (moves) finger.advance(frames.plate_deg());
    if (t % period_ms != 0) continue;
    hrt_sample sample = hrt_sample_init();
    sample.flags = HRT_SAMPLE_PLATE_POSITION;
    sample.time_ns = std::int64_t{1'000'000} * t;
    sample.finger_position_m[0] = 1e-3 * (finger.position().right_mm + 1.2 * noise.normal());
    sample.finger_position_m[2] = 0.05 - 1e-3 * (finger.position().away_mm - 1.2 * noise.normal());
    const auto update = [&] { return frames.update(sample); };
    require((moves ? counted(update) : update()) == HRT_OK, "hrt_reach_update");
    updates += moves;
  }
  return updates;
}

void count_updates(const char* row, int period_ms) {
  std::uint64_t updates = 0;
  for (std::uint32_t person = 0; person < 6; ++person) updates += count_updates(person, period_ms);
  end_row(row, updates);
}

void count_setup_updates() {
  constexpr int updates = 3000;
  hrt_session session{};
  hrt_person person{};
  hrt_target ahead{};
  hrt_target_config target = hrt_target_config_init();
  target.role = HRT_TARGET_VIRTUAL;
  hrt_sample sample = hrt_sample_init();
  hrt_setup_step step = hrt_setup_step_init();
  require(api.session_create(HRT_VERSION, nullptr, &session) == HRT_OK, "hrt_session_create");
  require(api.target_add(session, &target, &ahead) == HRT_OK, "hrt_target_add");
  require(api.person_create(nullptr, 1, &person) == HRT_OK, "hrt_person_create");
  require(api.person_begin(person, session, ahead) == HRT_OK, "hrt_person_begin");
  require(api.setup_begin(session, HRT_SETUP_CALIBRATION, nullptr) == HRT_OK, "hrt_setup_begin");
  for (int i = 0; i < updates; ++i) {
    const bool rested = step.instruction == HRT_STEP_REST_AT_START;
    require(api.person_move(person, std::int64_t{11'111'111} * i, step.plate_orientation_deg, &sample) == HRT_OK,
            "hrt_person_move");
    require(counted([&] { return api.setup_update(session, &sample, &step); }) == HRT_OK, "hrt_setup_update");
    if (step.instruction != HRT_STEP_REST_AT_START || rested) continue;
    require(api.person_begin(person, session, ahead) == HRT_OK, "hrt_person_begin");
  }
  require(step.done > 5, "hrt_setup_update");
  api.person_destroy(person);
  api.session_destroy(session);
  end_row("update of a set-up", updates);
}

// Counts each step of the fit to 40 slides of 2 s, each after 2 s of rest, at 250 Hz. The table has the largest count.
void count_fit() {
  constexpr int slides = 40;
  const PersonCondition condition = draw_person(people_families()[0], 2.0, 1, 0);
  Draws noise(1, 2, 0, 0);
  std::vector<CalibrationTrial> trials;
  for (std::uint32_t i = 0; i < slides; ++i) {
    CalibrationTrial trial{.plate_orientation_deg = 75.0 * planned_share(static_cast<int>(i))};
    SlidingPerson finger(condition.person, {}, 0.0, 100.0, {1, 3, 0, i});
    for (int t = 0; t < 4000; ++t) {
      if (t >= 2000 && !finger.done()) finger.advance(trial.plate_orientation_deg);
      if (t % 4 == 0)
        trial.samples.push_back({1e-3 * t, finger.position() + PlatePoint{noise.normal(), noise.normal()}});
    }
    trials.push_back(std::move(trial));
  }
  CalibrationFit fit(std::move(trials), 0.0);
  for (bool done = false; !done;) {
    done = counted([&] { return fit.step(); });
    end_row("largest step of a fit of 40 slides", 1);
  }
  require(std::holds_alternative<Calibration>(fit.result()), "CalibrationFit");
}

void count_paper_updates(int horizon) {
  constexpr std::int64_t reaches = 10;
  constexpr std::int64_t steps = 30;
  hrt_session_config config = hrt_session_config_init();
  config.guidance = HRT_GUIDANCE_FIXED_DIRECTION;
  config.paper.horizon = static_cast<std::uint32_t>(horizon);
  hrt_sample sample = hrt_sample_init();
  sample.flags = HRT_SAMPLE_DIRECTION;
  for (std::uint32_t reach = 0; reach < reaches; ++reach) {
    Frames frames(config, -5.0, 5.0);
    SimulatedParticipant person(Participant{}, 5.0);
    Draws noise(1, 1, reach, 0);
    for (std::int64_t i = 0; i < steps; ++i) {
      sample.time_ns = 100'000'000 * i;
      sample.finger_direction_deg = person.finger_direction_deg();
      require(counted([&] { return frames.update(sample); }) == HRT_OK, "hrt_reach_update");
      person.step(frames.plate_deg(), noise.normal());
    }
  }
  end_row("update of the paper's controller, N = " + std::to_string(horizon), reaches * steps);
}

void count_solves(int horizon, bool has_rate_bound) {
  constexpr int problems = 300;
  Random random(static_cast<unsigned>(horizon));
  for (int i = 0; i < problems; ++i) {
    const RandomProblem drawn(random, horizon, has_rate_bound ? RandomRate::moderate : RandomRate::none);
    Mpc mpc(drawn.config);
    const Mpc::Command command = counted([&] { return mpc.solve(drawn.problem); });
    require(std::isfinite(command.plate_offset_deg), "Mpc::solve");
  }
  end_row(std::string("random solve, N = ") + std::to_string(horizon) + (has_rate_bound ? ", rate bound" : ""),
          problems);
}

void count_reaches(const char* family) {
  constexpr std::uint32_t people = 2;
  constexpr int reaches = 5;
  for (std::uint32_t person = 0; person < people; ++person) {
    const PersonCondition condition = draw_person(*people_family(family), 1.5, 1, person);
    const RetargeterConfig controller = people_controller(condition);
    counted([&] { return simulate_person(condition, &controller, reaches, 1, person); });
  }
  end_row(std::string("simulated reach, ") + family, people * reaches);
}

}  // namespace
}  // namespace hrt

int main(int argc, char** argv) {
  using namespace hrt;
  if (argc != 2) {
    std::fprintf(stderr, "usage: hrt_instructions LIBRARY, under callgrind; the script `instructions` runs it\n");
    return 2;
  }
  load(argv[1]);
  count_sessions();
  count_updates("update under ARRIVAL at 90 Hz", 11);
  count_updates("update under ARRIVAL at 1 kHz", 1);
  count_setup_updates();
  count_fit();
  for (const int horizon : {3, 20}) count_paper_updates(horizon);
  for (const int horizon : {3, 20})
    for (const bool has_rate_bound : {false, true}) count_solves(horizon, has_rate_bound);
  for (const char* family : {"linear", "place", "mixture"}) count_reaches(family);
}
