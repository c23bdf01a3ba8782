// From the numbers of [particles.box] to the variables of inputs/box/in.bed and in.grains.
#include "mbd_solver/scene/box_bed.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/clump_shape.h"
#include "mbd_solver/scene/grain_time_step.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {

namespace {

using Variables = std::map<std::string, std::string>;

constexpr double kLooseFraction = 0.55, kDenseFraction = 0.61;  // solid fraction of settled beds [-]
constexpr double kBelowSurface = 1.3;                           // depth of the mean surface below z = 0, in radii
constexpr double kPouredHeight = 2.4;                           // of the loose column, over the depth of the bed
constexpr double kPouredClumps = 4.8;                           // the same of clumps, which need more space
constexpr double kFilledByClumps = 0.14;                        // share of that column [-]
constexpr double kPourFriction = 0.05;                          // packing = "dense"
constexpr int kDigits = 12;

std::string number(double value) { return number_text(value, kDigits); }

std::vector<Clump> clumps_of(const BoxSpec& box) {
  std::vector<Clump> clumps;
  for (const double radius : box.radius)
    for (const std::string& name : box.clumps) clumps.push_back(clump_of(clump_shape(name), radius));
  return clumps;
}

// Of clumps: one of their spheres, which is lighter than the clump and has the shorter times.
ElasticGrain smallest_grain(const BoxSpec& box) {
  const GrainMaterialSpec& m = box.material;
  double radius = *std::min_element(box.radius.begin(), box.radius.end());
  for (const Clump& clump : clumps_of(box)) radius = std::min(radius, clump.radius);
  return {radius, m.density, m.young, m.poisson};
}

// Impact speed of the uppermost poured grain [m/s].
double pour_speed(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const double height = box.clumps.empty() ? kPouredHeight : kPouredClumps;
  return std::sqrt(2.0 * scene.gravity.norm() * (height - 1.0) * box.depth);
}

// The largest speed known before the run [m/s].
double known_speed(const Scene& scene) {
  double speed = std::max(pour_speed(scene), scene.initial.velocity.norm());
  for (const BodyVelocitySpec& body : scene.initial.bodies)
    speed = std::max(speed, body.velocity.value_or(Eigen::Vector3d::Zero()).norm());
  return speed;
}

// `fraction` of the Rayleigh time, half of it of the Hertz time.
double step_for(const BoxSpec& box, double speed) {
  const ElasticGrain grain = smallest_grain(box);
  return rounded_down(
      std::min(box.rayleigh_fraction * rayleigh_time(grain), 0.5 * box.rayleigh_fraction * hertz_time(grain, speed)));
}

std::string contact_model(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const GrainMaterialSpec& m = box.material;
  std::string model = "hertz tangential history";
  if (std::max(m.cohesion, box.bodies.cohesion.value_or(0.0)) > 0.0)
    model += " cohesion " + std::string(name_of(m.cohesion_model));
  if (const RollingModel rolling = rolling_model_of(scene); rolling != RollingModel::kNone)
    model += " rolling_friction " + std::string(name_of(rolling));
  return model;
}

// Share of the k-th of `count` kinds; equal without `shares`.
double share_of(const std::vector<double>& shares, std::size_t k, std::size_t count) {
  if (shares.empty() || count < 2) return 1.0 / static_cast<double>(count);
  return shares[k] / std::accumulate(shares.begin(), shares.end(), 0.0);
}

// The words of LIGGGHTS' templates, each in quotes, and of their distribution by mass. Mass and inertia are given; LIGGGHTS
// estimates only the share of each sphere in the clump's volume (ntry), for its own statistics.
void add_clumps(const BoxSpec& box, Variables& all) {
  const std::vector<Clump> clumps = clumps_of(box);
  if (clumps.empty()) return;
  const double density = box.material.density;
  double level = 0.0;
  std::string words, mix = std::to_string(clumps.size());
  for (std::size_t k = 0; k < clumps.size(); ++k) {
    const Clump& clump = clumps[k];
    const std::size_t shapes = box.clumps.size();
    words +=
        std::string(k == 0 ? "" : " ") + "'nspheres " + std::to_string(clump.centres.cols()) + " ntry 1000000 spheres";
    for (Eigen::Index i = 0; i < clump.centres.cols(); ++i) {
      for (int c = 0; c < 3; ++c) words += " " + number(clump.centres(c, i));
      words += " " + number(clump.radius);
    }
    words += " mass " + number(density * clump.volume) + " inertia_tensor";
    for (const auto& [r, c] : {std::pair{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}})
      words += " " + number(density * clump.inertia(r, c));
    words += " use_density'";
    mix += " clump_" + std::to_string(k + 1) + " " +
           number(share_of(box.shares, k / shapes, box.radius.size()) * share_of(box.clump_shares, k % shapes, shapes));
    level = std::max(level, clump.radius);
  }
  all["clump_words"] = words;
  all["clump_mix"] = mix;
  all["filled"] = number(kFilledByClumps);
  all["level"] = number(-level);
}

bool is_prime(int n) {
  for (int d = 2; static_cast<long>(d) * d <= n; ++d)
    if (n % d == 0) return false;
  return n > 1;
}

// LIGGGHTS requires primes above 10000; the scripts use none of these.
int prime_of(int seed) {
  int n = 20000000;
  for (int k = 0; k < seed; ++k)
    while (!is_prime(++n)) {
    }
  return n;
}

// What the scripts of the bed and of the run have in common.
Variables common_variables(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const GrainMaterialSpec& m = box.material;
  const Eigen::Vector3d down = scene.gravity.normalized();
  return {{"clumps", box.clumps.empty() ? "0" : "1"},
          {"length", number(box.size[0])},
          {"width", number(box.size[1])},
          {"depth", number(box.depth)},
          {"x", number(box.centre[0])},
          {"y", number(box.centre[1])},
          {"periodic", box.periodic ? "1" : "0"},
          {"radius_1", number(box.radius.front())},
          {"radius_2", number(box.radius.back())},
          {"g", number(scene.gravity.norm())},
          {"gx", number(down.x())},
          {"gy", number(down.y())},
          {"gz", number(down.z())},
          {"model", contact_model(scene)},
          {"young", number(m.young)},
          {"poisson", number(m.poisson)},
          {"body_young", number(box.bodies.young)},
          {"body_poisson", number(box.bodies.poisson)},
          {"restitution", number(m.restitution)},
          {"cohesion", number(m.cohesion)}};
}

Variables bed_variables(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const BoxNumbers numbers = box_numbers(scene);
  const bool dense = box.packing == Packing::kDense;
  const double share = box.radius.size() < 2 ? 0.0 : share_of(box.shares, 1, 2);
  Variables all = common_variables(scene);
  all["margin"] = number(numbers.margin);
  all["headroom"] = number(numbers.headroom);
  all["share_2"] = number(share);
  all["pit_x1"] = number(box.pit.empty() ? 0.0 : box.pit[0]);
  all["pit_x2"] = number(box.pit.empty() ? 0.0 : box.pit[1]);
  all["pit_depth"] = number(box.pit.empty() ? 0.0 : box.pit_depth);
  all["density"] = number(box.material.density);
  all["seed"] = std::to_string(prime_of(box.seed));
  all["dt"] = number(step_for(box, pour_speed(scene)));
  all["pour_friction"] = number(dense ? kPourFriction : box.material.friction);
  all["pour_rolling"] = number(dense ? 0.0 : box.material.rolling_friction);
  add_clumps(box, all);
  return all;
}

Variables run_variables(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const GrainMaterialSpec& m = box.material;
  const BodyContactSpec& b = box.bodies;
  Variables all = common_variables(scene);
  all["dt"] = number(box_numbers(scene).time_step);
  all["every"] = box.every ? std::to_string(*box.every) : "auto";
  all["frames"] = number(box.frames);
  all["walls"] = box.walls ? "1" : "0";
  all["friction"] = number(m.friction);
  all["rolling"] = number(m.rolling_friction);
  all["body_friction"] = number(b.friction.value_or(m.friction));
  all["body_rolling"] = number(b.rolling_friction.value_or(m.rolling_friction));
  all["body_restitution"] = number(b.restitution.value_or(m.restitution));
  all["body_cohesion"] = number(b.cohesion.value_or(m.cohesion));
  int meshes = 0, beams = 0;
  std::string bodies, ids, pairs = "gravity scene", chains;
  for (const BoundarySpec& boundary : scene.boundaries) {
    const std::string& name = boundary.body;
    if (boundary.surface) {
      const std::string gap = meshes++ == 0 ? "" : " ";
      bodies += gap + name;
      ids += gap + "mesh_" + name;
      pairs += " mesh mesh_" + name + " " + name;
    }
    if (boundary.beams) chains += (beams++ == 0 ? "body " : " body ") + name;
  }
  all["mesh_count"] = std::to_string(meshes);
  all["beam_count"] = std::to_string(beams);
  all["couples"] = pairs;
  if (meshes > 0) all["mesh_bodies"] = bodies;
  if (meshes > 0) all["meshes"] = ids;
  if (beams > 0) all["beams"] = chains;
  return all;
}

}  // namespace

std::string box_script(const std::string& name) { return shipped_file("inputs/box/" + name); }

RollingModel rolling_model_of(const Scene& scene) {
  const ParticlesSpec& particles = *scene.particles;
  const bool corners = !particles.box->clumps.empty() && !particles.source.given("box.material.rolling_model");
  return corners ? RollingModel::kNone : particles.box->material.rolling_model;
}

BoxNumbers box_numbers(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const ElasticGrain grain = smallest_grain(box);
  const double largest = *std::max_element(box.size.begin(), box.size.end());
  BoxNumbers n;
  n.rayleigh = rayleigh_time(grain);
  n.hertz = hertz_time(grain, known_speed(scene));
  n.time_step = box.time_step.value_or(step_for(box, known_speed(scene)));
  if (!box.time_step && scene.particles->source.given("max_time_step"))
    n.time_step = std::min(n.time_step, scene.particles->max_time_step);
  n.headroom = box.headroom.value_or(largest);
  n.margin = box.periodic ? 0.0 : box.margin.value_or(0.25 * largest);
  const double filled = box.depth - kBelowSurface * *std::max_element(box.radius.begin(), box.radius.end());
  const double volume =
      (box.packing == Packing::kDense ? kDenseFraction : kLooseFraction) * box.size[0] * box.size[1] * filled;
  for (std::size_t i = 0; i < box.radius.size(); ++i) {
    const double share = share_of(box.shares, i, box.radius.size());
    n.grains += share * volume / (4.0 / 3.0 * kPi * std::pow(box.radius[i], 3));
  }
  return n;
}

void resolve_box(Scene& scene, Findings& findings) {
  if (!scene.particles || !scene.particles->box || !check_box(scene, findings)) return;
  ParticlesSpec& particles = *scene.particles;
  if (!particles.script.empty() || particles.bed) return;  // a scene of another ground may have both
  try {
    particles.script = box_script("in.grains");
    particles.bed = BedSpec{box_script("in.bed"), bed_variables(scene)};
  } catch (const InputError& e) {
    findings.coded_error(particles.source, "box", e.what());
    return;
  }
  particles.variables.merge(run_variables(scene));
  if (!particles.surface_height) particles.surface_height = 0.0;
  if (!particles.source.given("max_time_step")) particles.max_time_step = box_numbers(scene).time_step;
}

}  // namespace footfall
