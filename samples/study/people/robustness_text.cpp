#include "samples/study/people/robustness.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samples/app/text/text.h"
#include "samples/study/cli/output.h"

namespace hrt::study {
namespace {

using Rows = std::vector<RobustnessRow>;

// Rounds to a whole percentage; only a share of all cases becomes 100.
std::string rounded(const Share& share) {
  if (share.of == 0) return "-";
  const double percent = share.percent();
  return fixed(share.hits < share.of ? std::min(percent, 99.0) : percent, 0);
}

Rows rows_where(const Rows& rows, const std::function<bool(const RobustnessRow&)>& is) {
  Rows found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found), is);
  return found;
}

Rows of_people(const Rows& rows, const std::string& name) {
  return rows_where(rows, [&](const RobustnessRow& row) { return row.people.name == name; });
}

bool is_invented(const RobustnessRow& row) { return row.people.kind == FamilyKind::invented; }
bool is_recorded(const RobustnessRow& row) { return row.people.kind == FamilyKind::recorded; }
bool is_misplaced(const RobustnessRow& row) { return row.people.kind == FamilyKind::misplaced; }

std::string near_line(const std::string& name, const Rows& rows, const std::vector<double>& durations_s,
                      const std::function<std::string(const Rows&, ControllerKind)>& words) {
  std::string line = left(name, 15);
  for (const double duration_s : durations_s) {
    const Rows of_duration = rows_where(rows, [&](const RobustnessRow& row) { return row.duration_s == duration_s; });
    for (const ControllerKind controller : all_controllers)
      line += right(words(of_duration, controller), controller == ControllerKind::none ? 5 : 4);
  }
  return line + '\n';
}

std::string near_table(const RobustnessStudy& study) {
  const Rows& rows = study.rows;
  const std::vector<double>& durations_s = study.options.durations_s;
  std::string page = left("", 15);
  for (const double duration_s : durations_s) page += right(number(duration_s) + " s", 21);
  page += '\n' + left("", 15);
  for (std::size_t i = 0; i < durations_s.size(); ++i)
    page += "   no pap   1" + right(std::to_string(study.options.reaches), 4) + " inf";
  page += '\n';
  for (const SimulatedPeople& people : study.people)
    page += near_line(
        label(people), of_people(rows, people.name), durations_s,
        [](const Rows& of, ControllerKind controller) { return rounded(of.front().cell(controller).feasible.near); });
  if (study.people.size() == 1) return page;
  const auto mean = [](const Rows& of, ControllerKind controller) {
    const double percent = mean_near_percent(of, controller);
    return std::isnan(percent) ? "-" : fixed(percent, 0);
  };
  const auto mean_line = [&](const std::string& name, bool tuned, FamilyKind kind) {
    const Rows of = rows_where(
        rows, [&](const RobustnessRow& row) { return row.people.tuned == tuned && row.people.kind == kind; });
    return of.empty() ? "" : near_line(name, of, durations_s, mean);
  };
  const Rows invented = rows_where(rows, is_invented);
  return page + '\n' + mean_line("mean, recorded", false, FamilyKind::recorded) +
         mean_line("mean, tuned on", true, FamilyKind::invented) +
         mean_line("mean, untuned *", false, FamilyKind::invented) +
         (invented.empty() ? "" : near_line("mean of both", invented, durations_s, mean)) +
         mean_line("mean, error +", false, FamilyKind::misplaced);
}

// "0.42 (0.38-0.47)"; a bound that the sample does not determine is "?".
std::string with_interval(const Quantile& quantile, int decimals) {
  if (std::isnan(quantile.value)) return "-";
  return fixed(quantile.value, decimals) + " (" + between(quantile.low, quantile.high, decimals) + ")";
}

std::string with_interval(const Share& share) {
  if (share.of == 0) return "-";
  const PercentInterval interval = share.interval();
  return fixed(share.percent(), 1) + " (" + between(interval.low, interval.high, 1) + ")";
}

std::string flags_table(const Rows& all, std::uint64_t reaches) {
  const Rows rows = rows_where(all, is_invented);
  const Rows recorded = rows_where(all, is_recorded);
  const Rows off = rows_where(all, is_misplaced);
  constexpr ControllerKind flagging[] = {ControllerKind::paper, ControllerKind::first, ControllerKind::last,
                                         ControllerKind::informed};
  const auto line = [&](const std::string& name, const Rows& of,
                        const std::function<Share(const RobustnessCell&)>& share) {
    std::string text = left(name, 41);
    for (const ControllerKind controller : flagging) text += right(with_interval(pooled(of, controller, share)), 19);
    return text + '\n';
  };
  using Cell = const RobustnessCell&;
  std::string page = left("Flags, % of reaches (95 % interval)", 41);
  for (const std::string& title :
       {std::string("pap"), std::string("reach 1"), "reach " + std::to_string(reaches), std::string("inf")})
    page += right(title, 19);
  page += '\n';
  page += line("gap infeasible: flagged unreachable", rows, [](Cell cell) { return cell.infeasible.found; }) +
          line("  missed without a flag", rows, [](Cell cell) { return cell.infeasible.silent; }) +
          line("gap feasible: flagged unreachable", rows, [](Cell cell) { return cell.feasible.unreachable; }) +
          line("  missed without a flag", rows, [](Cell cell) { return cell.feasible.silent; }) +
          line("  on target, but flagged", rows, [](Cell cell) { return cell.feasible.false_alarm; }) +
          line("all: flagged as a misfit", rows, [](Cell cell) { return cell.misfit; }) +
          line("  flagged off target", rows, [](Cell cell) { return cell.off_target; });
  if (const Rows linear = of_people(rows, people_families().front().name); !linear.empty())
    page += line("linear: interval contains true w_T", linear, [](Cell cell) { return cell.weight_covered; });
  if (!recorded.empty())
    page +=
        line("recorded, feasible: missed without a flag", recorded, [](Cell cell) { return cell.feasible.silent; }) +
        line("  infeasible: flagged unreachable", recorded, [](Cell cell) { return cell.infeasible.found; }) +
        line("  flagged as a misfit", recorded, [](Cell cell) { return cell.misfit; });
  if (!off.empty())
    page += line("systematic error: missed without a flag", off, [](Cell cell) { return cell.feasible.silent; });
  return page;
}

// All numbers of one kind of people.
std::string details_table(const SimulatedPeople& people, const Rows& rows) {
  std::string page = people.name + ": " + people.description + '\n';
  for (const bool is_feasible : {true, false}) {
    const bool any = std::any_of(rows.begin(), rows.end(), [&](const RobustnessRow& row) {
      return row.cell(ControllerKind::none).group(is_feasible).near.of > 0;
    });
    if (!any) continue;
    page +=
        std::string("\nPeople for whom the gap is ") + (is_feasible ? "feasible" : "infeasible") +
        ": reaches within 1.5 deg, quantiles of the miss, median of the largest\nperceived-direction error, misses " +
        "without a flag. 95 % intervals; ?: too few reaches determine this bound\n" + right("s", 4) + "  " +
        left("controller", 18) + right("within, %", 19) + right("median miss, mm", 18) + right("95 % miss, mm", 18) +
        right("error, deg", 18) + right("unflagged, %", 19) + '\n';
    for (const RobustnessRow& row : rows) {
      if (row.cell(ControllerKind::none).group(is_feasible).near.of == 0) continue;
      for (const ControllerKind controller : all_controllers) {
        const ReachGroup& of = row.cell(controller).group(is_feasible);
        page += right(controller == ControllerKind::none ? number(row.duration_s) : "", 4) + "  " +
                left(controller_titles[static_cast<std::size_t>(controller)], 18) + right(with_interval(of.near), 19) +
                right(with_interval(of.miss_median_mm, 1), 18) + right(with_interval(of.miss_95_mm, 1), 18) +
                right(with_interval(of.peak_felt_error_median_deg, 1), 18) +
                right(controller == ControllerKind::none ? "" : with_interval(of.silent), 19) + '\n';
      }
    }
  }
  return page;
}

// The numbers of a cell. Without a controller there are no flags.
void put_numbers(Row& row, const RobustnessCell& cell, bool flags) {
  const auto put_flag = [&](const std::string& name, const Share& share) { put(row, name, flags ? share : Share{}); };
  row["feasible"] = cell.feasible.near.of;
  row["infeasible"] = cell.infeasible.near.of;
  for (const bool is_feasible : {true, false}) {
    const ReachGroup& group = cell.group(is_feasible);
    const std::string whose = is_feasible ? "" : "infeasible_";
    put(row, whose + "near", group.near);
    put(row, whose + "miss_median", "_mm", group.miss_median_mm);
    put(row, whose + "miss_95", "_mm", group.miss_95_mm);
    put(row, whose + "peak_felt_error_median", "_deg", group.peak_felt_error_median_deg);
    put(row, whose + "peak_felt_error_95", "_deg", group.peak_felt_error_95_deg);
    put_flag(whose + "silent_miss", group.silent);
    put_flag(whose + "false_alarm", group.false_alarm);
  }
  put_flag("unreachable_found", cell.infeasible.found);
  put_flag("unreachable_false", cell.feasible.unreachable);
  put_flag("misfit", cell.misfit);
  put_flag("off_target", cell.off_target);
  put_flag("weight_covered", cell.weight_covered);
  put_flag("bias_covered", cell.bias_covered);
  put_flag("habit_covered", cell.habit_covered);
  put_flag("miss_covered", cell.miss_covered);
}

// Description of the conditions of all reaches.
std::string condition_words(const RobustnessStudy& study) {
  const RobustnessOptions& options = study.options;
  const bool has_families = std::any_of(study.people.begin(), study.people.end(),
                                        [](const SimulatedPeople& each) { return people_family(each.name.c_str()); });
  return "At most " + std::to_string(options.people) + " people of each family at each duration, seed " +
         std::to_string(options.seed) +
         (has_families
              ? ". Unless the description of a family states otherwise: 100 mm, a gap of 10°, w_T from 0.12 to "
                "0.30, tracker noise of 1.2 mm at 90 Hz, a servo with 400°/s and a latency of 30 ms."
              : ". The file of --person defines the person.") +
         " Our controller does not know the duration.";
}

std::string informed_of(const RobustnessStudy& study) {
  std::string names;
  for (const PersonState::Index trait : study.options.informed_of)
    names += (names.empty() ? "" : ", ") + std::string(person_state[trait].name);
  return names;
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
  std::string page =
      wrapped("Simulated reaches; there was no human trial. " + condition_words(study), 110) + '\n' + '\n' +
      wrapped(
          "The table has the percentage of reaches that end within 1.5 deg of the real target's bearing, of people for "
          "whom the gap is feasible (-: of none). The 95 % interval of a cell is at most +-" +
              fixed(widest, 1) + " points. A cell takes no more people once its interval is at most +-" +
              number(study.options.points) + " points (--within); cells have " + fixed(people, 0) +
              " people on average (--format csv has the number of each).",
          110) +
      "\n\nno: no controller. pap: the paper's controller.\n1, " + std::to_string(study.options.reaches) +
      ": our controller in a person's first reach, and in reach " + std::to_string(study.options.reaches) +
      ", with its estimates from the earlier ones.\n" +
      wrapped("inf: our controller in the first reach, with the person's true values of " + informed_of(study) + ".",
              110) +
      "\n*: family that was not used to tune our controller. ~: paths and speeds of recorded reaches.\n"
      "+: systematic error of the tracker or of the plate, which no controller can detect within a reach.\n\n" +
      near_table(study);
  if (study.people.size() == 1) page += '\n' + details_table(study.people.front(), study.rows);
  return page + '\n' + flags_table(study.rows, study.options.reaches);
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
              {"misplaced", is_misplaced(of)},
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
