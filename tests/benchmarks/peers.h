// Solvers of others beside ours. Each is there if `peers` is given where it is installed.
#pragma once

#include <vector>

#include "tests/core/paper/mpc_reference.h"

namespace hrt {

/// Solves the problem anew, with the factor of its hessian made ahead. Returns the microseconds that it took,
/// the least of five, and writes the first plate offset in degrees.
using PeerSolve = double (*)(const DenseProblem& problem, double& first_deg);

struct Peer {
  const char* name;
  PeerSolve solve;
};

/// Those compiled in.
std::vector<Peer> peers();

}  // namespace hrt
