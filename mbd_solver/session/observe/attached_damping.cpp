// Modes of all bodies under the conditions of all joints: a dense eigenvalue problem in a basis of the free motions.

#include "mbd_solver/session/observe/attached_damping.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/dynamics/assembly.h"
#include "mbd_solver/dynamics/body_force.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/fe/eigen_solver.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/observe/start_values.h"

namespace footfall {
namespace {

constexpr double kOther = 0.2;     // relative difference of ratios that is told
constexpr double kEqual = 1e-6;    // relative difference of eigenvalues of equal bodies, by round-off
constexpr double kFreeSag = 0.1;   // g / omega^2 of the free body over its size: told where it is built
constexpr double kElastic = 1e-6;  // of the largest eigenvalue: rigid motions are below

// Columns: independent velocities that all joints allow.
Eigen::MatrixXd free_motions(const Model& model, const Layout& layout, const Kinematics& kinematics, double t) {
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(layout.row_count, layout.v_size);
  int largest = 0;
  for (int i = 0; i < model.body_count(); ++i) largest = std::max(largest, 2 * kinematics.of(i).size());
  Eigen::VectorXd scratch = Eigen::VectorXd::Zero(2 * largest);
  for_each_row(
      model, layout, kinematics, t, scratch,
      [&](const RowPlace& at, const PairMotion& pair, const Eigen::Ref<Eigen::VectorXd>& phi_v, const RowValue&) {
        const Joint& joint = model.joint(at.joint);
        if (joint.rows[at.local].inertia > 0.0) return;  // a rotor is no condition
        const std::array<int, 2> v = pair_v(layout, joint.m1.body, joint.m2.body);
        for (int i = 0; i < 2; ++i) {
          const int n = pair.body[i]->size();
          if (n > 0) B.row(at.row).segment(v[i], n) += phi_v.segment(pair.offset(i), n).transpose();
        }
      });
  if (layout.row_count == 0) return Eigen::MatrixXd::Identity(layout.v_size, layout.v_size);
  Eigen::FullPivLU<Eigen::MatrixXd> lu(B);
  lu.setThreshold(1e-9);
  return lu.kernel();
}

// Of modes of one frequency (columns) the combination in which this body, with velocities from v on, has the most strain
// energy: power iteration.
Eigen::VectorXd mode_of(const Eigen::MatrixXd& modes, const Eigen::VectorXd& stiffness, Eigen::Index v) {
  const Eigen::MatrixXd own = modes.middleRows(v, stiffness.size());
  const Eigen::MatrixXd energy = own.transpose() * stiffness.asDiagonal() * own;
  Eigen::Index most = 0;
  energy.diagonal().maxCoeff(&most);
  Eigen::VectorXd a = energy.col(most);
  for (int k = 0; k < 50 && a.norm() > 0.0; ++k) a = energy * a.normalized();
  return modes * (a.norm() > 0.0 ? a.normalized() : Eigen::VectorXd::Unit(modes.cols(), most));
}

struct AttachedModes {
  Eigen::MatrixXd shapes;  // columns: velocities of the mechanism, mass-orthonormal
  Eigen::VectorXd lambda;  // [1/s2]
  Eigen::MatrixXd M;
  Eigen::VectorXd K, C;
};

bool has_modes(const Model& model, int body) { return model.body(body).mode_count() > 0; }

// Of more than `most` velocities none: the effort grows with their third power.
AttachedModes modes_of(const Scene& scene, const Model& model, const Layout& layout, int most) {
  AttachedModes out;
  if (layout.v_size > most) return out;
  const Assembly assembly = assemble(model, assembly_options(scene, model));
  Kinematics kinematics(model);
  kinematics.load(layout, assembly.state.q, assembly.state.v, Eigen::VectorXd());
  kinematics.load_turns(layout, assembly.state.z);
  const Eigen::MatrixXd N = free_motions(model, layout, kinematics, 0.0);
  out.M = Eigen::MatrixXd::Zero(layout.v_size, layout.v_size);
  out.K = out.C = Eigen::VectorXd::Zero(layout.v_size);
  for (int i = 0; i < model.body_count(); ++i) {
    const int v = layout.body_v[i], n = kinematics.of(i).size();
    InertiaScratch scratch(n - 6);
    Eigen::MatrixXd own(n, n);
    body_mass_matrix(model.body(i), kinematics.of(i), scratch, own);
    out.M.block(v, v, n, n) = own;
    if (n == 6) continue;
    out.K.segment(v + 6, n - 6) = model.body(i).modal()->stiffness;
    out.C.segment(v + 6, n - 6) = model.body(i).modal()->damping;
  }
  const Eigen::MatrixXd KN = out.K.asDiagonal() * N, MN = out.M * N;
  const Modes modes = all_modes(N.transpose() * KN, N.transpose() * MN, out.K.maxCoeff());
  out.shapes = N * modes.shapes;
  out.lambda = modes.lambda;
  return out;
}

std::vector<AttachedDamping> damping_of(const Model& model, const Layout& layout, const AttachedModes& modes) {
  std::vector<AttachedDamping> out;
  for (int i = 0; i < model.body_count(); ++i) {
    if (!has_modes(model, i) || !(model.body(i).modal()->damping.maxCoeff() > 0.0)) continue;
    const int v = layout.body_v[i] + 6, s = model.body(i).mode_count();
    for (Eigen::Index k = 0; k < modes.lambda.size(); ++k) {
      const double lambda = modes.lambda[k];
      if (lambda <= kElastic * modes.K.segment(v, s).minCoeff()) continue;
      Eigen::Index count = 1;  // modes of this frequency: equal bodies side by side mix in them
      while (k + count < modes.lambda.size() && std::abs(modes.lambda[k + count] - lambda) < kEqual * lambda) ++count;
      const Eigen::VectorXd x = mode_of(modes.shapes.middleCols(k, count), modes.K.segment(v, s), v);  // x^T M x = 1
      if (x.segment(v, s).cwiseAbs2().dot(modes.K.segment(v, s)) < 0.5 * lambda) continue;
      const double omega = std::sqrt(lambda);
      const double given = modes.C[v] / (2.0 * std::sqrt(modes.K[v]));
      const double ratio = x.cwiseAbs2().dot(modes.C) / (2.0 * omega);
      if (std::abs(ratio - given) > kOther * given) out.push_back({i, omega / (2.0 * kPi), given, ratio});
      break;
    }
  }
  return out;
}

bool any_modes(const Model& model) {
  for (int i = 0; i < model.body_count(); ++i)
    if (has_modes(model, i)) return true;
  return false;
}

// Static deflection under gravity, in the elastic modes: sum x_k (x_k^T M g) / lambda_k. Motions that bend nothing do not count.
std::vector<std::string> sag_warnings(const Model& model, const Layout& layout, const AttachedModes& modes) {
  std::vector<std::string> out;
  double softest = HUGE_VAL;  // [1/s2]
  Eigen::VectorXd g = Eigen::VectorXd::Zero(layout.v_size);
  for (int i = 0; i < model.body_count(); ++i) {
    g.segment<3>(layout.body_v[i]) = model.gravity();
    if (has_modes(model, i)) softest = std::min(softest, model.body(i).modal()->stiffness.minCoeff());
  }
  Eigen::VectorXd sag = Eigen::VectorXd::Zero(layout.v_size);
  const Eigen::VectorXd force = modes.M * g;
  for (Eigen::Index k = 0; k < modes.lambda.size(); ++k)
    if (modes.lambda[k] > kElastic * softest)
      sag += modes.shapes.col(k) * (modes.shapes.col(k).dot(force) / modes.lambda[k]);
  for (int i = 0; i < model.body_count(); ++i) {
    if (!has_modes(model, i)) continue;
    const ModalBody& body = *model.body(i).modal();
    const double bends = largest_deflection(body, sag.segment(layout.body_v[i] + 6, body.mode_count()));
    const double size = extent(body);
    const bool told = model.gravity().norm() / body.stiffness.minCoeff() > kFreeSag * size;  // of the free body
    if (bends > kDeflectionRange * size && !told)
      out.push_back(
          with_code(code::kBendsUnderWeight,
                    "body " + model.body(i).name() + " bends by " + number_text(bends, 3) +
                        " m from its mean axes under the weight that its joints hold, " + number_text(bends / size, 3) +
                        " of its extent, beyond the range of linear modes. Check Young's modulus (Pa) and its "
                        "sections (m); else divide it into several bodies"));
  }
  return out;
}

}  // namespace

std::vector<AttachedDamping> attached_damping(const Scene& scene, const Mechanism& mechanism, int most) {
  const Model& model = mechanism.model;
  if (!any_modes(model)) return {};
  const Layout layout(model);
  return damping_of(model, layout, modes_of(scene, model, layout, most));
}

namespace {

// One warning for all bodies of equal numbers, as three digits show them: bodies of an array differ by round-off.
std::vector<std::string> warnings_of(const std::vector<AttachedDamping>& found, const Mechanism& mechanism) {
  std::vector<std::pair<std::string, std::vector<std::string>>> texts;
  for (const AttachedDamping& at : found) {
    const std::string given = number_text(at.given, 3);
    const std::string text = ".flexible.damping: " + given +
                             " is the damping ratio of the modes of the free body; as its joints hold it, its lowest "
                             "mode (" +
                             number_text(at.frequency, 3) + " Hz) has " + number_text(at.ratio, 3) + ". For " + given +
                             " in that mode give damping = " + number_text(at.given * at.given / at.ratio, 3);
    auto same = std::find_if(texts.begin(), texts.end(), [&](const auto& entry) { return entry.first == text; });
    if (same == texts.end()) same = texts.insert(texts.end(), {text, {}});
    same->second.push_back(mechanism.model.body(at.body).name());
  }
  std::vector<std::string> out;
  for (const auto& [text, names] : texts) {
    const bool several = names.size() > 1;
    std::string all = names.front();
    for (std::size_t k = 1; k < names.size(); ++k) all += ", " + names[k];
    out.push_back(with_code(code::kAttachedDamping, "bodies." + (several ? "{" + all + "}" : all) + text));
  }
  return out;
}

}  // namespace

std::vector<std::string> warnings_of_held_bodies(const Scene& scene, const Mechanism& mechanism) {
  const Model& model = mechanism.model;
  if (!any_modes(model)) return {};
  const Layout layout(model);
  const AttachedModes modes = modes_of(scene, model, layout, kMostVelocities);
  if (modes.lambda.size() == 0) return {};
  std::vector<std::string> out = warnings_of(damping_of(model, layout, modes), mechanism);
  for (std::string& warning : sag_warnings(model, layout, modes)) out.push_back(std::move(warning));
  return out;
}

std::vector<std::string> damping_warnings_of_run(const Scene& scene, const Mechanism& mechanism) {
  constexpr int kQuick = 200;  // velocities: some milliseconds
  std::vector<AttachedDamping> told;
  for (const AttachedDamping& at : attached_damping(scene, mechanism, kQuick))
    if (std::abs(at.given - kDefaultDampingRatio) > 1e-9) told.push_back(at);
  return warnings_of(told, mechanism);
}

}  // namespace footfall
