// hrt-study authority: the gaps that the plate can sustain, over the tactile weight.
#include "core/paper/authority.h"
#include "core/person/person_authority.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

// Studies with people have covered ridges within this of the motion.
constexpr double human_data_deg = 60.0;

struct Options {
  std::vector<double> tactile_weights{0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45};
  std::vector<double> gaps_deg{2, 4, 6, 8, 10, 12, 15, 20, 30, 45};
  double motion_bound_deg = 75.0;
  double plate_bound_deg = 84.5;
  std::string format = "text";
  std::string out;
};

// One weight and one gap, with the virtual direction at 0.
struct Point {
  double tactile_weight;
  Authority motion;  // plate bounded about the motion, linear illusion
  Authority paper;   // plate bounded about the virtual direction

  bool beyond_human_data() const {
    return std::abs(motion.plate_orientation_deg - motion.settling_direction_deg) > human_data_deg + 1e-9;
  }
};

Point at(const Options& options, double tactile_weight, double gap_deg) {
  return {tactile_weight,
          authority_about_motion(-gap_deg, 0.0, {.weight = tactile_weight, .curve = 0.0},
                                 options.motion_bound_deg),
          steering_authority(-gap_deg, 0.0, tactile_weight, options.plate_bound_deg)};
}

std::string text(const Options& options) {
  std::string page =
      "Where the plate must stand, in deg from the virtual direction, to hold the finger on a real target "
      "that\n"
      "lies the gap away from it. -: no orientation within " +
      number(options.motion_bound_deg) + " deg of the motion holds it. *: the ridges stand more\nthan " +
      number(human_data_deg) +
      " deg from the motion, the largest angle of human data. From the model, for a linear illusion;\n"
      "there was no human trial of the controller.\n\n"
      "The largest gap, deg, with the plate within " +
      number(options.motion_bound_deg) + " deg of the motion (ours), and within " +
      number(options.plate_bound_deg) +
      " deg of the virtual\ndirection (the paper's).\n\n"
      "tactile   largest gap   gap, deg\n weight   ours  paper's";
  for (const double gap_deg : options.gaps_deg) page += right(number(gap_deg), 7);
  page += '\n';
  for (const double tactile_weight : options.tactile_weights) {
    const Point any = at(options, tactile_weight, 0.0);
    page += right(number(tactile_weight), 7) + right(fixed(any.motion.max_gap_deg, 2), 7) +
            right(fixed(any.paper.max_gap_deg, 2), 9);
    for (const double gap_deg : options.gaps_deg) {
      const Point point = at(options, tactile_weight, gap_deg);
      page += right(point.motion.reachable ? (point.beyond_human_data() ? "*" : "") +
                                                 fixed(point.motion.plate_orientation_deg, 1)
                                           : "-",
                    7);
    }
    page += '\n';
  }
  return page;
}

std::string csv(const Options& options) {
  std::string page =
      "tactile_weight,gap_deg,motion_bound_deg,max_gap_deg,reachable,margin_deg,plate_offset_deg,"
      "settling_offset_deg,beyond_human_data,paper_plate_bound_deg,paper_max_gap_deg,paper_reachable,"
      "paper_margin_deg,paper_plate_offset_deg,paper_settling_offset_deg\n";
  const auto fields = [](double bound_deg, const Authority& authority) {
    return number(bound_deg) + ',' + number(authority.max_gap_deg) + (authority.reachable ? ",1," : ",0,") +
           number(authority.margin_deg) + ',' + number(authority.plate_orientation_deg) + ',' +
           number(authority.settling_direction_deg);
  };
  for (const double tactile_weight : options.tactile_weights)
    for (const double gap_deg : options.gaps_deg) {
      const Point point = at(options, tactile_weight, gap_deg);
      page += number(tactile_weight) + ',' + number(gap_deg) + ',' +
              fields(options.motion_bound_deg, point.motion) + (point.beyond_human_data() ? ",1," : ",0,") +
              fields(options.plate_bound_deg, point.paper) + '\n';
    }
  return page;
}

std::string json(const Options& options) {
  nlohmann::ordered_json page{{"simulation", true},
                              {"motion_bound_deg", options.motion_bound_deg},
                              {"human_data_deg", human_data_deg},
                              {"paper_plate_bound_deg", options.plate_bound_deg}};
  const auto put = [](nlohmann::ordered_json& entry, const std::string& prefix, const Authority& authority) {
    entry[prefix + "max_gap_deg"] = authority.max_gap_deg;
    entry[prefix + "reachable"] = authority.reachable;
    entry[prefix + "margin_deg"] = authority.margin_deg;
    entry[prefix + "plate_offset_deg"] = authority.plate_orientation_deg;
    entry[prefix + "settling_offset_deg"] = authority.settling_direction_deg;
  };
  for (const double tactile_weight : options.tactile_weights)
    for (const double gap_deg : options.gaps_deg) {
      const Point point = at(options, tactile_weight, gap_deg);
      nlohmann::ordered_json entry{{"tactile_weight", tactile_weight}, {"gap_deg", gap_deg}};
      put(entry, "", point.motion);
      entry["beyond_human_data"] = point.beyond_human_data();
      put(entry, "paper_", point.paper);
      page["map"].push_back(entry);
    }
  return page.dump(2) + '\n';
}

}  // namespace

void add_authority(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(
      app, "authority", "The gaps between real and virtual target that can be held, over the tactile weight.",
      R"(The largest gap is the largest shift of the felt direction: w_T times the bound for a linear
illusion, with the plate bounded about the motion, as our controller keeps it. The paper bounds it
about the virtual direction (fields paper_...). Studies with people cover ridges within 60 deg of the
motion: beyond_human_data marks what needs more. Offsets are from the virtual direction; the real
one lies at minus the gap. All is from the model; there was no human trial of the controller.

Examples:
  hrt-study authority
  hrt-study authority --tactile-weight 0.05:0.45:9 --gap 10 --format csv --out map.csv)",
      [options] {
        const Output output("--out", options->out);
        output.write(options->format == "csv"    ? csv(*options)
                     : options->format == "json" ? json(*options)
                                                 : text(*options));
      });
  add_numbers(command, "--tactile-weight", &options->tactile_weights, tactile_weight_range,
              "Shares of touch in the felt direction (w_T).");
  add_numbers(command, "--gap", &options->gaps_deg, gap_range, "Gaps: virtual minus real direction, deg.");
  add_number(command, "--motion-bound", &options->motion_bound_deg, {0.0, 90.0, false, false},
             "How far the ridges' normal turns from the motion, deg.");
  add_number(command, "--plate-bound", &options->plate_bound_deg, plate_bound_range,
             "How far the paper's plate turns from the virtual direction, deg.");
  add_choice(command, "--format", &options->format, {"text", "csv", "json"}, "What to write.");
  add_out(command, &options->out);
}

}  // namespace hrt::study
