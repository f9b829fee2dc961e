// hrt-study steering: how well rate and delay of a person's steering are found, and whether knowing them
// helps the controller.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"
#include "core/simulation/slide.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/numbers/parallel.h"
#include "samples/study/numbers/statistics.h"
#include "samples/study/people/coverage.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

constexpr double near_deg = 1.5;
constexpr double mean_rate_per_s = 8.5;    // of simulated people
constexpr double prior_rate_per_s = 17.0;  // of the controller's unknown person

struct Options {
  std::uint64_t people = 25;
  std::uint64_t reach_people = 100;
  std::uint64_t slides = 12;
  double angle_deg = 35.0;
  double duration_s = 2.0;
  std::uint64_t seed = 1;
  std::uint64_t threads = 2;
  std::string out;
};

// People whose steering has a rate and a delay in the sense of the law; and whose has none, or more.
constexpr const char* law_kinds[] = {"linear",  "predictive", "place",     "clip-45",  "sine-45",
                                     "habit-5", "mixture",    "noise-100", "outliers", "slow-tracker"};
constexpr const char* other_kinds[] = {"steps", "heavy-arm", "crossings"};
constexpr const char* reach_kinds[] = {"linear", "sine-45", "bias-3", "habit-5", "noise-100"};
constexpr double durations_s[] = {0.8, 1.0, 1.5};

struct Found {
  Person person;
  SteeringFit steering;
};

// Two slides at each of eleven angles over a plate at rest, then those over a turning one.
Found calibrate_person(const PeopleFamily& family, const Options& options, std::uint32_t index) {
  const PersonCondition condition = draw_person(family, options.duration_s, options.seed, index);
  std::vector<CalibrationTrial> trials;
  std::uint32_t slide = 0;
  for (int i = 0; i < 22; ++i)  // neighbours far apart
    trials.push_back(simulate_slide(condition, -75.0 + 15.0 * ((i * 7) % 11), options.seed, index, slide++));
  for (std::uint64_t i = 0; i < options.slides; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    trials.push_back(
        simulate_turning_slide(condition, side * options.angle_deg, options.seed, index, slide++));
  }
  const auto result = calibrate(trials);
  const auto* calibration = std::get_if<Calibration>(&result);
  return {.person = condition.person, .steering = calibration ? calibration->steering : SteeringFit{}};
}

// The columns of one number; of people without a truth, known and width alone.
std::string text_of(const Tally& tally, bool has_truth) {
  return cell(tally.known.percent(), 0, 7) +
         (has_truth ? tally.covered_text(7) + cell(tally.mean_error(), 1, 7)
                    : right("-", 7) + right("-", 16)) +
         cell(tally.mean_width(), 1, 8);
}

// Rate, in 1/s with its error in %, and delay, in ms, of people of one kind.
struct SteeringTally {
  Tally rate;
  Tally delay;
  Share unlike;

  void add(const Found& found) {
    const SteeringFit& steering = found.steering;
    const double rate_per_s = found.person.gain_per_s;
    const double delay_ms = 1e3 * found.person.delay_s;
    const Interval found_ms = in_thousandths(steering.delay_s);
    rate.add(steering.rate_per_s, rate_per_s, 100.0 * (steering.rate_per_s.value / rate_per_s - 1.0));
    delay.add(found_ms, delay_ms, found_ms.value - delay_ms);
    unlike.count(steering.law_p < min_fit_p);
  }
  std::string line(const std::string& name, bool has_truth) const {
    return left(name, 14) + text_of(rate, has_truth) + text_of(delay, has_truth) +
           cell(unlike.percent(), 0, 8) + "\n";
  }
};

std::string coverage_text(const Options& options, Progress* progress, std::uint64_t* done,
                          std::uint64_t all) {
  std::string page =
      "Rate and delay of the steering of simulated people, from " + std::to_string(options.slides) +
      " slides of " + number(options.duration_s) + " s within which the plate turns between " +
      number(options.angle_deg) +
      " deg to one\nside and the other, after 22 over a plate at rest. There was no human trial. " +
      std::to_string(options.people) +
      " people a kind.\nknown: % of people; cover: % of those whose 95 % interval holds the truth, and the "
      "95 % interval of that\nshare; error and width: means, the rate's error in %; unlike: % of people "
      "whose paths no law of steering fits.\n\n" +
      left("", 14) + left("rate, 1/s", 38) + "delay, ms\n" + left("", 14) +
      "  known  cover           error   width  known  cover           error   width  unlike\n";
  SteeringTally all_of_law;
  const auto add_row = [&](const char* kind, bool has_truth) {
    std::vector<Found> found(options.people);
    for_each_part(options.people, options.threads, [&](std::uint64_t i) {
      found[i] = calibrate_person(*people_family(kind), options, static_cast<std::uint32_t>(i));
    });
    SteeringTally of_kind;
    for (const Found& one : found) {
      of_kind.add(one);
      if (has_truth) all_of_law.add(one);
    }
    page += of_kind.line(kind, has_truth);
    progress->update(++*done, all);
  };
  for (const char* kind : law_kinds) add_row(kind, true);
  page += all_of_law.line("all of these", true);
  for (const char* kind : other_kinds) add_row(kind, false);
  return page +
         "\nThe last rows have no rate and delay of this law: steps of 100 ms, an arm that lags, ridges felt "
         "as they are\ncrossed. What is found of them is the law's nearest.\n";
}

// What the controller is given of the steering.
enum class Given { nothing, rate, lag, relative };
constexpr Given all_given[] = {Given::nothing, Given::rate, Given::lag, Given::relative};
constexpr double model_delay_s = 0.06;

double given_rate(const Person& person, Given given) {
  switch (given) {
    case Given::lag:
      return 1.0 / std::max(1.0 / person.gain_per_s + person.delay_s - model_delay_s, 0.03);
    case Given::relative:
      return prior_rate_per_s * person.gain_per_s / mean_rate_per_s;
    default:
      return person.gain_per_s;
  }
}

bool ends_near(const PersonCondition& condition, Given given, std::uint64_t seed, std::uint32_t index) {
  RetargeterConfig config = people_controller(condition);
  if (given != Given::nothing)
    know(config.person, PersonTrait::gain, given_rate(condition.person, given), 0.5);
  return std::abs(simulate_person(condition, &config, 1, seed, index).front().bearing_error_deg) <= near_deg;
}

std::string control_text(const Options& options, Progress* progress, std::uint64_t* done, std::uint64_t all) {
  std::string page =
      "\nFirst reaches of " + std::to_string(options.reach_people) +
      " people that end within 1.5 deg of the real target's bearing, % of those who can hold the gap\n(95 % "
      "interval), with the steering as the controller assumes it, with the person's true rate, with rate "
      "and\ndelay as one lag, and with 17 /s times the true rate over the mean person's.\n\n" +
      left("", 22) + left("assumed", 17) + left("true rate", 17) + left("as one lag", 17) + "relative\n";
  std::array<Share, std::size(all_given)> sums;
  const auto row = [&](const std::string& name, const std::array<Share, std::size(all_given)>& shares) {
    std::string text = left(name, 20);
    for (const Share& share : shares)
      text += cell(share.percent(), 1, 6) +
              left(" (" + between(share.interval().low, share.interval().high, 0) + ")", 11);
    return text + "\n";
  };
  for (const char* kind : reach_kinds)
    for (const double duration_s : durations_s) {
      std::vector<std::array<int, std::size(all_given)>> near(options.reach_people);
      for_each_part(options.reach_people, options.threads, [&](std::uint64_t part) {
        const auto i = static_cast<std::uint32_t>(part);
        const PersonCondition condition = draw_person(*people_family(kind), duration_s, options.seed, i);
        const bool holds = can_hold(condition);
        for (std::size_t g = 0; g < std::size(all_given); ++g)
          near[i][g] = holds ? (ends_near(condition, all_given[g], options.seed, i) ? 1 : 0) : -1;
      });
      std::array<Share, std::size(all_given)> shares;
      for (const auto& one : near)
        for (std::size_t g = 0; g < one.size(); ++g)
          if (one[g] >= 0) shares[g].count(one[g] == 1);
      for (std::size_t g = 0; g < shares.size(); ++g) sums[g].add(shares[g]);
      page += row(std::string(kind) + ", " + number(duration_s) + " s", shares);
      progress->update(++*done, all);
    }
  return page + row("all", sums);
}

void run(const Options& options) {
  const Output out("--out", options.out);
  Progress progress;
  const std::uint64_t kinds = options.people > 0 ? std::size(law_kinds) + std::size(other_kinds) : 0;
  const std::uint64_t cells = options.reach_people > 0 ? std::size(reach_kinds) * std::size(durations_s) : 0;
  std::uint64_t done = 0;
  std::string page;
  if (options.people > 0) page += coverage_text(options, &progress, &done, kinds + cells);
  if (options.reach_people > 0) page += control_text(options, &progress, &done, kinds + cells);
  out.write(page);
}

}  // namespace

void add_steering(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(
      app, "steering",
      "How well rate and delay of a person's steering are found, and whether they help the controller.",
      R"(Simulated people slide while the plate turns, and are calibrated; then the controller leads them,
knowing their steering or not.

Examples:
  hrt-study steering
  hrt-study steering --people 0 --reaches 1000)",
      [options] { run(*options); });
  add_integer(command, "--people", &options->people, 0, 100'000, "People of each kind to calibrate.");
  add_integer(command, "--reaches", &options->reach_people, 0, 100'000,
              "People of each kind and duration to lead.");
  add_integer(command, "--slides", &options->slides, 6, 1000, "Slides over a turning plate.");
  add_number(command, "--angle", &options->angle_deg, {5.0, 75.0}, "To which the plate turns, deg.");
  add_number(command, "--duration", &options->duration_s, {0.5, 20.0}, "Time of a slide, s.");
  add_threads(command, &options->threads);
  add_seed(command, &options->seed);
  add_out(command, &options->out);
}

}  // namespace hrt::study
