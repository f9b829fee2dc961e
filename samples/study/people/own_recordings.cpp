#include "samples/study/people/own_recordings.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/math/elementary.h"
#include "samples/study/cli/output.h"
#include "samples/study/numbers/csv.h"

namespace hrt::study {
namespace {

constexpr std::size_t max_reaches_bytes = 1U << 28;
constexpr double moving_share = 0.05;    // fraction of the largest speed above which the finger moves
constexpr double min_reach_mm = 20.0;    // the direction of a shorter reach is too uncertain
constexpr std::size_t min_samples = 20;  // minimum number of samples in motion
constexpr double smoothing_s = 0.05;     // half width of the moving average, against the tracker's noise
constexpr double max_position_mm = 1e5;

using Samples = std::vector<TimedPoint>;

Samples smoothed(const Samples& samples) {
  Samples smooth;
  for (const TimedPoint& at : samples) {
    PlatePoint sum;
    double count = 0.0;
    for (const TimedPoint& near : samples) {
      if (std::abs(near.time_s - at.time_s) > smoothing_s) continue;
      sum = sum + near.position;
      count += 1.0;
    }
    smooth.push_back({at.time_s, (1.0 / count) * sum});
  }
  return smooth;
}

// Returns the samples from the first to the last in motion.
Samples motion_of(const Samples& samples) {
  std::vector<double> speeds_mm_s;
  for (std::size_t i = 1; i < samples.size(); ++i)
    speeds_mm_s.push_back(distance_mm(samples[i - 1].position, samples[i].position) /
                          (samples[i].time_s - samples[i - 1].time_s));
  if (speeds_mm_s.empty()) return {};
  const double limit_mm_s = moving_share * *std::max_element(speeds_mm_s.begin(), speeds_mm_s.end());
  const auto moves = [limit_mm_s](double speed) { return speed > limit_mm_s; };
  const auto first = std::find_if(speeds_mm_s.begin(), speeds_mm_s.end(), moves) - speeds_mm_s.begin();
  const auto last = speeds_mm_s.rend() - std::find_if(speeds_mm_s.rbegin(), speeds_mm_s.rend(), moves);
  return first < last ? Samples(samples.begin() + first, samples.begin() + last + 1) : Samples{};
}

// Returns the position at a fraction of the path. `along_mm`: path length up to each sample.
PlatePoint position_at(const Samples& samples, const std::vector<double>& along_mm, double fraction) {
  const double at_mm = std::clamp(fraction, 0.0, 1.0) * along_mm.back();
  const auto after = std::clamp<std::ptrdiff_t>(
      std::lower_bound(along_mm.begin(), along_mm.end(), at_mm) - along_mm.begin(), 1, std::ssize(along_mm) - 1);
  const auto i = static_cast<std::size_t>(after);
  const double step_mm = along_mm[i] - along_mm[i - 1];
  const double share = step_mm > 0.0 ? (at_mm - along_mm[i - 1]) / step_mm : 0.0;
  return samples[i - 1].position + share * (samples[i].position - samples[i - 1].position);
}

RecordedReach reach_of(const Samples& motion) {
  std::vector<double> along_mm{0.0};
  for (std::size_t i = 1; i < motion.size(); ++i)
    along_mm.push_back(along_mm.back() + distance_mm(motion[i - 1].position, motion[i].position));
  RecordedReach reach;
  const double chord_deg = bearing_deg(motion.front().position, motion.back().position);
  const std::size_t steps = reach.direction_deg.size() - 1;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double fraction = static_cast<double>(i) / static_cast<double>(steps);
    const double half = 0.5 / static_cast<double>(steps);
    const PlatePoint from = position_at(motion, along_mm, fraction - half);
    const PlatePoint to = position_at(motion, along_mm, fraction + half);
    reach.direction_deg[i] = wrap_deg(bearing_deg(from, to) - chord_deg, 360.0);
  }
  std::size_t next = 1;
  const std::size_t times = reach.path_fraction.size() - 1;
  for (std::size_t i = 0; i <= times; ++i) {
    const double time_s = motion.front().time_s + (motion.back().time_s - motion.front().time_s) *
                                                      static_cast<double>(i) / static_cast<double>(times);
    while (next + 1 < motion.size() && motion[next].time_s < time_s) ++next;
    const double share = (time_s - motion[next - 1].time_s) / (motion[next].time_s - motion[next - 1].time_s);
    reach.path_fraction[i] = (along_mm[next - 1] + share * (along_mm[next] - along_mm[next - 1])) / along_mm.back();
  }
  return reach;
}

RecordedReach checked_reach(const std::string& name, double number, const Samples& samples) {
  const std::string which = fmt::format("{}, reach {}", name, number);
  const Samples motion = motion_of(smoothed(samples));
  if (motion.size() < min_samples)
    throw UsageError(
        fmt::format("{} has {} samples in motion; at least {} are needed: record at 40 Hz or more, from rest to rest",
                    which, motion.size(), min_samples));
  const double length_mm = distance_mm(motion.front().position, motion.back().position);
  if (length_mm < min_reach_mm)
    throw UsageError(
        fmt::format("{} ends {:.0f} mm from its start; at least {} mm are needed. Are positions in millimetres?", which,
                    length_mm, min_reach_mm));
  return reach_of(motion);
}

std::vector<std::string> csv_files(const std::string& argument, const std::string& folder) {
  namespace fs = std::filesystem;
  const auto refuse = [&](const std::string& why) {
    return UsageError(not_allowed(argument, folder, "a folder with recorded reaches in .csv files (" + why + ")"));
  };
  std::error_code error;
  std::vector<std::string> files;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".csv") files.push_back(entry->path().string());
  if (error) throw refuse(error.message());
  if (files.empty()) throw refuse("there is no .csv file");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<RecordedReach> parse_reaches(const std::string& name, std::string_view text) {
  CsvReader csv(name, text, "reach,time_s,right_mm,away_mm");
  std::vector<RecordedReach> reaches;
  Samples samples;
  double number = 0.0;
  while (csv.next()) {
    const double of = csv.number("reach", {.low = 0.0, .high = 1e9, .whole = true});
    const TimedPoint sample{csv.number("time_s", {-1e9, 1e9}),
                            {csv.number("right_mm", {-max_position_mm, max_position_mm}),
                             csv.number("away_mm", {-max_position_mm, max_position_mm})}};
    if (!samples.empty() && of != number) {
      reaches.push_back(checked_reach(name, number, samples));
      samples.clear();
    }
    if (!samples.empty() && !(sample.time_s > samples.back().time_s))
      throw csv.wrong("time_s", "later than in the row before");
    number = of;
    samples.push_back(sample);
  }
  if (!samples.empty()) reaches.push_back(checked_reach(name, number, samples));
  if (reaches.empty()) throw UsageError(name + " has no reach: there is no row under the header; add one per position");
  return reaches;
}

SimulatedPeople people_of_recordings(const std::string& argument, const std::string& folder) {
  std::vector<OwnPath> paths;
  for (const std::string& file : csv_files(argument, folder))
    paths.push_back(own_path_of(parse_reaches(file, read_input(argument, file, max_reaches_bytes))));
  return {.name = "own",
          .description = fmt::format("{} files of --recorded", paths.size()),
          .kind = FamilyKind::recorded,
          .draw = [paths = std::move(paths)](double duration_s, std::uint64_t seed, std::uint32_t index) {
            PersonCondition condition = draw_person(*people_family("linear"), duration_s, seed, index);
            move_as_recorded(condition, paths[index % paths.size()]);
            return condition;
          }};
}

}  // namespace hrt::study
