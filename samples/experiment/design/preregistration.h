// Texts made from a design: of a registered report, and the experimenters' protocol.
#pragma once

#include <string>

#include "samples/experiment/design/design.h"

namespace hrt::experiment {

/// Markdown: every field of the design with what it means, defaults too; and, in brackets, what its authors
/// have to say.
std::string preregistration_text(const Design& design);

/// PROTOCOL.md with the design's numbers in it.
std::string protocol_text(const Design& design);

}  // namespace hrt::experiment
