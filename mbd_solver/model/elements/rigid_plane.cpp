// Heights are tested first, so that points off the plane cost little; then force and derivatives of each contact.

#include "mbd_solver/model/elements/rigid_plane.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/kinematic_vector.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr int kRimPlaces = 12;     // m of an edge: the second lowest place is 0.13 R above the lowest
constexpr double kUpright = 1e-9;  // s below which an edge lies flat and has no lowest place
constexpr double kClear = 1e-9;    // a place above this height does not touch, round-off included [m]

// Of place k of an edge.
double rim_cosine(int k) {
  static const std::array<double, kRimPlaces> cosines = [] {
    std::array<double, kRimPlaces> out{};
    for (int i = 0; i < kRimPlaces; ++i) out[i] = std::cos(2.0 * kPi * i / kRimPlaces);
    return out;
  }();
  return cosines[k];
}

double rim_sine(int k) {
  static const std::array<double, kRimPlaces> sines = [] {
    std::array<double, kRimPlaces> out{};
    for (int i = 0; i < kRimPlaces; ++i) out[i] = std::sin(2.0 * kPi * i / kRimPlaces);
    return out;
  }();
  return sines[k];
}

}  // namespace

// One point in contact: everything the force and its derivatives need.
struct RigidPlane::Contact {
  MovingPoint p;
  const Marker* marker = nullptr;
  double radius = 0.0;
  double overlap = 0.0;                              // delta [m]
  double elastic = 0.0;                              // k delta^1.5 [N]
  double normal_force = 0.0;                         // f_n [N]
  double by_overlap = 0.0;                           // d f_n / d delta
  double by_closing = 0.0;                           // d f_n / d delta'
  double closing = 0.0;                              // delta' [m/s]
  int place = 0;                                     // its spring is the entries 2 place, 2 place + 1 of z
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();    // v_t [m/s]
  Eigen::Vector3d spring = Eigen::Vector3d::Zero();  // xi / tau [m/s]
  Eigen::Vector3d u = Eigen::Vector3d::Zero();       // v_t + xi / tau [m/s]
  double inverse_speed = 0.0;                        // 1 / sqrt(u^2 + v_s^2)
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // on the body [N]
  Eigen::Matrix3d wander = Eigen::Matrix3d::Zero();  // G: p moves along its edge by G dtheta as the body turns [m]
};

struct RigidPlane::Scratch : ElementScratch {
  Scratch(const ForceElement& element, Eigen::Index n) : ElementScratch(element), X(3, n), by_x(3, n) {}
  Eigen::Matrix3Xd X, by_x;
};

RigidPlane::RigidPlane(std::string name, std::vector<ContactPoint> points, const Parameters& parameters,
                       std::vector<ContactRim> rims)
    : ContactElement(std::move(name),
                     !points.empty() ? points.front().marker.body
                     : !rims.empty() ? rims.front().marker.body
                                     : kGround,
                     kGround),
      points_(std::move(points)),
      rims_(std::move(rims)),
      parameters_(parameters) {
  const std::string where = "rigid plane of \"" + this->name() + "\": ";
  if (points_.empty() && rims_.empty()) throw InputError(code::kNoContactPoints, where + "no contact points given.");
  if (!(parameters_.normal.norm() > 0.0))
    throw InputError(code::kParameterOutOfRange, where + "the normal must not be zero.");
  parameters_.check(where);
  parameters_.normal.normalize();
  for (const ContactPoint& point : points_) {
    FOOTFALL_DEMAND(point.marker.body == bodies()[0] && point.marker.body != kGround);
    if (!(point.radius >= 0.0))
      throw InputError(code::kParameterOutOfRange, where + "the radius of a contact point must not be negative.");
    reach_ = std::max(reach_, point.marker.s0.norm() + point.radius);
    flexible_reach_ = std::max(flexible_reach_, point.marker.S.norm());
  }
  for (const ContactRim& rim : rims_) {
    FOOTFALL_DEMAND(rim.marker.body == bodies()[0] && rim.marker.body != kGround && rim.marker.S.cols() == 0);
    if (!(rim.radius > 0.0))
      throw InputError(code::kParameterOutOfRange, where + "the radius of a round edge must be positive.");
    reach_ = std::max(reach_, rim.marker.s0.norm() + rim.radius);
  }
  tangents_ = axes_with_z(parameters_.normal).leftCols<2>();
}

std::unique_ptr<ElementScratch> RigidPlane::scratch(SharedCopies&) const {
  return std::make_unique<Scratch>(*this, 6 + (points_.empty() ? 0 : points_.front().marker.S.cols()));
}

bool RigidPlane::far(const BodyKinematics& body) const {
  const double reach = body.modes == 0 ? reach_ : reach_ + flexible_reach_ * body.a.norm();
  return parameters_.normal.dot(body.r - parameters_.point) > reach;
}

int RigidPlane::place_count() const { return static_cast<int>(points_.size() + kRimPlaces * rims_.size()); }

bool RigidPlane::contact(const ElementInput& in, const Marker& marker, double radius, int place, Contact& out) const {
  const Eigen::Vector3d& n = parameters_.normal;
  out.p = MovingPoint(*in.pair.body[0], marker);
  out.overlap = radius - n.dot(out.p.value() - parameters_.point);
  if (out.overlap <= 0.0) return false;
  out.marker = &marker;
  out.radius = radius;
  const Eigen::Vector3d velocity = out.p.rate() + radius * n.cross(in.pair.body[0]->w);  // w x (-radius n)
  out.closing = -n.dot(velocity);
  out.slip = velocity + out.closing * n;
  out.place = place;
  if (parameters_.stick_time > 0.0) out.spring = tangents_ * in.z.segment<2>(2 * place) / parameters_.stick_time;
  out.u = out.slip + out.spring;

  const ContactLaw::Normal normal = parameters_.normal_force(out.overlap, out.closing);
  out.elastic = normal.elastic;
  out.normal_force = normal.force;
  out.by_overlap = normal.by_overlap;
  out.by_closing = normal.by_closing;
  out.inverse_speed = 1.0 / std::sqrt(out.u.squaredNorm() + parameters_.slip_speed * parameters_.slip_speed);
  out.force = out.normal_force * (n - parameters_.friction * out.inverse_speed * out.u);
  return true;
}

template <class Use>
void RigidPlane::each_contact(const ElementInput& in, const ContactRim& rim, int first_place, Use use) const {
  const BodyKinematics& body = *in.pair.body[0];
  const Eigen::Vector3d& n = parameters_.normal;
  const Eigen::Vector3d a = body.A * rim.marker.axes.col(2);
  const Eigen::Vector3d down = n.dot(a) * a - n;
  const double s = down.norm();
  const Eigen::Vector3d centre = body.r + body.A * rim.marker.s0;
  if (n.dot(centre - parameters_.point) > s * rim.radius) return;
  const bool tilted = s > kUpright;
  const Eigen::Vector3d e_0 = tilted ? Eigen::Vector3d(down / s) : Eigen::Vector3d(body.A * rim.marker.axes.col(0));
  const Eigen::Vector3d b = a.cross(e_0);
  const double height = n.dot(centre - parameters_.point);
  Contact at;
  Marker on_rim;
  for (int k = 0; k < kRimPlaces; ++k) {
    const Eigen::Vector3d e_k = rim_cosine(k) * e_0 + rim_sine(k) * b;
    if (height + rim.radius * n.dot(e_k) > kClear) continue;
    on_rim.s0 = rim.marker.s0 + rim.radius * (body.A.transpose() * e_k);
    if (!contact(in, on_rim, 0.0, first_place + k, at)) continue;
    // b stays horizontal while the body turns by dtheta: in addition the places turn about a by psi = -(b x n).dtheta / s.
    if (tilted) at.wander = (-rim.radius / s) * a.cross(e_k) * b.cross(n).transpose();
    use(at);
  }
}

template <class Use>
void RigidPlane::each_contact(const ElementInput& in, Use use) const {
  if (far(*in.pair.body[0])) return;
  // Heights first: most points do not touch, and their velocities are not required.
  const BodyKinematics& body = *in.pair.body[0];
  const Eigen::Vector3d n_B = body.A.transpose() * parameters_.normal;
  const double height = parameters_.normal.dot(body.r - parameters_.point);
  const double bent =
      body.modes == 0 ? 0.0 : flexible_reach_ * body.a.norm();  // largest displacement of a point by the modes
  Contact at;
  int place = -1;
  for (const ContactPoint& point : points_) {
    const Marker& m = point.marker;
    ++place;
    double h = height + n_B.dot(m.s0);
    if (h - bent - point.radius > kClear) continue;
    for (Eigen::Index k = 0; k < m.S.cols(); ++k) h += n_B.dot(m.S.col(k)) * body.a[k];
    if (h - point.radius <= kClear && contact(in, m, point.radius, place, at)) use(at);
  }
  ++place;
  for (const ContactRim& rim : rims_) {
    each_contact(in, rim, place, use);
    place += kRimPlaces;
  }
}

void RigidPlane::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q,
                           Eigen::Ref<Eigen::VectorXd> dz) const {
  const bool springs = parameters_.stick_time > 0.0;
  if (springs) dz = -in.z / parameters_.stick_time;
  each_contact(in, [&](const Contact& at) {
    at.p.add_transposed(at.force, Q);
    Q.segment<3>(3) -= at.radius * parameters_.normal.cross(at.force);
    if (springs) dz.segment<2>(2 * at.place) += tangents_.transpose() * parameters_.clipped(at.u);
  });
}

bool RigidPlane::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  // Force f(delta, c', xi), c' = velocity of the contact place:  df = f_delta ddelta + f_c dc' + f_u dxi / tau
  //   ddelta/dx = -n^T (X + [0, G, 0]),  dc'/dx = p'_x + [0, w~ G, 0],  dc'/dv = X_c = X + [0, radius n~, 0]
  // and the rate of xi, T^T clip(P c' + xi / tau) - xi / tau;  T^T P = T^T for the tangents T
  const Eigen::Vector3d& n = parameters_.normal;
  const double mu = parameters_.friction;
  const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - n * n.transpose();
  const Eigen::Vector3d w = in.pair.body[0]->w;
  const double tau = parameters_.stick_time;
  Eigen::Matrix3Xd &X = scratch_of<Scratch>(in).X, &by_x = scratch_of<Scratch>(in).by_x;
  bool any = tau > 0.0;
  if (any) out.ddz_dz.noalias() -= Eigen::Matrix2d::Identity().replicate(place_count(), 1) / tau;
  each_contact(in, [&](const Contact& at) {
    any = true;
    const Eigen::Vector3d direction = n - mu * at.inverse_speed * at.u;
    const Eigen::Matrix3d friction_by_u =
        (-mu * at.normal_force) * (at.inverse_speed * tangent -
                                   (at.inverse_speed * at.inverse_speed * at.inverse_speed) * at.u * at.u.transpose());
    const Eigen::Matrix3d by_u = -at.by_closing * direction * n.transpose() + friction_by_u;
    const Eigen::Matrix3d by_p = -at.by_overlap * direction * n.transpose();

    X.setZero();
    by_x.setZero();
    const KinematicVector p = KinematicVector::point(in.pair, 0, *at.marker);
    p.add_jacobian(X);
    p.add_rate_jacobian(by_x);
    const Eigen::Matrix<double, 2, 3> dxi_by_u = tangents_.transpose() * parameters_.clip(at.u).slope;
    if (tau > 0.0) {
      out.ddz_dx.middleRows<2>(2 * at.place).noalias() += dxi_by_u.lazyProduct(by_x);
      out.ddz_dx.block<2, 3>(2 * at.place, 3) += dxi_by_u * skew(w) * at.wander;
      out.ddz_dz.middleRows<2>(2 * at.place) += dxi_by_u * tangents_ / tau;
    }
    for (Eigen::Index j = 0; j < X.cols(); ++j) {  // df/dx
      const Eigen::Vector3d column = by_u * by_x.col(j) + by_p * X.col(j);
      by_x.col(j) = column;
    }
    by_x.block<3, 3>(0, 3) += (by_u * skew(w) + by_p) * at.wander;
    X.block<3, 3>(0, 3) += at.radius * skew(n);  // X_c
    out.dQ_dx.noalias() += X.transpose().lazyProduct(by_x);
    by_x.noalias() = by_u.lazyProduct(X);  // df/dv
    out.dQ_dv.noalias() += X.transpose().lazyProduct(by_x);
    if (tau > 0.0) {
      const Eigen::Matrix<double, 3, 2> by_xi = friction_by_u * tangents_ / tau;
      out.dQ_dz.middleCols<2>(2 * at.place).noalias() += X.transpose().lazyProduct(by_xi);
      out.ddz_dv.middleRows<2>(2 * at.place).noalias() += dxi_by_u.lazyProduct(X);
    }
    p.add_second(at.force, out.dQ_dx);
    out.dQ_dx.block<3, 3>(3, 3) -= skew(at.force) * at.wander;  // the moment p x f
  });
  return any;
}

void RigidPlane::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  const double mu = parameters_.friction, tau = parameters_.stick_time, v_s = parameters_.slip_speed;
  each_contact(in, [&](const Contact& at) {
    stored[Stored::kContact] += 0.4 * at.elastic * at.overlap;
    power[Dissipation::kContact] += (at.normal_force - at.elastic) * at.closing;
    power[Dissipation::kFriction] += mu * at.normal_force * at.inverse_speed * at.u.dot(at.slip);
    if (tau == 0.0) return;
    // Stored mu f psi(xi), f = k delta^1.5: its rate is not dissipated.
    const double root = std::sqrt(at.spring.squaredNorm() + v_s * v_s), psi = tau * (root - v_s);
    const Eigen::Vector3d rate = parameters_.clipped(at.u) - at.spring;  // xi'
    stored[Stored::kContact] += mu * at.elastic * psi;
    power[Dissipation::kFriction] -=
        mu * (at.elastic * at.spring.dot(rate) / root + 1.5 * at.elastic / at.overlap * at.closing * psi);
  });
}

Eigen::Matrix<double, 6, 1> RigidPlane::wrench(const ElementInput& in) const {
  Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
  each_contact(in, [&](const Contact& at) {
    const Eigen::Vector3d arm = at.p.value() - in.pair.body[0]->r - at.radius * parameters_.normal;
    out.head<3>() += at.force;
    out.tail<3>() += arm.cross(at.force);
  });
  return out;
}

double RigidPlane::largest_overlap(const ElementInput& in) const {
  double largest = 0.0;
  each_contact(in, [&](const Contact& at) { largest = std::max(largest, at.overlap); });
  return largest;
}

}  // namespace footfall
