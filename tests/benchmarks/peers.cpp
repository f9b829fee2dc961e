#include "tests/benchmarks/peers.h"

#include <array>
#include <vector>

#ifdef HRT_EIQUADPROG
#include <eiquadprog/eiquadprog-fast.hpp>
#include <eiquadprog/eiquadprog-rt.hpp>
#endif
#ifdef HRT_DAQP
#include <api.h>
#include <utils.h>
#endif

namespace hrt {
namespace {

#ifdef HRT_EIQUADPROG
using eiquadprog::solvers::EiquadprogFast;
using eiquadprog::solvers::RtEiquadprog;

// Where the factor is given, it takes the gradient with the other sign.
template <class Solver, int n, int bounds>
double eiquadprog_us(const DenseProblem& problem, double& first_deg) {
  const Eigen::Index size = problem.gradient.size();
  const Eigen::Matrix<double, n, n> hessian = problem.hessian.cast<double>();
  const Eigen::Matrix<double, n, 1> gradient = -problem.gradient.cast<double>();
  const Eigen::Matrix<double, bounds, n> rows = -problem.rows.cast<double>();
  const Eigen::Matrix<double, bounds, 1> limits = problem.limits.cast<double>();
  const Eigen::Matrix<double, n, n> factor =
      problem.hessian.llt().matrixU().solve(LongMatrix::Identity(size, size)).template cast<double>();
  const Eigen::Matrix<double, n == Eigen::Dynamic ? n : 0, n> no_rows(0, size);
  Eigen::Matrix<double, n, 1> plate(size);
  std::array<Solver, solves_timed> solvers;
  for (Solver& solver : solvers) {
    if constexpr (n == Eigen::Dynamic) solver.reset(gradient.size(), 0, limits.size());
    solver.is_inverse_provided_ = true;
  }
  const double us =
      solve_us([&](int i) { solvers[i].m_J = factor; },
               [&](int i) { solvers[i].solve_quadprog(hessian, gradient, no_rows, {}, rows, limits, plate); });
  first_deg = plate[0];
  return us;
}

// Its solver for sizes that are known to the compiler at the paper's horizon.
double eiquadprog_us(const DenseProblem& problem, double& first_deg) {
  if (problem.limits.size() == 6) return eiquadprog_us<RtEiquadprog<3, 0, 6>, 3, 6>(problem, first_deg);
  if (problem.limits.size() == 12) return eiquadprog_us<RtEiquadprog<3, 0, 12>, 3, 12>(problem, first_deg);
  return eiquadprog_us<EiquadprogFast, Eigen::Dynamic, Eigen::Dynamic>(problem, first_deg);
}
#endif

#ifdef HRT_DAQP
double daqp_us(const DenseProblem& problem, double& first_deg) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const int n = static_cast<int>(problem.gradient.size());
  const int links = static_cast<int>(problem.limits.size()) / 2 - n;
  Rows hessian = problem.hessian.cast<double>();
  Rows rows = problem.rows.bottomRows(2 * links).topRows(links).cast<double>();
  Eigen::VectorXd gradient = problem.gradient.cast<double>();
  Eigen::VectorXd upper(n + links), lower(n + links);
  const Eigen::VectorXd limits = problem.limits.cast<double>();
  upper << limits.head(n), limits.segment(2 * n, links);
  lower << -limits.segment(n, n), -limits.tail(links);
  std::vector<int> sense(static_cast<std::size_t>(n + links));
  DAQPProblem qp{};
  qp.n = n, qp.m = n + links, qp.ms = n;
  qp.H = hessian.data(), qp.f = gradient.data(), qp.A = rows.data();
  qp.bupper = upper.data(), qp.blower = lower.data(), qp.sense = sense.data();
  std::array<DAQPWorkspace, solves_timed> workspaces{};
  for (DAQPWorkspace& work : workspaces) setup_daqp(&qp, &work, nullptr);
  std::vector<double> plate(static_cast<std::size_t>(n)), multipliers(static_cast<std::size_t>(n + links));
  DAQPResult result{};
  result.x = plate.data(), result.lam = multipliers.data();
  const double us =
      solve_us([&](int i) { daqp_deactivate_constraints(&workspaces[i]), reset_daqp_workspace(&workspaces[i]); },
               [&](int i) {
                 daqp_update_ldp(DAQP_UPDATE_v | DAQP_UPDATE_d, &workspaces[i], &qp);
                 daqp_solve(&result, &workspaces[i]);
               });
  first_deg = plate[0];
  for (DAQPWorkspace& work : workspaces) free_daqp_workspace(&work), free_daqp_ldp(&work);
  return us;
}
#endif

}  // namespace

std::vector<Peer> peers() {
  return {
#ifdef HRT_EIQUADPROG
      {"eiquadprog", &eiquadprog_us},
#endif
#ifdef HRT_DAQP
      {"DAQP", &daqp_us},
#endif
  };
}

}  // namespace hrt
