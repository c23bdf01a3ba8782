// ground.soil: numbers of a soil without grains from a file, laid under the keys of the scene; and the checks of these numbers.

#include <filesystem>

#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/scene_check.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {

using namespace code;  // NOLINT: the codes of this module

namespace {

namespace files = std::filesystem;

// mu for which 894 mu^3 - 386 mu^2 + 89 mu was fitted, with room around it.
constexpr double kLeastFriction = 0.05, kMostFriction = 1.2;

const std::vector<std::string> kRftKeys = {"resistance", "gravity"};
const std::vector<std::string> kSinkageKeys = {"cohesive_modulus", "frictional_modulus", "exponent", "width",
                                               "shear_length"};

}  // namespace

void add_ground_soil(ConfigNode& scene, const std::string& folder, Findings& findings) {
  ConfigNode* ground = scene.find("ground");
  if (!ground || ground->kind != ConfigNode::Kind::kTable) return;
  const ConfigNode* soil = ground->find("soil");
  if (!soil || soil->kind != ConfigNode::Kind::kText) return;  // another type is reported by the reader
  const int line = soil->line;
  const std::string name = soil->text;
  std::error_code ignored;
  std::string path;
  if (const std::string own = files::path(folder) / name; !name.empty() && files::is_regular_file(own, ignored)) {
    path = own;
  } else {
    const std::vector<std::string> names = shipped_tables("inputs/grounds");
    if (!is_in(names, name)) {
      findings.error(kUnknownSoil, line, "ground.soil", "\"", name,
                     "\" is neither a file (relative to the folder of the scene) nor a soil of inputs/grounds.",
                     known_names("soils", name, names));
      return;
    }
    path = shipped_file("inputs/grounds/" + name + ".toml");
  }
  const ConfigNode file = parse_toml_file(path);
  const ConfigNode* numbers = file.find("law");
  if (!numbers || numbers->kind != ConfigNode::Kind::kTable) {
    findings.error(
        kSoilFile, line, "ground.soil", "the file ", path,
        " has no table [law]; expected a file of `footfall ground fit`, or a file like the ones in inputs/grounds");
    return;
  }
  ConfigNode* law = ground->find("law");
  if (!law) {
    ConfigNode fresh;
    fresh.line = line;
    ground->table.emplace_back("law", fresh);
    law = ground->find("law");
  }
  if (law->kind != ConfigNode::Kind::kTable) return;  // reported by the reader
  // A scene that chooses another law takes nothing of the file.
  const ConfigNode *own = law->find("kind"), *theirs = numbers->find("kind");
  if (own && theirs && own->kind == ConfigNode::Kind::kText && own->text != theirs->text) {
    findings.error(kConflictingKeys, own->line, "ground.law.kind", "is \"", own->text, "\", but the soil \"", name,
                   "\" has numbers of the law \"", theirs->text, "\"; remove one of the two");
    return;
  }
  fill_missing(*law, *numbers, line);
}

void check_soil(const Scene& scene, Findings& findings) {
  const GroundSpec& ground = scene.ground;
  const EntryFindings at(findings, ground.source);
  const bool used = ground.kind == GroundKind::kSoil;
  at.error_if(used && !ground.law, kGroundIncomplete, "law",
              "is missing; ground.kind = \"soil\" needs ground.soil = \"NAME\", or [ground.law] with its numbers");
  if (!ground.law) return;
  const SoilSpec& law = *ground.law;
  const bool rft = law.kind == SoilLawKind::kRft;
  at.error_if(used && ground.plane && !at.given("law.normal") &&
                  ground.plane->normal.normalized().dot(law.normal.normalized()) < 1.0 - 1e-9,
              kKeyWithoutEffect, "plane.normal", "tilts the plane, not the soil; ground.law.normal tilts the soil");
  for (const std::string& name : law.bodies)
    at.error_if(scene.boundary_of(name) == nullptr, kUnknownBoundary, "law.bodies", "\"", name,
                "\" has no entry in [[boundaries]].", known_names("boundaries", name, boundary_names(scene)));
  for (const std::string& key : rft ? kSinkageKeys : kRftKeys)
    at.error_if(used && at.given("law." + key), kKeyWithoutEffect, "law." + key, "has no effect on the law \"",
                name_of(law.kind), "\"; remove it");
  if (rft) {
    at.error_if(!law.resistance && !(law.friction >= kLeastFriction && law.friction <= kMostFriction), kOutOfRange,
                "law.friction", "is ", law.friction, ", expected ", kLeastFriction, " to ", kMostFriction,
                ": the resistance follows from it by a formula for this range; give law.resistance [Pa/m] instead");
    at.error_if(law.gravity && !law.resistance, kNeedsOtherKey, "law.gravity",
                "needs law.resistance [Pa/m], the resistance that was measured at this gravity; give it, or remove "
                "law.gravity");
    at.error_if(used && scene.gravity.isZero() && (!law.resistance || law.gravity), kGroundIncomplete, "law.resistance",
                "follows from the weight of the soil, but gravity is 0; give it [Pa/m] without law.gravity");
  } else {
    at.missing_if(!law.frictional_modulus && !(law.cohesive_modulus > 0.0), "law.frictional_modulus",
                  "give the modulus of pressure and sinkage [Pa/m^n]");
    at.missing_if(!law.shear_length, "law.shear_length", "give the K of Janosi and Hanamoto [m]");
  }
  if (!used) return;
  const std::vector<std::string>& named = law.bodies;
  for (const BoundarySpec& boundary : scene.boundaries) {
    if (boundary.surface || (!named.empty() && !is_in(named, boundary.body))) continue;
    findings.error(
        kGroundIncomplete, boundary.source, "surface",
        "is missing: a soil acts on facets, and beams have none; add surface = {}, or name in ground.law.bodies "
        "the boundaries that touch the soil");
  }
}

}  // namespace footfall
