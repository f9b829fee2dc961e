// Measures updates of PersonReach in whole reaches of simulated people, at 90 Hz and at 1 kHz with 1.2 mm of
// noise: median, 99th percentile and maximum, including the fit and the replay at the onset. Each update has its
// minimum time over several runs of the same reach, to exclude other work of the machine.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "core/person/person_reach.h"
#include "core/simulation/people.h"

namespace hrt {
namespace {

constexpr int people = 40;
constexpr int runs = 9;
constexpr int milliseconds = 2500;

double elapsed_us(std::chrono::steady_clock::time_point from) {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - from).count();
}

// Measures half a second of rest and a reach, which are the same in each run.
void time_reach(std::uint32_t person, int period_ms, std::vector<double>& min_us) {
  const PersonCondition condition = draw_person(people_families()[0], 1.5, 1, person);
  const Reach reach{.real_direction_deg = condition.real_direction_deg,
                    .virtual_direction_deg = condition.virtual_direction_deg};
  PersonReach controller({.person = unknown_person(), .plate = condition.plate}, reach);
  SlidingPerson finger(condition.person, {}, reach.virtual_direction_deg, reach.real_distance_mm, {1, 0, person, 0});
  Draws noise(1, 1, person, 0);
  std::size_t update = 0;
  for (int t = 0; t < milliseconds; ++t) {
    if (t >= 500 && !finger.done()) finger.advance(controller.command().plate_orientation_deg);
    if (t % period_ms != 0) continue;
    const FingerSample sample{.time_ns = std::int64_t{1'000'000} * t,
                              .observation = Observation::position,
                              .position = {finger.position().right_mm + 1.2 * noise.normal(),
                                           finger.position().away_mm + 1.2 * noise.normal()}};
    const auto begun = std::chrono::steady_clock::now();
    controller.update(sample);
    const double us = elapsed_us(begun);
    if (update == min_us.size()) min_us.push_back(us);
    min_us[update] = std::min(min_us[update], us);
    ++update;
  }
}

void report(const char* rate, int period_ms) {
  std::vector<double> all_us;
  for (std::uint32_t person = 0; person < people; ++person) {
    std::vector<double> min_us;
    for (int run = 0; run < runs; ++run) time_reach(person, period_ms, min_us);
    all_us.insert(all_us.end(), min_us.begin(), min_us.end());
  }
  std::sort(all_us.begin(), all_us.end());
  const auto share = [&](double of) {
    return all_us[static_cast<std::size_t>(of * static_cast<double>(all_us.size() - 1))];
  };
  std::printf("%-6s  %9.2f  %6.2f  %6.2f\n", rate, share(0.5), share(0.99), share(1.0));
}

}  // namespace
}  // namespace hrt

int main() {
  std::printf("rate    median us  99 %%    worst\n");
  hrt::report("90 Hz", 11);
  hrt::report("1 kHz", 1);
}
