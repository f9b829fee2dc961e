// Reaches seen from above, as a picture.
#pragma once

#include <string>
#include <vector>

#include "samples/reach/reach.h"

namespace hrt::reach {

struct PlottedReach {
  TargetPair pair;
  ReachResult result;
};

/// One panel a reach: the plate, its ridges at a few moments, the finger's true path, the path that its
/// owner feels, and both targets. `note` stands below. At most `most_plotted` reaches are drawn; the note
/// then says so.
std::string svg_of(const std::vector<PlottedReach>& reaches, const TargetSet& targets,
                   const std::string& note);

inline constexpr std::size_t most_plotted = 12;

}  // namespace hrt::reach
