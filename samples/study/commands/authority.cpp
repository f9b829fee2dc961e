// hrt-study authority: the gaps that the plate can sustain, over the tactile weight.
#include "core/authority.h"

#include <nlohmann/json.hpp>

#include "samples/study/arguments.h"
#include "samples/study/commands/commands.h"
#include "samples/study/output.h"

namespace hrt::study {
namespace {

struct Options {
  std::vector<double> tactile_weights{0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45};
  std::vector<double> gaps_deg{2, 4, 6, 8, 10, 12, 15, 20, 30, 45};
  double plate_bound_deg = 84.5;
  std::string format = "text";
  std::string out;
};

Authority at(const Options& options, double tactile_weight, double gap_deg) {
  return steering_authority(-gap_deg, 0.0, tactile_weight, options.plate_bound_deg);
}

std::string text(const Options& options) {
  std::string page =
      "Where the plate must stand, in deg from the virtual direction, to hold the finger on a real target "
      "that\n"
      "lies the gap away from it; -: no orientation within " +
      number(options.plate_bound_deg) + " deg holds it. From the model; there was no human trial.\n\n";
  page += "tactile   largest   gap, deg\n weight  gap, deg ";
  for (const double gap_deg : options.gaps_deg) page += right(number(gap_deg), 7);
  page += '\n';
  for (const double tactile_weight : options.tactile_weights) {
    const double largest_deg = largest_gap_deg(tactile_weight, options.plate_bound_deg);
    page += right(number(tactile_weight), 7) + right(fixed(largest_deg, 2), 10) + ' ';
    for (const double gap_deg : options.gaps_deg) {
      const Authority authority = at(options, tactile_weight, gap_deg);
      page += right(authority.reachable ? fixed(authority.plate_orientation_deg, 1) : "-", 7);
    }
    page += '\n';
  }
  return page;
}

std::string csv(const Options& options) {
  std::string page =
      "tactile_weight,plate_bound_deg,largest_gap_deg,gap_deg,reachable,margin_deg,plate_offset_deg,"
      "settling_offset_deg\n";
  for (const double tactile_weight : options.tactile_weights)
    for (const double gap_deg : options.gaps_deg) {
      const Authority authority = at(options, tactile_weight, gap_deg);
      page += number(tactile_weight) + ',' + number(options.plate_bound_deg) + ',' +
              number(authority.largest_gap_deg) + ',' + number(gap_deg) + ',' +
              (authority.reachable ? "1," : "0,") + number(authority.margin_deg) + ',' +
              number(authority.plate_orientation_deg) + ',' + number(authority.settling_direction_deg) + '\n';
    }
  return page;
}

std::string json(const Options& options) {
  nlohmann::ordered_json page{{"simulation", true}, {"plate_bound_deg", options.plate_bound_deg}};
  for (const double tactile_weight : options.tactile_weights)
    for (const double gap_deg : options.gaps_deg) {
      const Authority authority = at(options, tactile_weight, gap_deg);
      page["map"].push_back({{"tactile_weight", tactile_weight},
                             {"largest_gap_deg", authority.largest_gap_deg},
                             {"gap_deg", gap_deg},
                             {"reachable", authority.reachable},
                             {"margin_deg", authority.margin_deg},
                             {"plate_offset_deg", authority.plate_orientation_deg},
                             {"settling_offset_deg", authority.settling_direction_deg}});
    }
  return page.dump(2) + '\n';
}

}  // namespace

void add_authority(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(
      app, "authority", "The gaps between real and virtual target that can be held, over the tactile weight.",
      "Offsets are from the virtual direction; the real one lies at minus the gap.\n"
      "\n"
      "Examples:\n"
      "  hrt-study authority\n"
      "  hrt-study authority --tactile-weight 0.05:0.45:9 --gap 10 --format csv --out map.csv",
      [options] {
        const Output output("--out", options->out);
        output.write(options->format == "csv"    ? csv(*options)
                     : options->format == "json" ? json(*options)
                                                 : text(*options));
      });
  add_numbers(command, "--tactile-weight", &options->tactile_weights, tactile_weight_range,
              "Shares of touch in the felt direction (w_T).");
  add_numbers(command, "--gap", &options->gaps_deg, gap_range, "Gaps: virtual minus real direction, deg.");
  add_number(command, "--plate-bound", &options->plate_bound_deg, plate_bound_range,
             "How far the plate turns from the virtual direction, deg.");
  add_choice(command, "--format", &options->format, {"text", "csv", "json"}, "What to write.");
  add_path(command, "--out", &options->out, "a file in a folder that can be written",
           "Write there instead of to standard output.");
}

}  // namespace hrt::study
