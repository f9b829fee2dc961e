// Solvers of others beside ours. Each is compiled from a checkout that `peers` is given, else not there.
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
