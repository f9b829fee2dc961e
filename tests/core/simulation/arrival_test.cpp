// Compares the phases that the controller reports (onset, rests, arrival, time to go) with the truth, for motions with
// the statistics of recorded reaches.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <vector>

#include "core/retargeter.h"
#include "core/simulation/controllers.h"
#include "core/simulation/people.h"
#include "core/simulation/person.h"
#include "core/simulation/tracker.h"

namespace hrt {
namespace {

constexpr double rest_s = 0.5;
constexpr std::uint64_t seed = 1;

struct Moment {
  double time_s;
  PlatePoint finger;
  double speed_mm_s;
  PlateCommand command;
};

struct Watched {
  std::vector<Moment> moments;
  double stopped_s = 0.0;  // time of the stop; the motion begins at rest_s
  PlatePoint end;
};

// One reach, from a rest until a second after the stop.
Watched watch(const PersonCondition& condition, std::uint32_t index) {
  const PlatePoint start;
  Retargeter controller(people_controller(condition));
  controller.begin({.real_direction_deg = condition.real_direction_deg,
                    .virtual_direction_deg = condition.virtual_direction_deg,
                    .start = start,
                    .real_distance_mm = condition.distance_mm});
  SlidingPerson person(condition.person, start, condition.virtual_direction_deg, condition.distance_mm,
                       Draws(seed, 1, index, 0));
  Tracker tracker(condition.tracker, start, Draws(seed, 2, index, 0));
  PlateModel plate(condition.plate, 0.0);
  Watched watched;
  for (int ms = 0; !person.done() || 1e-3 * ms < watched.stopped_s + 1.0; ++ms) {
    const std::int64_t now_ns = std::int64_t{1'000'000} * ms;
    plate.advance(now_ns);
    if (1e-3 * ms > rest_s && !person.done()) {
      person.advance(plate.orientation_deg());
      watched.stopped_s = 1e-3 * ms;
    }
    tracker.sample_if_due(1e-3 * ms, person.position());
    while (const auto sample = tracker.arrived(now_ns)) {
      const PlateCommand command = controller.update(*sample);
      plate.command(command.plate_orientation_deg);
      watched.moments.push_back({1e-3 * ms, person.position(), person.done() ? 0.0 : person.speed_mm_s(), command});
    }
  }
  watched.end = person.position();
  return watched;
}

/// Numbers of reaches with an error.
struct Account {
  int began_early = 0;        // more than 60 ms before the onset
  int rested_in_motion = 0;   // PlateCommand::resting while the finger moves faster than 20 mm/s
  int arrived_in_motion = 0;  // PlateCommand::arrived more than 5 mm from the position of the stop
  int arrived_late = 0;       // PlateCommand::arrived more than 0.5 s after the stop, or never
  /// sum over reaches of the mean error in the middle half of the motion, as a fraction of the duration
  double time_to_go_error = 0.0;
};

void add(const Watched& reach, Account* account) {
  bool early = false, rested = false, in_motion = false, in_time = false;
  double error_sum = 0.0;
  int counted = 0;
  const double duration_s = reach.stopped_s - rest_s;
  for (const auto& [time_s, finger, speed_mm_s, command] : reach.moments) {
    const bool begun = command.step >= 0;
    early |= begun && time_s < rest_s - 0.06;
    rested |= begun && command.resting && speed_mm_s > 20.0;
    in_motion |= command.arrived && distance_mm(finger, reach.end) > 5.0;
    in_time |= command.arrived && time_s <= reach.stopped_s + 0.5;
    const double fraction = (time_s - rest_s) / duration_s;
    if (!begun || fraction < 0.25 || fraction > 0.75 || command.time_to_go_s < 0.0) continue;
    error_sum += (command.time_to_go_s - (reach.stopped_s - time_s)) / duration_s;
    ++counted;
  }
  account->began_early += early;
  account->rested_in_motion += rested;
  account->arrived_in_motion += in_motion;
  account->arrived_late += !in_time;
  if (counted > 0) account->time_to_go_error += error_sum / counted;
}

struct RecordedCase {
  const char* family;
  double duration_s;
};
void PrintTo(const RecordedCase& c, std::ostream* out) { *out << c.family << ' ' << c.duration_s << " s"; }

class Arrival : public testing::TestWithParam<RecordedCase> {};

TEST_P(Arrival, RecordedPaces_GiveArrivalAfterTheStop) {
  constexpr std::uint32_t people = 300;
  Account account;
  for (std::uint32_t i = 0; i < people; ++i)
    add(watch(draw_person(*people_family(GetParam().family), GetParam().duration_s, seed, i), i), &account);
  EXPECT_EQ(account.began_early, 0);
  EXPECT_LE(account.rested_in_motion, 0.01 * people);
  EXPECT_LE(account.arrived_in_motion, 0.01 * people);
  EXPECT_LE(account.arrived_late, 0.03 * people);
  EXPECT_NEAR(account.time_to_go_error / people, 0.0, 0.12);
}

INSTANTIATE_TEST_SUITE_P(Recorded, Arrival,
                         testing::Values(RecordedCase{"recorded", 0.8}, RecordedCase{"recorded", 1.5},
                                         RecordedCase{"recorded-50", 0.8}, RecordedCase{"recorded-50", 1.5}));

}  // namespace
}  // namespace hrt
