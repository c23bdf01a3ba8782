// What [particles.box] cannot be: values that LIGGGHTS refuses, sizes that do not suit the grains, too many grains.
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/clump_shape.h"
#include "mbd_solver/scene/grain_time_step.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

namespace {

constexpr double kMostGrains = 5e6;
constexpr double kLeastDepth = 4.0, kLeastSize = 8.0;  // of the bed, over the largest radius
constexpr double kSteepest = 30.0;                     // of gravity against -z [deg]
// The range of LIGGGHTS in SI units.
constexpr double kLeastRestitution = 0.05;  // more than this
constexpr double kSoftest = 5e6;            // [Pa]
constexpr int kMostSeeds = 10000;
constexpr std::size_t kMostTemplates = 12;  // of clumps, in inputs/box/in.bed

const char* const kNoOther = "; LIGGGHTS accepts no other";

void check_material(const EntryFindings& at, const std::string& of, double poisson, double young, double restitution) {
  at.error_if(!(poisson >= 0.0 && poisson < 0.5), kLiggghtsRange, of + "poisson",
              "is " + number_text(poisson) + ", expected 0 or more and less than 0.5" + kNoOther);
  at.error_if(young > 0.0 && young < kSoftest, kLiggghtsRange, of + "young",  // 0 was refused by the reader
              "is " + number_text(young) + " Pa, expected at least 5e6" + kNoOther);
  at.error_if(restitution <= kLeastRestitution, kLiggghtsRange, of + "restitution",
              "is " + number_text(restitution) + ", expected more than 0.05, at most 1" + kNoOther);
}

void check_counts(const EntryFindings& at, const BoxSpec& box) {
  const auto has = [](std::size_t count, const char* what = " numbers") {
    return "has " + std::to_string(count) + what;
  };
  // An empty list next to another finding was refused by the reader.
  const auto check = [&](const char* key, const std::vector<double>& list, std::size_t fewest, const char* expected) {
    const bool good = (list.size() >= fewest && list.size() <= 2) || (list.empty() && at.all().has_errors());
    at.error_if(!good, kWrongCount, key, has(list.size()) + ", expected " + expected);
  };
  check("box.size", box.size, 2, "[along x, along y] in m");
  check("box.centre", box.centre, 2, "[x, y] in m");
  check("box.radius", box.radius, 1, "one radius or two, in m; a bed of more radii needs a script of its own");
  at.error_if(!box.shares.empty() && (box.radius.size() != 2 || box.shares.size() != 2), kWrongCount, "box.shares",
              has(box.shares.size()) + " and radius " + std::to_string(box.radius.size()) +
                  ", expected two in each, or no shares");
  const std::vector<std::string> shapes = names_of<ClumpShape>();
  for (const std::string& name : box.clumps)
    if (!is_in(shapes, name))
      at.error(kUnknownClump, "box.clumps", "unknown clump \"" + name + "\"." + known_names("clumps", name, shapes));
  at.error_if(box.clumps.size() * box.radius.size() > kMostTemplates, kTooLarge, "box.clumps",
              has(box.clumps.size(), " shapes") + " and radius " + std::to_string(box.radius.size()) +
                  " numbers, expected at most twelve combinations");
  at.error_if(!box.clump_shares.empty() && box.clump_shares.size() != box.clumps.size(), kWrongCount,
              "box.clump_shares",
              has(box.clump_shares.size()) + " for " + std::to_string(box.clumps.size()) +
                  " clumps, expected one for each, or no shares");
}

void check_against_grains(const EntryFindings& at, const BoxSpec& box) {
  const double radius = *std::max_element(box.radius.begin(), box.radius.end());
  const auto check = [&](const char* key, double value, double least, const char* count) {
    at.error_if(value < least * radius * (1.0 - 1e-9), kBoxSize, key,
                "is " + number_text(value) + " m, expected at least " + count + " radii of the grains, " +
                    number_text(least * radius) + " m");
  };
  check("box.depth", box.depth, kLeastDepth, "four");
  check("box.size", *std::min_element(box.size.begin(), box.size.end()), kLeastSize, "eight");
}

void check_box_time_step(const Scene& scene, const EntryFindings& at) {
  const BoxSpec& box = *scene.particles->box;
  if (!box.time_step) return;
  const BoxNumbers n = box_numbers(scene);
  const double most = box.rayleigh_fraction * std::min(n.rayleigh, 0.5 * n.hertz);
  at.error_if(!at.given("max_time_step") && *box.time_step > most * (1.0 + 1e-9), kBoxTimeStep, "box.time_step",
              "is " + number_text(*box.time_step) + " s, " + share_text(*box.time_step / n.rayleigh) +
                  " of the Rayleigh time and " + share_text(*box.time_step / n.hertz) +
                  " of the Hertz time of these grains, expected at most " + number_text(most, 3) +
                  " s; larger steps give wrong results without any message. Remove it, or state "
                  "particles.max_time_step if the step is known to be right");
}

// Whole columns of the bed down to a depth, in a part of the bed only.
void check_pit(const EntryFindings& at, const BoxSpec& box) {
  if (box.pit.empty()) {
    at.error_if(at.given("box.pit_depth"), kNeedsOtherKey, "box.pit_depth",
                "needs box.pit, the ends of the pit along x");
    return;
  }
  const double left = box.centre[0] - 0.5 * box.size[0], right = box.centre[0] + 0.5 * box.size[0];
  std::vector<std::string> ends;
  for (const double x : box.pit) ends.push_back(number_text(x));
  at.error_if(box.pit.size() != 2 || !(box.pit[0] < box.pit[1]) || box.pit[1] <= left || box.pit[0] >= right ||
                  (box.pit[0] <= left && box.pit[1] >= right),
              kBoxPit, "box.pit",
              "is [" + joined(ends) + "], expected [x_1, x_2] in m, x_1 < x_2, a part of the bed from x = " +
                  number_text(left) + " to " + number_text(right));
  at.error_if(!(box.pit_depth > 0.0 && box.pit_depth <= box.depth), kBoxPit, "box.pit_depth",
              "is " + number_text(box.pit_depth) + " m, expected more than 0 and at most the depth of the bed, " +
                  number_text(box.depth) + " m");
}

// Names of bodies become words of a LIGGGHTS script and parts of its ids.
void check_names(const Scene& scene, Findings& findings) {
  for (const BoundarySpec& boundary : scene.boundaries)
    if (boundary.body.find_first_of("-.") != std::string::npos)
      findings.error(
          kLiggghtsRange, boundary.source, "body",
          "is \"" + boundary.body +
              "\", expected letters, digits and _ only, of which LIGGGHTS makes ids; rename the body, or use "
              "a script instead of [particles.box]");
}

void check_gravity(const Scene& scene, Findings& findings) {
  const Eigen::Vector3d& g = scene.gravity;
  const double tilt = 180.0 / kPi * std::atan2(std::hypot(g.x(), g.y()), -g.z());
  if (!(g.norm() > 0.0) || tilt > kSteepest)
    findings.error(kBoxGravity, scene.source, "gravity",
                   "is [" + number_text(g.x()) + ", " + number_text(g.y()) + ", " + number_text(g.z()) +
                       "] m/s2, expected along -z, or tilted by at most 30 degrees: the bed of [particles.box] settles "
                       "on its floor");
}

}  // namespace

bool check_box(const Scene& scene, Findings& findings) {
  const int before = findings.error_count();
  const BoxSpec& box = *scene.particles->box;
  const EntryFindings at(findings, scene.particles->source);
  if (scene.touches_particles()) {
    for (const char* key : {"script", "bed"})
      at.error_if(at.given(key), kConflictingKeys, key, "excludes box, which has scripts of its own; keep one");
    check_gravity(scene, findings);
    check_names(scene, findings);
  }
  check_counts(at, box);
  check_material(at, "box.material.", box.material.poisson, box.material.young, box.material.restitution);
  check_material(at, "box.bodies.", box.bodies.poisson, box.bodies.young, box.bodies.restitution.value_or(1.0));
  at.error_if(box.seed > kMostSeeds, kOutOfRange, "box.seed",
              "is " + std::to_string(box.seed) + ", expected 1 to " + std::to_string(kMostSeeds));
  at.error_if(box.periodic && box.margin, kConflictingKeys, "box.margin",
              "excludes periodic = true: there are no walls to leave space around");
  at.error_if(box.periodic && !box.walls, kConflictingKeys, "box.walls",
              "= false excludes periodic = true: a periodic bed has no sides to remove");
  at.error_if(!(box.rayleigh_fraction > 0.0), kOutOfRange, "box.rayleigh_fraction",
              "is 0, expected more than 0, such as 0.1");
  // Missing and refused numbers are reported already.
  const auto positive = [](const std::vector<double>& list) {
    return !list.empty() && std::all_of(list.begin(), list.end(), [](double x) { return x > 0.0; });
  };
  const bool complete = positive(box.size) && positive(box.radius) && box.depth > 0.0;
  if (!complete || findings.error_count() > before) return false;
  check_against_grains(at, box);
  check_pit(at, box);
  check_box_time_step(scene, at);
  const double grains = box_numbers(scene).grains;
  at.error_if(grains > kMostGrains, kBoxSize, "box.radius",
              "makes about " + number_text(grains, 2) + " grains of this bed, expected at most " +
                  number_text(kMostGrains) + "; check that it is in m");
  return findings.error_count() == before;
}

}  // namespace footfall
