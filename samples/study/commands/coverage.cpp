// hrt-study coverage: how often the calibration's intervals hold the truth.
#include "samples/study/people/coverage.h"

#include <memory>
#include <string>

#include "samples/app/text/text.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/numbers/parallel.h"
#include "samples/study/numbers/results.h"
#include "samples/study/numbers/statistics.h"

namespace hrt::study {
namespace {

struct CoverageOptions {
  CoverageSession session;
  std::uint64_t people = 50;
  std::uint64_t threads = 2;
  std::string kind = "all";
  Writing writing;
};

struct KindRow {
  const CoverageKind* kind;
  Coverage coverage;
};

struct CoverageStudy {
  CoverageOptions options;
  std::vector<KindRow> rows;
};

Coverage simulate(const CoverageKind& kind, const CoverageOptions& options) {
  std::vector<CoveragePerson> people(options.people);
  for_each_part(people.size(), options.threads, [&](std::uint64_t i) {
    people[i] = coverage_person(kind, options.session, static_cast<std::uint32_t>(i));
  });
  Coverage coverage;
  for (const CoveragePerson& person : people) coverage.add(person);
  return coverage;
}

std::string text(const CoverageStudy& study) {
  const CoverageOptions& options = study.options;
  std::string page =
      "Calibrations of simulated people; there was no human trial. " + std::to_string(options.people) +
      " people a kind, " + std::to_string(options.session.slides) + " slides at the angles of a set-up, " +
      number(options.session.duration_s) +
      " s each.\nknown: % of people of whom the calibration says that it knows the value; cover: % of those "
      "whose 95 %\ninterval holds the truth, and the 95 % interval of that share; error: mean of estimate "
      "less truth; width: mean of\nthe interval's.\n\n";
  page += left("", 14);
  for (const char* name : {"w_T", "bias, deg", "habit, deg", "largest gap, deg"}) page += "  " + left(name, 34);
  page += '\n' + left("", 14);
  for (int i = 0; i < quantities; ++i) page += "  known cover           error  width ";
  page += '\n';
  for (const KindRow& row : study.rows) {
    page += left(row.kind->name, 14);
    for (int i = 0; i < quantities; ++i) {
      const Tally& tally = row.coverage.of[static_cast<std::size_t>(i)];
      const int decimals = i == weight ? 4 : 2;
      page += cell(tally.known.percent(), 0, 7) + tally.covered_text(5) + cell(tally.mean_error(), decimals, 8) +
              cell(tally.mean_width(), decimals, 7);
    }
    page += '\n';
  }
  page +=
      "\nWithheld for a pattern over the plate's angle, the order of the slides, the path; refused: % of "
      "people\n";
  for (const KindRow& row : study.rows) {
    const Coverage& of = row.coverage;
    page += left(row.kind->name, 14) + cell(of.angle.percent(), 0, 6) + cell(of.order.percent(), 0, 6) +
            cell(of.path.percent(), 0, 6) + cell(of.refused.percent(), 0, 6) + "   " + row.kind->says + '\n';
  }
  return page;
}

Results results(const CoverageStudy& study) {
  Results found{.about = {{"simulation", true},
                          {"people", study.options.people},
                          {"seed", study.options.session.seed},
                          {"duration_s", study.options.session.duration_s},
                          {"slides", study.options.session.slides}},
                .rows = {}};
  for (const KindRow& kind : study.rows) {
    const Coverage& coverage = kind.coverage;
    Row row{{"kind", kind.kind->name},      {"description", kind.kind->says}, {"refused", coverage.refused.hits},
            {"angle", coverage.angle.hits}, {"order", coverage.order.hits},   {"path", coverage.path.hits}};
    for (std::size_t i = 0; i < quantities; ++i) {
      const Tally& tally = coverage.of[i];
      const std::string name = quantity_name[i];
      row[name + "_known"] = tally.known.hits;
      row[name + "_covered"] = tally.covered.hits;
      row[name + "_mean_error"] = tally.mean_error();
      row[name + "_mean_width"] = tally.mean_width();
    }
    found.rows.push_back(row);
  }
  return found;
}

CoverageStudy simulate(const CoverageOptions& options) {
  CoverageStudy study{.options = options, .rows = {}};
  for (const CoverageKind& kind : coverage_kinds())
    if (options.kind == "all" || options.kind == kind.name) study.rows.push_back({&kind, {}});
  Progress progress;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    study.rows[i].coverage = simulate(*study.rows[i].kind, options);
    progress.update(i + 1, study.rows.size());
  }
  return study;
}

}  // namespace

void add_coverage(CLI::App& app) {
  const auto options = std::make_shared<CoverageOptions>();
  CLI::App& command = add_command(
      app, "coverage", "How often the calibration's 95 % intervals hold the truth, over simulated people.",
      R"(People as 'robustness' has them, and others: strong and weak illusions, one with a peak, slides that slip,
people who change over the session. 50 people of all kinds take some three minutes.

Examples:
  hrt-study coverage --kind habit-5
  hrt-study coverage --slides 16 --people 200)",
      [options] { options->writing.write([options] { return simulate(*options); }, results, text); });
  std::vector<std::string> kinds{"all"};
  for (const CoverageKind& kind : coverage_kinds()) kinds.emplace_back(kind.name);
  add_choice(command, "--kind", options->kind, kinds, "Kind of people.");
  add_integer(command, "--people", options->people, 1, 100'000, "People of each kind.");
  add_integer(command, "--slides", options->session.slides, 16, 200, "Slides of each person.");
  add_number(command, "--duration", options->session.duration_s, {0.3, 20.0}, "Time of a slide, s.");
  add_threads(command, options->threads);
  add_seed(command, options->session.seed);
  options->writing.add_options(command);
}

}  // namespace hrt::study
