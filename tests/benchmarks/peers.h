// Solvers of others beside ours. Each is there if `peers` is given where it is installed.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "tests/core/paper/mpc_reference.h"

namespace hrt {

/// Solves of one problem by as many solvers that are timed as one: a clock may tick as rarely as one takes.
inline constexpr int solves_timed = 16;

/// Microseconds of one solve(i), the least of five times of `solves_timed`, after prepare(i).
double solve_us(const auto& prepare, const auto& solve) {
  double min_us = std::numeric_limits<double>::infinity();
  for (int repetition = 0; repetition < 5; ++repetition) {
    for (int i = 0; i < solves_timed; ++i) prepare(i);
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < solves_timed; ++i) solve(i);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    min_us = std::min(min_us, time.count() / solves_timed);
  }
  return min_us;
}

/// Solves the problem anew, with the factor of its hessian made ahead. Returns solve_us(), and writes the first
/// plate offset in degrees.
using PeerSolve = double (*)(const DenseProblem& problem, double& first_deg);

struct Peer {
  const char* name;
  PeerSolve solve;
};

/// Those compiled in.
std::vector<Peer> peers();

}  // namespace hrt
