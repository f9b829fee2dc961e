// Gains of a participant whose filter has converged.
#pragma once

#include "core/paper/participant.h"

namespace hrt {

constexpr std::array<double, max_horizon> steady_gains() {
  std::array<double, max_horizon> gains{};
  gains.fill(0.85);
  return gains;
}
inline constexpr auto gains = steady_gains();

}  // namespace hrt
