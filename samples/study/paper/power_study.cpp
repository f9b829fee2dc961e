#include "samples/study/paper/power_study.h"

#include <utility>

#include "samples/study/cli/output.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

const char* against_words(Against against) {
  return against == Against::paper ? "the paper's controller" : "no controller, the plate at 0";
}

PowerRow power_row(const PowerOptions& options, const std::vector<double>& differences, double effect_deg,
                   std::uint64_t reaches) {
  PowerRow row{.effect_deg = effect_deg, .reaches = reaches, .points = {}, .for_80 = {}, .for_90 = {}};
  for (const double people : options.people) {
    const auto count = static_cast<std::uint64_t>(people);
    row.points.push_back(
        {.people = count,
         .found = trial_power(differences, effect_deg, count, options.trials, options.pool.seed)});
  }
  return row;
}

Quantile median_error(const std::vector<PairedReaches>& pool, std::vector<double> PairedReaches::* errors,
                      std::uint64_t reaches) {
  std::vector<double> means;
  for (const PairedReaches& person : pool) {
    double sum = 0.0;
    for (std::uint64_t i = 0; i < reaches; ++i) sum += (person.*errors)[i];
    means.push_back(sum / static_cast<double>(reaches));
  }
  return quantile_of(means, 0.5);
}

std::string with_interval(const Quantile& quantile, int decimals) {
  return fixed(quantile.value, decimals) + " (" + between(quantile.low, quantile.high, decimals, " to ") +
         ")";
}

// "12 (10-15)"; more than max_people: "> 1000".
std::string people_text(const PeopleNeeded& needed) {
  const auto count = [](std::uint64_t people) {
    return people > max_people ? "> " + std::to_string(max_people) : std::to_string(people);
  };
  return count(needed.people) + " (" + count(needed.low) + "-" + count(needed.high) + ")";
}

std::string power_line(const PowerRow& row, const std::string& effect, bool needed) {
  std::string line = right(effect, 11) + right(std::to_string(row.reaches), 9) +
                     right(needed ? people_text(row.for_80) : "", 17) +
                     right(needed ? people_text(row.for_90) : "", 17) + "  ";
  for (const PowerPoint& point : row.points) line += right(fixed(point.found.percent(), 0), 5);
  return line + '\n';
}

double widest_interval(const PowerStudy& study) {
  double widest = 0.0;
  for (const PowerRow& row : study.rows)
    for (const PowerPoint& point : row.points) {
      const PercentInterval interval = point.found.interval();
      widest = std::max(widest, 0.5 * (interval.high - interval.low));
    }
  return widest;
}

// What the numbers take for granted, a sentence each.
std::vector<std::string> power_assumptions(const PowerOptions& options) {
  const std::string outcome =
      "Outcome: a person's mean size of the error of the real target's bearing, of the fingertip's "
      "true end. Test: paired t, two-sided, 5 %, found if the controller's error is the smaller one.";
  const std::string effect =
      "Effect: the differences are shifted to the mean that the row states, so that people differ from each "
      "other as the simulated ones do, whatever the effect. The mean that the simulation itself gives is no "
      "forecast.";
  return {
      "Design: within subject. Each person makes the stated number of reaches under each of two conditions: "
      "our controller, which starts without knowledge of the person and carries what it learns, and " +
          std::string(against_words(options.pool.against)) +
          ". Order, learning and fatigue of the person have no effect.",
      outcome,
      "People: " + std::to_string(options.pool.people) + " of each of " +
          std::to_string(options.families.size()) +
          " simulated families in equal parts, at a pace of 1 to 2 s, gap 10 deg over 100 mm; nobody is "
          "screened out, also not who cannot hold the gap. Real people may differ more.",
      effect,
      "Scatter from reach to reach is that of the simulation, plus " + number(options.pool.scatter_deg) +
          " deg (--scatter). Nobody drops out.",
  };
}

}  // namespace

PowerStudy simulate_power(const PowerOptions& options) {
  PowerStudy study{.options = options, .pool = {}, .rows = {}, .no_effect = {}};
  Progress progress;
  const std::vector<PairedReaches> pool =
      simulate_pool(options.families, options.pool,
                    [&](std::uint64_t done, std::uint64_t total) { progress.update(done, total); });
  for (const double value : options.reaches) {
    const auto reaches = static_cast<std::uint64_t>(value);
    const std::vector<double> differences = differences_deg(pool, reaches);
    study.pool.push_back({.reaches = reaches,
                          .difference_deg = spread(differences, options.pool.seed),
                          .with_deg = median_error(pool, &PairedReaches::with_deg, reaches),
                          .without_deg = median_error(pool, &PairedReaches::without_deg, reaches)});
    study.no_effect.push_back(power_row(options, differences, 0.0, reaches));
    for (const double effect_deg : options.effects_deg) {
      PowerRow row = power_row(options, differences, effect_deg, reaches);
      row.for_80 = people_needed(differences, effect_deg, 80.0, options.trials, options.pool.seed);
      row.for_90 = people_needed(differences, effect_deg, 90.0, options.trials, options.pool.seed);
      study.rows.push_back(row);
    }
  }
  return study;
}

std::string power_text(const PowerStudy& study) {
  std::string page = "Simulated trials of simulated people; there was no human trial. Assumptions:\n\n";
  for (const std::string& assumption : power_assumptions(study.options))
    page += wrapped(assumption, 100, "- ", "  ");
  page +=
      "\nThe simulated people (95 % intervals of the pool):\n  reaches   mean error, median over people, "
      "deg: with, without   difference, deg: mean           SD\n";
  for (const PoolSpread& pool : study.pool)
    page += right(std::to_string(pool.reaches), 9) + right(with_interval(pool.with_deg, 2), 24) +
            right(with_interval(pool.without_deg, 2), 25) +
            right(with_interval(pool.difference_deg.mean, 2), 24) +
            right(with_interval(pool.difference_deg.sd, 2), 22) + '\n';
  page +=
      "\nPeople for 80 and 90 % power (95 % interval of the pool), and power in % by people; simulated "
      "power is\nexact to +-" +
      fixed(widest_interval(study), 1) + " points (Wilson, " + std::to_string(study.options.trials) +
      " trials).\n\neffect, deg  reaches        for 80 %         for 90 %  ";
  for (const double people : study.options.people) page += right(number(people), 5);
  page += '\n';
  for (const PowerRow& row : study.rows) page += power_line(row, number(row.effect_deg), true);
  page +=
      "\nNo effect: how often a trial finds one all the same. More than 2.5 % shows that the t test is too "
      "lax for\n"
      "people whose differences are skewed as these are; powers of effects as small as that are too high.\n";
  for (const PowerRow& row : study.no_effect) page += power_line(row, "0", false);
  return page;
}

Results power_results(const PowerStudy& study) {
  const bool paper = study.options.pool.against == Against::paper;
  Results found{.about = {{"simulation", true},
                          {"trials", study.options.trials},
                          {"seed", study.options.pool.seed},
                          {"assumptions", power_assumptions(study.options)}},
                .rows = {}};
  for (const PoolSpread& pool : study.pool) {
    Row row{{"reaches", pool.reaches}};
    put(row, "difference_mean", "_deg", pool.difference_deg.mean);
    put(row, "difference_sd", "_deg", pool.difference_deg.sd);
    put(row, "with_median", "_deg", pool.with_deg);
    put(row, "without_median", "_deg", pool.without_deg);
    found.about["pool"].push_back(std::move(row));
  }
  const auto add = [&](const PowerRow& of, bool needed) {
    const auto count = [&](std::uint64_t people) {
      return needed && people <= max_people ? Row(people) : Row();
    };
    for (const PowerPoint& point : of.points) {
      Row row{{"against", paper ? "paper" : "none"},
              {"effect_deg", of.effect_deg},
              {"reaches", of.reaches},
              {"people", point.people}};
      put(row, "power", point.found);
      for (const auto& [name, people] :
           {std::pair("people_for_80", of.for_80), {"people_for_90", of.for_90}}) {
        row[name] = count(people.people);
        row[std::string(name) + "_low"] = count(people.low);
        row[std::string(name) + "_high"] = count(people.high);
      }
      found.rows.push_back(std::move(row));
    }
  };
  for (const PowerRow& row : study.no_effect) add(row, false);
  for (const PowerRow& row : study.rows) add(row, true);
  return found;
}

}  // namespace hrt::study
