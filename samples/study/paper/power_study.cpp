#include "samples/study/paper/power_study.h"

#include <nlohmann/json.hpp>

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

std::string power_line(const PowerRow& row, const std::string& effect, bool needed) {
  std::string line = right(effect, 11) + right(std::to_string(row.reaches), 9) +
                     right(needed ? people_text(row.for_80, "-") : "", 17) +
                     right(needed ? people_text(row.for_90, "-") : "", 17) + "  ";
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

std::string people_text(const PeopleNeeded& needed, const std::string& dash) {
  const auto count = [](std::uint64_t people) {
    return people > max_people ? "> " + std::to_string(max_people) : std::to_string(people);
  };
  return count(needed.people) + " (" + count(needed.low) + dash + count(needed.high) + ")";
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

std::string power_csv(const PowerStudy& study) {
  std::string page =
      "against,effect_deg,reaches,people,power_percent,power_low_percent,power_high_percent,"
      "people_for_80,people_for_80_low,people_for_80_high,people_for_90,people_for_90_low,people_for_90_"
      "high\n";
  const auto add = [&](const PowerRow& row, bool needed) {
    const auto count = [&](std::uint64_t people) {
      return ',' + (!needed || people > max_people ? "" : std::to_string(people));
    };
    for (const PowerPoint& point : row.points) {
      const PercentInterval interval = point.found.interval();
      page += std::string(study.options.pool.against == Against::paper ? "paper," : "none,") +
              number(row.effect_deg) + ',' + std::to_string(row.reaches) + ',' +
              std::to_string(point.people) + ',' + number(point.found.percent()) + ',' +
              number(interval.low) + ',' + number(interval.high);
      for (const PeopleNeeded* people : {&row.for_80, &row.for_90})
        page += count(people->people) + count(people->low) + count(people->high);
      page += '\n';
    }
  };
  for (const PowerRow& row : study.no_effect) add(row, false);
  for (const PowerRow& row : study.rows) add(row, true);
  return page;
}

std::string power_json(const PowerStudy& study) {
  using Json = nlohmann::ordered_json;
  const auto quantile = [](const Quantile& value) {
    return Json{{"value", value.value}, {"interval", {value.low, value.high}}};
  };
  Json page{{"simulation", true},
            {"against", study.options.pool.against == Against::paper ? "paper" : "none"},
            {"trials", study.options.trials},
            {"seed", study.options.pool.seed},
            {"assumptions", power_assumptions(study.options)}};
  for (const PoolSpread& pool : study.pool)
    page["pool"].push_back({{"reaches", pool.reaches},
                            {"difference_mean_deg", quantile(pool.difference_deg.mean)},
                            {"difference_sd_deg", quantile(pool.difference_deg.sd)},
                            {"with_median_deg", quantile(pool.with_deg)},
                            {"without_median_deg", quantile(pool.without_deg)}});
  const auto add = [&](const PowerRow& row, bool needed) {
    Json entry{{"effect_deg", row.effect_deg}, {"reaches", row.reaches}};
    for (const PowerPoint& point : row.points) {
      const PercentInterval interval = point.found.interval();
      entry["power"].push_back({{"people", point.people},
                                {"percent", point.found.percent()},
                                {"interval_percent", {interval.low, interval.high}}});
    }
    if (needed) {
      const auto people = [](const PeopleNeeded& found) {
        const auto count = [](std::uint64_t n) { return n > max_people ? Json() : Json(n); };
        return Json{{"value", count(found.people)}, {"interval", {count(found.low), count(found.high)}}};
      };
      entry["people_for_80"] = people(row.for_80);
      entry["people_for_90"] = people(row.for_90);
    }
    page["rows"].push_back(entry);
  };
  for (const PowerRow& row : study.no_effect) add(row, false);
  for (const PowerRow& row : study.rows) add(row, true);
  return page.dump(2) + '\n';
}

}  // namespace hrt::study
