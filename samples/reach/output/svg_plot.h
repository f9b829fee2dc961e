// Reaches seen from above, as a picture.
#pragma once

#include <string>
#include <vector>

#include "samples/reach/run/reach.h"

namespace hrt::reach {

struct PlottedReach {
  TargetPair pair;
  ReachResult result;
};

/// One panel a reach: plate, ridges under the finger at five moments, true path, felt path, both targets.
/// `note` stands below. At most `max_plotted` reaches are drawn; the note then says so.
std::string svg_of(const std::vector<PlottedReach>& reaches, const TargetSet& targets,
                   const std::string& note);

inline constexpr std::size_t max_plotted = 12;

}  // namespace hrt::reach
