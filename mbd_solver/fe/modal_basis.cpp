#include "mbd_solver/fe/modal_basis.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupler/base/errors.h"
#include "mbd_solver/fe/eigen_solver.h"
#include "mbd_solver/fe/fe_check.h"
#include "mbd_solver/fe/fe_partition.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kTwoPi = 6.28318530717958647692;
constexpr double kNoStiffness = 1e-8;     // lambda over elastic scale: less is motion without strain
constexpr double kStaticShift = 1e-4;     // of the elastic scale; see static_shapes
constexpr int kStaticPasses = 5;          // error 1e-4 to the sixth power, with a scale 100 times too high 1e-12
constexpr double kInterfaceMargin = 1.5;  // fixed-interface modes go up to 1.5 times the frequency limit
constexpr int kFirstGuess = 16;           // modes asked for first when only a frequency limit is known

double lambda_of(double frequency) { return std::pow(kTwoPi * frequency, 2); }

// What reduce() works on: stiffness and mass on the active degrees of freedom.
struct Problem {
  const FeModel& model;
  std::vector<int> active;
  Sparse K, M;
  double scale;   // an upper bound of the first elastic lambda [1/s2]
  int available;  // elastic modes there are
  std::string name;
};

// All modes with lambda up to the limit, and some above: asks for twice as many until one passes the limit.
// rank: how many there are.
Modes modes_up_to(const Sparse& K, const Sparse& M, double limit, int rank, double shift) {
  for (int count = std::min(kFirstGuess, rank);; count = std::min(2 * count, rank)) {
    Modes modes = lowest_modes(K, M, count, shift);
    if (count == rank || modes.lambda(count - 1) > limit) return modes;
  }
}

// The first six modes are the rigid-body motions: check_model has shown that they meet no force. No other may
// be without strain; what round-off makes of the six zeros measures how well a zero can be told.
void require_six_rigid(const VectorXd& lambda, const Problem& problem) {
  if (lambda.size() <= 6) return;
  const double zero = std::max(kNoStiffness * problem.scale, 10.0 * lambda.head<6>().cwiseAbs().maxCoeff());
  const Index rigid = (lambda.array() <= zero).count();
  if (rigid > 6)
    throw InputError(problem.name + ": the body can move without strain in " + std::to_string(rigid) +
                     " ways, expected the six rigid-body motions. Look for hinges or loose nodes in the model.");
}

// Elastic free-free modes, columns on the active degrees of freedom.
MatrixXd free_free_shapes(const Problem& problem, std::optional<int> count, double limit) {
  const Modes modes = count ? lowest_modes(problem.K, problem.M, *count + 6, problem.scale)
                            : modes_up_to(problem.K, problem.M, limit, problem.available + 6, problem.scale);
  require_six_rigid(modes.lambda, problem);
  return modes.shapes.rightCols(modes.shapes.cols() - 6);
}

// Degrees of freedom of the interface, as indices into problem.active.
std::vector<int> interface_dofs(const Problem& problem, const BasisOptions& options) {
  check_interface(problem.model, options.interface_nodes, problem.name);
  check_interface(problem.model, options.pinned_nodes, problem.name);
  std::vector<int> held(static_cast<std::size_t>(problem.model.node_count()), 0);  // components per node
  for (int node : options.pinned_nodes) held[static_cast<std::size_t>(node)] = 3;
  for (int node : options.interface_nodes) held[static_cast<std::size_t>(node)] = 6;
  std::vector<int> result;
  for (std::size_t i = 0; i < problem.active.size(); ++i)
    if (problem.active[i] % 6 < held[static_cast<std::size_t>(problem.active[i] / 6)])
      result.push_back(static_cast<int>(i));
  return result;
}

// Static shapes inside, -K_ii^-1 K_ib. K_ii is singular when the interface does not hold the body, but the
// loads K_ib do no work on the free motions, so a solution exists, and any will do: those motions are in the
// basis, too. It is found with a slightly shifted matrix and refined: each pass makes the error smaller by
// shift / (first elastic lambda + shift).
MatrixXd static_shapes(const Sparse& K_ii, const Sparse& M_ii, const Sparse& K_ib, double scale) {
  const Eigen::SimplicialLDLT<Sparse> factor(Sparse(K_ii + kStaticShift * scale * M_ii));
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0.0))
    throw InputError("stiffness is not positive definite with the interface held.");
  const MatrixXd load = -MatrixXd(K_ib);
  MatrixXd x = factor.solve(load);
  for (int pass = 0; pass < kStaticPasses; ++pass) x += factor.solve(load - K_ii * x);
  return x;
}

// [static shapes, fixed-interface modes] on the active degrees of freedom. held: those of the interface.
MatrixXd craig_bampton_basis(const Problem& problem, const std::vector<int>& held, std::optional<int> count,
                             double limit) {
  std::vector<int> all(problem.active.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<int> inside = other_dofs(all, held);
  const int n_held = static_cast<int>(held.size());
  const Index size = problem.K.rows();
  MatrixXd basis = scattered(MatrixXd::Identity(n_held, n_held), held, size);
  if (inside.empty()) return basis;

  const Sparse K_ii = selected(problem.K, inside, inside);
  const Sparse M_ii = selected(problem.M, inside, inside);
  basis += scattered(static_shapes(K_ii, M_ii, selected(problem.K, inside, held), problem.scale), inside, size);
  const int rank = mass_rank(M_ii);
  Modes fixed;
  if (count) {
    const int wanted = *count >= n_held - 6 ? *count - (n_held - 6) : *count;
    fixed = lowest_modes(K_ii, M_ii, std::min(wanted, rank), problem.scale);
  } else {
    fixed = modes_up_to(K_ii, M_ii, kInterfaceMargin * kInterfaceMargin * limit, rank, problem.scale);
  }
  MatrixXd result(size, n_held + fixed.shapes.cols());
  result << basis, scattered(fixed.shapes, inside, size);
  return result;
}

// The eigenproblem within that basis. Elastic shapes only.
MatrixXd craig_bampton_shapes(const Problem& problem, const std::vector<int>& held, std::optional<int> count,
                              double limit) {
  const MatrixXd basis = craig_bampton_basis(problem, held, count, limit);
  const Modes modes =
      all_modes(basis.transpose() * (problem.K * basis), basis.transpose() * (problem.M * basis), problem.scale);
  require_six_rigid(modes.lambda, problem);
  const Index elastic = modes.lambda.size() - 6;
  return basis * modes.shapes.middleCols(6, std::min<Index>(elastic, count ? *count : elastic));
}

void check_options(const BasisOptions& options, const std::string& name) {
  if (options.mode_count && *options.mode_count < 0)
    throw InputError(name + ": modes is " + std::to_string(*options.mode_count) + ", expected 0 or more.");
  if (options.max_frequency && !(*options.max_frequency > 0.0))
    throw InputError(name + ": maximum frequency is " + std::to_string(*options.max_frequency) +
                     " Hz, expected a positive number.");
  if (options.damping_ratio.empty()) throw InputError(name + ": no damping ratio given, expected at least one.");
  for (double zeta : options.damping_ratio)
    if (!(zeta >= 0.0) || !std::isfinite(zeta))
      throw InputError(name + ": damping ratio is " + std::to_string(zeta) + ", expected 0 or more.");
}

}  // namespace

ReducedBody reduce(const FeModel& model, const BasisOptions& options, const std::string& given_name) {
  const std::string name = "body \"" + given_name + "\"";
  check_options(options, name);
  check_model(model, name);
  const std::vector<int> active = active_dofs(model);
  const Sparse M = lumped_mass_matrix(model);
  Problem problem{model,
                  active,
                  selected(model.stiffness, active, active),
                  selected(M, active, active),
                  elastic_scale(model),
                  mass_rank(M) - 6,
                  name};
  if (options.mode_count && *options.mode_count > problem.available)
    throw InputError(name + ": " + std::to_string(*options.mode_count) + " modes asked for, but the model of " +
                     std::to_string(model.node_count()) + " nodes has only " + std::to_string(problem.available) +
                     " elastic degrees of freedom with mass. Ask for fewer modes or refine the mesh.");
  std::optional<int> count = options.mode_count;
  if (!count && !options.max_frequency) count = std::min(kDefaultModeCount, problem.available);
  const double limit = options.max_frequency ? lambda_of(*options.max_frequency) : 0.0;

  std::vector<int> held;
  if (options.kind == BasisKind::kCraigBampton) held = interface_dofs(problem, options);

  MatrixXd shapes(problem.K.rows(), 0);
  try {
    if (!count || *count > 0)
      shapes =
          held.empty() ? free_free_shapes(problem, count, limit) : craig_bampton_shapes(problem, held, count, limit);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  } catch (const NumericalError& error) {
    throw NumericalError(name + ": " + error.what());
  }
  shapes = scattered(shapes, active, M.rows());

  ModalBody raw;
  raw.name = given_name;
  raw.rho0 = model.nodes;
  raw.node_mass = model.node_mass;
  raw.node_inertia = model.node_inertia;
  raw.Phi.resize(3 * model.node_count(), shapes.cols());
  raw.Psi.resize(3 * model.node_count(), shapes.cols());
  for (int j = 0; j < model.node_count(); ++j) {
    raw.Phi.middleRows(3 * j, 3) = shapes.middleRows(6 * j, 3);
    raw.Psi.middleRows(3 * j, 3) = shapes.middleRows(6 * j + 3, 3);
  }
  raw.stress_modes = model.stress * shapes;
  raw.triangles = model.triangles;
  raw.segments = model.segments;
  BasisOptions kept = options;
  kept.mode_count = count;
  return orthonormalised(std::move(raw), shapes.transpose() * (model.stiffness * shapes), kept);
}

VectorXd frequencies(const ModalBody& body) { return body.stiffness.cwiseSqrt() / kTwoPi; }

}  // namespace footfall
