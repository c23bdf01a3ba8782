// A bed by numbers: time steps of grains, clumps of spheres in closed form, and the variables of the scripts of inputs/box.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/grains/bed_parts.h"
#include "mbd_solver/scene/grains/grain_sizes.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {
namespace {

const double kApart = std::sqrt(3.0);  // of touching centres, over the radius

// Centres about their mean, for spheres of radius 1.
Eigen::Matrix3Xd unit_centres(ClumpShape shape) {
  const double d = kApart;
  const double corner = d / std::sqrt(3.0);  // of a triangle, from its middle
  const double t = d / std::sqrt(8.0), top = std::sqrt(6.0) / 3.0 * d, o = d / std::sqrt(2.0);
  Eigen::Matrix3Xd x;
  switch (shape) {
    case ClumpShape::kPair: x.setZero(3, 2), x.row(0) << -0.5 * d, 0.5 * d; break;
    case ClumpShape::kRod: x.setZero(3, 3), x.row(0) << -d, 0.0, d; break;
    case ClumpShape::kTriangle:
    case ClumpShape::kBipyramid:
      x.setZero(3, shape == ClumpShape::kTriangle ? 3 : 5);
      for (int k = 0; k < 3; ++k)
        x.col(k) << corner * std::cos(2.0 * kPi * k / 3.0), corner * std::sin(2.0 * kPi * k / 3.0), 0.0;
      if (shape == ClumpShape::kBipyramid) x(2, 3) = top, x(2, 4) = -top;
      break;
    case ClumpShape::kTetrahedron:
      x.resize(3, 4);
      x << t, t, -t, -t, t, -t, t, -t, t, -t, -t, t;
      break;
    case ClumpShape::kOctahedron:
      x.setZero(3, 6);
      for (int k = 0; k < 3; ++k) x(k, 2 * k) = o, x(k, 2 * k + 1) = -o;
      break;
  }
  return x;
}

// Of the lens in which two unit spheres overlap whose centres are 2 h apart: volume, and its second moments about its
// middle, along the line of the centres and across it.
//   V = 2 pi int_h^1 (1 - z^2) dz     along = 2 pi int_h^1 (z - h)^2 (1 - z^2) dz     across = pi/2 int_h^1 (1 - z^2)^2 dz
struct Lens {
  double volume, along, across;
};
Lens lens_of(double h) {
  const auto plain = [](double z) { return z - z * z * z / 3.0; };
  const auto first = [](double z) { return z * z / 2.0 - std::pow(z, 4) / 4.0; };
  const auto second = [](double z) { return z * z * z / 3.0 - std::pow(z, 5) / 5.0; };
  const auto squared = [](double z) { return z - 2.0 * z * z * z / 3.0 + std::pow(z, 5) / 5.0; };
  const double along = second(1.0) - second(h) - 2.0 * h * (first(1.0) - first(h)) + h * h * (plain(1.0) - plain(h));
  return {2.0 * kPi * (plain(1.0) - plain(h)), 2.0 * kPi * along, 0.5 * kPi * (squared(1.0) - squared(h))};
}

// From the numbers of [particles.box] to the variables of inputs/box/in.bed and in.grains.

using Variables = std::map<std::string, std::string>;

constexpr double kLooseFraction = 0.55, kDenseFraction = 0.61;  // solid fraction of settled beds [-]
constexpr double kLooseFriction = 0.3;                          // from this friction on a bed is poured loose [-]
constexpr double kBelowSurface = 1.3;                           // depth of the mean surface below z = 0, in radii
constexpr double kPouredHeight = 2.4;                           // of the loose column, over the depth of the bed
constexpr double kPouredClumps = 4.8;                           // the same of clumps, which need more space
constexpr double kPourFriction = 0.05;                          // packing = "dense"
constexpr int kDigits = 12;
constexpr double kLevelledRest = 0.1,
                 kDampedRest = 0.25;  // times after the bed was levelled, over pour.settle_time [-]
constexpr double kSourcePeriod = 0.01, kSinkPeriod = 1e-3;  // between insertions and looks for grains, at most [s]
constexpr double kSourceFilling = 0.05;                     // of the region by one insertion, at most [-]

std::string number(double value) { return number_text(value, kDigits); }

std::vector<Clump> clumps_of(const BoxSpec& box) {
  std::vector<Clump> clumps;
  for (const double radius : all_radii(box))
    for (const std::string& name : box.clumps) clumps.push_back(clump_of(clump_shape(name), radius));
  return clumps;
}

// Of clumps: one of their spheres, which is lighter than the clump and has the shorter times.
ElasticGrain smallest_grain(const BoxSpec& box, double young) {
  const GrainMaterialSpec& m = box.material;
  double radius = smallest_radius(box);
  for (const Clump& clump : clumps_of(box)) radius = std::min(radius, clump.radius);
  return {radius, m.density, young, m.poisson};
}

// Impact speed of the uppermost poured grain [m/s].
double pour_speed(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const double height = box.clumps.empty() ? kPouredHeight : kPouredClumps;
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  return std::sqrt(2.0 * scene.gravity.norm() * (height - 1.0) * (box.depth + (bed ? bed->high - bed->low : 0.0)));
}

// The largest speed known before the run [m/s].
double known_speed(const Scene& scene) {
  double speed = std::max(pour_speed(scene), scene.initial.velocity.norm());
  for (const BodyVelocitySpec& body : scene.initial.bodies)
    speed = std::max(speed, body.velocity.value_or(Eigen::Vector3d::Zero()).norm());
  return speed;
}

// `fraction` of the Rayleigh time of grains with this modulus [Pa], half of it of their Hertz time.
double step_for(const BoxSpec& box, double young, double fraction, double speed) {
  const ElasticGrain grain = smallest_grain(box, young);
  return rounded_down(std::min(fraction * rayleigh_time(grain), 0.5 * fraction * hertz_time(grain, speed)));
}

// Expected of the settled bed of equal grains [-].
double solid_fraction(const BoxSpec& box) {
  if (!box.pour.friction) return box.packing == Packing::kDense ? kDenseFraction : kLooseFraction;
  const double loose = (*box.pour.friction - kPourFriction) / (kLooseFriction - kPourFriction);
  return kDenseFraction + (kLooseFraction - kDenseFraction) * std::clamp(loose, 0.0, 1.0);
}

std::string contact_model(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const GrainMaterialSpec& m = box.material;
  std::string model = "hertz tangential history";
  if (std::max(m.cohesion, box.bodies.cohesion.value_or(0.0)) > 0.0)
    model += concat(" cohesion ", name_of(m.cohesion_model));
  if (const RollingModel rolling = rolling_model_of(scene); rolling != RollingModel::kNone)
    model += concat(" rolling_friction ", name_of(rolling));
  return model;
}

// The templates of clumps, each in quotes, and their distribution by mass. Mass and inertia are given.
void add_clumps(const BoxSpec& box, Variables& all) {
  const std::vector<Clump> clumps = clumps_of(box);
  double level = 0.0;
  std::string words, mix = std::to_string(clumps.size());
  for (std::size_t k = 0; k < clumps.size(); ++k) {
    const std::size_t shapes = box.clumps.size();
    words += concat(k == 0 ? "" : " ", "'", clump_words(clumps[k], box.material.density), "'");
    mix += concat(
        " clump_", k + 1, " ",
        number(share_of(box.shares, k / shapes, box.radius.size()) * share_of(box.clump_shares, k % shapes, shapes)));
    level = std::max(level, clumps[k].radius);
  }
  all["clump_words"] = words;
  all["clump_mix"] = mix;
  all["level"] = number(-level);
}

bool is_prime(int n) {
  for (int d = 2; static_cast<long>(d) * d <= n; ++d)
    if (n % d == 0) return false;
  return n > 1;
}

// LIGGGHTS requires primes above 10000; the scripts use none of these. Small seeds count primes, large ones (of a campaign) are scattered by
// Knuth's multiplicative hash.
int prime_of(int seed) {
  constexpr int kFirst = 20000000, kCounted = 10000;
  constexpr std::uint64_t kKnuth = 2654435761u, kPlaces = 2000000000u;
  const int steps = std::min(seed, kCounted);
  int n = kFirst;
  for (int k = 0; k < steps; ++k)
    while (!is_prime(++n)) {
    }
  if (seed <= kCounted) return n;
  n += static_cast<int>(static_cast<std::uint64_t>(seed) * kKnuth % kPlaces);
  while (!is_prime(++n)) {
  }
  return n;
}

// What the scripts of the bed and of the run have in common.
Variables common_variables(const Scene& scene) {
  constexpr double kSkin = 0.3;  // of the smallest radius
  const BoxSpec& box = *scene.particles->box;
  const GrainMaterialSpec& m = box.material;
  const Eigen::Vector3d down = scene.gravity.normalized();
  Variables all = {{"clumps", box.clumps.empty() ? "0" : "1"},
                   {"length", number(box.size[0])},
                   {"width", number(box.size[1])},
                   {"depth", number(-box_floor(scene))},
                   {"x", number(box.centre[0])},
                   {"y", number(box.centre[1])},
                   {"periodic", box.periodic ? "1" : "0"},
                   {"radius_1", number(has_parts(box) ? smallest_radius(box) : box.radius.front())},
                   {"radius_2", number(has_parts(box) ? largest_radius(box) : box.radius.back())},
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
  if (has_parts(box)) all["skin"] = number(kSkin * smallest_radius(box));
  return all;
}

Variables bed_variables(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const BoxNumbers numbers = box_numbers(scene);
  const bool dense = box.packing == Packing::kDense;
  const double share = has_parts(box) || box.radius.size() < 2 ? 0.0 : share_of(box.shares, 1, 2);
  Variables all = common_variables(scene);
  all["margin"] = number(numbers.margin);
  all["headroom"] = number(numbers.headroom);
  all["share_2"] = number(share);
  all["pit_x1"] = number(box.pit.empty() ? 0.0 : box.pit[0]);
  all["pit_x2"] = number(box.pit.empty() ? 0.0 : box.pit[1]);
  all["pit_depth"] = number(box.pit.empty() ? 0.0 : box.pit_depth);
  all["density"] = number(box.material.density);
  all["seed"] = std::to_string(prime_of(box.seed));
  const double share_of_time = box.pour.rayleigh_fraction.value_or(box.rayleigh_fraction), young = box.material.young;
  all["dt"] = number(step_for(box, box.pour.young.value_or(young), share_of_time, pour_speed(scene)));
  if (box.pour.young) {
    all["pour_young"] = number(*box.pour.young);
    all["rest_dt"] = number(step_for(box, young, share_of_time, pour_speed(scene)));
  }
  all["pour_friction"] = number(box.pour.friction.value_or(dense ? kPourFriction : box.material.friction));
  all["pour_rolling"] = number(box.pour.rolling_friction.value_or(dense ? 0.0 : box.material.rolling_friction));
  all["rest_friction"] = number(box.material.friction);
  all["rest_rolling"] = number(box.material.rolling_friction);
  if (has_parts(box)) {
    add_parts(scene, all);
  } else if (!box.clumps.empty()) {
    add_clumps(box, all);
    all["filled"] = number(poured_bed(scene).filled);
  }
  const double limit = poured_bed(scene).limit;
  if (limit > 0.0) all["fall_limit"] = number(limit);
  if (box.pour.settle_time || limit > 0.0) {
    const double rest = box.pour.settle_time.value_or(2.0 * fall_time(scene));
    all["settle"] = number(fall_time(scene) + rest);
    all["rest"] = number(kLevelledRest * rest);
    all["damped"] = number(kDampedRest * rest);
  }
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  if (!bed) return all;
  const auto add = [](std::string& words, double value) {
    words += (words.empty() ? "" : "\n") + number_text(value, 5);
  };
  const double below = has_parts(box) ? levelling_radius(box) : 0.5 * (box.radius.front() + box.radius.back());
  std::string level;
  const double floor = box_floor(scene);  // words of LIGGGHTS cannot begin with a minus sign
  for (const double height : bed->heights) add(level, height - below - floor);
  all["terrain"] = "1";
  all["rise"] = number(bed->high);
  all["columns"] = std::to_string(bed->columns);
  all["rows"] = std::to_string(bed->rows);
  all["column_level"] = level;
  if (bed->rocks.empty()) return all;
  std::string rock_x, rock_y, rock_z, rock_r;
  for (const Terrain::Sphere& rock : bed->rocks) {
    add(rock_x, rock.centre.x() - box.centre[0] + 0.5 * box.size[0]);
    add(rock_y, rock.centre.y() - box.centre[1] + 0.5 * box.size[1]);
    add(rock_z, rock.centre.z() - floor);
    add(rock_r, rock.radius + largest_at(scene, rock.centre, rock.radius));
  }
  all["rocks"] = "1";
  all["rock_x"] = rock_x;
  all["rock_y"] = rock_y;
  all["rock_z"] = rock_z;
  all["rock_r"] = rock_r;
  return all;
}

// Their interval: a hundredth of a second, or until a twentieth of the region is full.
int steps_between(const GrainSourceSpec& source, double grains_per_second, double grain_volume, double dt) {
  const Eigen::Vector3d sides = (source.region[1] - source.region[0]).cwiseAbs();
  const double period = std::min(kSourcePeriod, kSourceFilling * sides.prod() / (grain_volume * grains_per_second));
  return std::max(1, static_cast<int>(std::lround(period / dt)));
}

// Corners in order, as LIGGGHTS wants them.
std::string block_of(const GrainRegionSpec& spec) {
  std::string out;
  for (int c = 0; c < 3; ++c)
    out += (c == 0 ? "" : " ") + number(std::min(spec.region[0][c], spec.region[1][c])) + " " +
           number(std::max(spec.region[0][c], spec.region[1][c]));
  return out;
}

std::string times_of(const GrainRegionSpec& spec) {
  return "from " + number(spec.from) + (spec.until ? " until " + number(*spec.until) : "");
}

void add_to_list(std::string& list, const std::string& words) { list += (list.empty() ? "'" : " '") + words + "'"; }

void add_sources_and_sinks(const Scene& scene, Variables& all) {
  const BoxSpec& box = *scene.particles->box;
  const double dt = box_numbers(scene).time_step;
  std::string boxes, flows, times;
  for (const GrainSourceSpec& source : box.sources) {
    const double rate = source_rate(box, source);
    const bool by_mass = source.rate && box.radius.size() > 1;  // of equal grains the number says the same
    add_to_list(boxes, block_of(source));
    add_to_list(
        flows, concat(by_mass ? "massrate " + number(*source.rate) : "particlerate " + number(rate), " insert_every ",
                      steps_between(source, rate, mean_grain_mass(box) / box.material.density, dt), " vel constant ",
                      number(source.velocity.x()), " ", number(source.velocity.y()), " ", number(source.velocity.z())));
    add_to_list(times, times_of(source));
  }
  if (!box.sources.empty()) {
    std::string radii, mix = std::to_string(box.radius.size());
    for (std::size_t i = 0; i < box.radius.size(); ++i) {
      radii += (i == 0 ? "" : " ") + number(box.radius[i]);
      mix += concat(" source_grain_", i + 1, " ", number(share_of(box.shares, i, box.radius.size())));
    }
    if (box.radius.size() == 1) radii += " " + radii, mix = "1 source_grain_1 1.0";
    all["source_radii"] = radii;
    all["source_count"] = std::to_string(box.sources.size());
    all["source_boxes"] = boxes;
    all["source_flows"] = flows;
    all["source_times"] = times;
    all["source_density"] = number(box.material.density);
    all["source_mix"] = mix;
  }
  boxes = times = "";
  const int every = std::max(1, static_cast<int>(std::lround(kSinkPeriod / dt)));
  for (const GrainRegionSpec& sink : box.sinks) {
    add_to_list(boxes, block_of(sink));
    add_to_list(times, concat("every ", every, " ", times_of(sink)));
  }
  if (box.sinks.empty()) return;
  all["sink_count"] = std::to_string(box.sinks.size());
  all["sink_boxes"] = boxes;
  all["sink_times"] = times;
}

// The newest checkpoint of a run with its grains. Throws InputError without one.
std::string grains_at_end(const Scene& scene) {
  namespace fs = std::filesystem;
  long newest = -1;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(scene.initial.from + "/checkpoint", ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.empty() || name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (fs::is_regular_file(entry.path() / "grains.restart", ignored)) newest = std::max(newest, std::stol(name));
  }
  if (newest < 0)
    throw InputError(
        code::kNoEndGrains, "initial.from: \"", scene.initial.from,
        "\" has no grains of its end; run that scene with output.keep_grains = true, or remove [particles.box] here");
  return concat(scene.initial.from, "/checkpoint/", newest, "/grains.restart");
}

// Size and time of the file tell one end from another, by which the bed is found again.
Variables continued_variables(const Scene& scene) {
  Variables all = common_variables(scene);
  const std::string file = grains_at_end(scene);
  all["grains"] = file;
  all["stamp"] =
      concat(std::filesystem::file_size(file), "_", std::filesystem::last_write_time(file).time_since_epoch().count());
  const BoxSpec& box = *scene.particles->box;
  all["dt"] = number(box_numbers(scene).time_step);
  all["friction"] = number(box.material.friction);
  all["rolling"] = number(box.material.rolling_friction);
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
  add_sources_and_sinks(scene, all);
  if (!box.follow.empty()) {
    all["follow"] = "1";
    all["follow_words"] = concat("body ", box.follow, " directions ", name_of(box.follow_directions), " distance ",
                                 number(follow_distance(box)));
  }
  return all;
}

}  // namespace

Clump clump_of(ClumpShape shape, double equal_radius) {
  const Eigen::Matrix3Xd x = unit_centres(shape);
  const double sphere = 4.0 / 3.0 * kPi;
  Clump clump;
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    clump.volume += sphere;
    S += sphere * (Eigen::Matrix3d::Identity() / 5.0 + x.col(i) * x.col(i).transpose());
    for (Eigen::Index j = 0; j < i; ++j) {
      const Eigen::Vector3d apart = x.col(i) - x.col(j), middle = 0.5 * (x.col(i) + x.col(j));
      if (apart.norm() >= 2.0) continue;
      const Lens lens = lens_of(0.5 * apart.norm());
      const Eigen::Matrix3d along = apart.normalized() * apart.normalized().transpose();
      clump.volume -= lens.volume;
      S -= lens.across * (Eigen::Matrix3d::Identity() - along) + lens.along * along +
           lens.volume * middle * middle.transpose();
    }
  }
  const double scale = equal_radius * std::cbrt(sphere / clump.volume);  // radius of the spheres [m]
  clump.centres = scale * x;
  clump.radius = scale;
  clump.volume *= std::pow(scale, 3);
  clump.inertia = std::pow(scale, 5) * (S.trace() * Eigen::Matrix3d::Identity() - S);
  // Zeros by symmetry, which another compiler may miss by round-off: these numbers identify a cached bed.
  constexpr double kRoundOff = 1e-13;
  clump.centres = (clump.centres.array().abs() < kRoundOff * scale).select(0.0, clump.centres);
  clump.inertia = (clump.inertia.array().abs() < kRoundOff * clump.inertia.trace()).select(0.0, clump.inertia);
  return clump;
}

ClumpShape clump_shape(const std::string& name) {
  const std::vector<std::string> names = names_of<ClumpShape>();
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return static_cast<ClumpShape>(k);
  throw InputError(code::kUnknownClump, "unknown clump \"", name, "\".", known_names("clumps", name, names));
}

// Rayleigh time and Hertz contact time.
double rayleigh_time(const ElasticGrain& g) {
  const double shear = g.young / (2.0 * (1.0 + g.poisson));
  return kPi * g.radius * std::sqrt(g.density / shear) / (0.1631 * g.poisson + 0.8766);
}

double hertz_time(const ElasticGrain& g, double speed) {
  const double mass = 0.5 * g.density * 4.0 / 3.0 * kPi * g.radius * g.radius * g.radius;
  const double young = g.young / (2.0 * (1.0 - g.poisson * g.poisson));
  return 2.87 * std::pow(mass * mass / (0.5 * g.radius * young * young * speed), 0.2);
}

double rounded_down(double value) {
  constexpr double kRoundOff = 1e-9;  // 8.8e-5 remains 8.8e-5
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::floor(value / unit + kRoundOff) * unit;
}

std::string clump_words(const Clump& clump, double density) {
  std::string words = concat("nspheres ", clump.centres.cols(), " ntry 1000000 spheres");
  for (Eigen::Index i = 0; i < clump.centres.cols(); ++i) {
    for (int c = 0; c < 3; ++c) words += " " + number(clump.centres(c, i));
    words += " " + number(clump.radius);
  }
  words += " mass " + number(density * clump.volume) + " inertia_tensor";
  for (const auto& [r, c] : {std::pair{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}})
    words += " " + number(density * clump.inertia(r, c));
  return words + " use_density";
}

bool follows_along(const BoxSpec& box, int axis) {
  return !box.follow.empty() && box.follow_directions != (axis == 0 ? FollowDirections::kY : FollowDirections::kX);
}

double longest_follow_distance(const BoxSpec& box) {
  constexpr double kShare = 0.35;  // as the fix bed/follow demands
  double side = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis)
    if (follows_along(box, axis)) side = std::min(side, box.size[axis]);
  return kShare * side;
}

double follow_distance(const BoxSpec& box) {
  constexpr double kOfLongest = 0.3 / 0.35;
  return box.follow_distance.value_or(kOfLongest * longest_follow_distance(box));
}

double mean_grain_mass(const BoxSpec& box) {
  // Shares are of the mass: of n kinds, the mean over the numbers is 1 / sum(share / mass).
  double per_mass = 0.0;
  for (std::size_t i = 0; i < box.radius.size(); ++i)
    per_mass += share_of(box.shares, i, box.radius.size()) /
                (box.material.density * 4.0 / 3.0 * kPi * std::pow(box.radius[i], 3));
  return 1.0 / per_mass;
}

double source_rate(const BoxSpec& box, const GrainSourceSpec& source) {
  return source.grains_per_second ? *source.grains_per_second : source.rate.value_or(0.0) / mean_grain_mass(box);
}

std::string box_script(const std::string& name) { return shipped_file("inputs/box/" + name); }

RollingModel rolling_model_of(const Scene& scene) {
  const ParticlesSpec& particles = *scene.particles;
  const bool corners = !particles.box->clumps.empty() && !particles.source.given("box.material.rolling_model");
  return corners ? RollingModel::kNone : particles.box->material.rolling_model;
}

BoxNumbers box_numbers(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const ElasticGrain grain = smallest_grain(box, box.material.young);
  const double largest = *std::max_element(box.size.begin(), box.size.end());
  BoxNumbers n;
  n.rayleigh = rayleigh_time(grain);
  n.hertz = hertz_time(grain, known_speed(scene));
  n.time_step = box.time_step.value_or(step_for(box, box.material.young, box.rayleigh_fraction, known_speed(scene)));
  if (!box.time_step && scene.particles->source.given("max_time_step"))
    n.time_step = std::min(n.time_step, scene.particles->max_time_step);
  n.headroom = box.headroom.value_or(largest);
  n.margin = box.periodic ? 0.0 : box.margin.value_or(0.25 * largest);
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  const double deep = box.depth + (bed ? bed->mean - bed->low : 0.0);
  const double fraction = solid_fraction(box);
  if (has_parts(box)) {
    n.grains = grains_of_parts(scene, deep, fraction);
    return n;
  }
  const double filled = deep - kBelowSurface * *std::max_element(box.radius.begin(), box.radius.end());
  const double volume = fraction * box.size[0] * box.size[1] * filled;
  for (std::size_t i = 0; i < box.radius.size(); ++i) {
    const double share = share_of(box.shares, i, box.radius.size());
    n.grains += share * volume / (4.0 / 3.0 * kPi * std::pow(box.radius[i], 3));
  }
  return n;
}

void resolve_box(Scene& scene, Findings& findings) {
  if (!scene.particles || !scene.particles->box) return;
  ParticlesSpec& particles = *scene.particles;
  if (!particles.box->follow.empty()) particles.box->periodic = true;
  if (!check_box(scene, findings)) return;
  if (!particles.script.empty() || particles.bed) return;  // a scene of another ground may have both
  try {
    particles.script = box_script("in.grains");
    particles.bed = scene.initial.from.empty() ? BedSpec{box_script("in.bed"), bed_variables(scene)}
                                               : BedSpec{box_script("in.continued"), continued_variables(scene)};
  } catch (const InputError& e) {
    findings.coded_error(particles.source, "box", e.what());
    particles.script.clear();  // not a second message about it
    return;
  }
  constexpr double kSmallBed = 2000.0;  // grains, of which ranks would mostly wait for each other
  if (!particles.source.given("ranks") && box_numbers(scene).grains < kSmallBed) particles.ranks = 1;
  particles.variables.merge(run_variables(scene));
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  if (!particles.surface_height) particles.surface_height = bed ? bed->high : 0.0;
  if (!particles.box->sinks.empty()) particles.outflow = true;
  if (!particles.source.given("max_time_step")) particles.max_time_step = box_numbers(scene).time_step;
}

// Merges the table of a shipped soil under the keys of the scene.

void fill_missing(ConfigNode& own, const ConfigNode& soil, int line) {
  for (const auto& [key, value] : soil.table) {
    ConfigNode* there = own.find(key);
    if (there && there->kind == ConfigNode::Kind::kTable && value.kind == ConfigNode::Kind::kTable) {
      fill_missing(*there, value, line);
    } else if (!there) {
      ConfigNode fresh = value;
      fresh.table.clear();
      fresh.line = line;
      fill_missing(fresh, value, line);
      own.table.emplace_back(key, fresh);
    }
  }
}

void add_soil(ConfigNode& scene, Findings& findings) {
  ConfigNode* particles = scene.find("particles");
  const ConfigNode* soil = particles ? particles->find("soil") : nullptr;
  if (!soil || soil->kind != ConfigNode::Kind::kText) return;  // another type is reported by the reader
  const int line = soil->line;
  const std::string name = soil->text;
  const std::vector<std::string> names = shipped_tables("inputs/soils");
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    findings.error(code::kUnknownSoil, line, "particles.soil", "unknown soil \"", name, "\".",
                   known_names("soils", name, names), " They are files of inputs/soils");
    return;
  }
  ConfigNode* box = particles->find("box");
  if (!box || box->kind != ConfigNode::Kind::kTable) {
    findings.error(code::kNeedsOtherKey, line, "particles.soil",
                   "needs a bed by numbers: [particles.box] with size, depth and radius");
    return;
  }
  const ConfigNode file = parse_toml_file(shipped_file("inputs/soils/" + name + ".toml"));
  if (const ConfigNode* numbers = file.find("box")) fill_missing(*box, *numbers, line);
}

}  // namespace footfall
