// Shape integrals over the nodes, then forces of inertia and their derivatives as sums over one or two modes (theory 1.2).

#include "mbd_solver/model/modal_inertia.h"

#include <Eigen/Eigenvalues>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/mass_properties.h"

namespace footfall {
namespace {

using Vec = Eigen::Ref<const Eigen::VectorXd>;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kRoundOff = 1e-12;  // of the largest modal mass: smaller off-diagonal terms are zero
constexpr double kZeroSum = 1e-8;    // of the largest sum over two modes: smaller ones are round-off

// A body without inertia about some axis has a singular mass matrix.
void require_positive_mass(double mass, const Matrix3d& inertia, const std::string& body) {
  const std::string who = body.empty() ? "body" : "body \"" + body + "\"";
  if (!(mass > 0.0))
    throw InputError(code::kMassProperties, who + ": mass is " + plain_text(mass) + " kg, expected a positive number.");
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(moments.minCoeff() > 0.0) || !inertia.allFinite())
    throw InputError(code::kMassProperties,
                     who + ": smallest principal moment of inertia is " + plain_text(moments.minCoeff()) +
                         " kg m2, expected a symmetric positive definite inertia about the centre of mass.");
}

}  // namespace

ModalInertia::ModalInertia(double mass, const Matrix3d& inertia)
    : mass_(mass),
      S0_(Vector3d::Zero()),
      S1_(3, 0),
      J0_(0.5 * (inertia + inertia.transpose())),
      J1_(6, 0),
      C0_(3, 0),
      pairs_(0, 0),
      Mff_(0, 0),
      K_(0),
      C_(0) {
  require_positive_mass(mass_, J0_, "");
}

ModalInertia::ModalInertia(const ModalBody& body)
    : modes_(body.mode_count()), S0_(Vector3d::Zero()), J0_(Matrix3d::Zero()), K_(body.stiffness), C_(body.damping) {
  const Index s = modes_;
  const Index nodes = body.node_count();
  FOOTFALL_DEMAND(body.node_mass.size() == nodes);
  FOOTFALL_DEMAND(static_cast<Index>(body.node_inertia.size()) == nodes);
  FOOTFALL_DEMAND(body.Phi.rows() == 3 * nodes && body.Phi.cols() == s);
  FOOTFALL_DEMAND(body.Psi.cols() == s);
  FOOTFALL_DEMAND(body.Psi.rows() == 3 * nodes + std::max<Index>(0, body.mass.rows() - 6 * nodes));
  FOOTFALL_DEMAND(body.damping.size() == s);
  if (s > 0) axes_ = principal_axes(body);
  turned_ = !axes_.isIdentity(0.0);
  S1_.setZero(3, s);
  J1_.setZero(6, s);
  C0_.setZero(3, s);
  pairs_.setZero(9 * s, s);
  Mff_.setZero(s, s);

  if (body.mass.size() > 0)
    sum_over_mass_matrix(body);
  else
    sum_over_nodes(body);
  J0_ = 0.5 * (J0_ + J0_.transpose()).eval();
  Mff_ = 0.5 * (Mff_ + Mff_.transpose()).eval();
  if (s > 0) {
    // Modes are orthogonal up to round-off, unless masses were added to the body.
    const Eigen::MatrixXd mass = Mff_.diagonal().asDiagonal();
    if ((Mff_ - mass).cwiseAbs().maxCoeff() <= kRoundOff * mass.maxCoeff()) Mff_ = mass;
    orthogonal_ = Mff_.isDiagonal(0.0);
    pairs_ = (pairs_.array().abs() > kZeroSum * pairs_.cwiseAbs().maxCoeff()).select(pairs_, 0.0).eval();
  }
  Eigen::MatrixXd parts(6 * s, s);
  for (int k = 0; k < modes_; ++k)
    for (int l = 0; l < modes_; ++l) {
      parts.block<3, 1>(3 * k, l) = coupling_slope(l, k) - coupling_slope(k, l);
      parts.block<3, 1>(3 * s + 3 * k, l) = 0.5 * (coupling_slope(l, k) + coupling_slope(k, l));
    }
  by_a_ = ColumnGroups(pairs_);
  by_da_ = ColumnGroups(parts);
  const Vector3d c = S0_ / (mass_ > 0.0 ? mass_ : 1.0);
  require_positive_mass(mass_, J0_ + mass_ * skew(c) * skew(c), body.name);
}

void ModalInertia::sum_over_nodes(const ModalBody& body) {
  const Index s = modes_;
  for (Index j = 0; j < body.node_count(); ++j) {
    const double m = body.node_mass(j);
    const Matrix3d J = axes_.transpose() * body.node_inertia[j] * axes_;
    const Vector3d rho0 = axes_.transpose() * body.rho0.col(j);
    const Matrix3d rho = skew(rho0);
    const Eigen::Matrix3Xd Phi = axes_.transpose() * body.Phi.middleRows(3 * j, 3);
    const Eigen::Matrix3Xd Psi = axes_.transpose() * body.Psi.middleRows(3 * j, 3);
    mass_ += m;
    S0_ += m * rho0;
    S1_ += m * Phi;
    J0_ += J - m * rho * rho;
    C0_ += m * rho * Phi + J * Psi;
    Mff_ += m * Phi.transpose() * Phi + Psi.transpose() * J * Psi;
    const bool turns = !J.isZero(0.0) && !Psi.isZero(0.0);
    if (m == 0.0 && !turns) continue;
    for (Index k = 0; k < s; ++k) {
      const Vector3d phi_k = Phi.col(k), t_k = Psi.col(k);
      const Matrix3d phi = skew(phi_k), t = skew(t_k);
      J1_.col(k) += twice_symmetric(-m * rho * phi + t * J);
      for (Index l = 0; l < s; ++l) {
        const Vector3d phi_l = Phi.col(l), t_l = Psi.col(l);
        pairs_.block<3, 1>(6 * s + 3 * k, l) +=
            m * phi_l.cross(phi_k) + t_l.cross(J * t_k) - 0.5 * (J * t_l.cross(t_k));
        Matrix3d half = -m * skew(phi_l) * phi;
        if (turns) half += 0.5 * (skew(t_l) * t + t * skew(t_l)) * J - skew(t_l) * J * t;
        pairs_.block<6, 1>(6 * k, l) += twice_symmetric(half);
      }
    }
  }
}

namespace {

using Rows3 = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// Every vector of three in x, rotated; the last `extra` rows are no vectors.
Eigen::MatrixXd turned(const Eigen::MatrixXd& x, const Matrix3d& R, Index extra) {
  Eigen::MatrixXd out(x.rows(), x.cols());
  const Index vectors = x.rows() - extra;
  for (Index i = 0; i + 2 < vectors; i += 3) out.middleRows(i, 3) = R * x.middleRows(i, 3);
  out.bottomRows(extra) = x.bottomRows(extra);
  return out;
}

// A mode at one node: displacement and rotation.
struct NodeShape {
  Vector3d phi, t;
  NodeShape(const Eigen::MatrixXd& U, Index node, Index mode)
      : phi(U.block<3, 1>(6 * node, mode)), t(U.block<3, 1>(6 * node + 3, mode)) {}
};

}  // namespace

// Velocities along the axes of the nodes, which turn by t: u_j = (1 - t~ + 1/2 t~ t~) (dr + w x rho_j + Phi_j da) and
// (1 - t~ + 1/2 t~ t~) w + (1 - 1/2 t~) Psi_j da. With R their part by dr and w at a = 0, U = [Phi; Psi], and by w
//   P_k = du/da_k = [-phi_k~ + t_k~ rho~; -t_k~],
//   P_lk = d2u/da_l da_k = [t_l~ phi_k~ + t_k~ phi_l~ - T rho~; T],   T = 1/2 (t_l~ t_k~ + t_k~ t_l~)
// and by da_k  Q_lk = [-t_l x phi_k; -1/2 t_l x t_k], the integrals follow from 1/2 u^T M u. The part by dr keeps its value
// at a = 0, so that the mass is constant.
void ModalInertia::sum_over_mass_matrix(const ModalBody& body) {
  const Index s = modes_, nodes = body.node_count();
  const Index extra = body.Psi.rows() - 3 * nodes;
  FOOTFALL_DEMAND(body.mass.rows() == 6 * nodes + extra && body.mass.cols() == 6 * nodes + extra);
  const Eigen::Matrix3Xd rho0 = axes_.transpose() * body.rho0;
  Eigen::MatrixXd U(6 * nodes + extra, s);
  U.bottomRows(extra) = body.Psi.bottomRows(extra);
  for (Index j = 0; j < nodes; ++j) {
    U.middleRows(6 * j, 3) = axes_.transpose() * body.Phi.middleRows(3 * j, 3);
    U.middleRows(6 * j + 3, 3) = axes_.transpose() * body.Psi.middleRows(3 * j, 3);
  }
  const auto times_mass = [&](const Eigen::MatrixXd& x) {
    return turned(body.mass * turned(x, axes_, extra), axes_.transpose(), extra);
  };
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(6 * nodes + extra, 6);
  R.topRows(6 * nodes) = rigid_motions(rho0);
  const Eigen::MatrixXd MR = times_mass(R), MU = times_mass(U);
  const Eigen::MatrixXd rigid = R.transpose() * MR;
  const Matrix3d S = 0.5 * (rigid.block<3, 3>(3, 0) - rigid.block<3, 3>(3, 0).transpose());
  mass_ = rigid.topLeftCorner<3, 3>().trace() / 3.0;
  S0_ = {S(2, 1), S(0, 2), S(1, 0)};
  J0_ = rigid.bottomRightCorner<3, 3>();
  S1_ = MR.leftCols<3>().transpose() * U;
  C0_ = MR.rightCols<3>().transpose() * U;
  Mff_ = U.transpose() * MU;
  const Rows3 MRw = MR.rightCols<3>();
  const bool turns = !body.Psi.topRows(3 * nodes).isZero(0.0);
  Rows3 P = Rows3::Zero(6 * nodes + extra, 3);
  for (Index k = 0; k < s; ++k) {
    for (Index j = 0; j < nodes; ++j) {
      const NodeShape of_k(U, j, k);
      P.middleRows<3>(6 * j) = -skew(of_k.phi) + skew(of_k.t) * skew(Vector3d(rho0.col(j)));
      P.middleRows<3>(6 * j + 3) = -skew(of_k.t);
    }
    const Rows3 MP = times_mass(P);
    J1_.col(k) = twice_symmetric(P.transpose() * MRw);
    for (Index l = 0; l < s; ++l) {
      Vector3d slope = P.transpose() * MU.col(l);  // dC_l/da_k
      Matrix3d half = Matrix3d::Zero();            // of J2_lk, the same as of J2_kl
      for (Index j = 0; j < nodes; ++j) {
        const NodeShape of_k(U, j, k), of_l(U, j, l);
        const Matrix3d MRw_u = MRw.middleRows<3>(6 * j), MRw_t = MRw.middleRows<3>(6 * j + 3);
        const Matrix3d t_k = skew(of_k.t), t_l = skew(of_l.t);
        if (turns) slope -= MRw_u.transpose() * (t_k * of_l.phi) + 0.5 * MRw_t.transpose() * (t_k * of_l.t);
        if (l > k) continue;
        const Matrix3d phi_k = skew(of_k.phi), phi_l = skew(of_l.phi);
        half += phi_l * MP.middleRows<3>(6 * j);
        if (!turns) continue;
        const Matrix3d rho = skew(Vector3d(rho0.col(j))), T = 0.5 * (t_l * t_k + t_k * t_l);
        half += rho * t_l * MP.middleRows<3>(6 * j) + t_l * MP.middleRows<3>(6 * j + 3) +
                MRw_u.transpose() * (t_l * phi_k + t_k * phi_l - T * rho) + MRw_t.transpose() * T;
      }
      pairs_.block<3, 1>(6 * s + 3 * l, k) = slope;
      if (l <= k) pairs_.block<6, 1>(6 * k, l) = pairs_.block<6, 1>(6 * l, k) = twice_symmetric(half);
    }
  }
}

Vector3d ModalInertia::to_principal(const Vector3d& x) const { return turned_ ? axes_.transpose() * x : x; }

Vector3d ModalInertia::to_body(const Vector3d& x) const { return turned_ ? axes_ * x : x; }

void ModalInertia::rows_to_body(Eigen::Ref<Eigen::MatrixXd> A) const {
  if (!turned_) return;
  for (Index k = 0; k < A.cols(); ++k)
    for (Index i : {0, 3}) A.block<3, 1>(i, k) = to_body(A.block<3, 1>(i, k));
}

void ModalInertia::columns_to_body(Eigen::Ref<Eigen::MatrixXd> A) const {
  if (!turned_) return;
  for (Index k = 0; k < A.rows(); ++k)
    for (Index i : {0, 3}) A.block<1, 3>(k, i) = to_body(A.block<1, 3>(k, i).transpose()).transpose();
}

Vector3d ModalInertia::first_moment(const Vec& a) const {
  Vector3d S = S0_;
  for (Index k = 0; k < modes_; ++k) S += a(k) * S1_.col(k);
  return S;
}

Vector3d ModalInertia::coupling(int k, const Vec& a) const {
  Vector3d C = C0_.col(k);
  for (int l = 0; l < modes_; ++l) C += a(l) * coupling_slope(l, k);
  return C;
}

Symmetric ModalInertia::inertia_slope(int k, const Vec& a) const {
  Symmetric dJ = J1_.col(k);
  for (int l = 0; l < modes_; ++l) dJ += a(l) * inertia_curvature(l, k);
  return dJ;
}

// J = J0 + sum_k a_k (J1_k + 1/2 sum_l a_l J2_lk) = J0 + 1/2 sum_k a_k (J1_k + dJ/da_k)
Matrix3d ModalInertia::inertia(const Vec& a) const {
  Symmetric J = Symmetric::Zero();
  for (int k = 0; k < modes_; ++k) J += 0.5 * a(k) * (J1_.col(k) + inertia_slope(k, a));
  return J0_ + matrix(J);
}

void ModalInertia::sum_by_a(const Vec& a, Scratch& scratch) const {
  scratch.by_a.head(6 * modes_) = J1_.reshaped();
  scratch.by_a.tail(3 * modes_) = C0_.reshaped();
  by_a_.add_product(a, scratch.by_a, scratch.sums);
}

void ModalInertia::times_modal_mass(const Vec& x, Eigen::Ref<Eigen::VectorXd> out) const {
  if (orthogonal_) {
    out = Mff_.diagonal().cwiseProduct(x);
  } else {
    out.noalias() = Mff_ * x;
  }
}

// M = [m I, -S~, S1; S~, J, C; S1^T, C^T, Mff]
void ModalInertia::mass_matrix(const Vec& a, Eigen::Ref<Eigen::MatrixXd> M) const {
  FOOTFALL_DEMAND(a.size() == modes_ && M.rows() == 6 + modes_ && M.cols() == 6 + modes_);
  const Matrix3d S = skew(to_body(first_moment(a)));
  Matrix3d J = inertia(a);
  if (turned_) J = (axes_ * J * axes_.transpose()).eval();
  M.topLeftCorner<3, 3>() = mass_ * Matrix3d::Identity();
  M.block<3, 3>(0, 3) = -S;
  M.block<3, 3>(3, 0) = S;
  M.block<3, 3>(3, 3) = 0.5 * (J + J.transpose());
  for (int k = 0; k < modes_; ++k) {
    const Vector3d S1 = to_body(S1_.col(k)), C = to_body(coupling(k, a));
    M.block<3, 1>(0, 6 + k) = S1;
    M.block<3, 1>(3, 6 + k) = C;
    M.block<1, 3>(6 + k, 0) = S1.transpose();
    M.block<1, 3>(6 + k, 3) = C.transpose();
  }
  M.bottomRightCorner(modes_, modes_) = Mff_;
}

void ModalInertia::mass_product(const Vec& a, const Vec& x, Scratch& scratch, Eigen::Ref<Eigen::VectorXd> out) const {
  const Index s = modes_;
  FOOTFALL_DEMAND(a.size() == s && x.size() == 6 + s && out.size() == 6 + s && scratch.by_a.size() == 9 * s);
  const Vector3d r = to_principal(x.head<3>()), w = to_principal(x.segment<3>(3));
  sum_by_a(a, scratch);
  const Vector3d S = first_moment(a);
  Vector3d force = mass_ * r + w.cross(S), moment = S.cross(r);
  Symmetric J_by_a = Symmetric::Zero();
  times_modal_mass(x.tail(s), out.tail(s));
  for (Index k = 0; k < s; ++k) {
    const Eigen::Map<const Symmetric> J1(&J1_(0, k)), dJ(&scratch.by_a(6 * k));
    const Eigen::Map<const Vector3d> S1(&S1_(0, k)), C(&scratch.by_a(6 * s + 3 * k));
    J_by_a += 0.5 * a(k) * (J1 + dJ);
    force += x(6 + k) * S1;
    moment += x(6 + k) * C;
    out(6 + k) += S1.dot(r) + C.dot(w);
  }
  const Matrix3d J = J0_ + matrix(J_by_a);
  out.head<3>() = to_body(force);
  out.segment<3>(3) = to_body(moment + J * w);
}

// g = M(a) dv + h(a, v); with dJ = sum_k da_k dJ/da_k, dC = sum_k da_k dC/da_k the part h is
// force:   2 w x (S1 da) + w x (w x S)
// moment:  dJ w + w x (J w + C da) + dC da
// modal k: -1/2 w . dJ/da_k w + w . sum_l da_l (dC_k/da_l - dC_l/da_k) + C_k da_k + K_k a_k
// All sums over two modes are two products. dC da is a sum over pairs of modes; only their symmetric part contributes.
void ModalInertia::inertia_force(const Vec& a, const Vec& v, const Vec& dv, Scratch& scratch,
                                 Eigen::Ref<Eigen::VectorXd> g) const {
  const Index s = modes_;
  FOOTFALL_DEMAND(a.size() == s && v.size() == 6 + s && dv.size() == 6 + s && g.size() == 6 + s);
  FOOTFALL_DEMAND(scratch.by_a.size() == 9 * s && scratch.by_da.size() == 6 * s);
  const Vector3d w = to_principal(v.segment<3>(3)), ddr = to_principal(dv.head<3>());
  const Vector3d dw = to_principal(dv.segment<3>(3));
  const auto da = v.tail(s), dda = dv.tail(s);
  sum_by_a(a, scratch);
  scratch.by_da.setZero();
  by_da_.add_product(da, scratch.by_da, scratch.sums);

  const Vector3d S = first_moment(a);
  const Symmetric half_squares = 0.5 * squares(w);
  Vector3d S1_da = Vector3d::Zero(), S1_dda = Vector3d::Zero();
  Vector3d C_da = Vector3d::Zero(), C_dda = Vector3d::Zero(), dC_da = Vector3d::Zero();
  Symmetric J_by_a = Symmetric::Zero(), dJ_da = Symmetric::Zero();
  times_modal_mass(dda, g.tail(s));
  for (Index k = 0; k < s; ++k) {
    const Eigen::Map<const Symmetric> J1(&J1_(0, k)), dJ(&scratch.by_a(6 * k));
    const Eigen::Map<const Vector3d> S1(&S1_(0, k)), C(&scratch.by_a(6 * s + 3 * k));
    const Eigen::Map<const Vector3d> gyroscopic(&scratch.by_da(3 * k)), dC(&scratch.by_da(3 * s + 3 * k));
    J_by_a += 0.5 * a(k) * (J1 + dJ);
    dJ_da += da(k) * dJ;
    S1_da += da(k) * S1;
    S1_dda += dda(k) * S1;
    C_da += da(k) * C;
    C_dda += dda(k) * C;
    dC_da += da(k) * dC;
    g(6 + k) += S1.dot(ddr) + C.dot(dw) + w.dot(gyroscopic) - half_squares.dot(dJ) + C_(k) * da(k) + K_(k) * a(k);
  }
  const Matrix3d J = J0_ + matrix(J_by_a);
  const Vector3d H = J * w + C_da;
  g.head<3>() = to_body(mass_ * ddr + dw.cross(S) + S1_dda + 2.0 * w.cross(S1_da) + w.cross(w.cross(S)));
  g.segment<3>(3) = to_body(S.cross(ddr) + J * dw + C_dda + matrix(dJ_da) * w + dC_da + w.cross(H));
}

double ModalInertia::kinetic_energy(const Vec& a, const Vec& v) const {
  FOOTFALL_DEMAND(a.size() == modes_ && v.size() == 6 + modes_);
  const Vector3d dr = to_principal(v.head<3>());
  const Vector3d w = to_principal(v.segment<3>(3));
  double T = 0.5 * mass_ * dr.squaredNorm() + dr.dot(w.cross(first_moment(a))) + 0.5 * w.dot(inertia(a) * w);
  for (int k = 0; k < modes_; ++k) {
    const double da = v(6 + k);
    double Mda = 0.0;
    for (int l = 0; l < modes_; ++l) Mda += Mff_(l, k) * v(6 + l);
    T += da * (dr.dot(S1_.col(k)) + w.dot(coupling(k, a)) + 0.5 * Mda);
  }
  return T;
}

double ModalInertia::strain_energy(const Vec& a) const { return 0.5 * (K_.array() * a.array().square()).sum(); }

double ModalInertia::damping_power(const Vec& da) const { return (C_.array() * da.array().square()).sum(); }

Vector3d ModalInertia::centre_of_mass(const Vec& a) const { return to_body(first_moment(a)) / mass_; }

// Row by row the derivatives of g = M(a) dv + h(a, v), with dv = [ddr; dw; dda]; see inertia_force().
void ModalInertia::derivatives(const Vec& a, const Vec& v, const Vec& dv, Eigen::Ref<Eigen::MatrixXd> dg_da,
                               Eigen::Ref<Eigen::MatrixXd> dg_dv) const {
  const Eigen::Index size = 6 + modes_;
  FOOTFALL_DEMAND(a.size() == modes_ && v.size() == size && dv.size() == size);
  FOOTFALL_DEMAND(dg_da.rows() == size && dg_da.cols() == modes_ && dg_dv.rows() == size && dg_dv.cols() == size);
  const Vector3d w = to_principal(v.segment<3>(3));
  const Vector3d ddr = to_principal(dv.head<3>());
  const Vector3d dw = to_principal(dv.segment<3>(3));
  const Matrix3d wx = skew(w);
  const Vector3d S = first_moment(a);
  const Symmetric half_squares = 0.5 * squares(w);
  Matrix3d J = J0_, J_rate = Matrix3d::Zero();
  Vector3d S1da = Vector3d::Zero(), Cda = Vector3d::Zero();
  for (int k = 0; k < modes_; ++k) {
    const double da = v(6 + k);
    const Matrix3d dJ = matrix(inertia_slope(k, a));
    const Vector3d S1 = S1_.col(k);
    Vector3d C = C0_.col(k);
    Vector3d to_dda = Vector3d::Zero();      // (dC/da_k) dda
    Vector3d to_da = Vector3d::Zero();       // (dC/da_k) da
    Vector3d C_rate = Vector3d::Zero();      // dC_k
    Symmetric dJ_rates = Symmetric::Zero();  // sum_l da_l d2J/da_l da_k
    for (int l = 0; l < modes_; ++l) {
      const Vector3d c_lk = coupling_slope(l, k), c_kl = coupling_slope(k, l);
      const Symmetric J2_lk = inertia_curvature(l, k);
      C += a(l) * c_lk;
      to_dda += dv(6 + l) * c_kl;
      to_da += v(6 + l) * c_kl;
      C_rate += v(6 + l) * c_lk;
      dJ_rates += v(6 + l) * J2_lk;
      dg_da(6 + k, l) = dw.dot(c_lk) - half_squares.dot(J2_lk);
      dg_dv(6 + k, 6 + l) = w.dot(c_lk - c_kl);
    }
    const Matrix3d dJ_rate = matrix(dJ_rates);
    J += 0.5 * a(k) * (matrix(J1_.col(k)) + dJ);
    J_rate += da * dJ;
    S1da += da * S1;
    Cda += da * C;
    dg_da(6 + k, k) += K_(k);
    dg_dv(6 + k, 6 + k) += C_(k);
    dg_da.block<3, 1>(0, k) = dw.cross(S1) + w.cross(w.cross(S1));
    dg_da.block<3, 1>(3, k) = S1.cross(ddr) + dJ * dw + to_dda + dJ_rate * w + w.cross(dJ * w + to_da);
    dg_dv.block<3, 1>(0, 6 + k) = 2.0 * w.cross(S1);
    dg_dv.block<3, 1>(3, 6 + k) = dJ * w + w.cross(C) + C_rate + to_da;
    dg_dv.block<1, 3>(6 + k, 3) = (C_rate - to_da - dJ * w).transpose();
  }
  dg_dv.leftCols<3>().setZero();
  dg_dv.block<3, 3>(0, 3) = -2.0 * skew(S1da) - skew(w.cross(S)) - wx * skew(S);
  dg_dv.block<3, 3>(3, 3) = J_rate + wx * J - skew(J * w + Cda);
  rows_to_body(dg_da);
  rows_to_body(dg_dv);
  columns_to_body(dg_dv);
}

}  // namespace footfall
