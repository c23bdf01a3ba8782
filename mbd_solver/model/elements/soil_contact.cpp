// Heights are tested first, so that facets above the ground cost little; then the law, in the axes of the ground.

#include "mbd_solver/model/elements/soil_contact.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/kinematic_vector.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kMoved = 0.5;   // of a facet's size: beyond, it is at another place of the ground
constexpr double kFound = 1.0;   // of a facet's size: a print nearer than this is under it
constexpr double kJoined = 0.5;  // of a facet's size: prints nearer than this are one
constexpr int kNumbers = 9;      // of a SoilMemory

}  // namespace

// ---- prints ----

long SoilGround::key(double x, double y) const {
  const long i = static_cast<long>(std::floor(x / cell_)), j = static_cast<long>(std::floor(y / cell_));
  return i * 2000003L + j;
}

int SoilGround::nearest(const Eigen::Vector2d& place, double within) const {
  int found = -1;
  double least = within * within;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      const auto cell = cells_.find(key(place.x() + i * cell_, place.y() + j * cell_));
      if (cell == cells_.end()) continue;
      for (const int k : cell->second) {
        const double square = (prints_[k].place - place).squaredNorm();
        if (square > least || (square == least && found >= 0 && k > found)) continue;
        least = square;
        found = k;
      }
    }
  }
  return found;
}

void SoilGround::leave(const Eigen::Vector2d& place, double depth, double apart) {
  if (!(depth > 0.0)) return;
  if (const int k = nearest(place, std::min(apart, cell_)); k >= 0) {
    double& known = prints_[k].depth;
    known = std::max(known, depth);
    return;
  }
  cells_[key(place.x(), place.y())].push_back(static_cast<int>(prints_.size()));
  prints_.push_back({place, depth});
}

double SoilGround::depth_at(const Eigen::Vector2d& place, double within) const {
  if (prints_.empty()) return 0.0;
  const int k = nearest(place, std::min(within, cell_));
  return k < 0 ? 0.0 : prints_[k].depth;
}

void SoilGround::restore(std::vector<Print> prints) {
  prints_ = std::move(prints);
  cells_.clear();
  for (std::size_t k = 0; k < prints_.size(); ++k)
    cells_[key(prints_[k].place.x(), prints_[k].place.y())].push_back(static_cast<int>(k));
}

// ---- contact ----

struct SoilContact::Touch {
  const SoilFacet* facet = nullptr;
  MovingPoint p;
  SoilPoint at;
  SoilStress stress;
  Covered covered;
  Eigen::Vector3d whole =
      Eigen::Vector3d::Zero();  // force on the body if all of the facet were in the ground, in W [N]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // on the body, in W [N]
  Frame frame;
};

struct SoilContact::Scratch : ElementScratch {
  Scratch(const ForceElement& element, std::shared_ptr<Terrain> uneven, std::shared_ptr<SoilGround> tracks,
          Eigen::Index n)
      : ElementScratch(element), terrain(std::move(uneven)), ground(std::move(tracks)), X(3, n), by_x(3, n) {}
  std::shared_ptr<Terrain> terrain;
  std::shared_ptr<SoilGround> ground;
  std::vector<SoilMemory> memory;  // of the facets, at the last end of a step
  Eigen::Matrix3Xd X, by_x;
};

SoilContact::SoilContact(std::string name, std::vector<SoilFacet> facets, bool two_sided, const Surface& place,
                         std::shared_ptr<const SoilLaw> law, std::shared_ptr<const SoilGround> ground,
                         bool keeps_ground)
    : ContactElement(std::move(name), facets.empty() ? kGround : facets.front().marker.body, kGround),
      facets_(std::move(facets)),
      two_sided_(two_sided),
      point_(place.point),
      terrain_(place.terrain),
      law_(std::move(law)),
      ground_(std::move(ground)),
      keeps_ground_(keeps_ground) {
  const std::string where = "soil under \"" + this->name() + "\": ";
  if (facets_.empty()) throw InputError(code::kNoContactPoints, where + "no facets given.");
  if (!(place.normal.norm() > 0.0))
    throw InputError(code::kParameterOutOfRange, where + "the normal must not be zero.");
  const Eigen::Vector3d up = place.normal.normalized();
  const Eigen::Matrix3d tangents = axes_with_z(up);
  axes_.row(0) = tangents.col(0).transpose();
  axes_.row(1) = tangents.col(1).transpose();
  axes_.row(2) = -up.transpose();
  for (const SoilFacet& facet : facets_) {
    FOOTFALL_DEMAND(facet.marker.body == bodies()[0] && facet.marker.body != kGround);
    reach_ = std::max(reach_, facet.marker.s0.norm());
    flexible_reach_ = std::max(flexible_reach_, facet.marker.S.norm());
    area_ += facet.area;
  }
}

std::unique_ptr<ElementScratch> SoilContact::scratch(SharedCopies& shared) const {
  auto out =
      std::make_unique<Scratch>(*this, shared.of(terrain_), shared.of(ground_), 6 + facets_.front().marker.S.cols());
  const double* nothing = nullptr;
  recall(nothing, *out);
  return out;
}

bool SoilContact::far(const BodyKinematics& body, const Scratch& scratch) const {
  const double reach = body.modes == 0 ? reach_ : reach_ + flexible_reach_ * body.a.norm();
  if (terrain_) {
    const Terrain::Lid lid = scratch.terrain->lid(body.r, reach);
    return lid.rocks.empty() && lid.above(body.r, reach);
  }
  return axes_.row(2).dot(body.r - point_) < -reach;
}

double SoilContact::size_of(const SoilFacet& facet) const { return std::sqrt(facet.area); }

SoilContact::Covered SoilContact::covered(const SoilFacet& facet, const BodyKinematics& body,
                                          const Eigen::Vector3d& down, double depth) {
  Covered out;
  if (facet.corners.empty()) return out;
  const Eigen::Vector3d up_B = -(body.A.transpose() * down);
  double squares = 0.0, cubes = 0.0;
  for (const Eigen::Vector3d& corner : facet.corners) {
    const double h = std::max(0.0, up_B.dot(corner));
    squares += h * h;
    cubes += h * h * h;
  }
  if (!(depth * squares < cubes)) return out;
  const double height = cubes / squares;
  out.share = depth / height;
  out.by_depth = 1.0 / height;
  for (const Eigen::Vector3d& corner : facet.corners) {
    const double h = std::max(0.0, up_B.dot(corner)), by_h = h * (3.0 * h - 2.0 * height) / squares;
    out.by_turn += out.share / height * by_h * (body.A * corner).cross(down);  // -s/H dH, dh = (A c x up) dtheta
  }
  return out;
}

// A facet that has moved without touching is over another place of the ground: over the print that is there, or, where it has come
// below the untouched ground around its print, over ground that has given way to it.
void SoilContact::look_below(std::size_t facet, const Eigen::Vector3d& place, Scratch& scratch) const {
  SoilMemory& memory = scratch.memory[facet];
  const double size = size_of(facets_[facet]);
  if (memory.touches || (place.head<2>() - memory.printed).squaredNorm() <= kMoved * kMoved * size * size) return;
  memory.print = std::max({0.0, place.z(), scratch.ground->depth_at(place.head<2>(), kFound * size)});
  memory.printed = place.head<2>();
}

SoilPoint SoilContact::point_of(const ElementInput& in, const SoilFacet& facet, const MovingPoint& p) const {
  const BodyKinematics& body = *in.pair.body[0];
  const Eigen::Vector3d normal = body.A * facet.normal;
  return {axes_ * (p.value() - point_), axes_ * normal, axes_ * p.rate()};
}

SoilPoint SoilContact::point_on_terrain(const ElementInput& in, std::size_t facet, const MovingPoint& p,
                                        const Scratch& scratch, Frame& frame) const {
  const BodyKinematics& body = *in.pair.body[0];
  const SoilMemory& memory = scratch.memory[facet];
  const Terrain::Height there = scratch.terrain->at(memory.place.x(), memory.place.y());
  const Eigen::Vector3d origin(memory.place.x(), memory.place.y(), there.h);
  const Eigen::Vector3d up = Eigen::Vector3d(-there.slope.x(), -there.slope.y(), 1.0).normalized();
  const Eigen::Matrix3d tangents = axes_with_z(up);
  frame.axes.row(0) = tangents.col(0).transpose();
  frame.axes.row(1) = tangents.col(1).transpose();
  frame.axes.row(2) = -up.transpose();
  const Terrain::Foot foot = scratch.terrain->foot(p.value());
  frame.by_p = frame.axes;
  frame.by_p.row(2) = -foot.normal.transpose();
  frame.spot = {foot.place.x(), foot.place.y(), -foot.distance};
  const Eigen::Vector3d normal = body.A * facets_[facet].normal;
  SoilPoint at{frame.axes * (p.value() - origin), frame.axes * normal, frame.axes * p.rate()};
  at.place.head<2>() += memory.place;
  at.place.z() = -foot.distance;
  return at;
}

template <class Use>
void SoilContact::each_touch(const ElementInput& in, SoilLaw::With with, Use use) const {
  const BodyKinematics& body = *in.pair.body[0];
  const Scratch& scratch = scratch_of<Scratch>(in);
  if (far(body, scratch)) return;
  if (terrain_) {
    const double up_to = body.modes == 0 ? reach_ : reach_ + flexible_reach_ * body.a.norm();
    const Terrain::Lid lid = scratch.terrain->lid(body.r, up_to);
    Touch touch;
    for (std::size_t k = 0; k < facets_.size(); ++k) {
      const SoilFacet& facet = facets_[k];
      touch.p = MovingPoint(body, facet.marker);
      const Eigen::Vector2d away = (touch.p.value() - body.r).head<2>();
      if (touch.p.value().z() - lid.height - lid.slope.dot(away) > 0.5 * lid.bend * away.squaredNorm()) continue;
      touch.at = point_on_terrain(in, k, touch.p, scratch, touch.frame);
      if (!(touch.at.place.z() > 0.0)) continue;
      const SoilMemory& memory = scratch.memory[k];
      if (!(touch.at.place.z() > memory.print)) continue;
      touch.facet = &facet;
      touch.stress = law_->stress(touch.at, memory, two_sided_, with);
      touch.covered = covered(facet, body, touch.frame.axes.row(2), touch.at.place.z());
      touch.whole = touch.frame.axes.transpose() * (facet.area * (touch.stress.traction + touch.stress.inertia));
      touch.force = touch.covered.share * touch.whole;
      use(touch);
    }
    return;
  }
  const Eigen::Vector3d down_B = body.A.transpose() * axes_.row(2).transpose();
  const double depth = axes_.row(2).dot(body.r - point_);
  Touch touch;
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    const SoilFacet& facet = facets_[k];
    double z = depth + down_B.dot(facet.marker.s0);
    for (Eigen::Index i = 0; i < facet.marker.S.cols(); ++i) z += down_B.dot(facet.marker.S.col(i)) * body.a[i];
    if (!(z > 0.0)) continue;
    const SoilMemory& memory = scratch.memory[k];
    if (!(z > memory.print)) continue;
    touch.p = MovingPoint(body, facet.marker);
    touch.at = point_of(in, facet, touch.p);
    touch.facet = &facet;
    touch.frame.axes = touch.frame.by_p = axes_;
    touch.stress = law_->stress(touch.at, memory, two_sided_, with);
    touch.covered = covered(facet, body, axes_.row(2), z);
    touch.whole = axes_.transpose() * (facet.area * (touch.stress.traction + touch.stress.inertia));
    touch.force = touch.covered.share * touch.whole;
    use(touch);
  }
}

void SoilContact::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd>) const {
  each_touch(in, SoilLaw::With::kTraction, [&](const Touch& touch) { touch.p.add_transposed(touch.force, Q); });
}

bool SoilContact::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  // f = s a R^T t(R p, R n, R p'):  df = s a R^T (t_p R dp + t_n R (-n~) dtheta + t_v R dp') + f/s (s_z dz + s_theta dtheta)
  Eigen::Matrix3Xd &X = scratch_of<Scratch>(in).X, &by_x = scratch_of<Scratch>(in).by_x;
  bool any = false;
  const BodyKinematics& body = *in.pair.body[0];
  each_touch(in, SoilLaw::With::kSlope, [&](const Touch& touch) {
    any = true;
    const Eigen::Matrix3d& axes = touch.frame.axes;
    const Covered& covered = touch.covered;
    const Eigen::Matrix3d turned = covered.share * touch.facet->area * axes.transpose();
    Eigen::Matrix3d by_p = turned * touch.stress.slope.leftCols<3>() * touch.frame.by_p;
    if (covered.by_depth > 0.0) by_p += covered.by_depth * touch.whole * touch.frame.by_p.row(2);
    const Eigen::Matrix3d by_n = turned * touch.stress.slope.middleCols<3>(3) * axes;
    const Eigen::Matrix3d by_v = turned * touch.stress.slope.rightCols<3>() * axes;
    X.setZero();
    by_x.setZero();
    const KinematicVector p = KinematicVector::point(in.pair, 0, touch.facet->marker);
    p.add_jacobian(X);
    p.add_rate_jacobian(by_x);
    for (Eigen::Index j = 0; j < X.cols(); ++j) {  // df/dx
      const Eigen::Vector3d column = by_v * by_x.col(j) + by_p * X.col(j);
      by_x.col(j) = column;
    }
    by_x.block<3, 3>(0, 3) -= by_n * skew(body.A * touch.facet->normal);
    if (covered.by_depth > 0.0) by_x.block<3, 3>(0, 3) += touch.whole * covered.by_turn.transpose();
    out.dQ_dx.noalias() += X.transpose().lazyProduct(by_x);
    by_x.noalias() = by_v.lazyProduct(X);  // df/dv
    out.dQ_dv.noalias() += X.transpose().lazyProduct(by_x);
    p.add_second(touch.force, out.dQ_dx);
  });
  return any;
}

// All work on the ground counts as dissipated, also what its elastic part gives back within the rebound: its power has no jump where
// the ground yields, unlike the power of the rest, so that its integral is as accurate as the motion.
void SoilContact::add_energy(const ElementInput& in, StoredEnergy&, Dissipated& power) const {
  each_touch(in, SoilLaw::With::kTraction, [&](const Touch& touch) {
    const double area = touch.covered.share * touch.facet->area;
    power[Dissipation::kSoil] -= area * touch.stress.traction.dot(touch.at.velocity);
    power[Dissipation::kSoilInertia] -= area * touch.stress.inertia.dot(touch.at.velocity);
  });
}

// ---- memory ----

void SoilContact::recall(const double*& from, ElementScratch& in) const {
  auto& scratch = own_scratch<Scratch>(in);
  scratch.memory.assign(facets_.size(), SoilMemory());
  if (from == nullptr) {
    for (std::size_t k = 0; k < facets_.size(); ++k) {
      Eigen::Vector3d start = axes_ * (facets_[k].start - point_);
      if (terrain_) {
        const Terrain::Foot foot = scratch.terrain->foot(facets_[k].start);
        start = {foot.place.x(), foot.place.y(), -foot.distance};
      }
      scratch.memory[k].printed = scratch.memory[k].place = start.head<2>();
      scratch.memory[k].print = std::max(0.0, start.z());
      scratch.memory[k].touches = start.z() > 0.0;
    }
    if (keeps_ground_) scratch.ground->restore({});
    return;
  }
  for (SoilMemory& m : scratch.memory) {
    m.print = from[0];
    m.place = {from[1], from[2]};
    m.shear = {from[3], from[4]};
    m.printed = {from[5], from[6]};
    m.touches = from[7] != 0.0;
    m.limit = from[8];
    from += kNumbers;
  }
  if (!keeps_ground_) return;
  std::vector<SoilGround::Print> prints(static_cast<std::size_t>(*from++));
  for (SoilGround::Print& print : prints) {
    print = {{from[0], from[1]}, from[2]};
    from += 3;
  }
  scratch.ground->restore(std::move(prints));
}

void SoilContact::save_memory(const ElementScratch& in, std::vector<double>& out) const {
  const auto& scratch = own_scratch<const Scratch>(in);
  for (const SoilMemory& m : scratch.memory)
    out.insert(out.end(), {m.print, m.place.x(), m.place.y(), m.shear.x(), m.shear.y(), m.printed.x(), m.printed.y(),
                           m.touches ? 1.0 : 0.0, m.limit});
  if (!keeps_ground_) return;
  out.push_back(static_cast<double>(scratch.ground->prints().size()));
  for (const SoilGround::Print& print : scratch.ground->prints())
    out.insert(out.end(), {print.place.x(), print.place.y(), print.depth});
}

bool SoilContact::remember(const ElementInput& in) const {
  const BodyKinematics& body = *in.pair.body[0];
  Scratch& scratch = scratch_of<Scratch>(in);
  const bool away = far(body, scratch);
  bool changed = false;
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    SoilMemory& m = scratch.memory[k];
    if (away && !m.touches && m.print == 0.0) continue;
    const MovingPoint p(body, facets_[k].marker);
    Frame frame;
    const SoilPoint at = terrain_ ? point_on_terrain(in, k, p, scratch, frame) : point_of(in, facets_[k], p);
    const Eigen::Vector3d spot = terrain_ ? frame.spot : at.place;
    const bool touched = m.touches;
    look_below(k, spot, scratch);
    if (!touched) m.place = (terrain_ ? spot : at.place).head<2>();
    if (!touched && !(at.place.z() > m.print)) continue;
    law_->remember(at, m);
    if (terrain_ && m.place == at.place.head<2>()) m.place = spot.head<2>();
    changed = true;
    const double size = size_of(facets_[k]);
    if (touched && !m.touches) {
      scratch.ground->leave(m.printed, m.print, kJoined * size);
    } else if (m.touches && !touched) {
      m.printed = spot.head<2>();
    } else if (m.touches && (spot.head<2>() - m.printed).squaredNorm() > kMoved * kMoved * size * size) {
      scratch.ground->leave(m.printed, m.print, kJoined * size);  // a facet that slides carries its depth along
      m.printed = spot.head<2>();
    }
  }
  return changed;
}

Eigen::Matrix<double, 6, 1> SoilContact::wrench(const ElementInput& in) const {
  Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
  each_touch(in, SoilLaw::With::kTraction, [&](const Touch& touch) {
    out.head<3>() += touch.force;
    out.tail<3>() += (touch.p.value() - in.pair.body[0]->r).cross(touch.force);
  });
  return out;
}

double SoilContact::largest_overlap(const ElementInput& in) const {
  double largest = 0.0;
  const BodyKinematics& body = *in.pair.body[0];
  if (far(body, scratch_of<Scratch>(in))) return largest;
  if (terrain_) {
    each_touch(in, SoilLaw::With::kTraction,
               [&](const Touch& touch) { largest = std::max(largest, touch.at.place.z()); });
    return largest;
  }
  for (const SoilFacet& facet : facets_)
    largest = std::max(largest, point_of(in, facet, MovingPoint(body, facet.marker)).place.z());
  return largest;
}

}  // namespace footfall
