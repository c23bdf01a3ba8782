// Free-free or Craig-Bampton shapes on the active degrees of freedom; then every basis, also one from a file, is freed from
// rigid motion, made mass-orthonormal and diagonalised.

#include "mbd_solver/fe/modal_basis.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <numeric>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/codes.h"
#include "mbd_solver/fe/eigen_solver.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/spider.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/mass_properties.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kShift = 1e-4;          // of the elastic scale; see balanced_solution
constexpr int kPasses = 5;               // error 1e-4 to the sixth power, with a scale 100 times too high 1e-12
constexpr double kSameDirection = 1e-9;  // smaller singular values relative to the largest are round-off
constexpr double kOnlyRigid = 1e-6;      // a smaller rest of a balanced unit load counts as zero

// A free body with its interface, on the same degrees of freedom.
struct HeldBody {
  const Sparse &K, &M;
  const MatrixXd& rigid;         // n x 6: its rigid-body motions, translations first
  const std::vector<int>& held;  // degrees of freedom of the interface; not empty
  double scale;                  // about the first elastic lambda [1/s2]
};

// Rows and columns of one size, so that metres and radians can be compared.
MatrixXd scaled(MatrixXd x) {
  for (Index j = 0; j < x.cols(); ++j)
    if (const double size = x.col(j).norm(); size > 0.0) x.col(j) /= size;
  return x;
}

// y with A y = 0, orthonormal columns.
MatrixXd null_space(const MatrixXd& A) {
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeFullV);
  const VectorXd& sigma = svd.singularValues();
  const Index rank = (sigma.array() > kSameDirection * sigma(0)).count();
  return svd.matrixV().rightCols(A.cols() - rank);
}

// x with K x = load, up to motions without strain. K may be singular if load does no work on these motions. M: mass, scale:
// about the first elastic lambda [1/s2]; they do not influence the solution. Throws InputError if K has negative directions.
// A slightly shifted matrix and refinement find it: each pass reduces the error by the factor
// shift / (first elastic lambda + shift).
MatrixXd balanced_solution(const Sparse& K, const Sparse& M, const MatrixXd& load, double scale) {
  const Eigen::SimplicialLDLT<Sparse> factor(Sparse(K + kShift * scale * M));
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0.0))
    throw InputError(code::kStiffness, "stiffness is not positive definite with the interface held.");
  MatrixXd x = factor.solve(load);
  for (int pass = 0; pass < kPasses; ++pass) x += factor.solve(load - K * x);
  return x;
}

// Columns: the unit loads at the interface, each balanced by others there: (I - Q Q^T) e_i, Q an orthonormal basis of
// the rigid-body motions of the interface.
MatrixXd interface_loads(const HeldBody& body) {
  const MatrixXd R_b = gathered(body.rigid, body.held);
  const Eigen::JacobiSVD<MatrixXd> svd(scaled(R_b), Eigen::ComputeThinU);
  const VectorXd& sigma = svd.singularValues();
  const MatrixXd Q = svd.matrixU().leftCols((sigma.array() > kSameDirection * sigma(0)).count());
  const Index n = R_b.rows();
  const MatrixXd balanced = MatrixXd::Identity(n, n) - Q * Q.transpose();
  std::vector<int> some;
  for (Index i = 0; i < n; ++i)
    if (balanced.col(i).norm() > kOnlyRigid) some.push_back(static_cast<int>(i));
  return scattered(gathered(balanced, some).transpose(), body.held, body.K.rows());
}

// Number of independent rigid-body motions that the interface holds, 0 to 6.
int held_motions(const HeldBody& body) {
  return 6 - static_cast<int>(null_space(gathered(scaled(body.rigid), body.held)).cols());
}

// The largest relative error, 0 to 1, of static deflections of a body with the elastic `shapes` (n x s, s > 0) against
// the full model: unit forces and moments at the interface, each balanced by others there: deflection at the loads,
// max_i 1 - c_i' / c_i with c = f . K^+ f of the model and c' = (Phi^T f) . (Phi^T K Phi)^-1 (Phi^T f) of the shapes.
double interface_error(const HeldBody& body, const MatrixXd& shapes) {
  const MatrixXd f = interface_loads(body);
  if (f.cols() == 0) return 0.0;
  const VectorXd exact = f.cwiseProduct(balanced_solution(body.K, body.M, f, body.scale)).colwise().sum();
  const MatrixXd unit = scaled(shapes), Q = unit.transpose() * f;
  const MatrixXd K = unit.transpose() * (body.K * unit);
  const VectorXd found = Q.cwiseProduct(K.ldlt().solve(Q)).colwise().sum();
  return (1.0 - found.array() / exact.array()).maxCoeff();
}

// The same for weight, held at the interface, along each axis: mean deflection, over that along the softest axis;
// f = M r for translations r, without the part that swings the body about an interface that does not hold it.
double weight_error(const HeldBody& body, const MatrixXd& shapes) {
  std::vector<int> all(static_cast<std::size_t>(body.K.rows()));
  std::iota(all.begin(), all.end(), 0);
  const std::vector<int> inside = other_dofs(all, body.held);
  if (inside.empty()) return 0.0;
  const Sparse K = selected(body.K, inside, inside), M = selected(body.M, inside, inside);
  const MatrixXd rigid = scaled(body.rigid), R = gathered(rigid, inside);
  const MatrixXd swing = R * null_space(gathered(rigid, body.held));
  MatrixXd f = M * R.leftCols<3>();
  if (swing.cols() > 0) {
    const MatrixXd M_swing = M * swing;
    f -= M_swing * (swing.transpose() * M_swing).ldlt().solve(swing.transpose() * f);
  }
  const VectorXd exact = f.cwiseProduct(balanced_solution(K, M, f, body.scale)).colwise().sum();

  // Motions of frame and shapes with the interface at rest.
  MatrixXd V(body.rigid.rows(), 6 + shapes.cols());
  V << body.rigid, shapes;
  V = scaled(V);
  const MatrixXd W = gathered(V, inside) * null_space(gathered(V, body.held));
  VectorXd found = VectorXd::Zero(3);
  if (W.cols() > 0) {
    const Modes modes = all_modes(W.transpose() * (K * W), W.transpose() * (M * W), body.scale);
    for (Index k = 0; k < modes.lambda.size(); ++k)
      if (modes.lambda(k) > kNoStiffness * body.scale)
        found += (f.transpose() * (W * modes.shapes.col(k))).cwiseAbs2() / modes.lambda(k);
  }
  return exact.maxCoeff() > 0.0 ? (exact - found).maxCoeff() / exact.maxCoeff() : 0.0;
}

// Of loads at joints and struts, and of weight: each balanced, they are solved with the full model and within the basis.
double static_error(const HeldBody& body, const MatrixXd& shapes) {
  FOOTFALL_DEMAND(!body.held.empty() && shapes.cols() > 0 && shapes.rows() == body.K.rows());
  return std::max({0.0, interface_error(body, shapes), weight_error(body, shapes)});
}

// --- Modes of equal frequency.

constexpr double kOneFrequency = 1e-9;  // relative difference of equal lambdas
constexpr double kApart = 1e-3;         // of the largest eigenvalue of B

// sum_i i e_i e_i^T, i = 1, 2, 3: distinguishes motions along the principal axes e_i.
Eigen::Matrix3d axis_weight(const Eigen::Matrix3d& principal_axes) {
  return principal_axes * Eigen::Vector3d(1.0, 2.0, 3.0).asDiagonal() * principal_axes.transpose();
}

// W, 6N x 6N: the node's mass times axis_weight for its displacement, nothing for its rotation [kg].
Eigen::SparseMatrix<double> axis_weights(const FeModel& model) {
  const Eigen::Matrix3d weight = axis_weight(principal_axes(mass_properties(model).inertia));
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < model.node_count(); ++j)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) entries.emplace_back(6 * j + a, 6 * j + b, model.node_mass(j) * weight(a, b));
  const Index size = 6 * model.node_count() + model.extra;
  Eigen::SparseMatrix<double> W(size, size);
  W.setFromTriplets(entries.begin(), entries.end());
  return W;
}

// Y (s x s, orthogonal): modes of equal frequency among the shapes X Y move along one axis each, where possible. lambda: s,
// rising [1/s2]; B = X^T W X, s x s. Within each group of equal frequency Y holds eigenvectors of B, if its eigenvalues are
// distinct; elsewhere Y is the identity.
MatrixXd along_axes(const VectorXd& lambda, const MatrixXd& B) {
  const Index modes = lambda.size();
  MatrixXd Y = MatrixXd::Identity(modes, modes);
  for (Index first = 0, end = 0; first < modes; first = end) {
    for (end = first + 1; end < modes && lambda(end) - lambda(end - 1) <= kOneFrequency * lambda(end);) ++end;
    const Index size = end - first;
    if (size == 1) continue;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(B.block(first, first, size, size));
    const VectorXd along = eigen.eigenvalues();  // rising
    const bool apart = (along.tail(size - 1) - along.head(size - 1)).minCoeff() > kApart * along(size - 1);
    if (apart) Y.block(first, first, size, size) = eigen.eigenvectors();
  }
  return Y;
}

// --- The reduction.

constexpr double kTwoPi = 2.0 * kPi;
constexpr double kRigidMode = 1e-2;  // of the elastic scale: files print modes with six digits
constexpr int kFirstGuess = 16;      // modes in the first attempt if only a frequency limit is known

double lambda_of(double frequency) { return std::pow(kTwoPi * frequency, 2); }

// Stiffness, mass and weights of directions (axis_weights) on the active degrees of freedom.
struct Problem {
  const FeModel& model;
  std::vector<int> active;
  Sparse K, M, W;
  double scale;  // an upper bound of the first elastic lambda [1/s2]
  std::string name;
};

// Limits of the modes, in addition to static shapes.
struct ModeLimits {
  std::optional<int> count;
  double limit = std::numeric_limits<double>::infinity();  // of lambda [1/s2]
};

// The modes with lambda up to the limit, at most `most`. rank: number of modes. One more is computed, so that a pair of equal
// frequency is aligned before it is split.
Modes modes_up_to(const Sparse& K, const Sparse& M, const Sparse& W, double limit, int most, int rank, double shift) {
  most = std::min(most, rank);
  const int seen = std::min(most + 1, rank);
  for (int count = std::isinf(limit) ? seen : std::min(kFirstGuess, seen);; count = std::min(2 * count, seen)) {
    const Modes modes = lowest_modes(K, M, count, shift);
    const Index within = (modes.lambda.array() <= limit).count();
    if (count < seen && within == count) continue;
    const MatrixXd shapes = modes.shapes * along_axes(modes.lambda, modes.shapes.transpose() * (W * modes.shapes));
    const Index taken = std::min<Index>(within, most);
    return {modes.lambda.head(taken), shapes.leftCols(taken)};
  }
}

// The required number of modes, or the default.
int checked_count(const Problem& problem, const ModeLimits& limits, int available, const std::string& on_top) {
  if (!limits.count) return std::isinf(limits.limit) ? std::min(kDefaultModeCount, available) : available;
  if (*limits.count > available)
    throw InputError(code::kTooManyModes,
                     problem.name + ": " + std::to_string(*limits.count) + " modes required" + on_top +
                         ", but the model of " + std::to_string(problem.model.node_count()) + " nodes has only " +
                         std::to_string(available) +
                         " elastic degrees of freedom with mass. Request fewer modes or refine the mesh.");
  return *limits.count;
}

// The first six modes are the rigid-body motions (check_model). No other mode may be without strain; the round-off of the six
// zeros gives the threshold.
void require_six_rigid(const VectorXd& lambda, const Problem& problem) {
  if (lambda.size() <= 6) return;
  const double zero = std::max(kNoStiffness * problem.scale, 10.0 * lambda.head<6>().cwiseAbs().maxCoeff());
  const Index rigid = (lambda.array() <= zero).count();
  if (rigid > 6)
    throw InputError(
        code::kFeModel,
        problem.name + ": the body has " + std::to_string(rigid) +
            " independent motions without strain; expected the six rigid-body motions. Check the model for hinges and "
            "loose nodes.");
}

// Elastic free-free modes, columns on the active degrees of freedom.
MatrixXd free_free_shapes(const Problem& problem, const ModeLimits& limits) {
  const int rank = mass_rank(problem.M);
  const int count = checked_count(problem, limits, rank - 6, "");
  const Modes modes = modes_up_to(problem.K, problem.M, problem.W, limits.limit, count + 6, rank, problem.scale);
  require_six_rigid(modes.lambda, problem);
  return modes.shapes.rightCols(modes.shapes.cols() - 6);
}

// Degrees of freedom of the interface, as indices into problem.active.
std::vector<int> interface_dofs(const Problem& problem, const BasisOptions& options) {
  check_interface(problem.model, options.interface_nodes, problem.name);
  check_interface(problem.model, options.pinned_nodes, problem.name);
  std::vector<int> held(static_cast<std::size_t>(problem.model.node_count()), 0);  // components per node
  for (int node : options.pinned_nodes) held[node] = 3;
  for (int node : options.interface_nodes) held[node] = 6;
  std::vector<int> result;
  for (std::size_t i = 0; i < problem.active.size() && problem.active[i] < 6 * problem.model.node_count(); ++i)
    if (problem.active[i] % 6 < held[problem.active[i] / 6]) result.push_back(static_cast<int>(i));
  return result;
}

// [static shapes, fixed-interface modes] on the active degrees of freedom. Static shapes inside: -K_ii^-1 K_ib. K_ii is
// singular if the interface does not hold the body, but the loads K_ib do no work on the free motions; any solution is valid,
// because these motions are the first fixed-interface modes. They are not counted.
MatrixXd craig_bampton_basis(const Problem& problem, const HeldBody& body, const ModeLimits& limits) {
  std::vector<int> all(problem.active.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<int> inside = other_dofs(all, body.held);
  const Index n_held = static_cast<Index>(body.held.size()), size = problem.K.rows();
  MatrixXd basis = scattered(MatrixXd::Identity(n_held, n_held), body.held, size);

  const Sparse K_ii = selected(problem.K, inside, inside);
  const Sparse M_ii = selected(problem.M, inside, inside), W_ii = selected(problem.W, inside, inside);
  const int holds = held_motions(body), free = 6 - holds, rank = inside.empty() ? 0 : mass_rank(M_ii);
  const int count = checked_count(problem, limits, std::max(0, rank - free),
                                  " in addition to " + std::to_string(n_held - holds) + " static shapes");
  if (inside.empty()) return basis;
  const MatrixXd load = -MatrixXd(selected(problem.K, inside, body.held));
  basis += scattered(balanced_solution(K_ii, M_ii, load, problem.scale), inside, size);
  const Modes fixed = modes_up_to(K_ii, M_ii, W_ii, limits.limit, count + free, rank, problem.scale);
  MatrixXd result(size, n_held + fixed.shapes.cols());
  result << basis, scattered(fixed.shapes, inside, size);
  return result;
}

// The eigenproblem within that basis. Elastic shapes only.
MatrixXd craig_bampton_shapes(const Problem& problem, const HeldBody& body, const ModeLimits& limits) {
  const MatrixXd basis = craig_bampton_basis(problem, body, limits);
  const Modes modes =
      all_modes(basis.transpose() * (problem.K * basis), basis.transpose() * (problem.M * basis), problem.scale);
  require_six_rigid(modes.lambda, problem);
  return basis * modes.shapes.rightCols(modes.lambda.size() - 6);
}

std::string static_warning(const std::string& name, double error) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(2);
  text << name << ": its modes underestimate static deflections at its attachments by " << 100.0 * error
       << " % (static_error). Increase modes or max_frequency, or use the basis \"craig_bampton\".";
  return with_code(code::kStaticError, text.str());
}

void check_options(const BasisOptions& options, const std::string& name) {
  if (options.mode_count && *options.mode_count < 0)
    throw InputError(code::kParameterOutOfRange,
                     name + ": modes is " + std::to_string(*options.mode_count) + ", expected 0 or more.");
  if (options.max_frequency && !(*options.max_frequency > 0.0))
    throw InputError(code::kParameterOutOfRange, name + ": maximum frequency is " + plain_text(*options.max_frequency) +
                                                     " Hz, expected a positive number.");
  if (options.damping_ratio.empty())
    throw InputError(code::kParameterOutOfRange, name + ": no damping ratio given, expected at least one.");
  for (double zeta : options.damping_ratio)
    if (!(zeta >= 0.0) || !std::isfinite(zeta))
      throw InputError(code::kParameterOutOfRange,
                       name + ": damping ratio is " + plain_text(zeta) + ", expected 0 or more.");
}

// The model before its spiders: nodes of spiders have no stiffness, and need none.
FeModel without_spiders(FeModel model) {
  model.follows.assign(static_cast<std::size_t>(model.stiffness.rows()), false);
  for (const Spider& spider : model.spiders)
    for (int i = 0; i < 6; ++i) model.follows[6 * spider.node + i] = true;
  return model;
}

constexpr double kSameShape = 1e-2;  // strain energy outside the known shapes, over a mode's energy; beyond it a remark

// Shapes whose coordinates without a place follow the nodes statically: modes within elements do, in all slow motions.
MatrixXd with_extra(const FeModel& model, MatrixXd shapes) {
  if (model.extra == 0) return shapes;
  std::vector<int> placed(static_cast<std::size_t>(6 * model.node_count())),
      extra(static_cast<std::size_t>(model.extra));
  std::iota(placed.begin(), placed.end(), 0);
  std::iota(extra.begin(), extra.end(), 6 * model.node_count());
  const Eigen::SimplicialLDLT<Sparse> factor(selected(model.stiffness, extra, extra));
  if (factor.info() == Eigen::Success)
    shapes.bottomRows(model.extra) =
        -factor.solve(selected(model.stiffness, extra, placed) * shapes.topRows(6 * model.node_count()));
  return shapes;
}

// Stresses at the nodes, 6N x s: stresses of the known shapes F (modes of another code), combined to the given shapes
// X with the least strain energy of the rest, X - F C: C = (F^T K F)^-1 F^T K X. Shapes without strain have no part.
MatrixXd stresses_of(const FeModel& model, const MatrixXd& shapes, const std::string& name, std::string& word) {
  const MatrixXd F = with_extra(model, model.known_shapes);
  const double rigid = kRigidMode * elastic_scale(model);
  const VectorXd energy = F.cwiseProduct(model.stiffness * F).colwise().sum().transpose(),
                 mass = F.cwiseProduct(mass_matrix(model) * F).colwise().sum().transpose();
  std::vector<Index> elastic;
  for (Index k = 0; k < F.cols(); ++k)
    if (energy(k) > rigid * mass(k)) elastic.push_back(k);
  if (elastic.empty())
    throw InputError(code::kFeModel, name + ": the modes with stresses are rigid motions, expected elastic modes.");
  const MatrixXd elastic_F = F(Eigen::all, elastic), KX = model.stiffness * shapes;
  const VectorXd size = energy(elastic).cwiseSqrt().cwiseInverse();
  const MatrixXd unit = elastic_F * size.asDiagonal();
  const MatrixXd gram = unit.transpose() * (model.stiffness * unit);
  const MatrixXd C = gram.ldlt().solve(unit.transpose() * KX);
  const MatrixXd rest = shapes - unit * C;
  const VectorXd all = shapes.cwiseProduct(KX).colwise().sum().transpose(),
                 missing = rest.cwiseProduct(model.stiffness * rest).colwise().sum().transpose();
  Index worst = 0;
  const double share = missing.cwiseQuotient(all).maxCoeff(&worst);
  if (share > kSameShape) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(2);
    text << name << ": the " << elastic.size() << " elastic modes of stress_file hold " << 100.0 * (1.0 - share)
         << " % of the strain energy of the body's mode " << worst
         << ", so that its stresses are too low. Write more modes there, or use basis = \"free_free\".";
    word = with_code(code::kStressModes, text.str());
  }
  return model.known_stresses(Eigen::all, elastic) * (size.asDiagonal() * C);
}

ReducedBody reduce(const FeModel& given, const FeModel& model, const Sparse* T, const BasisOptions& options,
                   const std::string& given_name);

}  // namespace

ReducedBody reduce(const FeModel& given, const BasisOptions& options, const std::string& given_name) {
  const std::string name = "body \"" + given_name + "\"";
  check_options(options, name);
  if (!given.spiders.empty()) {
    check_model(without_spiders(given), name);
    const Constrained independent = constrained(given);
    return reduce(given, independent.model, &independent.T, options, given_name);
  }
  return reduce(given, given, nullptr, options, given_name);
}

namespace {

ReducedBody reduce(const FeModel& given, const FeModel& model, const Sparse* T, const BasisOptions& options,
                   const std::string& given_name) {
  const std::string name = "body \"" + given_name + "\"";
  check_model(model, name);
  const std::vector<int> active = active_dofs(model);
  const Sparse M = mass_matrix(model);
  const Problem problem{model,
                        active,
                        selected(model.stiffness, active, active),
                        selected(M, active, active),
                        selected(axis_weights(model), active, active),
                        elastic_scale(model),
                        name};
  ModeLimits limits{options.mode_count};
  if (options.max_frequency) limits.limit = lambda_of(*options.max_frequency);

  MatrixXd shapes(problem.K.rows(), 0);
  std::optional<double> error_of_statics;
  double error_at_attachments = 0.0;
  try {
    const std::vector<int> held = interface_dofs(problem, options);
    const MatrixXd rigid = gathered(rigid_motions(model, mass_properties(model).centre), active);
    const HeldBody body{problem.K, problem.M, rigid, held, problem.scale};
    if (!(limits.count && *limits.count == 0)) {
      shapes = options.kind == BasisKind::kFreeFree || held.empty() ? free_free_shapes(problem, limits)
                                                                    : craig_bampton_shapes(problem, body, limits);
      if (!held.empty() && shapes.cols() > 0) {
        error_of_statics = static_error(body, shapes);
        error_at_attachments = interface_error(body, shapes);
      }
    }
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.find(name) == 0 ? what : name + ": " + what);
  } catch (const NumericalError& error) {
    throw NumericalError(name + ": " + error.what());
  }
  shapes = scattered(shapes, active, M.rows());
  if (T != nullptr) shapes = (*T * shapes).eval();

  ModalBody raw;
  raw.name = given_name;
  raw.rho0 = model.nodes;
  raw.node_mass = given.node_mass;
  raw.node_inertia = given.node_inertia;
  raw.mass = given.mass;

  raw.Phi.resize(3 * model.node_count(), shapes.cols());
  raw.Psi.resize(3 * model.node_count() + model.extra, shapes.cols());
  raw.Psi.bottomRows(model.extra) = shapes.bottomRows(model.extra);
  for (int j = 0; j < model.node_count(); ++j) {
    raw.Phi.middleRows(3 * j, 3) = shapes.middleRows(6 * j, 3);
    raw.Psi.middleRows(3 * j, 3) = shapes.middleRows(6 * j + 3, 3);
  }
  raw.stress_modes = given.stress * shapes;
  std::string stress_word;
  if (given.known_shapes.cols() > 0 && shapes.cols() > 0) {
    raw.stress_modes = stresses_of(given, shapes, name, stress_word);
  }
  raw.triangles = model.triangles;
  raw.segments = model.segments;
  raw.static_error = error_of_statics;
  BasisOptions all_of_them = options;  // the shapes are already selected
  all_of_them.max_frequency.reset();
  if (shapes.cols() > 0) all_of_them.mode_count.reset();
  const std::vector<bool> turning = turning_nodes(given);
  ReducedBody reduced =
      orthonormalised(std::move(raw), shapes.transpose() * (given.stiffness * shapes), all_of_them, &turning);
  if (!stress_word.empty()) reduced.warnings.push_back(stress_word);
  if (error_at_attachments > kStaticTolerance) reduced.warnings.push_back(static_warning(name, error_at_attachments));
  return reduced;
}

}  // namespace

VectorXd frequencies(const ModalBody& body) { return body.stiffness.cwiseSqrt() / kTwoPi; }

// --- For every flexible body: no rigid motion, mass-orthonormal shapes, diagonal stiffness.

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kRigidShape = 1e-6;  // a shape is a rigid motion if less than this fraction of its norm remains
constexpr double kDependent = 1e-12;  // smallest eigenvalue of the Gram matrix of unit shapes

// Rows 6 j + i of displacements and rotations, then rows of Psi that have no place.
MatrixXd stacked(const MatrixXd& Phi, const MatrixXd& Psi) {
  MatrixXd U(Phi.rows() + Psi.rows(), Phi.cols());
  U.bottomRows(Psi.rows() - Phi.rows()) = Psi.bottomRows(Psi.rows() - Phi.rows());
  for (Index i = 0; i < Phi.rows(); i += 3) U.middleRows(2 * i, 6) << Phi.middleRows(i, 3), Psi.middleRows(i, 3);
  return U;
}

struct Shapes {
  const MatrixXd& Phi;
  const MatrixXd& Psi;
};

// M-weighted inner products of two sets of shapes.
MatrixXd inner(const ModalBody& body, const Shapes& one, const Shapes& two) {
  if (body.mass.size() > 0) return stacked(one.Phi, one.Psi).transpose() * (body.mass * stacked(two.Phi, two.Psi));
  MatrixXd MPhi = two.Phi, JPsi = two.Psi;
  for (Index j = 0; j < body.node_count(); ++j) {
    MPhi.middleRows(3 * j, 3) *= body.node_mass(j);
    JPsi.middleRows(3 * j, 3) = (body.node_inertia[j] * two.Psi.middleRows(3 * j, 3)).eval();
  }
  return one.Phi.transpose() * MPhi + one.Psi.transpose() * JPsi;
}

Shapes shapes_of(const ModalBody& body) { return {body.Phi, body.Psi}; }

MatrixXd gram(const ModalBody& body) { return inner(body, shapes_of(body), shapes_of(body)); }

// Removes the rigid-body content of the shapes: x - R (R^T M R)^-1 R^T M x, R = translations and rotations about Bo (the mass
// centre). turns: nodes that have rotations.
void remove_rigid_motion(ModalBody& body, const std::vector<bool>& turns) {
  const Index n = body.node_count();
  MatrixXd R_Phi = MatrixXd::Zero(3 * n, 6), R_Psi = MatrixXd::Zero(body.Psi.rows(), 6);
  const Shapes R{R_Phi, R_Psi};
  for (Index j = 0; j < n; ++j) {
    R_Phi.block<3, 3>(3 * j, 0).setIdentity();
    for (int i = 0; i < 3; ++i) R_Phi.block<3, 1>(3 * j, 3 + i) = Vector3d::Unit(i).cross(Vector3d(body.rho0.col(j)));
    if (turns[j]) R_Psi.block<3, 3>(3 * j, 3).setIdentity();
  }
  const MatrixXd rigid_mass = inner(body, R, R);
  const MatrixXd content = rigid_mass.ldlt().solve(inner(body, R, shapes_of(body)));
  body.Phi -= R_Phi * content;
  body.Psi -= R_Psi * content;
}

void transform(ModalBody& body, const MatrixXd& Y) {
  body.Phi = (body.Phi * Y).eval();
  body.Psi = (body.Psi * Y).eval();
  if (body.stress_modes.rows() > 0) body.stress_modes = (body.stress_modes * Y).eval();
}

void align_equal_frequencies(ModalBody& body) {
  const Matrix3d weight = axis_weight(principal_axes(body));
  MatrixXd WPhi = body.Phi;
  for (Index j = 0; j < body.node_count(); ++j)
    WPhi.middleRows(3 * j, 3) = (body.node_mass(j) * weight * body.Phi.middleRows(3 * j, 3)).eval();
  transform(body, along_axes(body.stiffness, body.Phi.transpose() * WPhi));
}

// Signs have no physical meaning; the largest displacement is made positive, so that files and pictures can be compared.
void fix_signs(ModalBody& body) {
  VectorXd sign = VectorXd::Ones(body.mode_count());
  for (Index k = 0; k < body.mode_count(); ++k) {
    Index at = 0;
    body.Phi.col(k).cwiseAbs().maxCoeff(&at);
    if (body.Phi(at, k) < 0.0) sign(k) = -1.0;
  }
  transform(body, sign.asDiagonal());
}

// First elastic frequency times size [m/s]: half the speed of sound, 2500 m/s, for a steel bar along its axis, less by
// thickness over length in bending. Less than the first are cables and foils, more than the second has no material.
constexpr double kSlowest = 0.3, kFastest = 1e4;
// Mass over the volume of the box around the nodes [kg/m3]: air has 1.2, osmium 22600. Boxes thinner than this share of their length
// may be shells, whose thickness is not in the box.
constexpr double kLightest = 1e-3, kDensest = 23000.0, kThinnestBox = 0.01;

double mass_of(const ModalBody& body) {
  return body.mass.size() > 0 ? mass_properties(body.rho0, body.mass).mass : body.node_mass.sum();
}

std::string frequency_warning(const ModalBody& body) {
  if (body.mode_count() == 0) return "";
  const double first = frequencies(body)(0), size = extent(body), mass = mass_of(body);
  const Eigen::Vector3d box = body.rho0.rowwise().maxCoeff() - body.rho0.rowwise().minCoeff();
  const bool slow_or_fast = !(first * size >= kSlowest && first * size <= kFastest);
  const bool light = mass < kLightest * box.prod();
  const bool dense = box.minCoeff() > kThinnestBox * box.maxCoeff() && mass > kDensest * box.prod();
  if (!slow_or_fast && !light && !dense) return "";
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "body \"" << body.name << "\": ";
  if (slow_or_fast)
    text << "first elastic frequency is " << first << " Hz at a size of " << size << " m, expected between "
         << kSlowest / size << " and " << kFastest / size << " Hz. ";
  if (light)
    text << "the body weighs " << mass << " kg in a box of " << box.x() << " x " << box.y() << " x " << box.z()
         << " m, a thousandth of air. ";
  if (dense)
    text << "the body weighs " << mass << " kg in a box of " << box.x() << " x " << box.y() << " x " << box.z()
         << " m, at least " << mass / box.prod()
         << " kg/m3, more than any solid. Densities of a model in mm-t-s are in t/mm3 (steel: 7.85e-9), in mm-kg-ms in "
            "kg/mm3, in in-lbf-s in lbf s2/in4 (steel: 7.35e-4). ";
  text << "Check the units: lengths in m (not mm), masses in kg, forces in N, Young's modulus in Pa.";
  return with_code(code::kUnusualFrequencies, text.str());
}

}  // namespace

ReducedBody orthonormalised(ModalBody body, const MatrixXd& stiffness, const BasisOptions& options,
                            const std::vector<bool>* turning) {
  const std::string who = "body \"" + body.name + "\"";
  const Index s = stiffness.cols();
  FOOTFALL_DEMAND(body.Phi.cols() == s && body.Psi.cols() == s && stiffness.rows() == s);
  if (options.mode_count && *options.mode_count > s)
    throw InputError(code::kTooManyModes, who + ": " + std::to_string(*options.mode_count) +
                                              " modes required, but there are only " + std::to_string(s) + ".");
  ReducedBody result;
  result.p_DBo = body.mass.size() > 0 ? mass_properties(body.rho0, body.mass).centre
                                      : Vector3d(body.rho0 * body.node_mass / body.node_mass.sum());
  body.rho0.colwise() -= result.p_DBo;
  const bool rotations = s > 0 && !body.Psi.topRows(3 * body.node_count()).isZero(0.0);
  std::vector<bool> turns(static_cast<std::size_t>(body.node_count()), rotations);
  if (rotations && turning != nullptr) turns = *turning;

  MatrixXd K = stiffness;
  if (s > 0) {
    const VectorXd before = gram(body).diagonal().cwiseSqrt();
    remove_rigid_motion(body, turns);
    const VectorXd norm = gram(body).diagonal().cwiseSqrt();
    for (Index k = 0; k < s; ++k)
      if (!(norm(k) > kRigidShape * before(k)))
        throw InputError(code::kShapesDependent,
                         who + ": mode " + std::to_string(k) +
                             " is a rigid-body motion; expected elastic modes only. Remove the mode.");
    const MatrixXd unit = norm.cwiseInverse().asDiagonal();
    transform(body, unit);
    K = unit * K * unit;
    const MatrixXd G = gram(body);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> independent(G);
    if (!(independent.eigenvalues()(0) > kDependent))
      throw InputError(code::kShapesDependent,
                       who + ": the " + std::to_string(s) +
                           " modes are not independent after rigid motion is removed. Remove dependent modes.");
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(0.5 * (K + K.transpose()),
                                                                   0.5 * (G + G.transpose()));
    if (!(eigen.eigenvalues()(0) > 0.0))
      throw InputError(code::kStiffness, who + ": the modal stiffness is not positive: smallest omega^2 is " +
                                             plain_text(eigen.eigenvalues()(0)) +
                                             " 1/s2. Every mode must store strain energy.");
    Index count = options.mode_count ? *options.mode_count : s;
    if (options.max_frequency) {
      const double limit = std::pow(2.0 * kPi * *options.max_frequency, 2);
      count = std::min<Index>(count, (eigen.eigenvalues().array() <= limit).count());
    }
    transform(body, eigen.eigenvectors().leftCols(count));
    body.stiffness = eigen.eigenvalues().head(count);
    // Once more, because of round-off: the first pass may have cancelled large rigid motions.
    remove_rigid_motion(body, turns);
    if (count > 0) {
      const Eigen::LLT<MatrixXd> cholesky(gram(body));
      transform(body, cholesky.matrixU().solve(MatrixXd::Identity(count, count)));
      align_equal_frequencies(body);
      fix_signs(body);
    }
  } else {
    body.stiffness.resize(0);
  }
  body.damping.resize(body.stiffness.size());
  for (Index k = 0; k < body.damping.size(); ++k) {
    const auto given = static_cast<Index>(options.damping_ratio.size());
    body.damping(k) = 2.0 * options.damping_ratio[std::min(k, given - 1)] * std::sqrt(body.stiffness(k));
  }
  const std::string warning = frequency_warning(body);
  if (!warning.empty()) result.warnings.push_back(warning);
  if (body.mode_count() == 0 && !(options.mode_count && *options.mode_count == 0))
    result.warnings.push_back(
        with_code(code::kUnusualFrequencies,
                  who + ": no elastic mode is below the frequency limit; the body is rigid. Increase the limit."));
  result.body = std::move(body);
  return result;
}

}  // namespace footfall
