// The checks of the LIGGGHTS script and of [particles.box]. LIGGGHTS decides in the end; these checks find in milliseconds
// what would end a run later, and what neither program can know by itself.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/couple_mbd_arguments.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/grains/bed_parts.h"
#include "mbd_solver/scene/grains/grain_sizes.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/particle_script.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {
using namespace code;

namespace {

// The time step in force when the coupled grains move. Before the coupling a script may settle its bed with another step;
// a step in an `if` is not known here.
void check_time_step(const ScriptText& script, const ParticlesSpec& particles, Findings& findings) {
  const ScriptCommand* step = nullptr;
  bool coupled = false;
  for (const ScriptCommand& command : script.commands()) {
    if (command.words[0] == "timestep" && command.words.size() > 1)
      step = command.conditional || !as_number(command.words[1]) ? nullptr : &command;
    coupled = coupled || command.is_fix("couple/mbd");
    if (command.words[0] == "run" && coupled) break;
  }
  if (step == nullptr) return;
  const double dt = *as_number(step->words[1]);
  if (dt <= particles.max_time_step * (1.0 + 1e-9)) return;
  const std::string whose = particles.box ? concat("the time step of the grains, box.time_step, is ", dt, " s")
                                          : concat("the script's time step is ", dt, " s (", step->place(), ")");
  findings.error(kScriptTimeStep, particles.source, "max_time_step", whose, ", expected at most ",
                 particles.max_time_step,
                 " s: on this kind of soil twice that runs without any message and is wrong by tens of per cent. "
                 "Reduce the time step, or set a larger max_time_step if these grains are known to allow it");
}

// A script that reads a settled bed, and a scene that does not say how it is made.
void check_bed_is_given(const ScriptText& script, const ParticlesSpec& particles, Findings& findings) {
  if (particles.bed || particles.box) return;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] == "write_restart" || w[0] == "restart") return;  // it may be the script's own
    if (w[0] != "read_restart" || w.size() < 2 || command.conditional) continue;
    const bool unknown = w[1].find("${") != std::string::npos;
    std::error_code ignored;
    if (unknown ? w[1].find("${bed}") == std::string::npos : std::filesystem::exists(w[1], ignored)) continue;
    findings.error(kScriptBed, particles.source, "script", command.place(), " reads a settled bed, ", w[1],
                   unknown ? ", whose variable has no value" : ", which does not exist",
                   "; add [particles.bed] with the script that makes it (script = \"in.bed\"), or name a restart file: "
                   "variables = { bed = \"FILE\" }");
  }
}

// LIGGGHTS replaces ${name} until none is left: forever, where a value leads back to its own name.
void check_values(const std::map<std::string, std::string>& variables, const std::string& key,
                  const EntryFindings& at) {
  for (const auto& [name, value] : variables) {
    if (const std::string fault = fault_of_variable(name, value); !fault.empty()) {
      at.error(kUnsafeValue, key + "." + name, fault);
      continue;
    }
    std::string chain = name;
    const std::string* text = &value;
    for (std::size_t steps = 0; steps <= variables.size(); ++steps) {
      const std::size_t begin = text->find("${"), end = text->find('}', begin);
      if (begin == std::string::npos || end == std::string::npos) break;
      const auto next = variables.find(text->substr(begin + 2, end - begin - 2));
      if (next == variables.end()) break;
      chain += " -> " + next->first;
      if (next->first == name) {
        at.error(kVariableCircle, key + "." + name, "the variable refers to itself: ", chain, "; give it a value");
        return;
      }
      text = &next->second;
    }
  }
}

// A variable that the script does not read has no effect. A name similar to a known one is misspelt; others may come from
// the scene's base, for another script.
void check_variables(const ScriptText& script, const std::map<std::string, std::string>& variables,
                     const std::string& key, const EntryFindings& at) {
  const std::vector<std::string> known(script.names().begin(), script.names().end());
  for (const auto& [name, value] : variables) {
    if (script.names().count(name) == 1) continue;
    const std::string what =
        "the script neither declares nor reads this variable." + known_names("variables", name, known);
    if (script.whole() && !nearest_name(name, known).empty())
      at.error(kUnknownVariable, key + "." + name, what);
    else
      at.warning(kUnusedVariable, key + "." + name, what);
  }
}

// The comparison of the handshake, made before a bed is poured.
void check_units(const ScriptText& script, const EntryFindings& at) {
  for (const ScriptCommand& command : script.commands())
    if (command.words[0] == "units" && !command.conditional && !command.is_computed() && command.words.size() == 2)
      at.error_if(command.words[1] != "si", kScriptNotSi, "script", command.place(), " sets `units ", command.words[1],
                  "`, expected `units si`: masses, lengths and times of the mechanism are in kg, m and s");
}

std::string gravity_text(const Eigen::Vector3d& v) { return concat("[", v[0], ", ", v[1], ", ", v[2], "] m/s2"); }

// How to set the size of the script's gravity, if only the size differs and a variable of its name is there.
std::string gravity_variable(const ScriptText& script, const Scene& scene, const Eigen::Vector3d& g) {
  const bool parallel = (g.normalized() - scene.gravity.normalized()).norm() < 1e-6;
  if (!parallel || script.names().count("gravity") == 0) return "";
  const std::string size = concat("variables.gravity=", scene.gravity.norm());
  return ": --set particles." + size + (scene.particles->bed ? " --set particles.bed." + size : "");
}

// The comparison of the handshake, made before a bed is poured: one fix gravity with plain numbers.
void check_gravity(const ScriptText& script, const Scene& scene, const EntryFindings& at) {
  const ScriptCommand* only = nullptr;
  bool grains_move = false, coupled = false;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (coupled && w[0] == "run" && !command.conditional) break;  // here they are compared
    coupled = coupled || command.is_fix("couple/mbd");
    if (w[0] == "unfix" && only != nullptr && w.size() > 1 && w[1] == only->words[1]) {
      if (command.conditional) return;
      only = nullptr;
    }
    if (command.is_fix("couple/mbd"))
      for (std::size_t i = 4; i + 1 < w.size(); ++i)
        if (w[i] == "gravity" && w[i + 1] == "script") return;
    if (w[0] == "fix" && w.size() > 3 && w[3].find('$') != std::string::npos) return;  // it may be any fix
    grains_move = grains_move || command.is_fix("nve/sphere") || command.is_fix("multisphere");
    if (!command.is_fix("gravity")) continue;
    if (only != nullptr || command.conditional) return;
    only = &command;
  }
  if (only == nullptr && grains_move && script.whole() && script.straight() && !scene.gravity.isZero(0.0)) {
    const Eigen::Vector3d down = scene.gravity.normalized();
    at.warning(kNoGrainGravity, "script", "has no fix gravity, so the grains have no weight; the scene's gravity is ",
               gravity_text(scene.gravity), ". Add  fix gravity all gravity ", scene.gravity.norm(), " vector ",
               down[0], " ", down[1], " ", down[2]);
  }
  if (only == nullptr || only->words.size() != 9 || only->words[5] != "vector") return;
  Eigen::Vector3d direction;
  const std::optional<double> size = as_number(only->words[4]);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::optional<double> x = as_number(only->words[6 + c]);
    if (!x) return;
    direction[static_cast<Eigen::Index>(c)] = *x;
  }
  if (!size || direction.isZero(0.0)) return;
  const Eigen::Vector3d g = *size * direction.normalized();
  at.error_if((g - scene.gravity).norm() > 1e-6 * scene.gravity.norm(), kScriptGravity, "script",
              "the gravity of the grains is ", gravity_text(g), " (", only->place(), "), the gravity of the scene ",
              gravity_text(scene.gravity), "; make them agree", gravity_variable(script, scene, g),
              ". A bed by [particles.box] takes the gravity of the scene, of a slope as well. If the grains are meant "
              "to have another gravity, write  fix ID all couple/mbd every N gravity script ...");
}

// The words of the last `fix ID all gravity ...` and of the elastic constants, by their meaning. (Friction differs on
// purpose: beds are poured with little of it, to be dense.)
std::map<std::string, std::string> conditions(const ScriptText& script) {
  std::map<std::string, std::string> all;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    std::size_t first = 0;
    if (command.is_fix("gravity")) first = 4;
    if (command.is_fix("property/global") && w.size() > 4 && (w[4] == "youngsModulus" || w[4] == "poissonsRatio"))
      first = 5;
    if (first == 0 || command.conditional) continue;
    std::string text;
    for (std::size_t i = first; i < w.size(); ++i) {
      const std::optional<double> number = as_number(w[i]);
      text += (text.empty() ? "" : " ") + (number ? number_text(*number, 12) : w[i]);
    }
    if (text.find("${") == std::string::npos) all[first == 4 ? "gravity" : w[4]] = text;
  }
  return all;
}

// A cached bed was poured by a script of its own. Gravity and elasticity should be the same in both, and so should every
// variable that both scripts have and the scene sets in one of them; but for the time step, which is the method's.
void compare_with_bed(const ScriptText& script, const ScriptText& bed, const ParticlesSpec& particles,
                      const EntryFindings& at) {
  const auto differs = [&](const std::string& what, const std::string& of_bed, const std::string& of_run) {
    at.warning(kBedDiffers, "bed", "the bed is made with ", what, " = ", of_bed, ", the run has ", of_run,
               ", so the grains do not rest as they would in the run; make them agree unless this is intended");
  };
  const std::map<std::string, std::string> of_bed = conditions(bed), of_run = conditions(script);
  for (const auto& [what, value] : of_bed) {
    const auto other = of_run.find(what);
    if (other != of_run.end() && other->second != value) differs(what, value, other->second);
  }
  for (const std::string& name : bed.names()) {
    const bool set = particles.variables.count(name) == 1 || particles.bed->variables.count(name) == 1;
    if (!set || name == "dt" || name == "gravity") continue;  // gravity is compared above
    const std::optional<double> here = as_number(bed.value(name)), there = as_number(script.value(name));
    if (here && there && *here != *there) differs("variable " + name, bed.value(name), script.value(name));
  }
}

bool is_file(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(name, ignored);
}

// The script and what it includes; nothing, with a finding, if a file includes itself.
std::optional<ScriptText> script_of(const std::string& file, const std::map<std::string, std::string>& variables,
                                    const std::string& key, const EntryFindings& at) {
  ScriptText script(file, variables);
  if (script.circle().empty()) return script;
  at.error(kScriptCircle, key, script.circle(), " includes a file that includes this line again");
  return std::nullopt;
}

// Lines of the LIGGGHTS script that couple: their words, and the bodies and meshes that they name.

using Names = std::vector<std::string>;

bool is_computed_word(const std::string& word) { return word.find('$') != std::string::npos; }

// By the reader of the fix itself.
void check_words(const ScriptCommand& command, const EntryFindings& at) {
  if (command.is_computed()) return;
  std::vector<const char*> words;
  for (std::size_t i = 1; i < command.words.size(); ++i) words.push_back(command.words[i].c_str());
  try {
    const CoupleMbdArguments arguments(static_cast<int>(words.size()), words.data());
  } catch (const InputError& error) {
    at.all().coded_error(at.source(), "script", command.place() + ": " + error.what());
  }
}

// The words that a line names after a keyword, as far as they are plain: `body NAME`, or the `distance`-th word of
// `mesh MESH BODY`.
Names named_after(const std::string& keyword, std::size_t distance, const ScriptCommand& command) {
  const std::size_t values = keyword == "mesh" ? 2 : 1;
  Names names;
  const Names& w = command.words;
  for (std::size_t i = 4; i + values < w.size(); ++i) {
    if (w[i] != keyword) continue;
    if (!is_computed_word(w[i + distance])) names.push_back(w[i + distance]);
    i += values;
  }
  return names;
}

// A jump may skip the lines of other scenes.
void check_bodies_named(const ScriptCommand& command, bool straight, const Names& known, const EntryFindings& at) {
  Names named;
  if (command.is_fix("couple/mbd/geometry") || command.is_fix("wall/gran/beam"))
    named = named_after("body", 1, command);
  if (command.is_fix("couple/mbd") && straight) named = named_after("mesh", 2, command);
  // The script of [particles.box] names the bodies of the scene itself, and none where nothing has a boundary.
  for (const std::string& body : named)
    if (!is_in(known, body) && !(known.empty() && at.given("box")))
      at.error(kScriptName, "script", command.place(), " names the body \"", body,
               "\", which has no boundary in this scene.", known_names("boundaries", body, known));
}

// A mesh that no line before this one makes. A loop, or a file that is not read, may make any.
void check_meshes_named(const ScriptText& script, const EntryFindings& at) {
  Names meshes;
  for (const ScriptCommand& command : script.commands()) {
    const Names& w = command.words;
    if (w[0] != "fix" || w.size() < 4) continue;
    if (is_computed_word(w[1]) || is_computed_word(w[3])) return;
    if (w[3].rfind("mesh/surface", 0) == 0) meshes.push_back(w[1]);
    if (!command.is_fix("couple/mbd") || command.conditional) continue;
    for (const std::string& mesh : named_after("mesh", 1, command))
      if (!is_in(meshes, mesh))
        at.error(kScriptName, "script", command.place(), " couples the mesh \"", mesh,
                 "\", but no line above it is a fix mesh/surface of this id.", known_names("meshes", mesh, meshes));
  }
}

bool may_run(const ScriptCommand& command) {
  return is_computed_word(command.words[0]) || command.words[0] == "partition" || command.words[0] == "run";
}

// The mechanism moves during the run. A loop may lead back to a line above.
void check_run_follows(const ScriptText& script, const EntryFindings& at) {
  const ScriptCommand* coupling = nullptr;
  for (const ScriptCommand& command : script.commands()) {
    if (command.is_fix("couple/mbd")) coupling = &command;
    if (coupling != nullptr && may_run(command)) return;
  }
  if (coupling != nullptr)
    at.error(kScriptNoRun, "script", coupling->place(),
             " couples, but no run follows this line, so nothing would move; add a last line  run 1000000000  (the "
             "scene ends it)");
}

// LIGGGHTS refuses it while a fix counts steps, as the coupling does.
void check_steps_continue(const ScriptText& script, const EntryFindings& at) {
  const ScriptCommand* coupling = nullptr;
  for (const ScriptCommand& command : script.commands()) {
    const Names& w = command.words;
    if (command.is_fix("couple/mbd")) coupling = command.conditional ? nullptr : &command;
    if (w[0] == "clear" || w[0] == "unfix") coupling = nullptr;
    if (w[0] == "reset_timestep" && coupling != nullptr && !command.conditional)
      at.error(kScriptResetsSteps, "script", command.place(), " resets the steps that the coupling (",
               coupling->place(), ") counts, which LIGGGHTS refuses; move reset_timestep above fix couple/mbd");
  }
}

// LIGGGHTS' own limits, which it reports when the run begins, after the bed is poured.
void check_moduli(const ScriptText& script, const EntryFindings& at) {
  constexpr double kSoft = 5e6, kHard = 1e9;  // [Pa]
  const auto allows = [&](const char* word) {
    return std::any_of(script.commands().begin(), script.commands().end(),
                       [&](const ScriptCommand& command) { return command.words[0] == word; });
  };
  for (const ScriptCommand& command : script.commands()) {
    const Names& w = command.words;
    if (command.conditional || !command.is_fix("property/global") || w.size() < 7 || w[4] != "youngsModulus") continue;
    for (std::size_t i = 6; i < w.size(); ++i) {
      const std::optional<double> young = as_number(w[i]);
      if (!young || (*young >= kSoft && *young <= kHard)) continue;
      const bool soft = *young < kSoft;
      const char* const word = soft ? "soft_particles" : "hard_particles";
      if (allows(word)) continue;
      at.error(kLiggghtsRange, "script", command.place(), " has a Young's modulus of ", *young,
               " Pa; LIGGGHTS refuses ",
               soft ? "less than 5e6, because grains so soft overlap much under small loads"
                    : "more than 1e9, because grains so stiff need very small time steps",
               ". If it is meant, write  ", word, " yes  below `units si`");
      return;
    }
  }
}

// A bed of a script lies on the plane wall that faces up most. Where that wall is tilted against gravity by more than the steepest
// slope of grains, the bed flows. Walls that may hold it otherwise, of meshes without a body or of cylinders, are not judged.
void check_bed_stands(const ScriptText& script, const Scene& scene, const EntryFindings& at) {
  constexpr double kStands = 30.0;  // [degrees]
  if (!script.whole() || scene.gravity.isZero(0.0)) return;
  std::set<std::string> coupled;
  for (const ScriptCommand& command : script.commands()) {
    if (!command.is_fix("couple/mbd")) continue;
    const Names& w = command.words;
    if (std::find(w.begin(), w.end(), "gravity") != w.end()) return;  // the grains may have another one
    for (const std::string& mesh : named_after("mesh", 1, command)) coupled.insert(mesh);
  }
  std::optional<double> nearest;  // cosine of gravity and the normal of a wall
  for (const ScriptCommand& command : script.commands()) {
    const Names& w = command.words;
    if (!command.is_fix("wall/gran")) continue;
    const auto meshes = std::find(w.begin(), w.end(), "meshes"), primitive = std::find(w.begin(), w.end(), "primitive");
    if (meshes != w.end() &&
        std::any_of(meshes + 1, w.end(), [&](const std::string& word) { return coupled.count(word) == 0; }))
      return;
    if (primitive == w.end()) continue;
    const auto plane = std::find_if(primitive, w.end(), [](const std::string& word) {
      return word == "xplane" || word == "yplane" || word == "zplane";
    });
    if (plane == w.end()) return;
    const double cosine = std::abs(scene.gravity.normalized()[(*plane)[0] - 'x']);
    nearest = std::max(nearest.value_or(0.0), cosine);
  }
  if (!nearest) return;
  const double tilt = std::acos(std::min(1.0, *nearest)) * 180.0 / kPi;
  if (tilt <= kStands) return;
  at.warning(kBedFlows, "script", "the bed flows: gravity ", gravity_text(scene.gravity), " is tilted by ",
             number_text(tilt, 3), " degrees against the plane wall that faces it most, and grains stand at most at ",
             kStands, " degrees; correct gravity, or add the wall on which the bed lies (fix wall/gran ... primitive)");
}

// Lines that couple: their words, the meshes and bodies that they name, and that a `run` follows. Reports only what is certain
// for any value of variables, any branch and any loop.
void check_coupling(const ScriptText& script, const Scene& scene, Findings& findings) {
  const EntryFindings at(findings, scene.particles->source);
  check_bed_stands(script, scene, at);
  for (const ScriptCommand& command : script.commands()) {
    if (command.conditional) continue;
    if (command.is_fix("couple/mbd")) check_words(command, at);
    check_bodies_named(command, script.straight(), boundary_names(scene), at);
  }
  if (!script.straight()) return;
  if (script.whole()) {
    check_moduli(script, at);
    check_meshes_named(script, at);
    check_run_follows(script, at);
  }
  check_steps_continue(script, at);
}

// Meshes of the LIGGGHTS script against its simulation box: drawn in millimetres, they are a thousand times too large.

using Box = Eigen::AlignedBox3d;

// region ID block xlo xhi ylo yhi zlo zhi, in plain numbers.
std::optional<Box> block(const ScriptCommand& command) {
  const std::vector<std::string>& w = command.words;
  if (w.size() < 9 || w[2] != "block") return std::nullopt;
  Box box;
  for (Eigen::Index c = 0; c < 3; ++c) {
    const std::optional<double> low = as_number(w[3 + 2 * c]), high = as_number(w[4 + 2 * c]);
    if (!low || !high || !(*low < *high)) return std::nullopt;
    box.min()[c] = *low;
    box.max()[c] = *high;
  }
  return box;
}

// The simulation box, if the text gives it: one create_box of a block, in metres.
std::optional<Box> simulation_box(const ScriptText& script) {
  std::map<std::string, std::optional<Box>> regions;
  std::optional<Box> box;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] == "lattice" || w[0] == "change_box" || w[0] == "displace_box") return std::nullopt;
    if (w[0] == "region" && w.size() > 2) regions[w[1]] = command.conditional ? std::nullopt : block(command);
    if (w[0] != "create_box" || w.size() < 3) continue;
    const auto region = regions.find(w[2]);
    if (box || command.conditional || region == regions.end() || !region->second) return std::nullopt;
    box = region->second;
  }
  return box;
}

bool all_sides_are_fixed(const ScriptText& script) {
  bool fixed = false;
  for (const ScriptCommand& command : script.commands())
    if (command.words[0] == "boundary")
      fixed = !command.conditional && command.words == std::vector<std::string>{"boundary", "f", "f", "f"};
  return fixed;
}

std::optional<Box> extent_of(const ScriptCommand& command, const std::string& here) {
  try {
    const SurfaceSpec surface = mesh_in_script(command, here);
    Box box;
    for (const Eigen::Vector3d& x : read_mesh(surface.file, surface.scale).vertices)
      box.extend(surface.orientation * x + surface.position);
    return box;
  } catch (const InputError&) {
    return std::nullopt;  // reported where the mesh is used
  }
}

std::string size_text(const Box& box) {
  const Eigen::Vector3d size = box.sizes();
  return number_text(size[0], 3) + " x " + number_text(size[1], 3) + " x " + number_text(size[2], 3) + " m";
}

// Meshes from files that are drawn a thousand times too large for the box.
void check_script_meshes(const ScriptText& script, const Scene& scene, Findings& findings) {
  const ParticlesSpec& particles = *scene.particles;
  std::optional<Box> box = simulation_box(script);
  if (!box && particles.bed && std::filesystem::is_regular_file(particles.bed->script))
    box = simulation_box(ScriptText(particles.bed->script, particles.bed->variables));
  if (!box) return;
  constexpr double kSuspicious = 20.0;  // of the box's diagonal; a thousandth of it fits in
  const double room = box->diagonal().norm();
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (command.conditional || w[0] != "fix" || w.size() < 4 || w[3].rfind("mesh/surface", 0) != 0) continue;
    const std::optional<Box> mesh = extent_of(command, std::filesystem::path(particles.script).parent_path().string());
    if (!mesh || mesh->diagonal().norm() < kSuspicious * room || 1e-3 * mesh->diagonal().norm() > room) continue;
    const std::string what = command.place() + ": mesh " + w[1] + " measures " + size_text(*mesh) +
                             ", the simulation box " + size_text(*box) +
                             "; if it is drawn in millimetres, add  scale 0.001";
    // LIGGGHTS stops when it has lost all triangles of a mesh.
    if (!mesh->intersects(*box) && script.straight() && all_sides_are_fixed(script))
      findings.error(code::kMeshOutsideBox, particles.source, "script", what);
    else
      findings.warning(code::kMeshLargerThanBox, particles.source, "script", what);
  }
}

// What [particles.box] cannot be: values that LIGGGHTS refuses, sizes that do not suit the grains, too many grains.

constexpr double kMostGrains = 5e6;
constexpr double kLeastDepth = 4.0, kLeastSize = 8.0;  // of the bed, over the largest radius
constexpr double kSteepest = 30.0;                     // of gravity against -z [deg]
// The range of LIGGGHTS in SI units.
constexpr double kLeastRestitution = 0.05;  // more than this
constexpr double kSoft = 5e6;               // [Pa]; below it only with `soft_particles yes`, as in inputs/box
constexpr double kSoftest = 1e4;            // [Pa]; a contact of softer grains is none
constexpr double kMostPourStep = 0.2;       // of the Rayleigh time
constexpr std::size_t kMostTemplates = 12;  // of clumps, in inputs/box/in.bed

const char* const kNoOther = "; LIGGGHTS accepts no other";

void check_material(const EntryFindings& at, const std::string& of, double poisson, double young, double restitution) {
  at.error_if(!(poisson >= 0.0 && poisson < 0.5), kLiggghtsRange, of + "poisson", "is ", poisson,
              ", expected 0 or more and less than 0.5", kNoOther);
  if (young > 0.0 && young < kSoftest) {  // 0 was refused by the reader
    at.error(kOutOfRange, of + "young", "is ", young, " Pa, expected at least 1e4; is it in MPa? Then write young_MPa");
  } else if (young < kSoft) {
    at.warning(kSoftMaterial, of + "young", "is ", young,
               " Pa; LIGGGHTS takes less than 5e6 for a mistake, because grains so soft overlap much under small "
               "loads, and their first peak of force is too low. The run allows it (soft_particles yes): watch "
               "max_overlap_over_radius in the summary, which should stay below 5 %");
  }
  at.error_if(restitution <= kLeastRestitution, kLiggghtsRange, of + "restitution", "is ", restitution,
              ", expected more than 0.05, at most 1", kNoOther);
}

void check_counts(const EntryFindings& at, const BoxSpec& box) {
  const auto has = [](std::size_t count, const char* what = " numbers") { return concat("has ", count, what); };
  // An empty list next to another finding was refused by the reader.
  const auto check = [&](const char* key, const std::vector<double>& list, std::size_t fewest, const char* expected) {
    const bool good = (list.size() >= fewest && list.size() <= 2) || (list.empty() && at.all().has_errors());
    at.error_if(!good, kWrongCount, key, has(list.size()), ", expected ", expected);
  };
  check("box.size", box.size, 2, "[along x, along y] in m");
  check("box.centre", box.centre, 2, "[x, y] in m");
  const std::vector<std::string> shapes = names_of<ClumpShape>();
  for (const std::string& name : box.clumps)
    if (!is_in(shapes, name))
      at.error(kUnknownClump, "box.clumps", "unknown clump \"", name, "\".", known_names("clumps", name, shapes));
  at.error_if(!has_parts(box) && box.clumps.size() * box.radius.size() > kMostTemplates, kTooLarge, "box.clumps",
              has(box.clumps.size(), " shapes"), " and radius ", box.radius.size(),
              " numbers, expected at most twelve combinations");
  at.error_if(!box.clump_shares.empty() && box.clump_shares.size() != box.clumps.size(), kWrongCount,
              "box.clump_shares", has(box.clump_shares.size()), " for ", box.clumps.size(),
              " clumps, expected one for each, or no shares");
}

void check_against_grains(const EntryFindings& at, const BoxSpec& box) {
  const double radius = *std::max_element(box.radius.begin(), box.radius.end());
  const auto check = [&](const char* key, double value, double least, const char* count) {
    at.error_if(value < least * radius * (1.0 - 1e-9), kBoxSize, key, "is ", value, " m, expected at least ", count,
                " radii of the grains, ", least * radius, " m");
  };
  check("box.depth", box.depth, kLeastDepth, "four");
  check("box.size", *std::min_element(box.size.begin(), box.size.end()), kLeastSize, "eight");
}

void check_box_time_step(const Scene& scene, const EntryFindings& at) {
  const BoxSpec& box = *scene.particles->box;
  if (!box.time_step) return;
  const BoxNumbers n = box_numbers(scene);
  const double most = box.rayleigh_fraction * std::min(n.rayleigh, 0.5 * n.hertz);
  at.error_if(!at.given("max_time_step") && *box.time_step > most * (1.0 + 1e-9), kBoxTimeStep, "box.time_step", "is ",
              *box.time_step, " s, ", share_text(*box.time_step / n.rayleigh), " of the Rayleigh time and ",
              share_text(*box.time_step / n.hertz), " of the Hertz time of these grains, expected at most ",
              number_text(most, 3),
              " s; larger steps give wrong results without any message. Remove it, or state particles.max_time_step if "
              "the step is known to be right");
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
              kBoxPit, "box.pit", "is [", joined(ends),
              "], expected [x_1, x_2] in m, x_1 < x_2, a part of the bed from x = ", left, " to ", right);
  at.error_if(!(box.pit_depth > 0.0 && box.pit_depth <= box.depth), kBoxPit, "box.pit_depth", "is ", box.pit_depth,
              " m, expected more than 0 and at most the depth of the bed, ", box.depth, " m");
}

// Whether a block for grains is one, and where grains of the bed can be.
void check_region(const EntryFindings& at, const std::string& key, const Scene& scene, const GrainRegionSpec& spec,
                  double least) {
  const BoxSpec& box = *scene.particles->box;
  const BoxNumbers n = box_numbers(scene);
  const Eigen::Vector3d low = spec.region[0].cwiseMin(spec.region[1]), high = spec.region[0].cwiseMax(spec.region[1]);
  at.error_if((high - low).minCoeff() < least, kGrainRegion, key, "is ", (high - low).minCoeff(),
              " m wide, expected at least ", number_text(least, 3),
              " m in every direction: two opposite corners of a block, [[x, y, z], [x, y, z]] in m");
  const double around = box.walls ? 0.0 : n.margin;
  const Eigen::Vector3d least_corner(box.centre[0] - 0.5 * box.size[0] - around,
                                     box.centre[1] - 0.5 * box.size[1] - around, -box.depth),
      last_corner(box.centre[0] + 0.5 * box.size[0] + around, box.centre[1] + 0.5 * box.size[1] + around, n.headroom);
  for (int c = 0; c < 3; ++c)
    at.error_if(low[c] < least_corner[c] - 1e-9 || high[c] > last_corner[c] + 1e-9, kGrainRegion, key, "reaches from ",
                low[c], " to ", high[c], " m along ", "xyz"[c], ", expected within the bed and the space above it, ",
                least_corner[c], " to ", last_corner[c], " m", c == 2 ? " (box.headroom)" : "");
  at.error_if(spec.until && *spec.until <= spec.from, kRangeReversed, key, "ends at ", spec.until.value_or(0.0),
              " s, expected after its beginning at ", spec.from, " s");
}

constexpr double kFollowRadii = 40.0;  // least side of a bed that follows a body [radius of a grain]
constexpr double kMostFilled = 0.25;   // of a source by grains on their way out: more rarely find space
constexpr std::size_t kMostSources = 8;

void check_sources_and_sinks(const EntryFindings& at, const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  at.error_if(box.sources.size() > kMostSources, kWrongCount, "box.sources", "has ", box.sources.size(),
              " entries, expected at most ", kMostSources);
  const double radius = *std::max_element(box.radius.begin(), box.radius.end());
  at.error_if(!box.clumps.empty() && !(box.sources.empty() && box.sinks.empty()), kConflictingKeys,
              box.sources.empty() ? "box.sinks" : "box.sources",
              "is for spheres, but box.clumps makes clumps of them; remove one of the two");
  for (std::size_t i = 0; i < box.sinks.size(); ++i)
    check_region(at, concat("box.sinks.", i, ".region"), scene, box.sinks[i], radius);
  for (std::size_t i = 0; i < box.sources.size(); ++i) {
    const GrainSourceSpec& source = box.sources[i];
    const std::string key = concat("box.sources.", i);
    at.missing_if(!source.rate && !source.grains_per_second, key + ".rate", "give rate [kg/s] or grains_per_second");
    at.error_if(source.rate && source.grains_per_second, kConflictingKeys, key + ".rate",
                "is given as grains_per_second, too; keep one of the two");
    const int before = at.all().error_count();
    check_region(at, key + ".region", scene, source, 2.5 * radius);
    if (at.all().error_count() > before || (!source.rate && !source.grains_per_second)) continue;
    // A grain leaves the block of height h within t: h = v t + g t^2 / 2, or sideways.
    const Eigen::Vector3d sides = (source.region[1] - source.region[0]).cwiseAbs();
    const double g = scene.gravity.norm(), v = std::abs(source.velocity.z());
    double leaves = (std::sqrt(v * v + 2.0 * g * sides.z()) - v) / g;
    for (int c = 0; c < 2; ++c)
      if (source.velocity[c] != 0.0) leaves = std::min(leaves, sides[c] / std::abs(source.velocity[c]));
    const double volume = mean_grain_mass(box) / box.material.density;
    const double filled = source_rate(box, source) * volume * leaves / sides.prod();
    at.error_if(filled > kMostFilled, kGrainRegion, key + ".region", "would be filled by grains to ",
                share_text(filled), ", expected at most ", share_text(kMostFilled),
                ": grains come faster than they leave it. Enlarge it, give new grains a velocity, or lower the rate");
  }
}

// A bed that goes along with a body.
void check_follow(const EntryFindings& at, const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  for (const char* key : {"box.follow_directions", "box.follow_distance"})
    at.error_if(box.follow.empty() && at.given(key), kNeedsOtherKey, key,
                "is for a bed that follows a body; add box.follow = \"BODY\"");
  if (box.follow.empty()) return;
  const std::vector<std::string> touched = boundary_names(scene);
  at.error_if(!is_in(touched, box.follow), kUnknownBody, "box.follow", "is \"", box.follow,
              "\", expected a body with a boundary.", known_names("boundaries", box.follow, touched));
  const auto excludes = [&](bool both, const std::string& key, const std::string& why) {
    at.error_if(both, kConflictingKeys, key, "excludes box.follow: ", why, "; remove one of the two");
  };
  excludes(!box.zones.empty(), "box.zones", "the bed is the same after each of its lengths");
  excludes(!box.clumps.empty(), "box.clumps", "only beds of spheres can be put in front of a body");
  excludes(!box.pit.empty(), "box.pit", "the pit would come again with each length of the bed");
  excludes(!box.sources.empty(), "box.sources", "the bed in front is the bed at rest");
  excludes(!box.sinks.empty(), "box.sinks", "the bed in front is the bed at rest");
  if (!scene.initial.from.empty())
    at.all().error(kConflictingKeys, scene.source, "initial.from",
                   "excludes particles.box.follow: the bed in front has to be a bed at rest; start on a new bed");
  const double longest = longest_follow_distance(box),
               largest = *std::max_element(box.radius.begin(), box.radius.end());
  for (int axis = 0; axis < 2; ++axis) {
    if (!follows_along(box, axis)) continue;
    const double side = box.size[axis];
    at.error_if(side < kFollowRadii * largest, kBoxSize, "box.size", "is ", side, " m along ", "xy"[axis],
                ", where the bed follows a body, expected at least ", kFollowRadii * largest,
                " m, forty radii of a grain: the bed moves by tenths of it");
  }
  at.error_if(box.follow_distance && *box.follow_distance > longest, kOutOfRange, "box.follow_distance", "is ",
              *box.follow_distance, " m, expected at most ", longest,
              " m, 0.35 of the shortest side along which the bed follows");
}

// Names of bodies become words of a LIGGGHTS script and parts of its ids.
void check_names(const Scene& scene, Findings& findings) {
  for (const BoundarySpec& boundary : scene.boundaries)
    if (boundary.body.find_first_of("-.") != std::string::npos)
      findings.error(kLiggghtsRange, boundary.source, "body", "is \"", boundary.body,
                     "\", expected letters, digits and _ only, of which LIGGGHTS makes ids; rename the body, or use a "
                     "script instead of [particles.box]");
}

void check_gravity(const Scene& scene, Findings& findings) {
  const Eigen::Vector3d& g = scene.gravity;
  const double tilt = 180.0 / kPi * std::atan2(std::hypot(g.x(), g.y()), -g.z());
  if (!(g.norm() > 0.0) || tilt > kSteepest)
    findings.error(
        kBoxGravity, scene.source, "gravity", "is [", g.x(), ", ", g.y(), ", ", g.z(),
        "] m/s2, expected along -z, or tilted by at most 30 degrees: the bed of [particles.box] settles on its floor");
  const BoxSpec& box = *scene.particles->box;
  const StandingSlope stands = standing_slope(box);
  if (tilt > kSteepest || tilt <= stands.degrees || scene.ground.terrain) return;  // told elsewhere
  const int axis = std::abs(g.x()) >= std::abs(g.y()) ? 0 : 1;
  const bool open = box.periodic || follows_along(box, axis) || !box.walls;
  findings.warning(
      kBedFlows, scene.source, "gravity", "is tilted by ", number_text(tilt, 3), " degrees against the bed, but ",
      stands.grains, " stand at most at ", number_text(stands.degrees, 3), " degrees: the bed flows towards ",
      g[axis] > 0.0 ? "+" : "-", "xy"[axis],
      open ? " without end; " : ", until its lower wall holds it and its surface is flatter by the difference; ",
      "tilt gravity less, or raise box.material.friction and rolling_friction");
}

}  // namespace

void check_script(const Scene& scene, Findings& findings) {
  const ParticlesSpec& particles = *scene.particles;
  const EntryFindings at(findings, particles.source);
  if (!is_file(particles.script)) return;  // reported with its path
  const std::optional<ScriptText> script = script_of(particles.script, particles.variables, "script", at);
  if (!script) return;
  const bool couples = std::any_of(script->commands().begin(), script->commands().end(),
                                   [](const ScriptCommand& command) { return command.is_fix("couple/mbd"); });
  at.error_if(!couples && script->whole(), kScriptNotCoupled, "script",
              "has no line \"fix ID all couple/mbd ...\" (in ", particles.script,
              " and the files it includes), so the mechanism would never meet the grains; add one, or set ground.kind "
              "to \"none\" or \"plane\"");
  if (couples) check_time_step(*script, particles, findings);
  check_coupling(*script, scene, findings);
  check_script_meshes(*script, scene, findings);
  check_bed_is_given(*script, particles, findings);
  check_units(*script, at);
  check_gravity(*script, scene, at);
  check_values(particles.variables, "variables", at);
  check_variables(*script, particles.variables, "variables", at);
  if (!particles.bed || !is_file(particles.bed->script)) return;
  const std::optional<ScriptText> bed = script_of(particles.bed->script, particles.bed->variables, "bed.script", at);
  if (!bed) return;
  check_values(particles.bed->variables, "bed.variables", at);
  check_variables(*bed, particles.bed->variables, "bed.variables", at);
  compare_with_bed(*script, *bed, particles, at);
}

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
  const std::string periodic = box.follow.empty() ? "periodic = true" : "follow, which makes the bed periodic";
  const bool margin = at.source().written_together(box.follow.empty() ? "box.periodic" : "box.follow", "box.margin");
  at.error_if(box.periodic && margin, kConflictingKeys, "box.margin", "excludes ", periodic,
              ": there are no walls to leave space around");
  at.error_if(box.periodic && !box.walls, kConflictingKeys, "box.walls", "= false excludes ", periodic,
              ": a periodic bed has no sides to remove");
  at.error_if(!(box.rayleigh_fraction > 0.0), kOutOfRange, "box.rayleigh_fraction",
              "is 0, expected more than 0, such as 0.1");
  const double pour_step = box.pour.rayleigh_fraction.value_or(kMostPourStep);
  at.error_if(!(pour_step > 0.0 && pour_step <= kMostPourStep), kOutOfRange, "box.pour.rayleigh_fraction", "is ",
              pour_step, ", expected more than 0 and at most ", kMostPourStep,
              ": larger steps throw grains out of the bed");
  const double pour_young = box.pour.young.value_or(box.material.young);
  at.error_if(!(pour_young >= std::min(kSoft, box.material.young) && pour_young <= box.material.young), kOutOfRange,
              "box.pour.young", "is ", pour_young, " Pa, expected at least ", kSoft,
              " Pa and at most box.material.young, ", box.material.young, " Pa");
  at.error_if(box.pour.young && !box.clumps.empty(), kConflictingKeys, "box.pour.young",
              "excludes clumps, which are poured with their own modulus; remove one of the two");
  // Missing and refused numbers are reported already.
  const auto positive = [](const std::vector<double>& list) {
    return !list.empty() && std::all_of(list.begin(), list.end(), [](double x) { return x > 0.0; });
  };
  const bool zones = std::all_of(box.zones.begin(), box.zones.end(), [&](const GrainZoneSpec& zone) {
    return positive(zone.size) && positive(zone.radius) && zone.depth > 0.0;
  });
  const bool complete = positive(box.size) && positive(box.radius) && box.depth > 0.0 && zones;
  if (!complete || findings.error_count() > before) return false;
  check_against_grains(at, box);
  check_zones(scene, at);
  if (findings.error_count() > before) return false;
  check_pit(at, box);
  check_box_time_step(scene, at);
  check_sources_and_sinks(at, scene);
  check_follow(at, scene);
  const double grains = box_numbers(scene).grains;
  at.error_if(grains > kMostGrains, kBoxSize, "box.radius", "makes about ", number_text(grains, 2),
              " grains of this bed, expected at most ", kMostGrains, "; check that it is in m");
  return findings.error_count() == before;
}

}  // namespace footfall
