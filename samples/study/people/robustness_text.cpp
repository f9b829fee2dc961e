#include "samples/study/people/robustness.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "samples/app/text/text.h"
#include "samples/study/cli/output.h"

namespace hrt::study {
namespace {

using Rows = std::vector<RobustnessRow>;

using Cell = const RobustnessCell&;

// Rounds to a whole percentage; at most 99 unless all cases are hits.
std::string rounded(const Share& share) {
  return cell(share.hits < share.of ? std::min(share.percent(), 99.0) : share.percent(), 0);
}

Rows rows_where(const Rows& rows, const std::function<bool(const RobustnessRow&)>& is) {
  Rows found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found), is);
  return found;
}

Rows of_people(const Rows& rows, const std::string& name) {
  return rows_where(rows, [&](const RobustnessRow& row) { return row.people.name == name; });
}

Rows of_kind(const Rows& rows, FamilyKind kind) {
  return rows_where(rows, [&](const RobustnessRow& row) { return row.people.kind == kind; });
}

std::string near_line(const std::string& name, const Rows& rows, const std::vector<double>& durations_s,
                      const std::function<std::string(const Rows&, ControllerKind)>& words) {
  std::string line = fmt::format("{:15}", name);
  for (const double duration_s : durations_s) {
    const Rows of_duration = rows_where(rows, [&](const RobustnessRow& row) { return row.duration_s == duration_s; });
    for (const ControllerKind controller : all_controllers)
      line += fmt::format("{:>{}}", words(of_duration, controller), controller == ControllerKind::none ? 5 : 4);
  }
  return line + '\n';
}

std::string near_table(const RobustnessStudy& study) {
  const Rows& rows = study.rows;
  const std::vector<double>& durations_s = study.options.durations_s;
  std::string page = fmt::format("{:15}", ""), titles = page;
  for (const double duration_s : durations_s) {
    page += fmt::format("{:>21}", fmt::format("{} s", duration_s));
    titles += fmt::format("   no pap   1{:>4} inf", study.options.reaches);
  }
  page += '\n' + titles + '\n';
  for (const SimulatedPeople& people : study.people)
    page += near_line(
        label(people), of_people(rows, people.name), durations_s,
        [](const Rows& of, ControllerKind controller) { return rounded(of.front().cell(controller).feasible.near); });
  if (study.people.size() == 1) return page;
  const auto mean_line = [&](const std::string& name, const Rows& of) {
    const auto mean = [](const Rows& some, ControllerKind controller) {
      return cell(mean_near_percent(some, controller), 0);
    };
    return of.empty() ? "" : near_line(name, of, durations_s, mean);
  };
  const Rows invented = of_kind(rows, FamilyKind::invented);
  return page + '\n' + mean_line("mean, recorded", of_kind(rows, FamilyKind::recorded)) +
         mean_line("mean, tuned on", rows_where(invented, [](const RobustnessRow& row) { return row.people.tuned; })) +
         mean_line("mean, untuned *",
                   rows_where(invented, [](const RobustnessRow& row) { return !row.people.tuned; })) +
         mean_line("mean of both", invented) + mean_line("mean, error +", of_kind(rows, FamilyKind::misplaced));
}

// Returns "0.42 (0.38-0.47)"; a bound that the sample does not determine is "?".
std::string with_interval(const Quantile& quantile, int decimals) {
  if (std::isnan(quantile.value)) return "-";
  return fmt::format("{:.{}f} ({})", quantile.value, decimals, between(quantile.low, quantile.high, decimals));
}

std::string with_interval(const Share& share) {
  return with_interval(Quantile{share.percent(), share.interval().low, share.interval().high}, 1);
}

std::string flags_table(const Rows& all, std::uint64_t reaches) {
  const Rows rows = of_kind(all, FamilyKind::invented), recorded = of_kind(all, FamilyKind::recorded);
  struct Line {
    const char* name;
    const Rows& of;
    std::function<Share(Cell)> share;
  };
  const Rows linear = of_people(rows, people_families().front().name), off = of_kind(all, FamilyKind::misplaced);
  const Line lines[] = {
      {"gap infeasible: flagged unreachable", rows, [](Cell of) { return of.infeasible.found; }},
      {"  missed without a flag", rows, [](Cell of) { return of.infeasible.silent; }},
      {"gap feasible: flagged unreachable", rows, [](Cell of) { return of.feasible.unreachable; }},
      {"  missed without a flag", rows, [](Cell of) { return of.feasible.silent; }},
      {"  on target, but flagged", rows, [](Cell of) { return of.feasible.false_alarm; }},
      {"all: flagged as a misfit", rows, [](Cell of) { return of.misfit; }},
      {"  flagged off target", rows, [](Cell of) { return of.off_target; }},
      {"linear: interval contains true w_T", linear, [](Cell of) { return of.weight_covered; }},
      {"recorded, feasible: missed without a flag", recorded, [](Cell of) { return of.feasible.silent; }},
      {"  infeasible: flagged unreachable", recorded, [](Cell of) { return of.infeasible.found; }},
      {"  flagged as a misfit", recorded, [](Cell of) { return of.misfit; }},
      {"systematic error: missed without a flag", off, [](Cell of) { return of.feasible.silent; }}};
  std::string page = fmt::format("{:41}{:>19}{:>19}{:>19}{:>19}\n", "Flags, % of reaches (95 % interval)", "pap",
                                 "reach 1", fmt::format("reach {}", reaches), "inf");
  for (const Line& line : lines) {
    if (line.of.empty() && &line.of != &rows) continue;
    page += fmt::format("{:41}", line.name);
    for (const ControllerKind controller : all_controllers)
      if (controller != ControllerKind::none)
        page += fmt::format("{:>19}", with_interval(pooled(line.of, controller, line.share)));
    page += '\n';
  }
  return page;
}

std::string details_table(const SimulatedPeople& people, const Rows& rows) {
  std::string page = people.name + ": " + people.description + '\n';
  for (const bool is_feasible : {true, false}) {
    const Rows some = rows_where(
        rows, [&](const RobustnessRow& row) { return row.cell(ControllerKind::none).group(is_feasible).near.of > 0; });
    if (some.empty()) continue;
    page += fmt::format(
        "\nPeople for whom the gap is {}: reaches within 1.5 deg, quantiles of the miss, median of the largest\n"
        "perceived-direction error, misses without a flag. 95 % intervals; ?: too few reaches for this bound\n"
        "{:>4}  {:18}{:>19}{:>18}{:>18}{:>18}{:>19}\n",
        is_feasible ? "feasible" : "infeasible", "s", "controller", "within, %", "median miss, mm", "95 % miss, mm",
        "error, deg", "unflagged, %");
    for (const RobustnessRow& row : some)
      for (const ControllerKind controller : all_controllers) {
        const bool is_first = controller == ControllerKind::none;
        const ReachGroup& of = row.cell(controller).group(is_feasible);
        page +=
            fmt::format("{:>4}  {:18}{:>19}{:>18}{:>18}{:>18}{:>19}\n", is_first ? fmt::to_string(row.duration_s) : "",
                        controller_titles[static_cast<std::size_t>(controller)], with_interval(of.near),
                        with_interval(of.miss_median_mm, 1), with_interval(of.miss_95_mm, 1),
                        with_interval(of.peak_felt_error_median_deg, 1), is_first ? "" : with_interval(of.silent));
      }
  }
  return page;
}

// Adds the numbers of a cell to a row. `flags` false: the columns of flags and intervals are empty, as without a
// controller.
void put_numbers(Row& row, const RobustnessCell& cell, bool flags) {
  const auto put_flag = [&](const std::string& name, const Share& share) { put(row, name, flags ? share : Share{}); };
  row["feasible"] = cell.feasible.near.of;
  row["infeasible"] = cell.infeasible.near.of;
  for (const std::string whose : {"", "infeasible_"}) {
    const ReachGroup& group = cell.group(whose.empty());
    put(row, whose + "near", group.near);
    put(row, whose + "miss_median", "_mm", group.miss_median_mm);
    put(row, whose + "miss_95", "_mm", group.miss_95_mm);
    put(row, whose + "peak_felt_error_median", "_deg", group.peak_felt_error_median_deg);
    put(row, whose + "peak_felt_error_95", "_deg", group.peak_felt_error_95_deg);
    put_flag(whose + "silent_miss", group.silent);
    put_flag(whose + "false_alarm", group.false_alarm);
  }
  for (const auto& [name, share] : {std::pair("unreachable_found", cell.infeasible.found),
                                    {"unreachable_false", cell.feasible.unreachable},
                                    {"misfit", cell.misfit},
                                    {"off_target", cell.off_target},
                                    {"weight_covered", cell.weight_covered},
                                    {"bias_covered", cell.bias_covered},
                                    {"habit_covered", cell.habit_covered},
                                    {"miss_covered", cell.miss_covered}})
    put_flag(name, share);
}

std::string condition_words(const RobustnessStudy& study) {
  const bool has_families = std::any_of(study.people.begin(), study.people.end(),
                                        [](const SimulatedPeople& each) { return people_family(each.name.c_str()); });
  return fmt::format(
      "At most {} people of each family at each duration, seed {}. {} Our controller does not know the duration.",
      study.options.people, study.options.seed,
      has_families ? "Unless the description of a family states otherwise: reaches of 100 mm, a gap of 10°, w_T from "
                     "0.12 to 0.30, tracker noise of 1.2 mm at 90 Hz, a servo with 400°/s and a latency of 30 ms."
                   : "The options --person and --recorded define the people.");
}

std::string informed_of(const RobustnessStudy& study) {
  std::vector<std::string> names;
  for (const PersonState::Index trait : study.options.informed_of) names.emplace_back(person_state[trait].name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string label(const SimulatedPeople& people) {
  return people.name + (people.kind == FamilyKind::misplaced  ? " +"
                        : people.kind == FamilyKind::recorded ? " ~"
                        : people.tuned                        ? ""
                                                              : " *");
}

std::string robustness_text(const RobustnessStudy& study) {
  double widest = 0.0, people = 0.0;
  for (const RobustnessRow& row : study.rows)
    for (const RobustnessCell& cell : row.cells) {
      if (cell.feasible.near.of > 0) widest = std::max(widest, half_interval(cell.feasible.near));
      people += static_cast<double>(cell.people()) / static_cast<double>(study.rows.size() * all_controllers.size());
    }
  const std::uint64_t reaches = study.options.reaches;
  std::string page = fmt::format(
      "{}\n\n{}\n\n"
      "no: no controller. pap: the paper's controller.\n"
      "1, {}: our controller (the plugin's default) in a person's first reach, and in reach {}, with its estimates\n"
      "from the reaches before.\n{}\n"
      "*: family that was not used to tune our controller. ~: paths and speeds of recorded reaches.\n"
      "+: systematic error of the tracker or of the plate, which no controller can detect within a reach\n"
      "(placed-touch3: no error, for comparison).\n\n",
      wrapped("Simulated reaches; there was no human trial. " + condition_words(study), 110),
      wrapped(fmt::format(
                  "The table has the percentage of reaches that end within 1.5 deg of the real target's bearing, of "
                  "people for whom the gap is feasible (-: no one). The 95 % interval of a cell is at most +-{:.1f} "
                  "points. A cell takes no more people once its interval is at most +-{} points (--within); cells have "
                  "{:.0f} people on average (--format csv has the number of each).",
                  widest, study.options.points, people),
              110),
      reaches, reaches,
      wrapped("inf: our controller in the first reach, with the person's true values of " + informed_of(study) + ".",
              110));
  page += near_table(study);
  if (study.people.size() == 1) page += '\n' + details_table(study.people.front(), study.rows);
  return page + '\n' + flags_table(study.rows, reaches);
}

Results robustness_results(const RobustnessStudy& study) {
  Results found{.about = {{"simulation", true},
                          {"people", study.options.people},
                          {"seed", study.options.seed},
                          {"informed_of", informed_of(study)},
                          {"condition", condition_words(study)}},
                .rows = {}};
  for (const RobustnessRow& of : study.rows)
    for (const ControllerKind controller : all_controllers) {
      Row row{{"family", of.people.name},
              {"tuned", of.people.tuned},
              {"misplaced", of.people.kind == FamilyKind::misplaced},
              {"duration_s", of.duration_s},
              {"controller", controller_names[static_cast<std::size_t>(controller)]},
              {"reach", controller == ControllerKind::last ? study.options.reaches : 1},
              {"people", of.cell(controller).people()},
              {"seed", study.options.seed}};
      put_numbers(row, of.cell(controller), controller != ControllerKind::none);
      row["description"] = of.people.description;
      found.rows.push_back(std::move(row));
    }
  return found;
}

}  // namespace hrt::study
