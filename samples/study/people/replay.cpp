#include "samples/study/people/replay.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/learning.h"
#include "core/math/trigonometry.h"
#include "core/retargeter.h"
#include "core/simulation/controllers.h"
#include "core/tracker/repeated_position.h"
#include "samples/app/text/text.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/people/own_recordings.h"

namespace hrt::study {
namespace {

constexpr std::size_t max_recording_bytes = std::size_t{1} << 29;
constexpr const char* open_loop_words =
    "Recorded paths in an open loop: the finger could not answer. A path, its end and its felt error are "
    "those of the plate that stood there, whatever our controller would have commanded.";

double last_bearing_deg(const RecordedPath& path) {
  PlatePoint last = path.reach.start;
  for (const FingerSample& sample : path.samples)
    if (sample.observation == Observation::position) last = sample.position;
  return wrap_deg(bearing_deg(path.reach.start, last) - path.reach.real_direction_deg, 360.0);
}

const char* source_name(PlateSource source) {
  static constexpr const char* names[] = {"measured", "commanded", "resting"};
  return names[static_cast<std::size_t>(source)];
}

std::string flag_words(const ReachSummary& summary) {
  std::string words;
  const auto add = [&](bool flag, const char* word) {
    if (flag) words += (words.empty() ? "" : " ") + std::string(word);
  };
  add(summary.unreachable, "unreachable");
  add(summary.misfit, "misfit");
  add(summary.off_target, "off_target");
  return words;
}

std::string file_name(const ReplayedPath& replayed) {
  return std::filesystem::path(replayed.path.file).filename().string();
}

std::vector<std::pair<const char*, double>> numbers(const ReplayedPath& replayed) {
  const ReachSummary& summary = replayed.summary;
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  return {{"samples", static_cast<double>(summary.samples)},
          {"dropped_samples", static_cast<double>(summary.dropped_samples)},
          {"gap_deg", replayed.path.reach.virtual_direction_deg - replayed.path.reach.real_direction_deg},
          {"recorded_bearing_error_deg", replayed.bearing_error_deg},
          {"tactile_weight", summary.estimate.tactile_weight},
          {"tactile_weight_sd", summary.estimate.tactile_weight_sd},
          {"bias_deg", replayed.person.mean(PersonState::bias)},
          {"bias_sd_deg", trait_sd(replayed.person, PersonState::bias)},
          {"habit_deg", replayed.person.mean(PersonState::habit)},
          {"habit_sd_deg", trait_sd(replayed.person, PersonState::habit)},
          {"duration_s", summary.person ? summary.person->duration_s : unknown},
          {"tracker_noise_mm", summary.estimate.tracker_noise_mm},
          {"peak_felt_error_deg", replayed.peak_felt_error_deg},
          {"command_change_median_deg", replayed.command_change_deg.value},
          {"last_command_deg", replayed.last.plate_orientation_deg},
          {"last_plate_deg", *replayed.path.samples.back().plate_orientation_deg}};
}

}  // namespace

std::vector<ReplayedPath> replay(const RecordedPaths& recorded) {
  std::vector<ReplayedPath> replayed;
  RetargeterConfig config = people_controller();
  config.plate = recorded.plate;
  config.tracker_latency_ns = recorded.tracker_latency_ns;
  for (const RecordedPath& path : recorded.paths) {
    Retargeter retargeter(config);
    retargeter.begin(path.reach);
    std::vector<double> changes_deg;
    PlateCommand last = retargeter.command();
    RepeatedPosition<PlatePoint> repeated;
    for (FingerSample sample : path.samples) {
      if (sample.observation == Observation::position && repeated.is_copy(sample.time_ns, sample.position))
        sample.observation = Observation::none;
      last = retargeter.update(sample);
      changes_deg.push_back(std::abs(wrap_deg(last.plate_orientation_deg - *sample.plate_orientation_deg, 180.0)));
    }
    const ReachSummary summary = retargeter.summary();
    const auto learnt = retargeter.learnt();
    if (learnt)
      config.person = carried(config.person, *learnt, summary.unreachable || summary.off_target, unknown_person());
    replayed.push_back({.path = path,
                        .bearing_error_deg = last_bearing_deg(path),
                        .peak_felt_error_deg = summary.peak_felt_error_deg,
                        .command_change_deg = quantile_of(changes_deg, 0.5),
                        .last = last,
                        .summary = summary,
                        .person = config.person,
                        .learnt = learnt.has_value()});
  }
  return replayed;
}

Replayed replay_folder(const std::string& argument, const std::string& folder) {
  Replayed all;
  for (const std::string& file : csv_files(argument, folder, "recordings or calibration data")) {
    const RecordedPaths recorded = parse_recorded_paths(file, read_input(argument, file, max_recording_bytes));
    for (ReplayedPath& path : replay(recorded)) all.paths.push_back(std::move(path));
    all.left_out.insert(all.left_out.end(), recorded.left_out.begin(), recorded.left_out.end());
  }
  return all;
}

std::string replay_text(const Replayed& all) {
  std::string page =
      wrapped(std::string(open_loop_words) +
                  " Each file is taken as the reaches of one person, whom the controller does not know at first.",
              110) +
      '\n' +
      "\nend: recorded bearing of the end less the real target's\nw_T: after the reach; bias, habit: as "
      "carried to the next one; +- standard deviation\nfelt: largest felt error, as estimated\nturn: median size of "
      "our "
      "command less where the plate stood\nplate: measured, from recorded commands, or resting: calibration "
      "data, whose goal is straight ahead;\n  a real target " +
      number(assumed_gap_deg) + " deg to its right is assumed\n\n" + left("file", 20) + right("reach", 6) +
      right("end, deg", 10) + right("w_T", 15) + right("bias, deg", 14) + right("habit, deg", 14) +
      right("felt, deg", 11) + right("turn, deg", 11) + "  plate      flags\n";
  const auto with_sd = [](double value, double sd, int decimals) {
    return fixed(value, decimals) + " +- " + fixed(sd, decimals);
  };
  const auto trait = [&](const PersonBelief& person, PersonState::Index index) {
    return with_sd(person.mean(index), trait_sd(person, index), 1);
  };
  for (const ReplayedPath& replayed : all.paths) {
    const ReachSummary& summary = replayed.summary;
    page += left(cut_to(file_name(replayed), 19), 20) + right(std::to_string(replayed.path.number), 6) +
            right(fixed(replayed.bearing_error_deg, 1), 10) +
            right(with_sd(summary.estimate.tactile_weight, summary.estimate.tactile_weight_sd, 2), 15) +
            right(trait(replayed.person, PersonState::bias), 14) +
            right(trait(replayed.person, PersonState::habit), 14) + right(fixed(replayed.peak_felt_error_deg, 1), 11) +
            right(fixed(replayed.command_change_deg.value, 1), 11) + "  " +
            left(source_name(replayed.path.plate_source), 11) + flag_words(summary) + '\n';
  }
  if (!all.left_out.empty()) page += '\n';
  for (const std::string& sentence : all.left_out) page += sentence + '\n';
  return page;
}

Results replay_results(const Replayed& replayed) {
  Results found{.about = {{"open_loop", open_loop_words}, {"left_out", replayed.left_out}}, .rows = {}};
  for (const ReplayedPath& path : replayed.paths) {
    Row row{{"file", file_name(path)},
            {"reach", path.path.number},
            {"plate", source_name(path.path.plate_source)},
            {"learnt", path.learnt}};
    for (const auto& [name, value] : numbers(path)) row[name] = value;
    row["unreachable"] = path.summary.unreachable;
    row["misfit"] = path.summary.misfit;
    row["off_target"] = path.summary.off_target;
    found.rows.push_back(std::move(row));
  }
  return found;
}

}  // namespace hrt::study
