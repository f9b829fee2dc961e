#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "samples/experiment/output/export.h"
#include "samples/experiment/session/session.h"
#include "samples/experiment/session/simulated.h"
#include "tests/samples/process.h"
#include "tests/samples/text.h"

namespace hrt::experiment {

/// Returns a design with two conditions, `repeats` trials of each of two pairs in a block, and no set-up. `change`
/// alters its JSON.
inline Design small_design(unsigned repeats, const std::function<void(nlohmann::json&)>& change = {}) {
  nlohmann::json study = {
      {"title", "small"},
      {"participants", 2},
      {"conditions",
       {{{"name", "secret people"}, {"controller", "people"}}, {{"name", "hidden none"}, {"controller", "none"}}}},
      {"pairs",
       {{{"name", "left"}, {"virtual_deg", 6}, {"real_deg", 0}},
        {{"name", "right"}, {"virtual_deg", -6}, {"real_deg", 0}}}},
      {"repeats", repeats},
      {"practice_trials", 1},
      {"set_up", "none"},
      {"question", "Bent?"},
      {"simulated", {{"invalid_share", 0.2}}}};
  if (change) change(study);
  return parse_design(study.dump(), "study.json");
}

inline std::string run_simulated(const Design& design, const std::filesystem::path& study,
                                 const Disk& disk = Disk({}, false), unsigned participant = 1) {
  SimulatedSubject subject(design, participant, 7);
  return run_session(design, {study, participant, 1}, subject, disk);
}

/// Returns the text of the Refusal that `call` throws; empty if it does not throw.
inline std::string refusal_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return {};
}

}  // namespace hrt::experiment
