// The parts of the lander are chosen once. A sample then gives the places of pads and points, d and E over all edges, and what
// is kept: first contacts, stops and extremes.

#include "mbd_solver/session/observe/landing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/session/codes.h"

namespace footfall {

namespace {

constexpr double kVertical = 1e-9;  // an edge or an area this small, over the size of the lander, has no direction [-]

[[noreturn]] void throw_pads(const Scene& scene, const std::string& what) {
  throw InputError(code::kLandingPads, place_of(scene.file, scene.landing->source, "pads") + what);
}

// Twice the area of the triangle o a b, positive counter-clockwise.
double turn(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a - o).x() * (b - o).y() - (a - o).y() * (b - o).x();
}

// Andrew's monotone chain: indices of the convex hull, counter-clockwise, without points on its edges.
std::vector<std::size_t> hull_of(const std::vector<Eigen::Vector2d>& points) {
  std::vector<std::size_t> order(points.size()), hull;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].x() != points[b].x() ? points[a].x() < points[b].x() : points[a].y() < points[b].y();
  });
  for (int half = 0; half < 2; ++half) {
    const std::size_t before = hull.size();
    for (const std::size_t i : order) {
      while (hull.size() >= before + 2 && turn(points[hull[hull.size() - 2]], points[hull.back()], points[i]) <= 0.0)
        hull.pop_back();
      hull.push_back(i);
    }
    hull.pop_back();
    std::reverse(order.begin(), order.end());
  }
  return hull;
}

void see_least(Peak& extreme, double value, double time, bool first) {
  if (first || value < extreme.value) extreme = {value, time};
}

std::vector<LandingWatch::First> in_order(const std::vector<std::string>& names,
                                          const std::vector<std::optional<double>>& times) {
  std::vector<LandingWatch::First> firsts;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (times[i]) firsts.push_back({names[i], *times[i]});
  std::stable_sort(firsts.begin(), firsts.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return firsts;
}

}  // namespace

GroundLevel ground_level(const Subject& subject) {
  const GroundSpec& ground = subject.scene.ground;
  if (ground.is_flat()) {
    const auto& terrain = subject.mechanism.terrain;
    return {ground.normal(), ground.normal().dot(ground.point()),
            terrain ? std::make_shared<Terrain>(*terrain) : nullptr};
  }
  if (const std::shared_ptr<Terrain> field = build_bed_surface(subject.scene)) {
    TerrainSpec bare = *ground.terrain;  // rocks are bodies that lie on the field
    bare.rocks.clear();
    bare.rock_field.reset();
    if (!bare.is_plane()) return {Eigen::Vector3d::UnitZ(), 0.0, field};
    const Terrain::Height origin = field->at(0.0, 0.0);  // z = h + s_x x + s_y y
    const Eigen::Vector3d normal = Eigen::Vector3d(-origin.slope.x(), -origin.slope.y(), 1.0).normalized();
    return {normal, normal.z() * origin.h, nullptr};
  }
  return {axis_towards(up_direction(subject.scene.gravity)), subject.mechanism.placement.bed_height, nullptr};
}

LandingWatch::LandingWatch(const Subject& subject)
    : subject_(subject), up_(up_direction(subject.scene.gravity)), ground_(ground_level(subject)) {
  const LandingSpec& spec = *subject_.scene.landing;
  choose_base();
  choose_bodies();
  for (const LandingPointSpec& point : spec.points) points_.push_back(place_of_point(point));
  choose_pads();
  choose_edges();
  const Eigen::Vector3d axis_D = spec.axis ? *spec.axis : axis_towards(up_);
  const Eigen::Matrix3d A = rotation_matrix(subject_.mechanism.model.initial(lander_.base).L);
  lander_.axis_B = A.transpose() * subject_.mechanism.placement.R_WD * axis_D;
  now_.clearance.resize(points_.size());
  least_clearance_.resize(points_.size());
  pad_places_.resize(pads_.size());
  touched_.resize(pads_.size());
  touched_at_.resize(pads_.size(), Eigen::Vector3d::Zero());
  stopped_.resize(subject_.mechanism.struts.size());
  rests_.resize(stopped_.size(), false);
}

LandingWatch::LandingPoint LandingWatch::place_of_point(const LandingPointSpec& point) const {
  const int body = subject_.scene.body_index(point.body);
  const BodyState& start = subject_.mechanism.model.initial(body);
  return {body, rotation_matrix(start.L).transpose() * (subject_.mechanism.placement.point(point.point) - start.r),
          nullptr};
}

void LandingWatch::choose_base() {
  const Model& model = subject_.mechanism.model;
  const std::string& name = subject_.scene.landing->base;
  if (!name.empty()) {
    lander_.base = subject_.scene.body_index(name);
    return;
  }
  for (int i = 1; i < model.body_count(); ++i)
    if (model.body(i).mass() > model.body(lander_.base).mass()) lander_.base = i;
}

// The model has the bodies of the scene.
void LandingWatch::choose_bodies() {
  const Scene& scene = subject_.scene;
  std::vector<bool> found(scene.bodies.size(), false);
  found[lander_.base] = true;
  bool grows = true;
  const auto connect = [&](const auto& entries) {
    for (const auto& entry : entries) {
      const int a = scene.body_index(entry.bodies[0]), b = scene.body_index(entry.bodies[1]);
      if (a == kGround || b == kGround) continue;
      const auto i = static_cast<std::size_t>(a), k = static_cast<std::size_t>(b);
      if (found[i] == found[k]) continue;
      found[i] = found[k] = grows = true;
    }
  };
  while (grows) {
    grows = false;
    connect(scene.joints);
    connect(scene.struts);
    connect(scene.springs);
    connect(cable_pairs(scene.cables));
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    lander_.bodies.push_back(static_cast<int>(i));
    lander_.mass += subject_.mechanism.model.body(static_cast<int>(i)).mass();
  }
}

// By default the lander's bodies that have a boundary, without the base.
void LandingWatch::choose_pads() {
  const Scene& scene = subject_.scene;
  const std::vector<BodyBoundary>& boundaries = subject_.mechanism.boundaries;
  const auto add = [&](const std::string& name, int body) {
    const auto entry =
        std::find_if(boundaries.begin(), boundaries.end(), [&](const BodyBoundary& b) { return b.body == body; });
    pad_names_.push_back(name);
    pads_.push_back({body, Eigen::Vector3d::Zero(), entry == boundaries.end() ? nullptr : &*entry});
  };
  if (scene.landing->pads.empty()) {
    for (const BodyBoundary& entry : boundaries)
      if (entry.body != lander_.base &&
          std::find(lander_.bodies.begin(), lander_.bodies.end(), entry.body) != lander_.bodies.end())
        add(scene.bodies[entry.body].name, entry.body);
  }
  for (const std::string& name : scene.landing->pads) {
    const auto& points = scene.landing->points;
    const auto point = std::find_if(points.begin(), points.end(), [&](const auto& p) { return p.name == name; });
    if (point == points.end()) {
      add(name, scene.body_index(name));
    } else {
      pad_names_.push_back(name);
      pads_.push_back(points_[point - points.begin()]);
    }
  }
}

void LandingWatch::choose_edges() {
  const Scene& scene = subject_.scene;
  const Placement& placement = subject_.mechanism.placement;
  if (pads_.size() < 3)
    throw_pads(scene, "the lander has " + std::to_string(pads_.size()) + (pads_.size() == 1 ? " pad" : " pads") +
                          ", expected at least three on which it stands: name bodies with a boundary, or points of "
                          "[[landing.points]]");
  const Eigen::Vector3d axis_D = scene.landing->axis ? *scene.landing->axis : axis_towards(up_);
  const Eigen::Matrix3d axes = axes_with_z(axis_D);
  std::vector<Eigen::Vector2d> plan;
  double size = 0.0;
  for (const LandingPoint& pad : pads_) {
    const BodyState& start = subject_.mechanism.model.initial(pad.body);
    const Eigen::Vector3d p_W = start.r + rotation_matrix(start.L) * pad.p_B;
    plan.emplace_back((axes.transpose() * placement.R_WD.transpose() * (p_W - placement.p_WD)).head<2>());
    size = std::max(size, (plan.back() - plan.front()).norm());
  }
  edges_ = hull_of(plan);
  double area = 0.0;
  for (std::size_t i = 2; i < edges_.size(); ++i) area += turn(plan[edges_[0]], plan[edges_[i - 1]], plan[edges_[i]]);
  if (edges_.size() < 3 || !(area > kVertical * size * size))
    throw_pads(scene,
               "seen along the axis of the lander the pads are on one line, expected at least three that span an "
               "area; name other pads, or give landing.axis");
}

const std::string& LandingWatch::base() const { return subject_.mechanism.model.body(lander_.base).name(); }

// Horizontally the centre of a pad, as high as its lowest place.
Eigen::Vector3d LandingWatch::place_of(const LandingPoint& place, const Sample& sample) const {
  const BodyKinematics& body = sample.kinematics.of(place.body);
  if (place.boundary == nullptr) return body.r + body.A * place.p_B;
  const double lowest = lowest_place(*place.boundary, body.A.transpose() * up_, body.a);
  return std::isfinite(lowest) ? Eigen::Vector3d(body.r + lowest * up_) : body.r;
}

bool LandingWatch::touches(const LandingPoint& pad, const Eigen::Vector3d& p_W, const Sample& sample) const {
  if (sample.contact[pad.body].F_W.isZero(0.0)) return false;
  return pad.boundary != nullptr || ground_.above(p_W) <= 0.0;
}

bool LandingWatch::at_stop(std::size_t strut, const Sample& sample) const {
  const StrutSpec& spec = subject_.scene.struts[strut];
  if (!spec.stops && !spec.honeycomb) return false;
  const Handle<Strut> force = subject_.mechanism.struts[strut].force;
  const Strut& element = force.of(subject_.mechanism.model);
  const ElementInput in = element_input(subject_, sample, force.index());
  if (spec.stops) {
    const double stroke = element.motion(in.pair).stroke;
    if (spec.stops->largest_stroke && stroke >= *spec.stops->largest_stroke) return true;
    if (spec.stops->smallest_stroke && stroke <= *spec.stops->smallest_stroke && !rests_[strut]) return true;
  }
  for (std::size_t k = 0; spec.honeycomb && k < element.laws().size(); ++k) {
    const StrutLaw& law = *element.laws()[k];
    if (law.kind() != "honeycomb") continue;
    const Eigen::VectorXd z = in.z.segment(element.first_state(k), law.state_count());
    for (const Honeycomb::Report& report : static_cast<const Honeycomb&>(law).report(z))
      if (report.bottom_out > 0.0) return true;
  }
  return false;
}

void LandingWatch::measure_edges(const Sample& sample) {
  const Model& model = subject_.mechanism.model;
  Eigen::Vector3d c = Eigen::Vector3d::Zero();
  for (const int i : lander_.bodies) c += model.body(i).mass() / lander_.mass * sample.kinematics.of(i).r;
  const double weight = lander_.mass * subject_.scene.gravity.norm();
  now_.stability_distance = now_.tip_energy_margin = std::numeric_limits<double>::infinity();
  now_.fallen = false;
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const Eigen::Vector3d &p = pad_places_[edges_[k]], &next = pad_places_[edges_[(k + 1) % edges_.size()]];
    const Eigen::Vector3d e = next - p, side = up_.cross(e);
    if (!(side.norm() > kVertical * e.norm())) continue;  // one above the other: no vertical plane of its own
    const double d = side.normalized().dot(c - p);
    const Eigen::Vector3d u = e.normalized(), rho = (c - p) - u * u.dot(c - p);
    const double lift = weight * (rho.norm() * (up_ - u * u.dot(up_)).norm() - rho.dot(up_));
    double L = 0.0, I = 0.0;
    for (const int i : lander_.bodies) {
      const BodyKinematics& body = sample.kinematics.of(i);
      const double m = model.body(i).mass();
      const Eigen::Vector3d arm = body.r - p, u_B = body.A.transpose() * u;
      const Eigen::Vector3d J_u = model.body(i).rigid_inertia() * u_B;
      L += J_u.dot(body.A.transpose() * body.w) + m * arm.cross(body.dr).dot(u);
      I += J_u.dot(u_B) + m * arm.cross(u).squaredNorm();
    }
    const double turning = L * L / (2.0 * I);
    const double margin = d >= 0.0 ? lift - (L > 0.0 ? turning : 0.0) : -lift + (L > 0.0 ? -turning : turning);
    now_.stability_distance = std::min(now_.stability_distance, d);
    now_.tip_energy_margin = std::min(now_.tip_energy_margin, margin);
    now_.fallen = now_.fallen || (d < 0.0 && margin < 0.0);
  }
  if (std::isfinite(now_.stability_distance)) return;
  now_.stability_distance = now_.tip_energy_margin = 0.0;
}

// Times of a step's middle come after times of its end.
void LandingWatch::see_pads(const Sample& sample) {
  const double time = sample.state.time;
  now_.pads_touching = 0;
  now_.slid = 0.0;
  for (std::size_t i = 0; i < pads_.size(); ++i) {
    pad_places_[i] = place_of(pads_[i], sample);
    const bool touching = touches(pads_[i], pad_places_[i], sample);
    now_.pads_touching += touching ? 1 : 0;
    if (touching && (!touched_[i] || time < *touched_[i])) {
      touched_[i] = time;
      touched_at_[i] = pad_places_[i];
    }
    if (!touched_[i]) continue;
    const Eigen::Vector3d way = pad_places_[i] - touched_at_[i];
    const Eigen::Vector3d n = ground_.normal_at(pad_places_[i]);
    now_.slid = std::max(now_.slid, (way - n * n.dot(way)).norm());
  }
}

void LandingWatch::update(const Sample& sample) {
  const double time = sample.state.time;
  see_pads(sample);
  measure_edges(sample);
  const BodyKinematics& base = sample.kinematics.of(lander_.base);
  const Eigen::Vector3d axis = base.A * lander_.axis_B;
  now_.tilt = std::atan2(axis.cross(up_).norm(), axis.dot(up_));
  now_.struts_at_stops = 0;
  for (std::size_t k = 0; k < stopped_.size(); ++k) {
    if (!started_) rests_[k] = at_stop(k, sample);
    if (!at_stop(k, sample)) continue;
    ++now_.struts_at_stops;
    stopped_[k] = std::min(time, stopped_[k].value_or(time));
  }
  for (std::size_t k = 0; k < points_.size(); ++k) {
    now_.clearance[k] = ground_.above(place_of(points_[k], sample));
    see_least(least_clearance_[k], now_.clearance[k], time, !started_);
  }
  const bool begins = !started_ || (now_.pads_touching > 0 && !any_contact_);
  any_contact_ = any_contact_ || now_.pads_touching > 0;
  started_ = true;
  see_least(least_distance_, now_.stability_distance, time, begins);
  see_least(least_margin_, now_.tip_energy_margin, time, begins);
  if (begins || now_.tilt > largest_tilt_.value) largest_tilt_ = {now_.tilt, time};
}

std::vector<LandingWatch::First> LandingWatch::first_contacts() const { return in_order(pad_names_, touched_); }

std::vector<LandingWatch::First> LandingWatch::struts_at_stops() const {
  std::vector<std::string> names;
  for (const StrutEntry& strut : subject_.mechanism.struts) names.push_back(strut.name);
  return in_order(names, stopped_);
}

void LandingWatch::visit(Archive& archive) {
  archive.members<&LandingWatch::touched_, &LandingWatch::touched_at_, &LandingWatch::stopped_, &LandingWatch::rests_,
                  &LandingWatch::any_contact_, &LandingWatch::started_, &LandingWatch::least_distance_,
                  &LandingWatch::least_margin_, &LandingWatch::largest_tilt_, &LandingWatch::least_clearance_>(*this);
}

namespace {

constexpr int kStands = 3;  // pads

}  // namespace

LandingEnd::LandingEnd(const Subject& subject, const LandingWatch& landing)
    : spec_(*subject.scene.landing), base_(landing.base_body()), bodies_(landing.bodies()) {
  const Model& model = subject.mechanism.model;
  const Eigen::Vector3d r_base = model.initial(base_).r;
  for (const int i : bodies_) length_ = std::max(length_, (model.initial(i).r - r_base).norm());
  const Body& base = model.body(base_);
  length_ += std::sqrt(base.rigid_inertia().selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff() / base.mass());
}

bool LandingEnd::moves(const Sample& sample, const LandingWatch& landing) const {
  bool touches = false;
  for (const int i : bodies_) {
    if (!(sample.kinematics.of(i).dr.norm() <= spec_.rest_speed)) return true;
    touches = touches || !sample.contact[i].F_W.isZero(0.0);
  }
  if (!(sample.kinematics.of(base_).w.norm() * length_ <= spec_.rest_speed)) return true;
  return landing.now().pads_touching < kStands && !(touches && landing.tipped());
}

// Two clocks, each set back by what contradicts its state.
void LandingEnd::update(const Sample& sample, const LandingWatch& landing) {
  const double time = sample.state.time;
  if (moves(sample, landing)) moved_ = std::max(moved_, time);
  if (!landing.now().fallen) upright_ = std::max(upright_, time);
  if (is_over()) return;
  rests_ = spec_.end_at_rest && time - moved_ >= spec_.rest_time;
  tipped_ = !rests_ && spec_.end_when_tipped && time - upright_ >= spec_.rest_time;
}

std::string LandingEnd::reason() const {
  const std::string time = number_text(spec_.rest_time, 3) + " s";
  if (rests_)
    return "the lander is at rest: for " + time + " nothing of it moved faster than " +
           number_text(spec_.rest_speed, 3) + " m/s";
  if (tipped_)
    return "the lander has tipped over: for " + time + " it was beyond its pads without the energy to return";
  return "";
}

void LandingEnd::visit(Archive& archive) {
  archive("moved", moved_);
  archive("upright", upright_);
  archive("rests", rests_);
  archive("fallen", tipped_);
}

}  // namespace footfall
