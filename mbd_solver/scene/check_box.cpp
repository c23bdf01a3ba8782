// What cannot be in [particles.box].
#include <algorithm>
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/clump_shape.h"
#include "mbd_solver/scene/grain_time_step.h"

namespace footfall {

namespace {

constexpr double kMostGrains = 5e6;
constexpr double kLeastDepth = 4.0, kLeastSize = 8.0;  // of the bed, over the largest radius
constexpr double kSteepest = 30.0;                     // of gravity against -z [deg]
// What LIGGGHTS takes of SI units.
constexpr double kLeastRestitution = 0.05;  // more than this
constexpr double kSoftest = 5e6;            // [Pa]
constexpr int kMostSeeds = 10000;
constexpr double kDegree = 57.29577951308232;

void check_ratio(const Source& source, const std::string& key, double poisson, Findings& findings) {
  if (!(poisson >= 0.0 && poisson < 0.5))
    findings.error(source, key,
                   "is " + number_text(poisson) + ", expected 0 or more and less than 0.5: LIGGGHTS takes no other");
}

void check_modulus(const Source& source, const std::string& key, double young, Findings& findings) {
  if (young > 0.0 && young < kSoftest)  // zero was told when it was read
    findings.error(source, key, "is " + number_text(young) + " Pa, expected at least 5e6: LIGGGHTS takes no less");
}

void check_restitution(const Source& source, const std::string& key, double value, Findings& findings) {
  if (value <= kLeastRestitution)
    findings.error(source, key,
                   "is " + number_text(value) + ", expected more than 0.05, up to 1: LIGGGHTS takes no less");
}

// An empty list beside another finding is one whose numbers were refused when it was read.
bool has(const std::vector<double>& list, std::size_t fewest, std::size_t most, const Findings& findings) {
  return (list.size() >= fewest && list.size() <= most) || (list.empty() && findings.has_errors());
}

void check_sizes(const Source& source, const BoxSpec& box, Findings& findings) {
  const auto numbers = [](const std::vector<double>& list) {
    return "has " + std::to_string(list.size()) + " numbers";
  };
  if (!has(box.size, 2, 2, findings))
    findings.error(source, "box.size", numbers(box.size) + ", expected [along x, along y] in m");
  if (!has(box.centre, 2, 2, findings))
    findings.error(source, "box.centre", numbers(box.centre) + ", expected [x, y] in m");
  if (!has(box.radius, 1, 2, findings))
    findings.error(source, "box.radius",
                   numbers(box.radius) + ", expected one radius or two, in m; a bed of more needs a script of its own");
  if (!box.shares.empty() && (box.radius.size() != 2 || box.shares.size() != 2))
    findings.error(source, "box.shares",
                   numbers(box.shares) + " beside " + std::to_string(box.radius.size()) +
                       " in radius, expected two of both, or no shares");
}

void check_clumps(const Source& source, const BoxSpec& box, Findings& findings) {
  constexpr std::size_t kMostKinds = 12;  // templates of inputs/box/in.bed
  for (const std::string& name : box.clumps) {
    const std::vector<std::string> names = names_of<ClumpShape>();
    if (std::find(names.begin(), names.end(), name) == names.end())
      findings.error(source, "box.clumps", "there is no clump \"" + name + "\"." + known_names("clumps", name, names));
  }
  if (box.clumps.size() * box.radius.size() > kMostKinds)
    findings.error(source, "box.clumps",
                   "has " + std::to_string(box.clumps.size()) + " shapes beside " + std::to_string(box.radius.size()) +
                       " radii, expected at most twelve of both together");
  if (!box.clump_shares.empty() && box.clump_shares.size() != box.clumps.size())
    findings.error(source, "box.clump_shares",
                   "has " + std::to_string(box.clump_shares.size()) + " numbers beside " +
                       std::to_string(box.clumps.size()) + " clumps, expected one for each, or no shares");
}

void check_against_grains(const Source& source, const BoxSpec& box, Findings& findings) {
  const double radius = *std::max_element(box.radius.begin(), box.radius.end());
  if (box.depth < kLeastDepth * radius * (1.0 - 1e-9))
    findings.error(source, "box.depth",
                   "is " + number_text(box.depth) + " m, expected at least four radii of the grains, " +
                       number_text(kLeastDepth * radius) + " m");
  const double size = *std::min_element(box.size.begin(), box.size.end());
  if (size < kLeastSize * radius * (1.0 - 1e-9))
    findings.error(source, "box.size",
                   "is " + number_text(size) + " m, expected at least eight radii of the grains, " +
                       number_text(kLeastSize * radius) + " m");
}

void check_box_time_step(const Scene& scene, Findings& findings) {
  const ParticlesSpec& particles = *scene.particles;
  const BoxSpec& box = *particles.box;
  if (!box.time_step) return;
  const BoxNumbers n = box_numbers(scene);
  const double most = box.rayleigh_fraction * std::min(n.rayleigh, 0.5 * n.hertz);
  if (particles.source.given("max_time_step") || *box.time_step <= most * (1.0 + 1e-9)) return;
  findings.error(particles.source, "box.time_step",
                 "is " + number_text(*box.time_step) + " s, " + share_text(*box.time_step / n.rayleigh) +
                     " of the Rayleigh time and " + share_text(*box.time_step / n.hertz) +
                     " of the Hertz time of these grains, expected at most " + number_text(most, 3) +
                     " s: larger steps run without complaint and are wrong. Leave it out, or state "
                     "particles.max_time_step if you know that they are right");
}

// Whole columns of the bed down to a depth, part of it only.
void check_pit(const Source& source, const BoxSpec& box, Findings& findings) {
  if (box.pit.empty()) {
    if (source.given("box.pit_depth"))
      findings.error(source, "box.pit_depth", "stands without box.pit, which says where along x the pit is");
    return;
  }
  const double left = box.centre[0] - 0.5 * box.size[0], right = box.centre[0] + 0.5 * box.size[0];
  if (box.pit.size() != 2 || !(box.pit[0] < box.pit[1]) || box.pit[1] <= left || box.pit[0] >= right ||
      (box.pit[0] <= left && box.pit[1] >= right))
    findings.error(
        source, "box.pit",
        "is [" +
            [&] {
              std::vector<std::string> texts;
              for (const double x : box.pit) texts.push_back(number_text(x));
              return joined(texts);
            }() +
            "], expected [x_1, x_2] in m, x_1 < x_2, a part of the bed from x = " + number_text(left) + " to " +
            number_text(right));
  if (!(box.pit_depth > 0.0 && box.pit_depth <= box.depth))
    findings.error(source, "box.pit_depth",
                   "is " + number_text(box.pit_depth) + " m, expected more than 0 and at most the depth of the bed, " +
                       number_text(box.depth) + " m");
}

// Words of a LIGGGHTS script and parts of its ids.
void check_names(const Scene& scene, Findings& findings) {
  for (const BoundarySpec& boundary : scene.boundaries) {
    const bool good = std::all_of(boundary.body.begin(), boundary.body.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
    if (!good)
      findings.error(boundary.source, "body",
                     "is \"" + boundary.body +
                         "\", but ids of LIGGGHTS are made of letters, digits and _ only; with "
                         "[particles.box], name the body so");
  }
}

void check_gravity(const Scene& scene, Findings& findings) {
  const Eigen::Vector3d& g = scene.gravity;
  const double tilt = kDegree * std::atan2(std::hypot(g.x(), g.y()), -g.z());
  if (!(g.norm() > 0.0) || tilt > kSteepest)
    findings.error(
        scene.source, "gravity",
        "is [" + number_text(g.x()) + ", " + number_text(g.y()) + ", " + number_text(g.z()) +
            "] m/s2, expected one along -z, or tilted by at most 30 degrees: the bed of [particles.box] settles on "
            "its floor");
}

}  // namespace

bool check_box(const Scene& scene, Findings& findings) {
  const int before = findings.error_count();
  const ParticlesSpec& particles = *scene.particles;
  const Source& source = particles.source;
  const BoxSpec& box = *particles.box;
  if (scene.touches_particles()) {
    for (const char* key : {"script", "bed"})
      if (source.given(key))
        findings.error(source, key, "stands beside box, which has scripts of its own; keep one of the two");
    check_gravity(scene, findings);
    check_names(scene, findings);
  }
  check_sizes(source, box, findings);
  check_clumps(source, box, findings);
  const GrainMaterialSpec& m = box.material;
  check_ratio(source, "box.material.poisson", m.poisson, findings);
  check_ratio(source, "box.bodies.poisson", box.bodies.poisson, findings);
  check_modulus(source, "box.material.young", m.young, findings);
  check_modulus(source, "box.bodies.young", box.bodies.young, findings);
  check_restitution(source, "box.material.restitution", m.restitution, findings);
  check_restitution(source, "box.bodies.restitution", box.bodies.restitution.value_or(1.0), findings);
  if (box.seed > kMostSeeds)
    findings.error(source, "box.seed",
                   "is " + std::to_string(box.seed) + ", expected 1 to " + std::to_string(kMostSeeds));
  if (box.periodic && box.margin)
    findings.error(source, "box.margin", "stands beside periodic = true: there are no walls to leave space around");
  if (box.periodic && !box.walls)
    findings.error(source, "box.walls", "is false beside periodic = true: a periodic bed has no sides to take away");
  if (!(box.rayleigh_fraction > 0.0))
    findings.error(source, "box.rayleigh_fraction", "is 0, expected more than 0, as 0.1");
  // What is missing or no number was reported when it was read.
  const auto positive = [](double x) { return x > 0.0; };
  const bool whole = std::all_of(box.size.begin(), box.size.end(), positive) && box.depth > 0.0 &&
                     std::all_of(box.radius.begin(), box.radius.end(), positive) && !box.size.empty() &&
                     !box.radius.empty();
  if (!whole || findings.error_count() > before) return false;
  check_against_grains(source, box, findings);
  check_pit(source, box, findings);
  check_box_time_step(scene, findings);
  if (const double grains = box_numbers(scene).grains; grains > kMostGrains)
    findings.error(source, "box.radius",
                   "makes about " + number_text(grains, 2) + " grains of this bed, expected at most " +
                       number_text(kMostGrains) + "; is it in m?");
  return findings.error_count() == before;
}

}  // namespace footfall
