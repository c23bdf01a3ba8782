// The same operations as in curved_contact.cpp and contact_law.cpp, in the same order.

#include "mbd_solver/model/elements/contact_lanes.h"

#include <algorithm>

#include "mbd_solver/base/lanes.h"

namespace footfall {
namespace {

enum Column {  // three for vectors of W, two for numbers along the tangents
  kShare,
  kArm,                   // d [m]
  kNormal = kArm + 3,     // n
  kMotion = kNormal + 3,  // dp [m/s]
  kOver = kMotion + 3,    // g, the velocity over the ground [m/s]
  kForce = kOver + 3,     // [N]
  kHeld = kForce + 3,     // P xi / tau [m/s]
  kSlip = kHeld + 3,      // u [m/s]
  kSpring = kSlip + 3,    // T^T xi / tau [m/s]
  kDrive = kSpring + 2,   // T^T clip(u) [m/s]
  kRate = kDrive + 2,     // of T^T xi [m/s]
  kOverlap = kRate + 2,   // delta [m]
  kClosing,               // delta' [m/s]
  kInverse,               // 1 / sqrt(u^2 + v_s^2) [s/m]
  kElastic,               // k delta^1.5 [N]
  kPressed,               // f_n [N]
  kStored,                // [J]
  kDamped,                // [W]
  kRubbed,                // [W]
  kColumns
};

struct Table {
  double* of;
  std::ptrdiff_t apart;
  int count;
  double* column(int k) const { return of + k * apart; }
};

// Along the tangents of n, T = R(z -> n) [e_x e_y]: T s = (s - c a m, -a) with m = (n_x, n_y), a = m.s, c = 1 / (1 + n_z).
template <class L>
FOOTFALL_IN_LINE typename L::Real turn_of(const typename L::Vector& n) {
  const typename L::Real least = L::all(1e-6), by = 1.0 + n.z;
  return 1.0 / (by > least ? by : least);
}
template <class L>
FOOTFALL_IN_LINE typename L::Vector along(const typename L::Vector& n, const typename L::Real& x,
                                          const typename L::Real& y) {
  const typename L::Real c = turn_of<L>(n), a = n.x * x + n.y * y;
  return {x - c * a * n.x, y - c * a * n.y, -a};
}

template <class L>
FOOTFALL_IN_LINE void apply_law(const Table& at, const ContactLaw& law, const Eigen::Vector3d& dr,
                                const Eigen::Vector3d& w) {
  using Real = typename L::Real;
  using Vector = typename L::Vector;
  for (int i = 0; i < at.count; i += L::kCount) {
    const auto column = [&](int k) { return at.column(k) + i; };
    const Vector n = L::load(column(kNormal), at.apart), d = L::load(column(kArm), at.apart);
    Vector g = L::load(column(kMotion), at.apart);
    g.x += dr.x() + (w.y() * d.z - w.z() * d.y);
    g.y += dr.y() + (w.z() * d.x - w.x() * d.z);
    g.z += dr.z() + (w.x() * d.y - w.y() * d.x);
    const Real closing = -n.dot(g), overlap = L::load(column(kOverlap));
    const Vector spring = along<L>(n, L::load(column(kSpring)), L::load(column(kSpring + 1)));
    const Vector held = spring - n * n.dot(spring), u = g + n * closing + held;
    const Real inverse = 1.0 / L::square_root(u.dot(u) + law.slip_speed * law.slip_speed);
    const Real elastic = law.stiffness * L::load(column(kShare)) * overlap * L::square_root(overlap);
    Real damped = law.damping * closing, pressed;
    for (int k = 0; k < L::kCount; ++k) damped[k] = damped[k] < 0.0 ? std::exp(damped[k]) : 1.0 + damped[k];
    pressed = elastic * damped;
    const Vector force = (n - u * (law.friction * inverse)) * pressed;
    // clip(u) along the tangents: T^T y = (y_x, y_y) - (c (m.y) + y_z) m
    const Real size = L::square_root(u.dot(u)), most = L::all(ContactLaw::kStretch * law.slip_speed);
    const Real clip = size > most ? most / size : L::all(1.0);
    const Vector y = u * clip;
    const Real f = turn_of<L>(n) * (n.x * y.x + n.y * y.y) + y.z;
    L::store(g, column(kOver), at.apart);
    L::store(force, column(kForce), at.apart);
    L::store(held, column(kHeld), at.apart);
    L::store(u, column(kSlip), at.apart);
    L::store(y.x - f * n.x, column(kDrive));
    L::store(y.y - f * n.y, column(kDrive + 1));
    L::store(closing, column(kClosing));
    L::store(inverse, column(kInverse));
    L::store(elastic, column(kElastic));
    L::store(pressed, column(kPressed));
  }
}

template <class L>
FOOTFALL_IN_LINE void find_energies(const Table& at, const ContactLaw& law) {
  using Real = typename L::Real;
  using Vector = typename L::Vector;
  const double mu = law.friction, tau = law.stick_time, v_s = law.slip_speed;
  for (int i = 0; i < at.count; i += L::kCount) {
    const auto column = [&](int k) { return at.column(k) + i; };
    const auto vector = [&](int k) { return L::load(column(k), at.apart); };
    const Vector n = vector(kNormal), held = vector(kHeld);
    const Real elastic = L::load(column(kElastic)), pressed = L::load(column(kPressed)),
               overlap = L::load(column(kOverlap)), closing = L::load(column(kClosing));
    Real stored = 0.4 * elastic * overlap;
    Real rubbed = mu * pressed * L::load(column(kInverse)) * vector(kSlip).dot(vector(kOver) + n * closing);
    if (tau > 0.0) {  // Stored mu f psi(P xi), f = k delta^1.5: its rate is not dissipated.
      const Vector rate = along<L>(n, L::load(column(kRate)), L::load(column(kRate + 1)));
      const Real root = L::square_root(held.dot(held) + v_s * v_s), psi = tau * (root - v_s);
      stored += mu * elastic * psi;
      rubbed -= mu * (elastic * held.dot(rate) / root + 1.5 * elastic / overlap * closing * psi);
    }
    L::store(stored, column(kStored));
    L::store((pressed - elastic) * closing, column(kDamped));
    L::store(rubbed, column(kRubbed));
  }
}

struct ApplyLaw {
  template <class L>
  static FOOTFALL_IN_LINE void run(const Table& at, const ContactLaw& law, const Eigen::Vector3d& dr,
                                   const Eigen::Vector3d& w) {
    apply_law<L>(at, law, dr, w);
  }
};
struct FindEnergies {
  template <class L>
  static FOOTFALL_IN_LINE void run(const Table& at, const ContactLaw& law) {
    find_energies<L>(at, law);
  }
};
const auto kApplyLaw =
    BestLanes<ApplyLaw, const Table&, const ContactLaw&, const Eigen::Vector3d&, const Eigen::Vector3d&>::choose();
const auto kFindEnergies = BestLanes<FindEnergies, const Table&, const ContactLaw&>::choose();

}  // namespace

void ContactLanes::add(int spring, double share, const Eigen::Vector3d& d, const Eigen::Vector3d& dp,
                       const Eigen::Vector3d& n, double overlap) {
  const Eigen::Index at = count();
  if (at == of_.rows()) {  // rows that are not used have numbers that can be computed with
    of_.conservativeResize(2 * at + kMostLanes, kColumns);
    of_.bottomRows(of_.rows() - at).setOnes();
  }
  spring_.push_back(spring);
  double* const row = &of_(at, 0);
  const Eigen::Index apart = of_.rows();
  row[kShare * apart] = share;
  row[kOverlap * apart] = overlap;
  for (int k = 0; k < 3; ++k) {
    row[(kArm + k) * apart] = d[k];
    row[(kMotion + k) * apart] = dp[k];
    row[(kNormal + k) * apart] = n[k];
  }
}

void ContactLanes::apply(const ContactLaw& law, const Eigen::Vector3d& dr, const Eigen::Vector3d& w,
                         const Eigen::Ref<const Eigen::VectorXd>& springs) {
  const bool held = law.stick_time > 0.0;
  for (int i = 0; i < count(); ++i)
    for (int k = 0; k < 2; ++k) of_(i, kSpring + k) = held ? springs[2 * spring_[i] + k] / law.stick_time : 0.0;
  kApplyLaw({of_.data(), of_.rows(), count()}, law, dr, w);
}

Eigen::Vector3d ContactLanes::force(int contact) const { return of_.row(contact).segment<3>(kForce).transpose(); }

Eigen::Matrix<double, 6, 1> ContactLanes::wrench() const {
  Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
  for (int i = 0; i < count(); ++i) {
    const Eigen::Vector3d f = force(i), d = of_.row(i).segment<3>(kArm).transpose();
    out.head<3>() += f;
    out.tail<3>() += d.cross(f);
  }
  return out;
}

double ContactLanes::largest_overlap() const { return count() == 0 ? 0.0 : of_.col(kOverlap).head(count()).maxCoeff(); }

void ContactLanes::add_drive(Eigen::Ref<Eigen::VectorXd> rates) const {
  for (int i = 0, end = 0; i < count(); i = end) {
    Eigen::Vector2d drive = Eigen::Vector2d::Zero();
    for (; end < count() && spring_[end] == spring_[i]; ++end) drive += of_.row(end).segment<2>(kDrive).matrix();
    rates.segment<2>(2 * spring_[i]) += drive / (end - i);
  }
}

void ContactLanes::add_energy(const ContactLaw& law, StoredEnergy& stored, Dissipated& power) {
  for (int i = 0, end = 0; i < count(); i = end) {
    Eigen::Array<double, 1, 2> drive = Eigen::Array<double, 1, 2>::Zero();
    for (; end < count() && spring_[end] == spring_[i]; ++end) drive += of_.row(end).segment<2>(kDrive);
    drive /= end - i;
    for (int k = i; k < end; ++k) of_.row(k).segment<2>(kRate) = drive - of_.row(k).segment<2>(kSpring);
  }
  kFindEnergies({of_.data(), of_.rows(), count()}, law);
  for (int i = 0; i < count(); ++i) {
    stored[Stored::kContact] += of_(i, kStored);
    power[Dissipation::kContact] += of_(i, kDamped);
    power[Dissipation::kFriction] += of_(i, kRubbed);
  }
}

}  // namespace footfall
