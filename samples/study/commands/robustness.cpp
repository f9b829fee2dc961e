// hrt-study robustness: the controllers on simulated people who are not their model.
#include "samples/study/robustness.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

#include "samples/study/arguments.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/gnuplot.h"
#include "samples/study/figures/robustness_page.h"
#include "samples/study/figures/workshop.h"
#include "samples/study/output.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

namespace fs = std::filesystem;

struct Options {
  RobustnessOptions robustness;
  std::vector<const PeopleFamily*> families;
  std::string format = "text";
  std::string out;
};

using Rows = std::vector<RobustnessRow>;

// Words in lines of at most 110 characters.
std::string wrapped(const std::string& words) {
  std::string page;
  std::string line;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (line.size() + word.size() > 109) {
      page += line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return page + line + '\n';
}

// No more than all are 100 %.
std::string rounded(const Share& share) {
  if (share.of == 0) return "-";
  const double percent = share.percent();
  return fixed(share.hits < share.of ? std::min(percent, 99.0) : percent, 0);
}

std::string near_line(const std::string& name, const Rows& rows, const std::vector<double>& durations_s,
                      const std::function<std::string(const Rows&, Leading)>& words) {
  std::string line = left(name, 15);
  for (const double duration_s : durations_s) {
    const Rows of_duration = at_duration(rows, duration_s);
    for (const Leading leading : leadings)
      line += right(words(of_duration, leading), leading == Leading::none ? 5 : 4);
  }
  return line + '\n';
}

Rows of_family(const Rows& rows, const PeopleFamily* family) {
  Rows found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
               [&](const RobustnessRow& row) { return row.family == family; });
  return found;
}

Rows of_tuning(const Rows& rows, bool tuned) {
  Rows found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
               [&](const RobustnessRow& row) { return row.family->tuned == tuned; });
  return found;
}

std::string near_table(const Options& options, const Rows& rows) {
  const std::vector<double>& durations_s = options.robustness.durations_s;
  std::string page = left("", 15);
  for (const double duration_s : durations_s) page += right(number(duration_s) + " s", 21);
  page += '\n' + left("", 15);
  for (std::size_t i = 0; i < durations_s.size(); ++i) page += "   no pap 1st 5th inf";
  page += '\n';
  for (const PeopleFamily* family : options.families)
    page += near_line(std::string(family->name) + (family->tuned ? "" : " *"), of_family(rows, family),
                      durations_s,
                      [](const Rows& of, Leading leading) { return rounded(of.front().cell(leading).near); });
  const auto mean = [](const Rows& of, Leading leading) {
    const double percent = mean_near_percent(of, leading);
    return std::isnan(percent) ? "-" : fixed(percent, 0);
  };
  if (options.families.size() == 1) return page;
  return page + '\n' + near_line("mean, tuned on", of_tuning(rows, true), durations_s, mean) +
         near_line("mean, apart *", of_tuning(rows, false), durations_s, mean) +
         near_line("mean", rows, durations_s, mean);
}

std::string flags_table(const Rows& rows) {
  constexpr Leading flagging[] = {Leading::paper, Leading::first, Leading::fifth, Leading::informed};
  const auto line = [&](const std::string& name, const Rows& of, Share RobustnessCell::*share) {
    std::string text = left(name, 62);
    for (const Leading leading : flagging) {
      const Share total = pooled(of, leading, share);
      text += right(total.of == 0 ? "-" : fixed(total.percent(), 1), 7);
    }
    return text + '\n';
  };
  std::string page =
      "Flags, % of the reaches above                                     pap    1st    5th    inf\n";
  page += line("those who cannot hold the gap: found unreachable by then", rows,
               &RobustnessCell::unreachable_found) +
          line("  silent miss", rows, &RobustnessCell::silent_cannot_hold) +
          line("those who can: unreachable, falsely", rows, &RobustnessCell::unreachable_false) +
          line("  silent miss: off target and no flag", rows, &RobustnessCell::silent) +
          line("all: model does not fit", rows, &RobustnessCell::misfit) +
          line("  off target", rows, &RobustnessCell::off_target);
  if (const Rows linear = of_family(rows, &people_families().front()); !linear.empty())
    page +=
        line("linear: the 95 % interval of w_T covers the person's", linear, &RobustnessCell::weight_covered);
  return page;
}

std::string text(const Options& options, const Rows& rows) {
  return wrapped("Simulated reaches; there was no human trial. " + condition_words(options.robustness)) +
         '\n' +
         wrapped(
             "Percent of reaches that end within 1.5 deg of the real target's bearing, of people who can "
             "hold "
             "the gap. no: no controller; pap: the paper's; 1st: ours on a person's first reach; 5th: on the "
             "fifth; inf: ours, informed of the person's traits; -: nobody can hold the gap; *: family kept "
             "apart from the search for our controller's numbers.") +
         '\n' + near_table(options, rows) + '\n' + flags_table(rows);
}

// The numbers of a cell as CSV and JSON name them; NaN where there are none.
std::vector<std::pair<const char*, double>> numbers(const RobustnessCell& cell, bool flags) {
  const PercentInterval near = cell.near.interval();
  const auto flag = [&](const Share& share) { return (flags ? share : Share{}).percent(); };
  return {{"can_hold", static_cast<double>(cell.near.of)},
          {"cannot_hold", static_cast<double>(cell.unreachable_found.of)},
          {"near_percent", cell.near.percent()},
          {"near_low_percent", near.low},
          {"near_high_percent", near.high},
          {"miss_median_mm", cell.miss_median_mm},
          {"miss_95_mm", cell.miss_95_mm},
          {"peak_felt_error_median_deg", cell.peak_felt_error_median_deg},
          {"unreachable_found_percent", flag(cell.unreachable_found)},
          {"unreachable_false_percent", flag(cell.unreachable_false)},
          {"misfit_percent", flag(cell.misfit)},
          {"off_target_percent", flag(cell.off_target)},
          {"silent_miss_percent", flag(cell.silent)},
          {"silent_miss_cannot_hold_percent", flag(cell.silent_cannot_hold)},
          {"weight_covered_percent", flag(cell.weight_covered)}};
}

std::string csv(const Options& options, const Rows& rows) {
  std::string page = "family,tuned,duration_s,controller,people,seed";
  for (const auto& [name, value] : numbers(rows.front().cells.front(), true)) page += std::string(",") + name;
  page += ",description\n";
  for (const RobustnessRow& row : rows)
    for (const Leading leading : leadings) {
      page += std::string(row.family->name) + (row.family->tuned ? ",1," : ",0,") + number(row.duration_s) +
              ',' + leading_name(leading) + ',' + std::to_string(options.robustness.people) + ',' +
              std::to_string(options.robustness.seed);
      for (const auto& [name, value] : numbers(row.cell(leading), leading != Leading::none))
        page += ',' + (std::isnan(value) ? "" : number(value));
      page += std::string(",\"") + row.family->says + "\"\n";
    }
  return page;
}

std::string json(const Options& options, const Rows& rows) {
  nlohmann::ordered_json page{{"simulation", true},
                              {"people", options.robustness.people},
                              {"seed", options.robustness.seed},
                              {"condition", condition_words(options.robustness)}};
  for (const RobustnessRow& row : rows) {
    nlohmann::ordered_json entry{{"family", row.family->name},
                                 {"description", row.family->says},
                                 {"tuned", row.family->tuned},
                                 {"duration_s", row.duration_s}};
    for (const Leading leading : leadings)
      for (const auto& [name, value] : numbers(row.cell(leading), leading != Leading::none))
        entry["controllers"][leading_name(leading)][name] = value;
    page["rows"].push_back(entry);
  }
  return page.dump(2) + '\n';
}

std::string formatted(const Options& options, const Rows& rows) {
  return options.format == "csv"    ? csv(options, rows)
         : options.format == "json" ? json(options, rows)
                                    : text(options, rows);
}

// draw_person() takes durations to the millisecond, and files are named after them.
void check_durations(const Options& options) {
  std::set<long long> seen_ms;
  for (const double duration_s : options.robustness.durations_s)
    if (!seen_ms.insert(std::llround(1e3 * duration_s)).second)
      throw UsageError(not_allowed("--durations", number(duration_s), "given once, to the millisecond"));
}

Rows simulate(const Options& options) {
  Progress progress;
  return simulate_robustness(options.families, options.robustness,
                             [&](std::uint64_t done, std::uint64_t total) { progress.update(done, total); });
}

// Pictures, page and numbers, all or none.
void make_folder(const Options& options) {
  const Workshop workshop("--out", options.out);
  run_gnuplot("", workshop.folder());  // missing: said before the work, not after it
  const Rows rows = simulate(options);
  const std::vector<Figure> figures = robustness_figures(options.robustness, rows);
  std::string script;
  for (const Figure& figure : figures) script += drawing(figure, "svg") + drawing(figure, "png");
  run_gnuplot(script, workshop.folder());
  std::vector<std::string> drawings;
  for (const Figure& figure : figures) drawings.push_back(workshop.read(figure.name + ".svg"));

  const std::string page = "robustness.html";
  replace_file(workshop.folder() / "robustness.csv", csv(options, rows));
  replace_file(workshop.folder() / "robustness.json", json(options, rows));
  replace_file(workshop.folder() / page, robustness_page(options.robustness, rows, figures, drawings));
  for (const Figure& figure : figures)
    for (const char* ending : {".svg", ".png"}) workshop.publish(figure.name + ending);
  for (const char* name : {"robustness.csv", "robustness.json", "robustness.html"}) workshop.publish(name);
  Output("--out", "")
      .write(formatted(options, rows) +
             (options.format == "text" ? "\nWrote " + std::to_string(2 * figures.size()) +
                                             " pictures, robustness.csv, robustness.json and the page " +
                                             (fs::path(options.out) / page).string() + "\n"
                                       : ""));
}

void run(const Options& options) {
  check_durations(options);
  if (!options.out.empty()) return make_folder(options);
  const Output output("--out", "");
  output.write(formatted(options, simulate(options)));
}

std::string family_list() {
  std::string list;
  for (const PeopleFamily& family : people_families())
    list += "  " + left(std::string(family.name) + (family.tuned ? "" : " *"), 16) + family.says + '\n';
  return list;
}

bool take_families(const std::string& names, std::vector<const PeopleFamily*>& families) {
  std::vector<const PeopleFamily*> taken;
  for (const std::string_view name : split(names, ',')) {
    const PeopleFamily* family = people_family(std::string(name).c_str());
    if (!family || std::find(taken.begin(), taken.end(), family) != taken.end()) return false;
    taken.push_back(family);
  }
  families = taken;
  return true;
}

}  // namespace

void add_robustness(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  for (const PeopleFamily& family : people_families()) options->families.push_back(&family);
  CLI::App& command = add_command(
      app, "robustness", "The controllers on simulated people who differ from what they assume.",
      R"(Answers: of the people of a family, how many arrive at the real target, how far off are the others,
how large an error do they feel, and does the controller flag a reach that fails? Each person reaches
without a controller; with the paper's; five times with ours, which starts without knowledge of the
person and carries what it learns; and once with ours informed of the person's traits, which shows
what is lost by not knowing them. All is simulation; there was no human trial.

The text is the share of reaches that end within 1.5 deg, and the flags. CSV and JSON have a line for
each family, duration and controller: that share with its 95 % interval (Wilson), the miss across
the real direction, the largest felt error, unreachable found (in this reach or one before) and
false, model does not fit, off target, silent misses (off target and no flag), and how often the
95 % interval of w_T covers the person's, which is 95 if the interval is honest. People who cannot
hold the gap, whatever the plate does, are counted apart. A field without a value is empty (CSV) or
null (JSON).

--out makes a folder with robustness.csv, robustness.json, a picture for each duration (.svg and
.png) and robustness.html, which contains everything. Needs gnuplot.

Examples:
  hrt-study robustness
  hrt-study robustness --family linear,place --durations 1.5 --people 1000
  hrt-study robustness --people 1000 --format csv > robustness.csv
  hrt-study robustness --out robustness

Families (*: kept apart from the search for our controller's numbers):
)" + family_list(),
      [options] { run(*options); });
  RobustnessOptions& robustness = options->robustness;
  add_integer(command, "--people", &robustness.people, 1, 100'000,
              "People of each family at each duration; 100 take a minute of one processor.");
  add_numbers(command, "--durations", &robustness.durations_s, {0.3, 20.0},
              "Durations of a reach without its pauses, s.");
  add_value(command, "--family", "different families, separated by commas (--help shows them)", "all",
            "People to simulate.",
            [options](const std::string& names) { return take_families(names, options->families); });
  add_seed(command, &robustness.seed);
  add_threads(command, &robustness.threads);
  add_choice(command, "--format", &options->format, {"text", "csv", "json"},
             "What to write to standard output.");
  add_path(command, "--out", &options->out, "a folder that can be written",
           "Folder for numbers, pictures and page; made if missing.");
}

}  // namespace hrt::study
