#include "samples/study/paper/power.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "samples/study/numbers/parallel.h"

#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"

namespace hrt::study {
namespace {

// Streams of Draws, apart from those of core/simulation/people.h.
enum Stream : std::uint32_t { pacing = 100, scattering, trialling, resampling };

constexpr std::uint32_t resamples = 1000;
// Of the pool, for the interval of people_needed(); the extremes of 40 hold 95 %.
constexpr std::uint32_t pools = 40;

std::vector<double> errors_deg(const PersonCondition& condition, const RetargeterConfig* controller,
                               const PoolOptions& options, std::uint32_t index, Draws& scatter) {
  std::vector<double> errors;
  for (const PersonOutcome& outcome :
       simulate_person(condition, controller, static_cast<int>(options.reaches), options.seed, index))
    errors.push_back(std::abs(outcome.bearing_error_deg + options.scatter_deg * scatter.normal()));
  return errors;
}

PairedReaches simulate(const PeopleFamily& family, const PoolOptions& options, std::uint32_t index) {
  Draws pace(options.seed, pacing, index, 0);
  const double duration_s = 1e-3 * std::floor(1000.0 + 1000.0 * pace.uniform());
  const PersonCondition condition = draw_person(family, duration_s, options.seed, index);
  const RetargeterConfig ours = people_controller(condition);
  const RetargeterConfig paper = paper_controller();
  Draws scatter(options.seed, scattering, index,
                static_cast<std::uint32_t>(&family - people_families().data()));
  const RetargeterConfig* other = options.against == Against::paper ? &paper : nullptr;
  PairedReaches reaches;
  reaches.with_deg = errors_deg(condition, &ours, options, index, scatter);
  reaches.without_deg = errors_deg(condition, other, options, index, scatter);
  return reaches;
}

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation(std::span<const double> values) {
  const double about = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - about) * (value - about);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

std::vector<double> resampled(std::span<const double> values, Draws& draws) {
  std::vector<double> sample(values.size());
  for (double& value : sample)
    value = values[static_cast<std::size_t>(draws.uniform() * static_cast<double>(values.size()))];
  return sample;
}

// The fewest people; power rises with their number.
std::uint64_t fewest(std::span<const double> differences, double effect, double wanted_percent,
                     std::uint64_t trials, std::uint64_t seed) {
  const auto enough = [&](std::uint64_t people) {
    return trial_power(differences, effect, people, trials, seed).percent() >= wanted_percent;
  };
  std::uint64_t too_few = 1;
  std::uint64_t many = 2;
  while (many <= max_people && !enough(many)) {
    too_few = many;
    many *= 2;
  }
  many = std::min(many, max_people + 1);
  while (many - too_few > 1) {
    const std::uint64_t middle = (too_few + many) / 2;
    (enough(middle) ? many : too_few) = middle;
  }
  return many;
}

}  // namespace

std::vector<PairedReaches> simulate_pool(
    std::span<const PeopleFamily* const> families, const PoolOptions& options,
    const std::function<void(std::uint64_t done, std::uint64_t total)>& progress) {
  std::vector<PairedReaches> pool(families.size() * options.people);
  const auto work = [&](std::uint64_t i) {
    pool[i] =
        simulate(*families[i / options.people], options, static_cast<std::uint32_t>(i % options.people));
  };
  for_each_part(pool.size(), options.threads, work, progress);
  return pool;
}

std::vector<double> differences_deg(std::span<const PairedReaches> pool, std::uint64_t reaches) {
  std::vector<double> differences;
  for (const PairedReaches& person : pool)
    differences.push_back(mean(std::span(person.without_deg).first(reaches)) -
                          mean(std::span(person.with_deg).first(reaches)));
  return differences;
}

Spread spread(std::span<const double> values, std::uint64_t seed) {
  Draws draws(seed, resampling, 0, 0);
  std::vector<double> means;
  std::vector<double> deviations;
  for (std::uint32_t i = 0; i < resamples; ++i) {
    const std::vector<double> sample = resampled(values, draws);
    means.push_back(mean(sample));
    deviations.push_back(deviation(sample));
  }
  return {.mean = {mean(values), quantile(means, 0.025), quantile(means, 0.975)},
          .sd = {deviation(values), quantile(deviations, 0.025), quantile(deviations, 0.975)}};
}

Share trial_power(std::span<const double> differences, double effect, std::uint64_t people,
                  std::uint64_t trials, std::uint64_t seed) {
  const double shift = effect - mean(differences);
  const double critical = student_critical(people - 1);
  const auto n = static_cast<double>(people);
  Share found;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    Draws draws(seed, trialling, static_cast<std::uint32_t>(trial), static_cast<std::uint32_t>(people));
    double sum = 0.0;
    double square_sum = 0.0;
    for (std::uint64_t i = 0; i < people; ++i) {
      const auto who = static_cast<std::size_t>(draws.uniform() * static_cast<double>(differences.size()));
      const double difference = differences[who] + shift;
      sum += difference;
      square_sum += difference * difference;
    }
    // t > critical, without a division by a deviation of 0.
    const double variance = std::max(0.0, (square_sum - sum * sum / n) / (n - 1.0));
    found.count(sum / n > critical * std::sqrt(variance / n));
  }
  return found;
}

PeopleNeeded people_needed(std::span<const double> differences, double effect, double wanted_percent,
                           std::uint64_t trials, std::uint64_t seed) {
  PeopleNeeded needed{
      .people = fewest(differences, effect, wanted_percent, trials, seed), .low = max_people + 1, .high = 0};
  Draws draws(seed, resampling, 1, 0);
  for (std::uint32_t i = 0; i < pools; ++i) {
    const std::uint64_t people = fewest(resampled(differences, draws), effect, wanted_percent,
                                        std::max<std::uint64_t>(1, trials / 10), seed + 1 + i);
    needed.low = std::min(needed.low, people);
    needed.high = std::max(needed.high, people);
  }
  return needed;
}

}  // namespace hrt::study
