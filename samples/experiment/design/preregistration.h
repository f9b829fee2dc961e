// The text of a registered report, from a design.
#pragma once

#include <string>

#include "samples/experiment/design/design.h"

namespace hrt::experiment {

/// Markdown: every field of the design with what it means, defaults too; and, in brackets, what its authors
/// have to say.
std::string preregistration_text(const Design& design);

}  // namespace hrt::experiment
