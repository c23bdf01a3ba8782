#include "mbd_solver/dynamics/assembly.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/dynamics/body_force.h"
#include "mbd_solver/dynamics/kinematics.h"

namespace footfall {
namespace {

constexpr int kMostClosingSteps = 30;
constexpr double kClosed = 1e-12;        // [m or rad]: what double precision reaches for mechanisms of metres
constexpr double kContradiction = 1e-8;  // what remains above this cannot be closed
// While the joints are still open by a gap g, redundant conditions look independent to about g: they must not
// steer the closing.
constexpr double kClosingRank = 1e-5;

// All rows at one state: phi, phi', and B = D Phi_v C^-T with M = C C^T (mass metric), D = rows scaled to
// unit length.
class DenseRows {
 public:
  DenseRows(const Model& model, const Layout& layout) : model_(model), layout_(layout), kinematics_(model) {}

  void evaluate(const State& state) {
    const int m = layout_.all_rows;
    kinematics_.load(layout_, state.q, state.v, Eigen::VectorXd());
    phi = rate = Eigen::VectorXd::Zero(m);
    B = Eigen::MatrixXd::Zero(m, layout_.v_size);
    Eigen::VectorXd phi_v;
    for (int row = 0; row < m; ++row) {
      const int j = layout_.row_joint[static_cast<std::size_t>(row)];
      const Joint& joint = model_.joint(j);
      const PairMotion pair = kinematics_.pair(joint.m1.body, joint.m2.body);
      const ConstraintRow& condition =
          joint.rows[static_cast<std::size_t>(row - layout_.joint_row[static_cast<std::size_t>(j)])];
      phi_v.resize(pair.size());
      MarkerVectors vectors(pair, joint.m1, joint.m2);
      const RowValue value = evaluate_row(condition, state.time, vectors, phi_v);
      phi[row] = value.phi;
      rate[row] = value.rate;
      const int bodies[2] = {joint.m1.body, joint.m2.body};
      for (int i = 0; i < 2; ++i) {
        if (bodies[i] == kGround) continue;
        B.block(row, layout_.body_v[static_cast<std::size_t>(bodies[i])], 1, pair.body[i]->size()) =
            phi_v.segment(pair.offset(i), pair.body[i]->size()).transpose();
      }
    }
    factors_.clear();
    for (int i = 0; i < model_.body_count(); ++i) {
      const int n = kinematics_.of(i).size();
      Eigen::MatrixXd M(n, n);
      InertiaScratch scratch(n - 6);
      body_mass_matrix(model_.body(i), kinematics_.of(i), scratch, M);
      factors_.emplace_back(M);
      Eigen::Ref<Eigen::MatrixXd> columns = B.middleCols(layout_.body_v[static_cast<std::size_t>(i)], n);
      columns = factors_.back().matrixL().solve(columns.transpose()).transpose().eval();
    }
    scale = Eigen::VectorXd::Ones(m);
    for (int row = 0; row < m; ++row) {
      const double size = B.row(row).norm();
      if (size > 0.0) scale[row] = 1.0 / size;
    }
    B = scale.asDiagonal() * B;
  }

  // The smallest change (in the mass metric) that removes the defects: -C^-T B^+ D defect.
  Eigen::VectorXd correction(const Eigen::VectorXd& defect, double rank_tolerance) const {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(rank_tolerance);
    decomposition.compute(B);
    Eigen::VectorXd x = -decomposition.solve(Eigen::VectorXd(scale.asDiagonal() * defect));
    for (int i = 0; i < model_.body_count(); ++i) {
      Eigen::Ref<Eigen::VectorXd> part =
          x.segment(layout_.body_v[static_cast<std::size_t>(i)], kinematics_.of(i).size());
      part = factors_[static_cast<std::size_t>(i)].matrixU().solve(part).eval();
    }
    return x;
  }

  const Kinematics& kinematics() const { return kinematics_; }
  Eigen::VectorXd phi, rate, scale;
  Eigen::MatrixXd B;

 private:
  const Model& model_;
  const Layout& layout_;
  Kinematics kinematics_;
  std::vector<Eigen::LLT<Eigen::MatrixXd>> factors_;
};

State initial_state(const Model& model, const Layout& layout) {
  State state;
  state.q.resize(layout.q_size);
  state.v.resize(layout.v_size);
  state.z.resize(layout.z_size);
  for (int i = 0; i < model.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const BodyState& body = model.initial(i);
    const int s = model.body(i).mode_count();
    state.q.segment(layout.body_q[at], 7 + s) << body.r, body.L, body.a;
    state.v.segment(layout.body_v[at], 6 + s) << body.dr, body.w, body.da;
  }
  for (int i = 0; i < model.force_count(); ++i)
    state.z.segment(layout.force_z[static_cast<std::size_t>(i)], model.force(i).state_count()) =
        model.force(i).initial_state();
  state.load_work = Eigen::VectorXd::Zero(model.body_count());
  return state;
}

std::string number(double x) { return number_text(x, 3); }

// Names of the joints that own the given rows, each once, quoted.
std::string joint_names(const Model& model, const Layout& layout, const std::set<int>& rows) {
  std::set<int> joints;
  for (int row : rows) joints.insert(layout.row_joint[static_cast<std::size_t>(row)]);
  std::string out;
  for (int joint : joints) out += (out.empty() ? "\"" : ", \"") + model.joint(joint).name + "\"";
  return out;
}

// Cosine of the angle between the attitude a joint wants and the one it has, where dot products alone cannot
// tell a half turn.
double attitude_cosine(const Joint& joint, const PairMotion& pair, double t) {
  double smallest = 1.0;
  if (joint.kind == "fixed" || joint.kind == "prismatic") {
    for (int k = 0; k < 3; ++k)
      smallest = std::min(
          smallest,
          KinematicVector::axis(pair, 0, joint.m1, k).value().dot(KinematicVector::axis(pair, 1, joint.m2, k).value()));
  }
  for (const ConstraintRow& row : joint.rows) {
    if (!row.rotation) continue;  // cos(angle - f) = sin(f) e_j1.e_i2 + cos(f) e_i1.e_i2
    const double f = row.motion->at(t).value;
    const auto axis = [&](const Factor& factor) {
      return KinematicVector::axis(pair, factor.kind == Factor::Kind::kAxis1 ? 0 : 1,
                                   factor.kind == Factor::Kind::kAxis1 ? joint.m1 : joint.m2, factor.axis);
    };
    double cosine = 0.0;
    const double weight[2] = {std::sin(f), std::cos(f)};
    for (int i = 0; i < 2; ++i)
      cosine += weight[i] * axis(row.terms[i].alpha).value().dot(axis(row.terms[i].beta).value());
    smallest = std::min(smallest, cosine);
  }
  return smallest;
}

// Every joint that is open by more than the tolerance, all of them in one message.
double check_gaps(const Model& model, const Layout& layout, const DenseRows& rows, double t, double tolerance) {
  std::string findings;
  double largest = 0.0;
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joint(j);
    double gap2 = 0.0, angle = 0.0;
    for (std::size_t k = 0; k < joint.rows.size(); ++k) {
      const double phi = rows.phi[layout.joint_row[static_cast<std::size_t>(j)] + static_cast<int>(k)];
      if (joint.rows[k].unit == ConstraintRow::Unit::kLength) {
        gap2 += phi * phi;
      } else {
        angle = std::max(angle, std::abs(phi));
      }
    }
    const PairMotion pair = rows.kinematics().pair(joint.m1.body, joint.m2.body);
    if (attitude_cosine(joint, pair, t) < 0.0) angle = kPi;  // a half turn, which the sines above do not see
    const double gap = std::sqrt(gap2);
    largest = std::max({largest, gap, angle});
    const std::string where =
        (findings.empty() ? "" : "\n") + std::string("joint \"") + joint.name + "\" (" + joint.kind + "): ";
    if (!(gap <= tolerance)) {
      findings += where + "gap of " + number(gap) + " m in the initial position; at most " + number(tolerance) +
                  " m is closed silently. Check the positions of its bodies and its point.";
    } else if (!(angle <= tolerance)) {
      findings += where + "its axes are off by " + number((angle > 1.0 ? kPi : std::asin(angle)) * 180.0 / kPi) +
                  " degrees in the initial position. Check the attitudes of its bodies and its axes.";
    }
  }
  if (!findings.empty()) throw InputError(findings);
  return largest;
}

void check_contradiction(const Model& model, const Layout& layout, const Eigen::VectorXd& defect, double scale,
                         const std::string& what, const std::string& unit) {
  std::set<int> worst;
  double largest = 0.0;
  for (int row = 0; row < defect.size(); ++row) largest = std::max(largest, std::abs(defect[row]));
  if (largest <= kContradiction * scale) return;
  for (int row = 0; row < defect.size(); ++row) {
    if (std::abs(defect[row]) > 0.1 * largest) worst.insert(row);
  }
  throw InputError("joints " + joint_names(model, layout, worst) + " contradict each other: " + what + " by " +
                   number(largest) + " " + unit + ". Move one of them, or free one of its directions.");
}

}  // namespace

Assembly assemble(const Model& model, const AssemblyOptions& options) {
  const Layout layout(model, all_rows_of(model));
  Assembly out;
  out.state = initial_state(model, layout);
  if (!out.state.z.allFinite()) throw InputError("an inner state of a force element is not finite at the start.");
  if (layout.all_rows == 0) return out;
  DenseRows rows(model, layout);
  rows.evaluate(out.state);
  out.largest_gap = check_gaps(model, layout, rows, out.state.time, options.gap_tolerance);

  // Close the joints: Gauss-Newton with the smallest correction, until the gaps no longer fall.
  double last = HUGE_VAL;
  for (int i = 0; i < kMostClosingSteps; ++i) {
    const double now = rows.phi.lpNorm<Eigen::Infinity>();
    if (now <= 1e-15 || (now <= kClosed && now >= 0.5 * last)) break;
    last = now;
    add_increment(layout, rows.correction(rows.phi, kClosingRank), out.state.q);
    rows.evaluate(out.state);
  }
  check_contradiction(model, layout, rows.phi, 1.0, "together they cannot be closed; they stay open", "m or rad");

  // Velocities: the smallest change that satisfies Phi_v v + Phi_t = 0. Twice, for round-off.
  const Eigen::VectorXd v_given = out.state.v;
  for (int i = 0; i < 2; ++i) {
    out.state.v += rows.correction(rows.rate, options.rank_tolerance);
    rows.evaluate(out.state);
  }
  out.largest_speed_change = (out.state.v - v_given).lpNorm<Eigen::Infinity>();
  check_contradiction(model, layout, rows.rate, 1.0 + out.state.v.lpNorm<Eigen::Infinity>(), "their speeds differ",
                      "m/s or rad/s");

  // Independent rows: the pivots of a QR of B^T. The others are combinations of them: R11 X = R12.
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(options.rank_tolerance);
  qr.compute(rows.B.transpose());
  const Eigen::Index rank = qr.rank();
  const Eigen::VectorXi order = qr.colsPermutation().indices();
  out.kept_rows.assign(order.data(), order.data() + rank);
  std::sort(out.kept_rows.begin(), out.kept_rows.end());
  if (rank == layout.all_rows) return out;

  const Eigen::MatrixXd R = qr.matrixR().topRows(rank);
  const Eigen::MatrixXd X =
      R.leftCols(rank).triangularView<Eigen::Upper>().solve(Eigen::MatrixXd(R.rightCols(layout.all_rows - rank)));
  std::vector<int> dropped(static_cast<std::size_t>(model.joint_count()), 0);
  std::vector<std::set<int>> sources(static_cast<std::size_t>(model.joint_count()));
  for (Eigen::Index k = 0; k < X.cols(); ++k) {
    const std::size_t joint = static_cast<std::size_t>(layout.row_joint[static_cast<std::size_t>(order[rank + k])]);
    ++dropped[joint];
    for (Eigen::Index i = 0; i < rank; ++i) {
      if (std::abs(X(i, k)) > 1e-6) sources[joint].insert(order[i]);
    }
  }
  for (int j = 0; j < model.joint_count(); ++j) {
    const std::size_t at = static_cast<std::size_t>(j);
    if (dropped[at] > 0)
      out.notes.push_back("joint \"" + model.joint(j).name + "\": " + std::to_string(dropped[at]) + " of its " +
                          std::to_string(model.joint(j).rows.size()) + " conditions follow from " +
                          joint_names(model, layout, sources[at]) + " and are left out (redundant).");
  }
  return out;
}

}  // namespace footfall
