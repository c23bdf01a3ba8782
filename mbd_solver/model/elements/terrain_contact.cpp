// A bound of the ground around the body is tested first, so that what is in the air costs little; then each place finds its foot.

#include "mbd_solver/model/elements/terrain_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/elements/curved_contact.h"
#include "mbd_solver/model/kinematic_vector.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr int kEdgePlaces = 12;        // of an edge that lies on the ground, and springs of each edge
constexpr int kEdgeSamples = 36;       // at which an edge looks for minima
constexpr double kStands = 0.5;        // sine of the angle to the ground above which an edge stands up
constexpr double kAboveGround = 1e-9;  // a place above this height does not touch, round-off included [m]
constexpr double kTurnsFreely = 1e-9;  // curvature of the distance along an edge below which its minimum has no place

}  // namespace

struct TerrainContact::Contact : CurvedContact {
  const Marker* marker = nullptr;
  MovingPoint p;
  bool wanders = false;
  // p moves along its edge by wander [dr; dtheta] as the body moves.
  Eigen::Matrix<double, 3, 6> wander = Eigen::Matrix<double, 3, 6>::Zero();
  bool on_rock = false;
};

TerrainContact::TerrainContact(std::string name, std::vector<ContactPoint> points, const ContactLaw& law,
                               std::shared_ptr<const Terrain> terrain, std::vector<ContactRim> rims, Touches touches)
    : ForceElement(std::move(name),
                   !points.empty() ? points.front().marker.body
                   : !rims.empty() ? rims.front().marker.body
                                   : kGround,
                   kGround),
      points_(std::move(points)),
      rims_(std::move(rims)),
      law_(law),
      terrain_(std::move(terrain)),
      field_(touches == Touches::kAll) {
  const std::string where = "ground under \"" + this->name() + "\": ";
  if (points_.empty() && rims_.empty()) throw InputError(code::kNoContactPoints, where + "no contact points given.");
  law_.check(where);
  FOOTFALL_DEMAND(terrain_ != nullptr);
  for (const ContactPoint& point : points_) {
    FOOTFALL_DEMAND(point.marker.body == bodies()[0] && point.marker.body != kGround && point.radius >= 0.0);
    reach_ = std::max(reach_, point.marker.s0.norm() + point.radius);
    flexible_reach_ = std::max(flexible_reach_, point.marker.S.norm());
  }
  for (const ContactRim& rim : rims_) {
    FOOTFALL_DEMAND(rim.marker.body == bodies()[0] && rim.marker.S.cols() == 0 && rim.radius > 0.0);
    reach_ = std::max(reach_, rim.marker.s0.norm() + rim.radius);
  }
}

TerrainContact::~TerrainContact() = default;

int TerrainContact::place_count() const { return static_cast<int>(points_.size() + kEdgePlaces * rims_.size()); }

void TerrainContact::add_contact(const ElementInput& in, const Marker& marker, double radius, const Terrain::Foot& foot,
                                 int place) const {
  Contact at;
  at.overlap = radius - foot.distance;
  if (at.overlap <= 0.0) return;
  const BodyKinematics& body = *in.pair.body[0];
  at.marker = &marker;
  at.p = MovingPoint(body, marker);
  at.radius = radius;
  at.n = foot.normal;
  at.H = foot.bend;
  at.on_rock = foot.rock >= 0;
  at.g = at.p.rate() - radius * body.w.cross(at.n);
  at.closing = -at.n.dot(at.g);
  if (law_.stick_time > 0.0) at.spring = in.z.segment<3>(3 * place) / law_.stick_time;
  at.apply(law_);
  contacts_.push_back(at);
}

// From an angle near a minimum of the distance along the edge to the minimum.
double TerrainContact::find_place_on_rim(const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& e_0,
                                         const Eigen::Vector3d& b, double angle, int rock, Terrain::Foot& foot) const {
  constexpr double kWide = 2.0 * kPi / kEdgeSamples;
  constexpr int kSteps = 80;
  const auto foot_at = [&](const Eigen::Vector3d& p) { return rock < 0 ? terrain_->foot(p) : terrain_->foot(p, rock); };
  double low = angle - kWide, high = angle + kWide;  // the slope of the distance changes its sign between them
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Vector3d e = std::cos(angle) * e_0 + std::sin(angle) * b,
                          t = std::cos(angle) * b - std::sin(angle) * e_0;
    foot = foot_at(centre + radius * e);
    const double slope = foot.normal.dot(t), curve = radius * t.dot(foot.bend * t) - foot.normal.dot(e);
    (slope < 0.0 ? low : high) = angle;
    double next = curve > kTurnsFreely ? angle - slope / curve : low - 1.0;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double step = next - angle;
    if (std::abs(step) < 1e-13) break;
    angle = next;
  }
  return angle;
}

template <class Use>
void TerrainContact::each_rim_place(const ElementInput& in, const ContactRim& rim, int first_place,
                                    const Terrain::Lid& lid, Use use) const {
  const BodyKinematics& body = *in.pair.body[0];
  const Eigen::Vector3d a = body.A * rim.marker.axes.col(2), centre = body.r + body.A * rim.marker.s0;
  const double R = rim.radius;
  const Eigen::Vector2d away = centre.head<2>() - body.r.head<2>();
  const Eigen::Vector3d up = Eigen::Vector3d(-lid.slope.x(), -lid.slope.y(), 1.0);
  const double far = away.norm() + R;
  const double above = centre.z() - lid.height - lid.slope.dot(away) - 0.5 * lid.bend * far * far;
  if (above > R * up.cross(a).norm() && lid.rocks.empty()) return;

  const Terrain::Height below = terrain_->at(centre.x(), centre.y());
  const Eigen::Vector3d n = Eigen::Vector3d(-below.slope.x(), -below.slope.y(), 1.0).normalized();
  const auto touch_rocks = [&](const Eigen::Vector3d& p, int place) {
    for (const int rock : lid.rocks) {
      const Terrain::Foot foot = terrain_->foot(p, rock);
      if (foot.distance < 0.0) add_contact(in, on_rim_, 0.0, foot, place);
    }
  };
  if (n.cross(a).norm() < kStands) {
    for (int k = 0; k < kEdgePlaces; ++k) {
      const double angle = 2.0 * kPi * k / kEdgePlaces;
      on_rim_.s0 =
          rim.marker.s0 + R * (std::cos(angle) * rim.marker.axes.col(0) + std::sin(angle) * rim.marker.axes.col(1));
      const Eigen::Vector3d p = body.r + body.A * on_rim_.s0;
      contacts_.clear();
      if (field_ && p.z() - terrain_->at(p.x(), p.y()).h < kAboveGround)
        add_contact(in, on_rim_, 0.0, terrain_->foot(p), first_place + k);
      touch_rocks(p, first_place + k);
      if (!contacts_.empty()) use(first_place + k, contacts_.data(), static_cast<int>(contacts_.size()));
    }
    return;
  }

  // Down in the plane of the edge, from where its springs are counted; the edge stands up, so there is such a direction.
  Eigen::Vector3d e_0 = n.dot(a) * a - n;
  e_0.normalize();
  const Eigen::Vector3d b = a.cross(e_0);
  struct Minimum {
    double angle;
    Terrain::Foot foot;
  };
  std::array<std::vector<Minimum>, kEdgePlaces> minima;
  bool any = false;
  const auto add = [&](double start, int rock) {
    Minimum one;
    one.angle = find_place_on_rim(centre, R, e_0, b, start, rock, one.foot);
    if (!(one.foot.distance < 0.0)) return;
    const int turn = static_cast<int>(std::lround(one.angle * kEdgePlaces / (2.0 * kPi)));
    std::vector<Minimum>& here = minima[static_cast<std::size_t>(((turn % kEdgePlaces) + kEdgePlaces) % kEdgePlaces)];
    for (const Minimum& known : here)
      if (known.foot.rock == rock && std::abs(std::remainder(known.angle - one.angle, 2.0 * kPi)) < 1e-6) return;
    here.push_back(one);
    any = true;
  };
  std::array<double, kEdgeSamples> gap{};
  for (int i = 0; i < kEdgeSamples && field_; ++i) {
    const double angle = 2.0 * kPi * i / kEdgeSamples;
    const Eigen::Vector3d p = centre + R * (std::cos(angle) * e_0 + std::sin(angle) * b);
    const Terrain::Height here = terrain_->at(p.x(), p.y());
    gap[static_cast<std::size_t>(i)] = (p.z() - here.h) / std::sqrt(1.0 + here.slope.squaredNorm());
  }
  const double arc = 2.0 * kPi * R / kEdgeSamples;
  for (int i = 0; i < kEdgeSamples && field_; ++i) {
    const double here = gap[static_cast<std::size_t>(i)];
    if (here > arc || here > gap[static_cast<std::size_t>((i + 1) % kEdgeSamples)] ||
        here > gap[static_cast<std::size_t>((i + kEdgeSamples - 1) % kEdgeSamples)])
      continue;
    add(2.0 * kPi * i / kEdgeSamples, -1);
  }
  for (const int rock : lid.rocks) {
    const Eigen::Vector3d d = terrain_->rocks()[static_cast<std::size_t>(rock)].centre - centre;
    if (d.norm() > R + terrain_->rocks()[static_cast<std::size_t>(rock)].radius) continue;
    add(std::atan2(d.dot(b), d.dot(e_0)), rock);
  }
  if (!any) return;
  for (int k = 0; k < kEdgePlaces; ++k) {
    for (const Minimum& one : minima[static_cast<std::size_t>(k)]) {
      const Eigen::Vector3d e = std::cos(one.angle) * e_0 + std::sin(one.angle) * b, t = a.cross(e);
      on_rim_.s0 = rim.marker.s0 + R * (body.A.transpose() * e);
      contacts_.clear();
      add_contact(in, on_rim_, 0.0, one.foot, first_place + k);
      if (contacts_.empty()) continue;
      Contact& at = contacts_.back();
      const double curve = R * t.dot(at.H * t) - at.n.dot(e);
      if (curve > kTurnsFreely) {
        Eigen::Matrix<double, 1, 6> turn;
        turn.head<3>() = -(t.transpose() * at.H) / curve;
        turn.tail<3>() = (t.transpose() * at.H * skew(centre + R * e - body.r) - t.cross(at.n).transpose()) / curve;
        at.wander = (R * t) * turn;
        at.wanders = true;
      }
      use(first_place + k, contacts_.data(), 1);
    }
  }
}

template <class Use>
void TerrainContact::each_place(const ElementInput& in, Use use) const {
  const BodyKinematics& body = *in.pair.body[0];
  const double reach = body.modes == 0 ? reach_ : reach_ + flexible_reach_ * body.a.norm();
  const Terrain::Lid lid = terrain_->lid(body.r, reach);
  if (lid.rocks.empty() && (!field_ || lid.above(body.r, reach))) return;
  const double up = std::sqrt(1.0 + lid.slope.squaredNorm());
  int place = -1;
  for (const ContactPoint& point : points_) {
    ++place;
    const Marker& m = point.marker;
    Eigen::Vector3d s = m.s0;
    if (m.S.cols() > 0) s.noalias() += m.S * body.a;
    const Eigen::Vector3d d = body.A * s, p = body.r + d;
    const Eigen::Vector2d across = d.head<2>();
    const double wide = across.norm() + point.radius;
    const double above = p.z() - lid.height - lid.slope.dot(across) - 0.5 * lid.bend * wide * wide - point.radius * up;
    contacts_.clear();
    if (field_ && above <= kAboveGround) {
      terrain_->feet(p, point.radius, feet_);
      for (const Terrain::Foot& foot : feet_) add_contact(in, m, point.radius, foot, place);
    }
    for (const int rock : lid.rocks) {
      const Terrain::Sphere& sphere = terrain_->rocks()[static_cast<std::size_t>(rock)];
      if ((p - sphere.centre).squaredNorm() < (sphere.radius + point.radius) * (sphere.radius + point.radius))
        add_contact(in, m, point.radius, terrain_->foot(p, rock), place);
    }
    if (!contacts_.empty()) use(place, contacts_.data(), static_cast<int>(contacts_.size()));
  }
  ++place;
  for (const ContactRim& rim : rims_) {
    each_rim_place(in, rim, place, lid, use);
    place += kEdgePlaces;
  }
}

Eigen::Vector3d TerrainContact::spring_rate(const Contact* contacts, int count) const {
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) rate += (law_.clip(contacts[i].u).value - contacts[i].held) / count;
  return rate;
}

void TerrainContact::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q,
                               Eigen::Ref<Eigen::VectorXd> dz) const {
  const bool springs = law_.stick_time > 0.0;
  if (springs) dz = -in.z / law_.stick_time;
  each_place(in, [&](int place, const Contact* contacts, int count) {
    for (int i = 0; i < count; ++i) {
      const Contact& at = contacts[i];
      at.p.add_transposed(at.force, Q);
      Q.segment<3>(3) -= at.radius * at.n.cross(at.force);
    }
    if (springs) dz.segment<3>(3 * place) = spring_rate(contacts, count);
  });
}

bool TerrainContact::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  const bool springs = law_.stick_time > 0.0;
  bool any = springs;
  if (springs) out.ddz_dz.noalias() -= Eigen::Matrix3d::Identity().replicate(place_count(), 1) / law_.stick_time;
  each_place(in, [&](int place, const Contact* contacts, int count) {
    any = true;
    if (springs) out.ddz_dz.middleRows<3>(3 * place) += Eigen::Matrix3d::Identity() / law_.stick_time;
    for (int i = 0; i < count; ++i) add_derivatives(in, contacts[i], place, 1.0 / count, out);
  });
  return any;
}

// The derivatives of one contact, as in SurfaceContact, W the way of a place along its edge:
//   D = X + W,  N = dn/dx = H D,  G = X + R n~ E                g = G v, Q = G^T f
//   g_x = p'_x + w~ W - R w~ N,  u_x = P g_x - (n.y) N - n y^T N,  y = g + xi / tau
void TerrainContact::add_derivatives(const ElementInput& in, const Contact& at, int place, double share,
                                     ElementDerivatives& out) const {
  const BodyKinematics& body = *in.pair.body[0];
  const int n = in.pair.size();
  const double tau = law_.stick_time;
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity(), P = unit - at.n * at.n.transpose(), turning = skew(body.w);
  for (Eigen::Matrix3Xd* m : {&X_, &D_, &N_, &G_, &g_x_, &f_x_, &f_v_, &u_x_}) m->setZero(3, n);

  const KinematicVector p = KinematicVector::point(in.pair, 0, *at.marker);
  p.add_jacobian(X_);
  D_ = X_;
  if (at.wanders) D_.leftCols<6>() += at.wander;
  N_.noalias() = at.H.lazyProduct(D_);
  G_ = X_;
  G_.middleCols<3>(3) += at.radius * skew(at.n);
  p.add_rate_jacobian(g_x_);
  if (at.wanders) g_x_.leftCols<6>() += turning * at.wander;
  g_x_.noalias() -= (at.radius * turning).lazyProduct(N_);

  const Eigen::Vector3d y = at.g + at.spring;
  u_x_.noalias() = P.lazyProduct(g_x_);
  u_x_.noalias() -= (at.n.dot(y) * unit + at.n * y.transpose()).lazyProduct(N_);
  const auto [by_u, by_g] = at.differentiate(law_, D_, N_, g_x_, u_x_, f_x_);
  f_v_.noalias() = by_g.lazyProduct(G_);

  out.dQ_dx.noalias() += G_.transpose().lazyProduct(f_x_);
  out.dQ_dv.noalias() += G_.transpose().lazyProduct(f_v_);
  p.add_second(at.force, out.dQ_dx);
  const Eigen::Matrix3d f = skew(at.force);
  out.dQ_dx.middleRows<3>(3).noalias() += (at.radius * f).lazyProduct(N_);
  if (at.wanders) out.dQ_dx.block<3, 6>(3, 0) -= f * at.wander;
  if (tau == 0.0) return;

  // xi' = clip(u) - P s: the share of this contact.
  const ContactLaw::Clipped clipped = law_.clip(at.u);
  const Eigen::Matrix3d by_s = P / tau;
  out.dQ_dz.middleCols<3>(3 * place).noalias() += G_.transpose().lazyProduct(by_u * by_s);
  f_v_.noalias() = (share * clipped.slope * P).lazyProduct(G_);
  out.ddz_dv.middleRows<3>(3 * place) += f_v_;
  out.ddz_dz.middleRows<3>(3 * place) += share * (clipped.slope - unit) * by_s;
  f_x_.noalias() = clipped.slope.lazyProduct(u_x_);
  f_x_.noalias() += (at.n.dot(at.spring) * unit + at.n * at.spring.transpose()).lazyProduct(N_);
  out.ddz_dx.middleRows<3>(3 * place) += share * f_x_;
}

void TerrainContact::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  const BodyKinematics& body = *in.pair.body[0];
  each_place(in, [&](int, const Contact* contacts, int count) {
    const Eigen::Vector3d xi_rate = spring_rate(contacts, count);
    for (int i = 0; i < count; ++i) {
      const Contact& at = contacts[i];
      Eigen::Vector3d way = at.p.rate();
      if (at.wanders) way += at.wander.leftCols<3>() * body.dr + at.wander.rightCols<3>() * body.w;
      const Eigen::Vector3d rate = xi_rate - law_.stick_time * at.n.dot(at.spring) * (at.H * way);
      at.add_energy(law_, rate, stored, power);
    }
  });
}

Eigen::Matrix<double, 6, 1> TerrainContact::wrench(const ElementInput& in) const {
  Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
  each_place(in, [&](int, const Contact* contacts, int count) {
    for (int i = 0; i < count; ++i) {
      const Contact& at = contacts[i];
      const Eigen::Vector3d arm = at.p.value() - at.radius * at.n - in.pair.body[0]->r;
      out.head<3>() += at.force;
      out.tail<3>() += arm.cross(at.force);
    }
  });
  return out;
}

double TerrainContact::largest_overlap(const ElementInput& in) const {
  double largest = 0.0;
  each_place(in, [&](int, const Contact* contacts, int count) {
    for (int i = 0; i < count; ++i) largest = std::max(largest, contacts[i].overlap);
  });
  return largest;
}

bool TerrainContact::touches_rock(const ElementInput& in) const {
  bool any = false;
  each_place(in, [&](int, const Contact* contacts, int count) {
    for (int i = 0; i < count; ++i) any = any || contacts[i].on_rock;
  });
  return any;
}

}  // namespace footfall
