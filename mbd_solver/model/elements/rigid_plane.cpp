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
constexpr int kOnRim = -1;         // a contact at no point of the list

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

// Plane and motion as the body sees them: all sums over points are in B, as one product with all points.
struct RigidPlane::Frame {
  Frame(const BodyKinematics& body, const Parameters& plane, const Eigen::Matrix<double, 3, 2>& tangents)
      : height(plane.normal.dot(body.r - plane.point)),
        n(body.A.transpose() * plane.normal),
        T(body.A.transpose() * tangents),
        dr(body.A.transpose() * body.dr),
        w(body.A.transpose() * body.w) {}

  double height;                  // of Bo [m]
  Eigen::Vector3d n;              // in B, as all below
  Eigen::Matrix<double, 3, 2> T;  // the tangents
  Eigen::Vector3d dr, w;          // [m/s], [rad/s]
};

// One point in contact: everything the force and its derivatives need. Vectors of two are along the tangents.
struct RigidPlane::Contact {
  int point = kOnRim;  // of points_
  int place = 0;       // its spring is the entries 2 place, 2 place + 1 of z
  double radius = 0.0;
  double overlap = 0.0;                              // delta [m]
  double closing = 0.0;                              // delta' [m/s]
  double inverse_speed = 0.0;                        // 1 / sqrt(u^2 + v_s^2)
  ContactLaw::Normal normal;                         // f_n [N] and its parts
  Eigen::Vector3d s = Eigen::Vector3d::Zero();       // p, from Bo in B [m]
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();     // p - radius n, likewise
  Eigen::Vector2d slip = Eigen::Vector2d::Zero();    // v_t [m/s]
  Eigen::Vector2d spring = Eigen::Vector2d::Zero();  // xi / tau [m/s]
  Eigen::Vector2d u = Eigen::Vector2d::Zero();       // v_t + xi / tau [m/s]
  Eigen::Matrix3d wander = Eigen::Matrix3d::Zero();  // G: p moves along its edge by G dtheta as the body turns [m]

  // On the body, in the frame of n and T [N].
  Eigen::Vector3d force(const Eigen::Vector3d& n, const Eigen::Matrix<double, 3, 2>& T, double friction) const {
    return normal.force * (n - T * (friction * inverse_speed * u));
  }
};

struct RigidPlane::Scratch : ElementScratch {
  Scratch(const ForceElement& element, Eigen::Index n, Eigen::Index points)
      : ElementScratch(element), X(3, n), by_x(3, n), s(points), ds(points), forces(points) {}
  Eigen::Matrix3Xd X, by_x;
  Eigen::VectorXd s, ds, forces;  // of points of a flexible body: deformed, its rate, forces, in B
  Marker on_rim;
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
  const Eigen::Index count = static_cast<Eigen::Index>(points_.size());
  s_.resize(3 * count);
  S_.resize(3 * count, points_.empty() ? 0 : points_.front().marker.S.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    s_.segment<3>(3 * i) = points_[i].marker.s0;
    S_.middleRows<3>(3 * i) = points_[i].marker.S;
  }
}

std::unique_ptr<ElementScratch> RigidPlane::scratch(SharedCopies&) const {
  return std::make_unique<Scratch>(*this, 6 + S_.cols(), S_.cols() > 0 ? s_.size() : 0);
}

bool RigidPlane::far(const BodyKinematics& body) const {
  const double reach = body.modes == 0 ? reach_ : reach_ + flexible_reach_ * body.a.norm();
  return parameters_.normal.dot(body.r - parameters_.point) > reach;
}

int RigidPlane::place_count() const { return static_cast<int>(points_.size() + kRimPlaces * rims_.size()); }

// The rest of a contact, from point, place, radius, overlap and s. ds: its rate by the modes, in B.
void RigidPlane::apply_law(const ElementInput& in, const Frame& frame, const Eigen::Vector3d& ds, Contact& at) const {
  at.arm = at.s - at.radius * frame.n;
  const Eigen::Vector3d velocity = frame.dr + frame.w.cross(at.arm) + ds;
  at.closing = -frame.n.dot(velocity);
  at.slip = frame.T.transpose() * velocity;
  if (parameters_.stick_time > 0.0) at.spring = in.z.segment<2>(2 * at.place) / parameters_.stick_time;
  at.u = at.slip + at.spring;
  at.normal = parameters_.normal_force(at.overlap, at.closing);
  at.inverse_speed = 1.0 / std::sqrt(at.u.squaredNorm() + parameters_.slip_speed * parameters_.slip_speed);
}

template <class Use>
void RigidPlane::each_contact_of_rim(const ElementInput& in, const Frame& frame, const ContactRim& rim, int first_place,
                                     Use use) const {
  const Eigen::Vector3d &n = frame.n, a = rim.marker.axes.col(2), &centre = rim.marker.s0;
  const Eigen::Vector3d down = n.dot(a) * a - n;
  const double s = down.norm(), height = frame.height + n.dot(centre);
  if (height > s * rim.radius) return;
  const bool tilted = s > kUpright;
  const Eigen::Vector3d e_0 = tilted ? Eigen::Vector3d(down / s) : Eigen::Vector3d(rim.marker.axes.col(0));
  const Eigen::Vector3d b = a.cross(e_0);
  const Eigen::Matrix3d& A = in.pair.body[0]->A;
  Contact at;
  for (int k = 0; k < kRimPlaces; ++k) {
    const Eigen::Vector3d e_k = rim_cosine(k) * e_0 + rim_sine(k) * b;
    at.s = centre + rim.radius * e_k;
    at.overlap = -(frame.height + n.dot(at.s));
    if (at.overlap <= 0.0) continue;
    at.place = first_place + k;
    apply_law(in, frame, Eigen::Vector3d::Zero(), at);
    // b stays horizontal while the body turns by dtheta: in addition the places turn about a by psi = -(b x n).dtheta / s.
    if (tilted) at.wander = (-rim.radius / s) * A * a.cross(e_k) * (A * b.cross(n)).transpose();
    use(at, frame);
  }
}

template <class Use>
void RigidPlane::each_contact(const ElementInput& in, Use use) const {
  const BodyKinematics& body = *in.pair.body[0];
  if (far(body)) return;
  const Frame frame(body, parameters_, tangents_);
  Scratch& scratch = scratch_of<Scratch>(in);
  const bool bends = S_.cols() > 0;
  if (bends) {
    scratch.s = s_;
    scratch.s.noalias() += S_ * body.a;
  }
  bool rates_known = false;
  const double* s = bends ? scratch.s.data() : s_.data();
  Contact at;
  for (std::size_t i = 0; i < points_.size(); ++i, s += 3) {
    at.overlap = points_[i].radius - (frame.height + frame.n[0] * s[0] + frame.n[1] * s[1] + frame.n[2] * s[2]);
    if (at.overlap <= 0.0) continue;
    if (bends && !rates_known) scratch.ds.noalias() = S_ * body.da;
    rates_known = true;
    at.point = at.place = static_cast<int>(i);
    at.radius = points_[i].radius;
    at.s = {s[0], s[1], s[2]};
    apply_law(in, frame, bends ? Eigen::Vector3d(scratch.ds.segment<3>(3 * at.point)) : Eigen::Vector3d::Zero(), at);
    use(at, frame);
  }
  int place = static_cast<int>(points_.size());
  for (const ContactRim& rim : rims_) {
    each_contact_of_rim(in, frame, rim, place, use);
    place += kRimPlaces;
  }
}

void RigidPlane::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q,
                           Eigen::Ref<Eigen::VectorXd> dz) const {
  const bool springs = parameters_.stick_time > 0.0, bends = S_.cols() > 0;
  if (springs) dz = -in.z / parameters_.stick_time;
  Eigen::VectorXd& forces = scratch_of<Scratch>(in).forces;
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;  // in B
  bool any = false;
  each_contact(in, [&](const Contact& at, const Frame& frame) {
    if (bends && !any) forces.setZero();
    any = true;
    const Eigen::Vector3d f = at.force(frame.n, frame.T, parameters_.friction);
    force += f;
    moment += at.arm.cross(f);
    if (bends) forces.segment<3>(3 * at.point) = f;
    if (springs) dz.segment<2>(2 * at.place) += parameters_.clipped(at.u);
  });
  if (!any) return;
  const Eigen::Matrix3d& A = in.pair.body[0]->A;
  Q.head<3>() += A * force;
  Q.segment<3>(3) += A * moment;
  if (bends) Q.segment(6, S_.cols()).noalias() += S_.transpose() * forces;
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
  Scratch& scratch = scratch_of<Scratch>(in);
  Eigen::Matrix3Xd &X = scratch.X, &by_x = scratch.by_x;
  bool any = tau > 0.0;
  if (any) out.ddz_dz.noalias() -= Eigen::Matrix2d::Identity().replicate(place_count(), 1) / tau;
  each_contact(in, [&](const Contact& at, const Frame&) {
    any = true;
    const double inverse = at.inverse_speed;
    const Eigen::Vector3d u = tangents_ * at.u, direction = n - mu * inverse * u, force = at.force(n, tangents_, mu);
    const Eigen::Matrix3d friction_by_u =
        (-mu * at.normal.force) * (inverse * tangent - (inverse * inverse * inverse) * u * u.transpose());
    const Eigen::Matrix3d by_u = -at.normal.by_closing * direction * n.transpose() + friction_by_u;
    const Eigen::Matrix3d by_p = -at.normal.by_overlap * direction * n.transpose();

    X.setZero();
    by_x.setZero();
    if (at.point == kOnRim) scratch.on_rim.s0 = at.s;
    const Marker& marker = at.point == kOnRim ? scratch.on_rim : points_[at.point].marker;
    const KinematicVector p = KinematicVector::point(in.pair, 0, marker);
    p.add_jacobian(X);
    p.add_rate_jacobian(by_x);
    const Eigen::Matrix<double, 2, 3> dxi_by_u = tangents_.transpose() * parameters_.clip(u).slope;
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
    p.add_second(force, out.dQ_dx);
    out.dQ_dx.block<3, 3>(3, 3) -= skew(force) * at.wander;  // the moment p x f
  });
  return any;
}

void RigidPlane::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  const double mu = parameters_.friction, tau = parameters_.stick_time, v_s = parameters_.slip_speed;
  each_contact(in, [&](const Contact& at, const Frame&) {
    const double elastic = at.normal.elastic, f_n = at.normal.force;
    stored[Stored::kContact] += 0.4 * elastic * at.overlap;
    power[Dissipation::kContact] += (f_n - elastic) * at.closing;
    power[Dissipation::kFriction] += mu * f_n * at.inverse_speed * at.u.dot(at.slip);
    if (tau == 0.0) return;
    // Stored mu f psi(xi), f = k delta^1.5: its rate is not dissipated.
    const double root = std::sqrt(at.spring.squaredNorm() + v_s * v_s), psi = tau * (root - v_s);
    const Eigen::Vector2d rate = parameters_.clipped(at.u) - at.spring;  // xi'
    stored[Stored::kContact] += mu * elastic * psi;
    power[Dissipation::kFriction] -=
        mu * (elastic * at.spring.dot(rate) / root + 1.5 * elastic / at.overlap * at.closing * psi);
  });
}

Eigen::Matrix<double, 6, 1> RigidPlane::wrench(const ElementInput& in) const {
  const Eigen::Matrix3d& A = in.pair.body[0]->A;
  Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
  each_contact(in, [&](const Contact& at, const Frame& frame) {
    const Eigen::Vector3d force = at.force(frame.n, frame.T, parameters_.friction);
    out.head<3>() += A * force;
    out.tail<3>() += A * at.arm.cross(force);
  });
  return out;
}

double RigidPlane::largest_overlap(const ElementInput& in) const {
  double largest = 0.0;
  each_contact(in, [&](const Contact& at, const Frame&) { largest = std::max(largest, at.overlap); });
  return largest;
}

}  // namespace footfall
