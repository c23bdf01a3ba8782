// A bound of the ground around the body is tested first, so that what is in the air costs little; then each place finds its foot.

#include "mbd_solver/model/elements/terrain_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/edge_on_terrain.h"
#include "mbd_solver/model/elements/contact_lanes.h"
#include "mbd_solver/model/elements/curved_contact.h"
#include "mbd_solver/model/kinematic_vector.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr int kEdgePlaces = 12;        // of an edge that lies on the ground, and springs of each edge
constexpr double kStands = 0.5;        // sine of the angle to the ground above which an edge is raised
constexpr double kAboveGround = 1e-9;  // a place above this height does not touch, round-off included [m]
constexpr double kSharp =
    30.0;  // times its radius: an edge counts its springs from the vertical where the ground may bend more
constexpr double kBends = 0.4;    // times its radius: an edge touches at one place where the ground bends less
constexpr double kOneWide = 1.2;  // half the angle within which that is [rad]
constexpr double kFlat = 1e-11;   // the ground is a plane if it bulges less within the reach of a body [m]
constexpr double kFace = 1e-6;  // of the radius: a point so near to the plane of an edge, and within it, is on its face
constexpr double kTurnsFreely = 1e-9;  // curvature of the distance along an edge below which its minimum has no place

// Directions of the places of an edge that lies.
const std::array<Eigen::Vector2d, kEdgePlaces>& edge_directions() {
  static const std::array<Eigen::Vector2d, kEdgePlaces> directions = [] {
    std::array<Eigen::Vector2d, kEdgePlaces> out;
    for (int k = 0; k < kEdgePlaces; ++k) {
      const double angle = 2.0 * kPi * k / kEdgePlaces;
      out[k] = {std::cos(angle), std::sin(angle)};
    }
    return out;
  }();
  return directions;
}

using Tangents = Eigen::Matrix<double, 3, 2>;

// T: the x and y axes of W, turned along with z to n by the smallest rotation.
Tangents tangents_at(const Eigen::Vector3d& n) {
  const double c = 1.0 / std::max(1e-6, 1.0 + n.z());
  Tangents T;
  T << 1.0 - c * n.x() * n.x(), -c * n.x() * n.y(), -c * n.x() * n.y(), 1.0 - c * n.y() * n.y(), -n.x(), -n.y();
  return T;
}

// With (x, y) of n as m, a = m.s, b = m.y:
//   T s = (s - c a m, -a),  T^T y = (y_x, y_y) - (c b + y_z) m,  c = 1 / (1 + n_z),  dc = -c^2 dn_z
Eigen::Vector3d along(const Eigen::Vector3d& n, const Eigen::Vector2d& s) {
  const double c = 1.0 / std::max(1e-6, 1.0 + n.z()), a = n.x() * s.x() + n.y() * s.y();
  return {s.x() - c * a * n.x(), s.y() - c * a * n.y(), -a};
}
Eigen::Vector2d parts_along(const Eigen::Vector3d& n, const Eigen::Vector3d& y) {
  const double c = 1.0 / std::max(1e-6, 1.0 + n.z()), f = c * (n.x() * y.x() + n.y() * y.y()) + y.z();
  return {y.x() - f * n.x(), y.y() - f * n.y()};
}
// Their derivatives by n.
Eigen::Matrix3d slope_of_tangent(const Eigen::Vector3d& n, const Eigen::Vector2d& s) {
  const double c = 1.0 / std::max(1e-6, 1.0 + n.z());
  const Eigen::Vector2d m = n.head<2>();
  const double a = m.dot(s);
  Eigen::Matrix3d out = Eigen::Matrix3d::Zero();
  out.topLeftCorner<2, 2>() = -c * m * s.transpose() - c * a * Eigen::Matrix2d::Identity();
  out.topRightCorner<2, 1>() = c * c * a * m;
  out.bottomLeftCorner<1, 2>() = -s.transpose();
  return out;
}
Eigen::Matrix<double, 2, 3> slope_of_parts(const Eigen::Vector3d& n, const Eigen::Vector3d& y) {
  const double c = 1.0 / std::max(1e-6, 1.0 + n.z());
  const Eigen::Vector2d m = n.head<2>();
  const double b = m.dot(y.head<2>());
  Eigen::Matrix<double, 2, 3> out;
  out.leftCols<2>() = -c * m * y.head<2>().transpose() - (c * b + y.z()) * Eigen::Matrix2d::Identity();
  out.col(2) = c * c * b * m;
  return out;
}

}  // namespace

struct TerrainContact::Contact : CurvedContact {
  int place = 0, point = kOnRim;  // of points_
  int way = -1;                   // of Scratch::ways; -1: none
  Eigen::Vector3d s, d;           // from Bo to p, in B and in W [m]
  bool on_rock = false;
  void count_off() {
    normal = {-normal.elastic, -normal.force, -normal.by_overlap, -normal.by_closing};
    force = -force;
  }
};

struct TerrainContact::Scratch : ElementScratch {
  Scratch(const ForceElement& element, std::shared_ptr<Terrain> ground, Eigen::Index flexible)
      : ElementScratch(element), terrain(std::move(ground)), forces(Eigen::VectorXd::Zero(flexible)) {}

  std::shared_ptr<Terrain> terrain;
  Terrain::Lid lid;  // over the last cell, with height and slope of the last place
  bool flat = false;
  double lid_reach = -1.0, lid_height = 0.0;  // [m]; height: at the middle
  double plane_height = 0.0;                  // of a plane above the field, at the middle [m]
  Eigen::Vector2d plane_slope = Eigen::Vector2d::Zero();
  Eigen::Array3d lid_cell = Eigen::Array3d::Zero();
  Eigen::Vector3d lid_middle = Eigen::Vector3d::Zero();
  // Contacts of the last state, with what they depend on.
  std::vector<double> state, known_state;
  Terrain::With known_with = Terrain::With::kNormal;
  std::vector<Contact> contacts;  // count of them
  std::size_t count = 0;
  ContactLanes lanes;  // these instead, where the field alone touches and derivatives are not asked for
  std::vector<Way> ways;
  // Buffers.
  std::vector<Candidate> candidates;
  Terrain::Feet feet;
  std::vector<Terrain::Foot> ball_feet;
  Eigen::VectorXd s, ds, forces;  // of own points: deformed, its rate, forces in B
  bool ds_known = false;
  Marker on_rim;
  Eigen::Matrix3Xd G, g_0, f_x, f_v;  // 3 x n

  bool clears_plane(const Eigen::Vector3d& p, double radius) const;
  double find_place_on_rim(const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& e_0,
                           const Eigen::Vector3d& b, double angle, int rock, Terrain::Foot& foot);
  // use(first, count) for the contacts of every place that has some.
  template <class Use>
  void each_place(Use use) const;
};

TerrainContact::TerrainContact(std::string name, std::vector<ContactPoint> points, const ContactLaw& law,
                               std::shared_ptr<const Terrain> terrain, std::vector<ContactRim> rims, Touches touches)
    : ContactElement(std::move(name),
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
  faces_.resize(rims_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (points_[i].radius > 0.0 || points_[i].marker.S.cols() > 0 || !sort_onto_face(static_cast<int>(i)))
      own_.push_back(static_cast<int>(i));
  }
  const Eigen::Index own = 3 * static_cast<Eigen::Index>(own_.size());
  own_s_.resize(own);
  own_S_.resize(own, own_.empty() ? 0 : points_[own_.front()].marker.S.cols());
  for (Eigen::Index i = 0; i < own / 3; ++i) {
    const Marker& marker = points_[own_[i]].marker;
    own_s_.segment<3>(3 * i) = marker.s0;
    own_S_.middleRows<3>(3 * i) = marker.S;
  }
}

std::unique_ptr<ElementScratch> TerrainContact::scratch(SharedCopies& shared) const {
  return std::make_unique<Scratch>(*this, shared.of(terrain_), own_S_.cols() > 0 ? own_s_.size() : 0);
}

bool TerrainContact::sort_onto_face(int point) {
  for (std::size_t k = 0; k < rims_.size(); ++k) {
    const Marker& rim = rims_[k].marker;
    const Eigen::Vector3d d = rim.axes.transpose() * (points_[point].marker.s0 - rim.s0);
    if (std::abs(d.z()) > kFace * rims_[k].radius || d.head<2>().norm() > rims_[k].radius) continue;
    const auto part = static_cast<int>(std::lround(std::atan2(d.y(), d.x()) * kEdgePlaces / (2.0 * kPi)));
    faces_[k].points[(part + kEdgePlaces) % kEdgePlaces].push_back(point);
    faces_[k].share = kEdgePlaces / (kEdgePlaces / faces_[k].share + 1.0);
    return true;
  }
  return false;
}

int TerrainContact::place_count() const { return static_cast<int>(own_.size() + kEdgePlaces * rims_.size()); }

TerrainContact::Contact* TerrainContact::add_contact(const ElementInput& in, const Candidate& candidate,
                                                     const Terrain::Foot& foot, bool with_bend,
                                                     Scratch& scratch) const {
  const double radius = candidate.radius;
  if (radius - foot.distance <= 0.0) return nullptr;
  const BodyKinematics& body = *in.pair.body[0];
  if (scratch.count == scratch.contacts.size()) scratch.contacts.emplace_back();
  Contact& at = scratch.contacts[scratch.count++];  // all of it is written below
  at.place = candidate.place;
  at.point = candidate.point;
  at.way = -1;
  at.s = candidate.s;
  at.d = candidate.d;
  at.overlap = radius - foot.distance;
  at.radius = radius;
  at.n = foot.normal;
  if (with_bend) at.H = foot.bend;
  at.on_rock = foot.rock >= 0;
  at.g = body.dr + body.w.cross(at.d - radius * at.n);
  if (body.modes > 0) {
    if (!scratch.ds_known) scratch.ds.noalias() = own_S_ * body.da;
    scratch.ds_known = true;
    at.g.noalias() += body.A.lazyProduct(scratch.ds.segment<3>(3 * at.place));
  }
  at.closing = -at.n.dot(at.g);
  if (law_.stick_time > 0.0) at.spring = along(at.n, in.z.segment<2>(2 * at.place) / law_.stick_time);
  if (candidate.share == 1.0) {
    at.apply(law_);
  } else {
    ContactLaw law = law_;
    law.stiffness *= candidate.share;
    at.apply(law);
  }
  if (foot.sign < 0.0) at.count_off();
  return &at;
}

// From an angle near a minimum of the distance along the edge to the minimum.
double TerrainContact::Scratch::find_place_on_rim(const Eigen::Vector3d& centre, double radius,
                                                  const Eigen::Vector3d& e_0, const Eigen::Vector3d& b, double angle,
                                                  int rock, Terrain::Foot& foot) {
  constexpr int kSteps = 80;
  const auto foot_at = [&](const Eigen::Vector3d& p) { return rock < 0 ? terrain->foot(p) : terrain->foot(p, rock); };
  double low = angle - kOneWide, high = angle + kOneWide;  // the slope of the distance changes its sign between them
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

// Of a point, on the plane that the ground is within the reach of the lid.
Terrain::Foot TerrainContact::foot_on_plane(const Terrain::Lid& lid, const Eigen::Vector3d& from_body,
                                            double above) const {
  Terrain::Foot foot;
  const double length = std::sqrt(1.0 + lid.slope.squaredNorm());
  foot.normal = Eigen::Vector3d(-lid.slope.x(), -lid.slope.y(), 1.0) / length;
  foot.distance = (above - lid.slope.dot(from_body.head<2>())) / length;
  return foot;
}

bool TerrainContact::Scratch::clears_plane(const Eigen::Vector3d& p, double radius) const {
  const double above = p.z() - plane_height - plane_slope.dot((p - lid_middle).head<2>());
  return above > kAboveGround + (radius > 0.0 ? radius * std::sqrt(1.0 + plane_slope.squaredNorm()) : 0.0);
}

// The contacts of all candidates, in their order.
void TerrainContact::touch(const ElementInput& in, const Terrain::Lid& lid, Terrain::With with,
                           Scratch& scratch) const {
  const BodyKinematics& body = *in.pair.body[0];
  const Eigen::Vector3d& r = body.r;
  if (!scratch.flat) {
    scratch.feet.clear();
    for (const Candidate& candidate : scratch.candidates)
      if (candidate.field && candidate.radius == 0.0) scratch.feet.add(r + candidate.d);
    scratch.terrain->below(scratch.feet, with);
    const bool points_alone = scratch.feet.count == static_cast<int>(scratch.candidates.size());
    if (with == Terrain::With::kNormal && points_alone && lid.rocks.empty() && scratch.count == 0) {
      touch_in_lanes(in, scratch);
      scratch.candidates.clear();
      return;
    }
  }
  const bool bends = with == Terrain::With::kBend;
  int next = 0;
  for (const Candidate& candidate : scratch.candidates) {
    const Eigen::Vector3d p = r + candidate.d;
    if (!candidate.field) {
    } else if (scratch.flat) {
      add_contact(in, candidate, foot_on_plane(lid, candidate.d, p.z() - lid.height), bends, scratch);
    } else if (candidate.radius == 0.0) {
      if (scratch.feet.near[next] == Terrain::Near::kFoot)
        add_contact(in, candidate, scratch.feet.of(next, with), bends, scratch);
      ++next;
    } else if (scratch.terrain->may_touch(p, candidate.radius)) {
      scratch.terrain->feet(p, candidate.radius, scratch.ball_feet);
      for (const Terrain::Foot& one : scratch.ball_feet) add_contact(in, candidate, one, bends, scratch);
    }
    for (const int rock : lid.rocks) {
      const Terrain::Sphere& sphere = scratch.terrain->rocks()[rock];
      const double far = sphere.radius + candidate.radius;
      if ((p - sphere.centre).squaredNorm() >= far * far) continue;
      Candidate alone = candidate;
      alone.share = 1.0;
      add_contact(in, alone, scratch.terrain->foot(p, rock), bends, scratch);
    }
  }
  scratch.candidates.clear();
}

void TerrainContact::touch_in_lanes(const ElementInput& in, Scratch& scratch) const {
  const BodyKinematics& body = *in.pair.body[0];
  const Terrain::Feet& feet = scratch.feet;
  for (int k = 0; k < feet.count; ++k) {
    if (feet.near[k] != Terrain::Near::kFoot || !(feet.distance[k] < 0.0)) continue;
    const Candidate& at = scratch.candidates[k];
    Eigen::Vector3d dp = Eigen::Vector3d::Zero();
    if (body.modes > 0) {
      if (scratch.lanes.count() == 0) scratch.ds.noalias() = own_S_ * body.da;
      dp.noalias() = body.A.lazyProduct(scratch.ds.segment<3>(3 * at.place));
    }
    scratch.lanes.add(at.place, at.share, at.d, dp, feet.normal.row(k).transpose(), -feet.distance[k]);
  }
  scratch.lanes.apply(law_, body.dr, body.w, in.z);
}

void TerrainContact::offer_face(const ElementInput& in, const Face& face, int part, int place, const Terrain::Lid& lid,
                                Scratch& scratch) const {
  const BodyKinematics& body = *in.pair.body[0];
  for (const int i : face.points[part]) {
    const Eigen::Vector3d& s = points_[i].marker.s0;
    const Eigen::Vector3d d = body.A * s;
    const double z = body.r.z() + d.z(),
                 above = z - lid.height - lid.slope.dot(d.head<2>()) - 0.5 * lid.bend * d.head<2>().squaredNorm();
    const bool field = field_ && above <= kAboveGround && z <= lid.top && !scratch.clears_plane(body.r + d, 0.0);
    if (field || !lid.rocks.empty()) scratch.candidates.push_back({place, i, 0.0, face.share, field, s, d});
  }
}

void TerrainContact::offer_own_points(const ElementInput& in, const Terrain::Lid& lid, Scratch& scratch) const {
  const BodyKinematics& body = *in.pair.body[0];
  const double up = std::sqrt(1.0 + lid.slope.squaredNorm());
  if (body.modes > 0) {
    scratch.s = own_s_;
    scratch.s.noalias() += own_S_ * body.a;
  }
  const Eigen::VectorXd& places = body.modes > 0 ? scratch.s : own_s_;
  for (std::size_t k = 0; k < own_.size(); ++k) {
    const double radius = points_[own_[k]].radius;
    const Eigen::Vector3d s = places.segment<3>(3 * static_cast<Eigen::Index>(k)), d = body.A * s;
    const double wide = d.head<2>().norm() + radius, z = body.r.z() + d.z();
    const double above = z - lid.height - lid.slope.dot(d.head<2>()) - 0.5 * lid.bend * wide * wide - radius * up;
    const bool field =
        field_ && above <= kAboveGround && z - radius <= lid.top && !scratch.clears_plane(body.r + d, radius);
    if (field || !lid.rocks.empty())
      scratch.candidates.push_back({static_cast<int>(k), own_[k], radius, 1.0, field, s, d});
  }
}

void TerrainContact::offer_rim(const ElementInput& in, std::size_t index, int first_place, const Terrain::Lid& lid,
                               Scratch& scratch) const {
  const ContactRim& rim = rims_[index];
  const Face& face = faces_[index];
  const BodyKinematics& body = *in.pair.body[0];
  const Eigen::Vector3d a = body.A * rim.marker.axes.col(2), centre = body.r + body.A * rim.marker.s0;
  const double R = rim.radius;
  const Eigen::Vector2d away = centre.head<2>() - body.r.head<2>();
  const Eigen::Vector3d up = Eigen::Vector3d(-lid.slope.x(), -lid.slope.y(), 1.0);
  const double far = away.norm() + R;
  const double above = centre.z() - lid.height - lid.slope.dot(away) - 0.5 * lid.bend * far * far;
  const bool clear = above > R * up.cross(a).norm() || centre.z() - R * a.head<2>().norm() > lid.top;
  if (clear && lid.rocks.empty()) return;
  const bool flat = scratch.flat;

  const bool sharp = field_ && !flat && lid.bend * R > kSharp && a.head<2>().norm() > kStands &&
                     scratch.terrain->lid(centre, R).bend * R > kSharp;
  const Eigen::Vector2d slope = flat ? lid.slope : scratch.terrain->at(centre.x(), centre.y()).slope;
  const Eigen::Vector3d n =
      sharp ? Eigen::Vector3d(0.0, 0.0, 1.0) : Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
  if (n.cross(a).norm() >= kStands) {
    const bool bends =
        field_ && !flat && lid.bend * R > kBends && (sharp || scratch.terrain->lid(centre, R).bend * R > kBends);
    return touch_standing_rim(in, index, first_place, lid, a, centre, n, bends, scratch);
  }
  for (int k = 0; k < kEdgePlaces; ++k) {
    const Eigen::Vector2d& e = edge_directions()[k];
    const Eigen::Vector3d s = rim.marker.s0 + R * (e.x() * rim.marker.axes.col(0) + e.y() * rim.marker.axes.col(1));
    const Eigen::Vector3d d = body.A * s;
    const bool field = field_ && !scratch.clears_plane(body.r + d, 0.0);
    if (field || !lid.rocks.empty())
      scratch.candidates.push_back({first_place + k, kOnRim, 0.0, flat ? 1.0 : face.share, field, s, d});
    if (!flat) offer_face(in, face, k, first_place + k, lid, scratch);
  }
}

void TerrainContact::touch_standing_rim(const ElementInput& in, std::size_t index, int first_place,
                                        const Terrain::Lid& lid, const Eigen::Vector3d& a,
                                        const Eigen::Vector3d& centre, const Eigen::Vector3d& n, bool bends,
                                        Scratch& scratch) const {
  const ContactRim& rim = rims_[index];
  const Face& face = faces_[index];
  const BodyKinematics& body = *in.pair.body[0];
  const double R = rim.radius;
  const bool flat = scratch.flat;
  // Down in the plane of the edge, from where its springs are counted; the edge is raised, so there is such a direction.
  Eigen::Vector3d e_0 = n.dot(a) * a - n;
  e_0.normalize();
  const Eigen::Vector3d b = a.cross(e_0);
  struct Minimum {
    double angle;
    Terrain::Foot foot;
    const EdgePlace* place = nullptr;
  };
  std::array<std::vector<Minimum>, kEdgePlaces> minima;
  bool any = false;
  const auto near = [&](double angle) -> std::vector<Minimum>& {
    const int turn = static_cast<int>(std::lround(angle * kEdgePlaces / (2.0 * kPi)));
    return minima[((turn % kEdgePlaces) + kEdgePlaces) % kEdgePlaces];
  };
  const auto add = [&](double start, int rock) {
    Minimum one;
    one.angle = scratch.find_place_on_rim(centre, R, e_0, b, start, rock, one.foot);
    if (!(one.foot.distance < 0.0)) return;
    std::vector<Minimum>& here = near(one.angle);
    for (const Minimum& other : here)
      if (other.foot.rock == rock && std::abs(std::remainder(other.angle - one.angle, 2.0 * kPi)) < 1e-6) return;
    here.push_back(one);
    any = true;
  };
  std::vector<EdgePlace> found;
  if (bends) find_edge_places(*scratch.terrain, centre, R, a, lid.top, found);
  for (const EdgePlace& place : found) {
    Minimum one;
    one.angle = std::atan2(place.e.dot(b), place.e.dot(e_0));
    one.foot.distance = -place.inside * place.tilt(a);
    one.foot.normal = place.n;
    one.place = &place;
    near(one.angle).push_back(one);
    any = true;
  }
  if (flat) {  // its lowest place
    Minimum one;
    one.angle = 0.0;
    const Eigen::Vector3d d = centre + R * e_0 - body.r;
    one.foot = foot_on_plane(lid, d, body.r.z() + d.z() - lid.height);
    any = one.foot.distance < 0.0;
    if (any) minima[0].push_back(one);
  }
  if (field_ && !flat && !bends) add(0.0, -1);
  for (const int rock : lid.rocks) {
    const Eigen::Vector3d d = scratch.terrain->rocks()[rock].centre - centre;
    if (d.norm() > R + scratch.terrain->rocks()[rock].radius) continue;
    add(std::atan2(d.dot(b), d.dot(e_0)), rock);
  }
  if (!any && (flat || face.share == 1.0)) return;
  for (int k = 0; k < kEdgePlaces; ++k) {
    if (!flat) offer_face(in, face, k, first_place + k, lid, scratch);
    for (const Minimum& one : minima[k]) {
      const Eigen::Vector3d e =
          one.place != nullptr ? one.place->e : Eigen::Vector3d(std::cos(one.angle) * e_0 + std::sin(one.angle) * b);
      const double share = one.place == nullptr ? 1.0 : std::pow(a.head<2>().norm() / one.place->tilt(a), 2.5);
      const double far = one.place == nullptr ? R : R - one.place->inside;
      const Eigen::Vector3d t = a.cross(e), s = rim.marker.s0 + far * (body.A.transpose() * e), d = body.A * s;
      Contact* const at = add_contact(in, {first_place + k, kOnRim, 0.0, share, true, s, d}, one.foot, true, scratch);
      if (at == nullptr) continue;
      const Eigen::Vector3d arm = centre + R * e - body.r;
      Way way;
      if (one.place != nullptr) {
        one.place->find_ways(a, centre, centre - body.r, way.wander, way.turn);
        way.turns = true;
        if (one.place->sign < 0.0) at->count_off();
        // By dtheta, of |a_h| and of s: (dtheta x a)_h.a_h / |a_h|,  -(n.a) d(n.a) / s
        const Eigen::Vector3d level = Eigen::Vector3d(a.x(), a.y(), 0.0).normalized();
        const double tilt = one.place->tilt(a), across = at->n.dot(a);
        Eigen::Matrix<double, 1, 6> by_level = Eigen::Matrix<double, 1, 6>::Zero(), by_tilt = a.transpose() * way.turn;
        by_level.tail<3>() = (a.cross(level) / a.head<2>().norm()).transpose();
        by_tilt.tail<3>() += a.cross(at->n).transpose();
        way.drags = true;
        way.drag = at->overlap * by_level;
        way.rim = static_cast<int>(index);
        way.stretch = (-across / (tilt * tilt)) * by_tilt;
        way.growth = 2.5 * by_level + (across / (tilt * tilt)) * by_tilt;
      } else {
        const double curve = R * t.dot(at->H * t) - at->n.dot(e);
        if (!(curve > kTurnsFreely)) continue;
        Eigen::Matrix<double, 1, 6> turn;
        turn.head<3>() = -(t.transpose() * at->H) / curve;
        turn.tail<3>() = (t.transpose() * at->H * skew(arm) - t.cross(at->n).transpose()) / curve;
        way.wander = (R * t) * turn;
      }
      at->way = static_cast<int>(scratch.ways.size());
      scratch.ways.push_back(way);
    }
  }
}

// Bounds hold in a cell around the place, a function of the place alone; height and slope are taken at the place.
const Terrain::Lid& TerrainContact::lid_over(const Eigen::Vector3d& r, double reach, Scratch& scratch) const {
  constexpr double kCell = 0.25;   // of the reach
  constexpr double kBeside = 0.4;  // of a cell: so that a body that rests at zero does not go to and fro between two
  const double size = std::max(kCell * reach, 1e-3);
  const Eigen::Array3d cell = (r.array() / size + kBeside).floor();
  if (scratch.lid_reach != reach || (cell != scratch.lid_cell).any()) {
    scratch.lid_cell = cell;
    scratch.lid_reach = reach;
    scratch.lid_middle = (size * (cell + (0.5 - kBeside))).matrix();
    const double wide = reach + size;  // > its half diagonal
    scratch.lid = scratch.terrain->lid(scratch.lid_middle, wide);
    scratch.lid_height = scratch.lid.height;
    const double x = scratch.lid_middle.x(),
                 y = scratch.lid_middle.y();  // of the mean slope: it leaves least room above the field
    scratch.plane_slope = Eigen::Vector2d(scratch.terrain->at(x + wide, y).h - scratch.terrain->at(x - wide, y).h,
                                          scratch.terrain->at(x, y + wide).h - scratch.terrain->at(x, y - wide).h) /
                          (2.0 * wide);
    scratch.plane_height = scratch.terrain->plane_above({x, y}, wide, scratch.plane_slope);
    scratch.flat = field_ && scratch.lid.rocks.empty() && 0.5 * scratch.lid.bend * wide * wide < kFlat;
  }
  if (scratch.flat) {
    scratch.lid.height = scratch.lid_height + scratch.lid.slope.dot(r.head<2>() - scratch.lid_middle.head<2>());
  } else if (r.z() - reach <= scratch.lid.top) {
    const Terrain::Height here = scratch.terrain->at(r.x(), r.y());
    scratch.lid.height = here.h;
    scratch.lid.slope = here.slope;
  }
  return scratch.lid;
}

// Of the same state and for the same purpose: what was asked before leaves no trace, not even in the last digit.
bool TerrainContact::is_known(const ElementInput& in, Terrain::With with, Scratch& scratch) const {
  const BodyKinematics& body = *in.pair.body[0];
  scratch.state.clear();
  const auto add = [&](const double* from, Eigen::Index count) {
    scratch.state.insert(scratch.state.end(), from, from + count);
  };
  for (const Eigen::Vector3d* x : {&body.r, &body.dr, &body.w}) add(x->data(), 3);
  add(body.A.data(), 9);
  if (body.modes > 0) {
    for (int k = 0; k < body.modes; ++k) scratch.state.push_back(body.a[k]);
    for (int k = 0; k < body.modes; ++k) scratch.state.push_back(body.da[k]);
  }
  add(in.z.data(), in.z.size());
  return scratch.state.size() == scratch.known_state.size() &&
         std::memcmp(scratch.state.data(), scratch.known_state.data(), scratch.state.size() * sizeof(double)) == 0 &&
         scratch.known_with == with;
}

TerrainContact::Scratch& TerrainContact::find_contacts(const ElementInput& in, Terrain::With with) const {
  Scratch& scratch = scratch_of<Scratch>(in);
  if (is_known(in, with, scratch)) return scratch;
  scratch.known_state.clear();
  scratch.count = 0;
  scratch.lanes.clear();
  scratch.candidates.clear();
  scratch.ways.clear();
  scratch.ds_known = false;
  touch_all(in, with, scratch);
  const auto before = [](const Contact& a, const Contact& b) { return a.place < b.place; };
  const auto begin = scratch.contacts.begin(), end = begin + static_cast<std::ptrdiff_t>(scratch.count);
  if (!std::is_sorted(begin, end, before)) std::stable_sort(begin, end, before);
  scratch.known_state.swap(scratch.state);
  scratch.known_with = with;
  return scratch;
}

void TerrainContact::touch_all(const ElementInput& in, Terrain::With with, Scratch& scratch) const {
  constexpr double kParts = 32.0;  // of the reach: steps in which it grows as the body bends, so that a lid lasts
  const BodyKinematics& body = *in.pair.body[0];
  double reach = reach_;
  if (body.modes > 0) reach += std::ceil(kParts * flexible_reach_ * body.a.norm() / reach_) * reach_ / kParts;
  const Terrain::Lid& lid = lid_over(body.r, reach, scratch);
  if (lid.rocks.empty() && (!field_ || body.r.z() - reach > lid.top || lid.above(body.r, reach))) return;
  offer_own_points(in, lid, scratch);
  int place = static_cast<int>(own_.size());
  for (std::size_t k = 0; k < rims_.size(); ++k, place += kEdgePlaces) offer_rim(in, k, place, lid, scratch);
  touch(in, lid, with, scratch);
}

template <class Use>
void TerrainContact::Scratch::each_place(Use use) const {
  for (std::size_t i = 0, end = 0; i < count; i = end) {
    while (end < count && contacts[end].place == contacts[i].place) ++end;
    use(&contacts[i], static_cast<int>(end - i));
  }
}

// T^T clip(u), the mean over the contacts of a place [m/s].
Eigen::Vector2d TerrainContact::spring_drive(const Contact* contacts, int count) const {
  Eigen::Vector2d drive = Eigen::Vector2d::Zero();
  for (int i = 0; i < count; ++i) drive += parts_along(contacts[i].n, law_.clipped(contacts[i].u)) / count;
  return drive;
}

void TerrainContact::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q,
                               Eigen::Ref<Eigen::VectorXd> dz) const {
  Scratch& scratch = find_contacts(in, Terrain::With::kNormal);
  const BodyKinematics& body = *in.pair.body[0];
  const bool springs = law_.stick_time > 0.0;
  if (springs) dz = -in.z / law_.stick_time;
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
  scratch.each_place([&](const Contact* contacts, int count) {
    const int place = contacts->place;
    Eigen::Vector3d here = Eigen::Vector3d::Zero();
    for (int i = 0; i < count; ++i) {
      const Contact& at = contacts[i];
      here += at.force;
      moment += (at.d - at.radius * at.n).cross(at.force);
      if (at.way >= 0 && scratch.ways[at.way].drags)
        Q.head<6>() -= at.normal.elastic * scratch.ways[at.way].drag.transpose();
    }
    force += here;
    if (body.modes > 0) scratch.forces.segment<3>(3 * place).noalias() = body.A.transpose().lazyProduct(here);
    if (springs) dz.segment<2>(2 * place) += spring_drive(contacts, count);
  });
  const ContactLanes& lanes = scratch.lanes;
  Q.head<3>() += force;
  Q.segment<3>(3) += moment;
  Q.head<6>() += lanes.wrench();
  if (springs) lanes.add_drive(dz);
  if (body.modes == 0 || (scratch.count == 0 && lanes.count() == 0)) return;
  for (int i = 0; i < lanes.count(); ++i)
    scratch.forces.segment<3>(3 * lanes.spring(i)).noalias() = body.A.transpose().lazyProduct(lanes.force(i));
  Q.segment(6, body.modes).noalias() += own_S_.transpose() * scratch.forces;
  scratch.forces.setZero();
}

bool TerrainContact::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  const bool springs = law_.stick_time > 0.0;
  if (springs) out.ddz_dz.noalias() -= Eigen::Matrix2d::Identity().replicate(place_count(), 1) / law_.stick_time;
  Scratch& scratch = find_contacts(in, Terrain::With::kBend);
  scratch.each_place([&](const Contact* contacts, int count) {
    for (int i = 0; i < count; ++i) add_derivatives(in, contacts[i], 1.0 / count, scratch, out);
  });
  return springs || scratch.count > 0;
}

// The derivatives of one contact, W the way of a place along its edge:
//   D = X + W,  N = dn/dx = H D,  G = X + R n~ E                g = G v, Q = G^T f
//   g_x = g_0 - R w~ N,  g_0 = p'_x + w~ W,   u_x = P g_x + u_N N,  u_N = -(n.g) - n g^T + d(T s)/dn / tau
// With f = f_n e, e = n - mu u / sqrt(u^2 + v_s^2), these are
//   f_x = f_g g_0 + f_N N - (df_n/d delta) e n^T D,  f_g = f_u P - (df_n/d delta') e n^T,
//   f_N = f_u u_N + f_n - (df_n/d delta') e g^T - R f_g w~,  f_v = f_g G
void TerrainContact::add_derivatives(const ElementInput& in, const Contact& at, double share, Scratch& scratch,
                                     ElementDerivatives& out) const {
  const BodyKinematics& body = *in.pair.body[0];
  const int place = at.place, n = in.pair.size();
  if (at.point == kOnRim) scratch.on_rim.s0 = at.s;
  const Marker& marker = at.point == kOnRim ? scratch.on_rim : points_[at.point].marker;
  const Way* const way = at.way < 0 ? nullptr : &scratch.ways[at.way];
  const double tau = law_.stick_time, mu = law_.friction, R = at.radius, inverse = at.inverse_speed;
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity(), P = unit - at.n * at.n.transpose(), turning = skew(body.w);
  Eigen::Matrix3Xd &G = scratch.G, &g_0 = scratch.g_0, &f_x = scratch.f_x, &f_v = scratch.f_v;
  G.setZero(3, n);
  g_0.setZero(3, n);
  f_x.resize(3, n);
  f_v.resize(3, n);
  const KinematicVector p = KinematicVector::point(in.pair, 0, marker);
  p.add_jacobian(G);
  p.add_rate_jacobian(g_0);

  Eigen::Matrix3d u_N = -at.n.dot(at.g) * unit - at.n * at.g.transpose();
  if (tau > 0.0) u_N += slope_of_tangent(at.n, in.z.segment<2>(2 * place) / tau);
  const Eigen::Vector3d e = at.n - mu * inverse * at.u;
  const Eigen::Matrix3d f_u =
      (-mu * at.normal.force * inverse) * (unit - (inverse * inverse) * at.u * at.u.transpose());
  const Eigen::Matrix3d f_g = f_u * P - at.normal.by_closing * e * at.n.transpose();
  const Eigen::Matrix3d f_N =
      f_u * u_N + at.normal.force * unit - at.normal.by_closing * e * at.g.transpose() - R * f_g * turning;
  const Eigen::Matrix3d f_D = -at.normal.by_overlap * e * at.n.transpose();
  // s' = T^T clip(u) - s / tau: the share of this contact.
  const ContactLaw::Clipped clipped = law_.clip(at.u);
  const Tangents T = tangents_at(at.n);
  const Eigen::Matrix<double, 2, 3> s_u = share * T.transpose() * clipped.slope, s_g = s_u * P,
                                    s_N = s_u * u_N - R * s_g * turning + share * slope_of_parts(at.n, clipped.value);
  const Eigen::Matrix3d f = skew(at.force);

  // What follows from N, before G has more than X.
  if (way == nullptr) {
    f_x.noalias() = (f_N * at.H + f_D).lazyProduct(G);
    if (R > 0.0) out.dQ_dx.middleRows<3>(3).noalias() += (R * f * at.H).lazyProduct(G);
    if (tau > 0.0) out.ddz_dx.middleRows<2>(2 * place).noalias() += (s_N * at.H).lazyProduct(G);
  } else {
    Eigen::Matrix3Xd D = G;
    D.leftCols<6>() += way->wander;
    g_0.leftCols<6>() += turning * way->wander;
    Eigen::Matrix3Xd N = Eigen::Matrix3Xd::Zero(3, n);
    if (way->turns)
      N.leftCols<6>() = way->turn;
    else
      N.noalias() = at.H.lazyProduct(D);
    f_x.noalias() = f_N.lazyProduct(N);
    f_x.noalias() += f_D.lazyProduct(way->drags ? G : D);
    if (way->drags) f_x.leftCols<6>() += at.force * way->growth;
    out.dQ_dx.middleRows<3>(3).noalias() += (R * f).lazyProduct(N);
    out.dQ_dx.block<3, 6>(3, 0) -= f * way->wander;
    if (tau > 0.0) out.ddz_dx.middleRows<2>(2 * place).noalias() += s_N.lazyProduct(N);
    if (way->drags) {  // of elastic overlap by_level^T, by_level = -a_z m^T / |a_h|^2, m = a x z
      const Eigen::Matrix<double, 1, 6> along_n = at.n.transpose() * G.leftCols<6>(),
                                        elastic = way->growth - (1.5 / at.overlap) * along_n,
                                        overlap = way->stretch - (1.0 / at.overlap) * along_n;
      out.dQ_dx.topLeftCorner<6, 6>() -= at.normal.elastic * way->drag.transpose() * (elastic + overlap);
      const Eigen::Vector3d a = body.A * rims_[way->rim].marker.axes.col(2), m = a.cross(Eigen::Vector3d::UnitZ());
      const double h = m.squaredNorm();
      Eigen::Matrix3d by_a = (1.0 / h + 2.0 * a.z() * a.z() / (h * h)) * m * m.transpose() - (a.z() * a.z() / h) * unit;
      by_a.col(2) += (a.z() / h) * a;
      out.dQ_dx.block<3, 3>(3, 3) += at.normal.elastic * at.overlap * by_a;
    }
  }
  if (R > 0.0) G.middleCols<3>(3) += R * skew(at.n);
  f_x.noalias() += f_g.lazyProduct(g_0);
  f_v.noalias() = f_g.lazyProduct(G);

  out.dQ_dx.noalias() += G.transpose().lazyProduct(f_x);
  out.dQ_dv.noalias() += G.transpose().lazyProduct(f_v);
  p.add_second(at.force, out.dQ_dx);
  if (tau == 0.0) return;
  out.dQ_dz.middleCols<2>(2 * place).noalias() += G.transpose().lazyProduct(f_u * T / tau);
  out.ddz_dv.middleRows<2>(2 * place).noalias() += s_g.lazyProduct(G);
  out.ddz_dz.middleRows<2>(2 * place) += s_u * T / tau;
  out.ddz_dx.middleRows<2>(2 * place).noalias() += s_g.lazyProduct(g_0);
}

void TerrainContact::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  Scratch& scratch = find_contacts(in, Terrain::With::kNormal);
  scratch.lanes.add_energy(law_, stored, power);
  scratch.each_place([&](const Contact* contacts, int count) {
    Eigen::Vector2d rate = Eigen::Vector2d::Zero();
    if (law_.stick_time > 0.0)
      rate = spring_drive(contacts, count) - in.z.segment<2>(2 * contacts->place) / law_.stick_time;
    for (int i = 0; i < count; ++i) contacts[i].add_energy(law_, along(contacts[i].n, rate), stored, power);
  });
}

Eigen::Matrix<double, 6, 1> TerrainContact::wrench(const ElementInput& in) const {
  const Scratch& scratch = find_contacts(in, Terrain::With::kNormal);
  Eigen::Matrix<double, 6, 1> out = scratch.lanes.wrench();
  for (std::size_t i = 0; i < scratch.count; ++i) {
    const Contact& at = scratch.contacts[i];
    out.head<3>() += at.force;
    out.tail<3>() += (at.d - at.radius * at.n).cross(at.force);
    if (at.way >= 0 && scratch.ways[at.way].drags) out -= at.normal.elastic * scratch.ways[at.way].drag.transpose();
  }
  return out;
}

double TerrainContact::largest_overlap(const ElementInput& in) const {
  const Scratch& scratch = find_contacts(in, Terrain::With::kNormal);
  double largest = scratch.lanes.largest_overlap();
  for (std::size_t i = 0; i < scratch.count; ++i) largest = std::max(largest, scratch.contacts[i].overlap);
  return largest;
}

bool TerrainContact::touches_rock(const ElementInput& in) const {
  const Scratch& scratch = find_contacts(in, Terrain::With::kNormal);
  return std::any_of(scratch.contacts.begin(), scratch.contacts.begin() + static_cast<std::ptrdiff_t>(scratch.count),
                     [](const Contact& at) { return at.on_rock; });
}

}  // namespace footfall
