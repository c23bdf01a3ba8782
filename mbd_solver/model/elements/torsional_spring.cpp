#include "mbd_solver/model/elements/torsional_spring.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/model/elements/dot_product.h"
#include "mbd_solver/model/joints/whole_turns.h"

namespace footfall {
namespace {

// s = y1.x2, c = x1.x2 with their rates, and the angle on the turn of z.
struct Angle {
  Angle(const ElementInput& in, const Marker& m1, const Marker& m2) : Angle(in.pair, m1, m2) {
    phi = std::atan2(s, c);
    if (in.z.size() > 0) phi += 2.0 * kPi * std::round((in.z[0] - phi) / (2.0 * kPi));
  }
  double rate() const { return (c * ds - s * dc) / rho; }

  KinematicVector x1, y1, x2;
  double s, c, ds, dc, rho;
  double phi = 0.0;

 private:
  Angle(const PairMotion& pair, const Marker& m1, const Marker& m2)
      : x1(KinematicVector::axis(pair, 0, m1, 0)),
        y1(KinematicVector::axis(pair, 0, m1, 1)),
        x2(KinematicVector::axis(pair, 1, m2, 0)),
        s(y1.value().dot(x2.value())),
        c(x1.value().dot(x2.value())),
        ds(dot_rate(y1, x2)),
        dc(dot_rate(x1, x2)),
        rho(s * s + c * c) {}
};

}  // namespace

TorsionalSpring::TorsionalSpring(std::string name, Marker m1, Marker m2, const Parameters& parameters)
    : ForceElement(std::move(name), m1.body, m2.body), m1_(std::move(m1)), m2_(std::move(m2)), parameters_(parameters) {
  if (!(parameters_.stiffness >= 0.0 && parameters_.damping >= 0.0))
    throw InputError("spring \"" + this->name() + "\": stiffness and damping must not be negative.");
  const Eigen::Index n = 12 + m1_.S.cols() + m2_.S.cols();
  sine_.resize(n);
  cosine_.resize(n);
  scratch_.resize(n);
}

void TorsionalSpring::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q,
                                Eigen::Ref<Eigen::VectorXd> dz) const {
  // Q = T dphi/dx,  dphi = (c ds - s dc) / rho
  const Angle at(in, m1_, m2_);
  const double T = -parameters_.stiffness * (at.phi - parameters_.free_angle) - parameters_.damping * at.rate();
  add_dot(at.y1, at.x2, T * at.c / at.rho, Q);
  add_dot(at.x1, at.x2, -T * at.s / at.rho, Q);
  if (dz.size() > 0) dz[0] = at.rate() + kTurnFollow * (at.phi - in.z[0]);
}

bool TorsionalSpring::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  const Angle at(in, m1_, m2_);
  const Eigen::Index n = in.pair.size();
  const double k = parameters_.stiffness, d = parameters_.damping;
  const double rate = at.rate();
  const double T = -k * (at.phi - parameters_.free_angle) - d * rate;
  Eigen::Ref<Eigen::VectorXd> S = sine_.head(n), C = cosine_.head(n), row = scratch_.head(n);
  S.setZero();
  C.setZero();
  add_dot(at.y1, at.x2, 1.0, S);
  add_dot(at.x1, at.x2, 1.0, C);

  // dphi'/dx,  rho phi' = c s' - s c'
  row.setZero();
  add_dot_rate(at.y1, at.x2, at.c / at.rho, row);
  add_dot_rate(at.x1, at.x2, -at.s / at.rho, row);
  row += (at.ds / at.rho - 2.0 * at.c * rate / at.rho) * C - (at.dc / at.rho + 2.0 * at.s * rate / at.rho) * S;
  if (state_count() > 0) {  // the turn is constant: dphi/dz = 0
    out.ddz_dx.row(0) += (row + (kTurnFollow * at.c / at.rho) * S - (kTurnFollow * at.s / at.rho) * C).transpose();
    out.ddz_dv.row(0) += ((at.c / at.rho) * S - (at.s / at.rho) * C).transpose();
    out.ddz_dz(0, 0) -= kTurnFollow;
  }
  // T by x: -k dphi/dx - d dphi'/dx
  row *= -d;
  row += (-k * at.c / at.rho) * S + (k * at.s / at.rho) * C;
  for (Eigen::Index j = 0; j < n; ++j) {
    const double phi_j = (at.c * S[j] - at.s * C[j]) / at.rho;        // dphi/dx_j = dphi'/dv_j
    const double rho_j = 2.0 * (at.s * S[j] + at.c * C[j]) / at.rho;  // (drho/dx_j) / rho
    // d(T c / rho)/dx S - d(T s / rho)/dx C
    const double by_s = (row[j] * at.c + T * C[j] - T * at.c * rho_j) / at.rho;
    const double by_c = (row[j] * at.s + T * S[j] - T * at.s * rho_j) / at.rho;
    out.dQ_dx.col(j) += by_s * S - by_c * C;
    out.dQ_dv.col(j) += (-d * phi_j * at.c / at.rho) * S + (d * phi_j * at.s / at.rho) * C;
  }
  add_dot_second(at.y1, at.x2, T * at.c / at.rho, out.dQ_dx);
  add_dot_second(at.x1, at.x2, -T * at.s / at.rho, out.dQ_dx);
  return true;
}

void TorsionalSpring::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  const Eigen::Vector3d at = sample(in);
  const double stretch = at[0] - parameters_.free_angle;
  stored[Stored::kStrain] += 0.5 * parameters_.stiffness * stretch * stretch;
  power[Dissipation::kDamper] += parameters_.damping * at[1] * at[1];
}

Eigen::Vector3d TorsionalSpring::sample(const ElementInput& in) const {
  const Angle at(in, m1_, m2_);
  const double phi = at.phi, rate = at.rate();
  return {phi, rate, -parameters_.stiffness * (phi - parameters_.free_angle) - parameters_.damping * rate};
}

}  // namespace footfall
