#include "mbd_solver/model/elements/surface_contact.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/model/elements/surface_contact_at.h"

namespace footfall {

SurfaceContact::SurfaceContact(std::string name, int body_1, int body_2, std::vector<Side> sides, const ContactLaw& law)
    : ForceElement(std::move(name), body_1, body_2), sides_(std::move(sides)), law_(law) {
  law_.check("contact \"" + this->name() + "\": ");
  for (const Side& side : sides_) {
    double reach = 0.0, flexible = 0.0;
    for (const ContactPoint& point : side.points) {
      FOOTFALL_DEMAND(point.marker.body == bodies()[static_cast<std::size_t>(side.slot)] &&
                      point.marker.body != kGround && point.radius >= 0.0);
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

SurfaceContact::~SurfaceContact() = default;

bool SurfaceContact::far(const Side& side, double reach, double flexible_reach, const ElementInput& in) const {
  if (side.seen->surface == nullptr) return true;
  const BodyKinematics &A = *in.pair.body[side.slot], &B = *in.pair.body[1 - side.slot];
  const double all = A.modes == 0 ? reach : reach + flexible_reach * A.a.norm();
  return !side.seen->surface->may_touch(B.A.transpose() * (A.r - B.r), all, side.seen->sides);
}

template <class Use>
void SurfaceContact::each_place(const ElementInput& in, Use use) const {
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
      side.seen->surface->touches(B.A.transpose() * from_B, point.radius, side.depth, side.seen->sides, touches_);
      if (touches_.empty()) continue;
      contacts_.clear();
      for (const SurfaceTouch& touch : touches_) {
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
        at.held = at.spring - at.n.dot(at.spring) * at.n;
        at.u = at.g + at.closing * at.n + at.held;
        at.inverse_speed = 1.0 / std::sqrt(at.u.squaredNorm() + law_.slip_speed * law_.slip_speed);
        at.normal = law_.normal_force(at.overlap, at.closing);
        at.force = at.normal.force * (at.n - law_.friction * at.inverse_speed * at.u);
        contacts_.push_back(at);
      }
      if (!contacts_.empty()) use(here, contacts_.data(), static_cast<int>(contacts_.size()));
    }
  }
}

Eigen::Vector3d SurfaceContact::spring_rate(const Contact* contacts, int count) const {
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) rate += (law_.clip(contacts[i].u).value - contacts[i].held) / count;
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
  const double mu = law_.friction, tau = law_.stick_time, v_s = law_.slip_speed;
  each_place(in, [&](int, const Contact* contacts, int count) {
    const Eigen::Vector3d xi_rate = spring_rate(contacts, count);
    const BodyKinematics& B = *in.pair.body[1 - contacts->slot];
    for (int i = 0; i < count; ++i) {
      const Contact& at = contacts[i];
      const double elastic = at.normal.elastic;
      stored[Stored::kContact] += 0.4 * elastic * at.overlap;
      power[Dissipation::kContact] += (at.normal.force - elastic) * at.closing;
      power[Dissipation::kFriction] += mu * at.normal.force * at.inverse_speed * at.u.dot(at.g + at.closing * at.n);
      if (tau == 0.0) continue;
      // Stored mu f psi(P xi), f = k delta^1.5: its rate is no loss.
      const double root = std::sqrt(at.held.squaredNorm() + v_s * v_s), psi = tau * (root - v_s);
      const Eigen::Vector3d n_rate = B.w.cross(at.n) + at.H * at.apart;
      const Eigen::Vector3d rate = xi_rate + tau * (B.w.cross(at.spring) - at.n.dot(at.spring) * n_rate);
      stored[Stored::kContact] += mu * elastic * psi;
      power[Dissipation::kFriction] -=
          mu * (elastic * at.held.dot(rate) / root + 1.5 * elastic / at.overlap * at.closing * psi);
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

}  // namespace footfall
