// Each point may have several contacts with the surface; they share one spring. Derivatives are written out (below).

#include "mbd_solver/model/elements/surface_contact.h"

#include <algorithm>
#include <array>

#include "coupler/base/errors.h"
#include "mbd_solver/model/elements/curved_contact.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

// One contact of a point.
struct SurfaceContact::Contact : CurvedContact {
  int slot = 0;                                      // of the body A with the point
  KinematicVector p;                                 // of the point
  Eigen::Vector3d from_B = Eigen::Vector3d::Zero();  // p - r_B [m]
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();   // p' - v_B(p) [m/s]
};

struct SurfaceContact::Scratch : ElementScratch {
  using ElementScratch::ElementScratch;
  std::vector<NearTriangle> near;
  std::vector<SurfaceTouch> touches;
  std::vector<Contact> contacts;          // of one point
  std::array<Eigen::Matrix3Xd, 8> parts;  // X, D, N, G, g_x, f_x, f_v, u_x of a contact, 3 x n
};

SurfaceContact::SurfaceContact(std::string name, int body_1, int body_2, std::vector<Side> sides, const ContactLaw& law)
    : ContactElement(std::move(name), body_1, body_2), sides_(std::move(sides)), law_(law) {
  law_.check("contact \"" + this->name() + "\": ");
  for (const Side& side : sides_) {
    double reach = 0.0, flexible = 0.0;
    for (const ContactPoint& point : side.points) {
      FOOTFALL_DEMAND(point.marker.body == bodies()[side.slot] && point.marker.body != kGround && point.radius >= 0.0);
      reach = std::max(reach, point.marker.s0.norm() + std::max(point.radius, side.depth));
      flexible = std::max(flexible, point.marker.S.norm());
    }
    FOOTFALL_DEMAND(side.seen != nullptr && side.depth > 0.0);
    reach_.push_back(reach);
    flexible_reach_.push_back(flexible);
    places_ += static_cast<int>(side.points.size());
  }
  FOOTFALL_DEMAND(places_ > 0);
}

std::unique_ptr<ElementScratch> SurfaceContact::scratch(SharedCopies&) const {
  return std::make_unique<Scratch>(*this);
}

bool SurfaceContact::far(const Side& side, double reach, double flexible_reach, const ElementInput& in) const {
  if (side.seen->surface == nullptr) return true;
  const BodyKinematics &A = *in.pair.body[side.slot], &B = *in.pair.body[1 - side.slot];
  const double all = A.modes == 0 ? reach : reach + flexible_reach * A.a.norm();
  return !side.seen->surface->may_touch(B.A.transpose() * (A.r - B.r), all, side.seen->sides);
}

template <class Use>
void SurfaceContact::each_place(const ElementInput& in, Use use) const {
  Scratch& scratch = scratch_of<Scratch>(in);
  int place = 0;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const Side& side = sides_[k];
    if (far(side, reach_[k], flexible_reach_[k], in)) {
      place += static_cast<int>(side.points.size());
      continue;
    }
    const BodyKinematics &A = *in.pair.body[side.slot], &B = *in.pair.body[1 - side.slot];
    for (const ContactPoint& point : side.points) {
      const int here = place++;
      const KinematicVector p = KinematicVector::point(in.pair, side.slot, point.marker);
      const Eigen::Vector3d from_B = p.value() - B.r;
      side.seen->surface->touches(B.A.transpose() * from_B, point.radius, side.depth, side.seen->sides, scratch.near,
                                  scratch.touches);
      if (scratch.touches.empty()) continue;
      scratch.contacts.clear();
      for (const SurfaceTouch& touch : scratch.touches) {
        Contact at;
        at.slot = side.slot;
        at.p = p;
        at.radius = point.radius;
        at.overlap = point.radius - touch.distance;
        if (at.overlap <= 0.0) continue;
        at.n = B.A * touch.normal;
        at.H = B.A * touch.bend * B.A.transpose();
        at.from_B = from_B;
        at.apart = p.rate() - B.dr - B.w.cross(from_B);
        at.g = at.apart - at.radius * (A.w - B.w).cross(at.n);
        at.closing = -at.n.dot(at.g);
        if (law_.stick_time > 0.0) at.spring = B.A * in.z.segment<3>(3 * here) / law_.stick_time;
        at.apply(law_);
        scratch.contacts.push_back(at);
      }
      if (!scratch.contacts.empty()) use(here, scratch.contacts.data(), static_cast<int>(scratch.contacts.size()));
    }
  }
}

Eigen::Vector3d SurfaceContact::spring_rate(const Contact* contacts, int count) const {
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) rate += (law_.clipped(contacts[i].u) - contacts[i].held) / count;
  return rate;
}

void SurfaceContact::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q,
                               Eigen::Ref<Eigen::VectorXd> dz) const {
  const bool springs = law_.stick_time > 0.0;
  if (springs) dz = -in.z / law_.stick_time;
  each_place(in, [&](int place, const Contact* contacts, int count) {
    const int slot = contacts->slot, A = in.pair.offset(slot), B = in.pair.offset(1 - slot);
    const BodyKinematics& other = *in.pair.body[1 - slot];
    for (int i = 0; i < count; ++i) {
      const Contact& at = contacts[i];
      const Eigen::Vector3d arm = at.radius * at.n.cross(at.force);
      at.p.add_transposed(at.force, Q);
      Q.segment<3>(A + 3) -= arm;
      if (other.ground) continue;
      Q.segment<3>(B) -= at.force;
      Q.segment<3>(B + 3) -= at.from_B.cross(at.force) - arm;
    }
    if (springs) dz.segment<3>(3 * place) = other.A.transpose() * spring_rate(contacts, count);
  });
}

bool SurfaceContact::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  const bool springs = law_.stick_time > 0.0;
  bool any = springs;
  if (springs) out.ddz_dz.noalias() -= Eigen::Matrix3d::Identity().replicate(places_, 1) / law_.stick_time;
  each_place(in, [&](int place, const Contact* contacts, int count) {
    any = true;
    if (springs) out.ddz_dz.middleRows<3>(3 * place) += Eigen::Matrix3d::Identity() / law_.stick_time;
    for (int i = 0; i < count; ++i) add_derivatives(in, contacts[i], place, 1.0 / count, out);
  });
  return any;
}

void SurfaceContact::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  each_place(in, [&](int, const Contact* contacts, int count) {
    const Eigen::Vector3d xi_rate = spring_rate(contacts, count);
    const BodyKinematics& B = *in.pair.body[1 - contacts->slot];
    for (int i = 0; i < count; ++i) {
      const Contact& at = contacts[i];
      const Eigen::Vector3d n_rate = B.w.cross(at.n) + at.H * at.apart;
      const Eigen::Vector3d rate = xi_rate + law_.stick_time * (B.w.cross(at.spring) - at.n.dot(at.spring) * n_rate);
      at.add_energy(law_, rate, stored, power);
    }
  });
}

Eigen::Matrix<double, 6, 1> SurfaceContact::wrench(const ElementInput& in) const {
  Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
  each_place(in, [&](int, const Contact* contacts, int count) {
    for (int i = 0; i < count; ++i) {
      const Contact& at = contacts[i];
      const Eigen::Vector3d f = at.slot == 0 ? at.force : Eigen::Vector3d(-at.force);
      const Eigen::Vector3d arm = at.p.value() - at.radius * at.n - in.pair.body[0]->r;
      out.head<3>() += f;
      out.tail<3>() += arm.cross(f);
    }
  });
  return out;
}

double SurfaceContact::largest_overlap(const ElementInput& in) const {
  double largest = 0.0;
  each_place(in, [&](int, const Contact* contacts, int count) {
    for (int i = 0; i < count; ++i) largest = std::max(largest, contacts[i].overlap);
  });
  return largest;
}

// The derivatives of one contact.
//   X = dp/dx of the point; E_r, E_A, E_B select dr of B and the rotations of A and B from dx
//   D = X - E_r + (p - r_B)~ E_B               d(phi) = n.D dx, also p' - v_B(p) = D v
//   N = dn/dx = H D - n~ E_B
//   G = D + R n~ (E_A - E_B)                   g = G v, Q = G^T f
//   g_x = p'_x - w_B~ (X - E_r) - R (w_A - w_B)~ N
//   u_x = P (g_x - s~ E_B) - (n.y) N - n y^T N,  y = g + s,  s = xi / tau
//   f   = f_n (n - mu u / sqrt(u^2 + v_s^2))
void SurfaceContact::add_derivatives(const ElementInput& in, const Contact& at, int place, double share,
                                     ElementDerivatives& out) const {
  const BodyKinematics &A = *in.pair.body[at.slot], &B = *in.pair.body[1 - at.slot];
  const int n = in.pair.size(), a = in.pair.offset(at.slot), b = in.pair.offset(1 - at.slot);
  const double tau = law_.stick_time;
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity(), P = unit - at.n * at.n.transpose();
  const Eigen::Vector3d turning = A.w - B.w;
  auto& [X, D, N, G, g_x, f_x, f_v, u_x] = scratch_of<Scratch>(in).parts;
  for (Eigen::Matrix3Xd& m : scratch_of<Scratch>(in).parts) m.setZero(3, n);

  // The point against B.
  at.p.add_jacobian(X);
  if (!B.ground) X.middleCols<3>(b) -= unit;  // X - E_r
  D = X;
  if (!B.ground) D.middleCols<3>(b + 3) += skew(at.from_B);
  N.noalias() = at.H.lazyProduct(D);
  if (!B.ground) N.middleCols<3>(b + 3) -= skew(at.n);
  G = D;
  G.middleCols<3>(a + 3) += at.radius * skew(at.n);
  if (!B.ground) G.middleCols<3>(b + 3) -= at.radius * skew(at.n);
  at.p.add_rate_jacobian(g_x);
  g_x.noalias() -= skew(B.w).lazyProduct(X);
  g_x.noalias() -= (at.radius * skew(turning)).lazyProduct(N);

  // The law.
  const Eigen::Vector3d y = at.g + at.spring;
  u_x.noalias() = P.lazyProduct(g_x);
  u_x.noalias() -= (at.n.dot(y) * unit + at.n * y.transpose()).lazyProduct(N);
  if (!B.ground) u_x.middleCols<3>(b + 3) -= P * skew(at.spring);
  const auto [by_u, by_g] = at.differentiate(law_, D, N, g_x, u_x, f_x);
  f_v.noalias() = by_g.lazyProduct(G);

  // Q = G^T f; then the rotation of G with the bodies at fixed f.
  out.dQ_dx.noalias() += G.transpose().lazyProduct(f_x);
  out.dQ_dv.noalias() += G.transpose().lazyProduct(f_v);
  at.p.add_second(at.force, out.dQ_dx);
  const Eigen::Matrix3d f = skew(at.force), arm = at.radius * f;
  out.dQ_dx.middleRows<3>(a + 3).noalias() += arm.lazyProduct(N);
  if (!B.ground) {
    out.dQ_dx.middleRows<3>(b + 3).noalias() += f.lazyProduct(X);
    out.dQ_dx.middleRows<3>(b + 3).noalias() -= arm.lazyProduct(N);
  }
  if (tau == 0.0) return;

  // xi_B' = R^T (clip(u) - P s), R the attitude of B: the share of this contact. -P s varies with n and B like u.
  const ContactLaw::Clipped clipped = law_.clip(at.u);
  const Eigen::Matrix3d R = B.A, R_T = share * R.transpose();
  const Eigen::Matrix3d by_s = P * R / tau;
  out.dQ_dz.middleCols<3>(3 * place).noalias() += G.transpose().lazyProduct(by_u * by_s);
  f_v.noalias() = (clipped.slope * P).lazyProduct(G);
  out.ddz_dv.middleRows<3>(3 * place).noalias() += R_T.lazyProduct(f_v);
  out.ddz_dz.middleRows<3>(3 * place) += R_T * (clipped.slope - unit) * by_s;
  f_x.noalias() = clipped.slope.lazyProduct(u_x);
  f_x.noalias() += (at.n.dot(at.spring) * unit + at.n * at.spring.transpose()).lazyProduct(N);
  if (!B.ground) f_x.middleCols<3>(b + 3) += P * skew(at.spring) + skew(clipped.value - at.held);
  out.ddz_dx.middleRows<3>(3 * place).noalias() += R_T.lazyProduct(f_x);
}

}  // namespace footfall
