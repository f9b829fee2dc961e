// hrt-study coverage: how often the calibration's intervals hold the truth.
#include "samples/study/coverage.h"

#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <thread>

#include <nlohmann/json.hpp>

#include "samples/study/arguments.h"
#include "samples/study/commands/commands.h"
#include "samples/study/output.h"
#include "samples/study/statistics.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

struct Options {
  CoverageSession session{.plate_angles_deg = coverage_angles()};
  std::uint64_t slides_an_angle = 4;
  std::uint64_t people = 50;
  std::uint64_t threads = 2;
  std::string kind = "all";
  std::string angles = "grid";
  std::string format = "text";
  std::string out;
};

struct Row {
  const CoverageKind* kind;
  Coverage coverage;
};

// Each person has a place of their own: no result depends on the order.
Coverage simulate(const CoverageKind& kind, const Options& options) {
  std::vector<CoveragePerson> people(options.people);
  std::atomic<std::uint64_t> next{0};
  const auto work = [&] {
    for (std::uint64_t i = next++; i < people.size(); i = next++)
      people[i] = coverage_person(kind, options.session, static_cast<std::uint32_t>(i));
  };
  {
    std::vector<std::jthread> others;
    for (std::uint64_t i = 1; i < options.threads; ++i) others.emplace_back(work);
    work();
  }
  Coverage coverage;
  for (const CoveragePerson& person : people) coverage.add(person);
  return coverage;
}

double percent(std::uint64_t of, std::uint64_t all) {
  return all > 0 ? 100.0 * static_cast<double>(of) / static_cast<double>(all) : std::nan("");
}

std::string cell(double value, int decimals, std::size_t width) {
  return right(std::isnan(value) ? "-" : fixed(value, decimals), width);
}

// Of those that are known, and Wilson's 95 % interval of it.
std::string covered(const Coverage::Of& of) {
  const double share = percent(of.covered, of.known);
  if (std::isnan(share)) return cell(share, 0, 5) + std::string(9, ' ');
  const PercentInterval range = wilson_interval(share, static_cast<double>(of.known));
  return cell(share, 0, 5) + left(" (" + fixed(range.low, 0) + "-" + fixed(range.high, 0) + ")", 9);
}

double mean(double sum, std::uint64_t of) {
  return of > 0 ? sum / static_cast<double>(of) : std::nan("");
}

std::string text(const Options& options, const std::vector<Row>& rows) {
  std::string page =
      "Calibrations of simulated people; there was no human trial. " + std::to_string(options.people) +
      " people a kind, " + std::to_string(options.session.plate_angles_deg.size() * options.slides_an_angle) +
      (options.session.planned ? " slides, angles as the plan chooses them, "
                               : " slides over -75 to 75 deg, ") +
      number(options.session.duration_s) +
      " s each.\nknown: % of people of whom the calibration says that it knows the value; cover: % of those "
      "whose 95 %\ninterval holds the truth, and the 95 % interval of that share; error: mean of estimate "
      "less truth; width: mean of\nthe interval's.\n\n";
  page += left("", 14);
  for (const char* name : {"w_T", "bias, deg", "habit, deg", "largest gap, deg"})
    page += "  " + left(name, 34);
  page += '\n' + left("", 14);
  for (int i = 0; i < quantities; ++i) page += "  known cover           error  width ";
  page += '\n';
  for (const Row& row : rows) {
    page += left(row.kind->name, 14);
    for (int i = 0; i < quantities; ++i) {
      const Coverage::Of& of = row.coverage.of[static_cast<std::size_t>(i)];
      const int decimals = i == weight ? 4 : 2;
      page += cell(percent(of.known, row.coverage.people), 0, 7) + covered(of) +
              cell(mean(of.error, of.known), decimals, 8) + cell(mean(of.width, of.known), decimals, 7);
    }
    page += '\n';
  }
  page +=
      "\nWithheld for a pattern over the plate's angle, the order of the slides, the path; refused: % of "
      "people\n";
  for (const Row& row : rows) {
    const Coverage& of = row.coverage;
    page += left(row.kind->name, 14) + cell(percent(of.angle, of.people), 0, 6) +
            cell(percent(of.order, of.people), 0, 6) + cell(percent(of.path, of.people), 0, 6) +
            cell(percent(of.refused, of.people), 0, 6) + "   " + row.kind->says + '\n';
  }
  return page;
}

std::string json(const Options& options, const std::vector<Row>& rows) {
  nlohmann::ordered_json page{{"simulation", true},
                              {"people", options.people},
                              {"seed", options.session.seed},
                              {"duration_s", options.session.duration_s},
                              {"planned", options.session.planned}};
  for (const Row& row : rows) {
    nlohmann::ordered_json entry{{"kind", row.kind->name},          {"description", row.kind->says},
                                 {"refused", row.coverage.refused}, {"angle", row.coverage.angle},
                                 {"order", row.coverage.order},     {"path", row.coverage.path}};
    for (std::size_t i = 0; i < quantities; ++i) {
      const Coverage::Of& of = row.coverage.of[i];
      entry["values"][quantity_name[i]] = {{"known", of.known},
                                           {"covered", of.covered},
                                           {"mean_error", mean(of.error, of.known)},
                                           {"mean_width", mean(of.width, of.known)}};
    }
    page["rows"].push_back(entry);
  }
  return page.dump(2) + '\n';
}

void run(Options options) {
  options.session.slides_an_angle = static_cast<int>(options.slides_an_angle);
  options.session.planned = options.angles == "planned";
  const Output out("--out", options.out);
  std::vector<Row> rows;
  Progress progress;
  const auto kinds = coverage_kinds();
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (options.kind == "all" || options.kind == kinds[i].name)
      rows.push_back({&kinds[i], simulate(kinds[i], options)});
    progress.update(i + 1, kinds.size());
  }
  out.write(options.format == "json" ? json(options, rows) : text(options, rows));
}

}  // namespace

void add_coverage(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(
      app, "coverage", "How often the calibration's 95 % intervals hold the truth, over simulated people.",
      R"(People as 'robustness' has them, and three more kinds: slides that slip, people who change over the
session. 50 people of all kinds take some ten minutes.

Examples:
  hrt-study coverage --kind habit-5
  hrt-study coverage --angles planned --trials 2 --people 200)",
      [options] { run(*options); });
  std::vector<std::string> kinds{"all"};
  for (const CoverageKind& kind : coverage_kinds()) kinds.emplace_back(kind.name);
  add_choice(command, "--kind", &options->kind, kinds, "Kind of people.");
  add_integer(command, "--people", &options->people, 1, 100'000, "People of each kind.");
  add_integer(command, "--trials", &options->slides_an_angle, 1, 100, "Slides at each of the 11 angles.");
  add_choice(command, "--angles", &options->angles, {"grid", "planned"},
             "Each angle as often as every other, or chosen one after another by what they show.");
  add_number(command, "--duration", &options->session.duration_s, {0.3, 20.0}, "Time of a slide, s.");
  add_integer(command, "--threads", &options->threads, 1, 64, "Threads.");
  add_seed(command, &options->session.seed);
  add_choice(command, "--format", &options->format, {"text", "json"}, "What to write.");
  add_out(command, &options->out);
}

}  // namespace hrt::study
