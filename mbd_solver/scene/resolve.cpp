// A scene is completed in this order: arrays, paths, points of joints, segments, meshes of the script, masses, bed.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "coupler/base/concat.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/matrix_model.h"
#include "mbd_solver/fe/modal_body_file.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/model/body.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/grains/grain_sizes.h"
#include "mbd_solver/scene/kind_keys.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/particle_script.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/run_spec.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {
using namespace code;

namespace {

// Joins paths with the scene's folder and reports those that do not exist.
void resolve_paths(Scene& scene, Findings& findings) {
  namespace fs = std::filesystem;
  FieldWalk walk([&](const std::string& key, const FieldRef& ref, const Rule& rule, const FieldWalk& at) {
    std::string* path = member<std::string>(ref);
    if (rule.meaning != Meaning::kPath || !path || path->empty()) return;
    const fs::path full = (fs::path(scene.folder) / *path).lexically_normal();
    std::error_code ignored;
    const bool folder = at.source() == &scene.initial.source && key == "from";
    const char* const wrong = !fs::exists(full, ignored) ? "does not exist" : folder ? "is none" : "is no plain file";
    if (folder ? !fs::is_directory(full, ignored) : !fs::is_regular_file(full, ignored))
      findings.error(code::kNoFile, *at.source(), at.local(key), "the ", folder ? "folder" : "file", " \"", *path,
                     "\" ", wrong, " (", full.string(), "); paths are relative to the scene's folder");
    *path = full.string();
  });
  visit_fields(walk, scene);
}

void resolve_joint_points(Scene& scene, Findings& findings) {
  for (JointSpec& joint : scene.joints) {
    if (!joint.point) continue;
    for (const char* key : {"point_a", "point_b"}) {
      if (joint.source.given(key))
        findings.error(code::kConflictingKeys, joint.source, key, "is given by \"point\" as well; keep one of the two");
    }
    joint.point_a = joint.point_b = *joint.point;
  }
}

bool check_shape(const BodySpec& body, Findings& findings) {
  const ShapeSpec& shape = *body.shape;
  const EntryFindings at(findings, body.source);
  if (!body.source.good("shape.kind")) return false;  // reported when it was read
  const ShapeKeys keys = keys_of(shape.kind);
  const std::string kind(name_of(shape.kind));
  const int before = findings.error_count();
  for (const std::string& key : keys.required)
    at.missing_if(!at.given("shape." + key), "shape." + key, "a ", kind, " needs it");
  for (const auto& [path, line] : body.source.lines) {
    const std::string key = path.rfind("shape.", 0) == 0 ? path.substr(6) : "kind";
    at.no_effect_if(key != "kind" && !is_in(keys.required, key) && !is_in(keys.optional, key), path, "a " + kind);
  }
  const std::set<std::string>& refused = body.source.refused;
  if (std::any_of(refused.begin(), refused.end(), [](const std::string& k) { return k.rfind("shape.", 0) == 0; }))
    return false;
  const bool long_body =
      shape.kind == ShapeKind::kTube || shape.kind == ShapeKind::kRod || shape.kind == ShapeKind::kCapsule;
  at.error_if(long_body && !((shape.to - shape.from).norm() > 0.0), kShape, "shape.to",
              "is the same point as \"from\", expected a different one");
  at.error_if(shape.kind == ShapeKind::kTube && 2.0 * shape.wall > shape.diameter, kShape, "shape.wall", "is ",
              shape.wall, " m, expected at most half the diameter; for a solid bar use kind = \"rod\"");
  at.error_if(shape.kind == ShapeKind::kDish && shape.depth > shape.radius, kShape, "shape.depth", "is ", shape.depth,
              " m, expected at most the radius");
  at.error_if(shape.kind == ShapeKind::kPoints && shape.points.size() < 3, kShape, "shape.points", "contains ",
              shape.points.size(), " points, expected at least three, not on one line");
  return findings.error_count() == before;
}

MassProperties turned(MassProperties p, const Eigen::Vector3d& axis, const Eigen::Vector3d& centre) {
  const Eigen::Matrix3d R = shortest_turn(Eigen::Vector3d::UnitZ(), axis.normalized());
  p.centre = R * p.centre + centre;
  p.inertia = R * p.inertia * R.transpose();
  return p;
}

// Thin spherical cap of rim radius a and depth h, lowest point at the origin, opening along z. On a sphere of radius s
// = (a^2 + h^2) / (2h) equal heights hold equal areas 2 pi s dz, so all moments are means over z in [0, h] with r^2 = 2
// s z - z^2.
MassProperties dish_properties(const ShapeSpec& shape, double density) {
  const double a = shape.radius, h = shape.depth, s = (a * a + h * h) / (2.0 * h);
  MassProperties p;
  p.mass = density * shape.thickness * 2.0 * kPi * s * h;
  p.centre = {0.0, 0.0, 0.5 * h};
  const double r2 = s * h - h * h / 3.0;
  const double across = 0.5 * r2 + h * h / 3.0 - 0.25 * h * h;
  p.inertia = Eigen::Vector3d(across, across, r2).asDiagonal();
  p.inertia *= p.mass;
  return p;
}

// Equal point masses of total mass 1.
MassProperties point_properties(const std::vector<Eigen::Vector3d>& points) {
  MassProperties p;
  p.mass = 1.0;
  for (const Eigen::Vector3d& x : points) p.centre += x / static_cast<double>(points.size());
  for (const Eigen::Vector3d& x : points) {
    const Eigen::Vector3d d = x - p.centre;
    p.inertia +=
        (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose()) / static_cast<double>(points.size());
  }
  return p;
}

// In D. A box's edges are along the body's axes.
MassProperties shape_properties(const BodySpec& body, double density, std::vector<std::string>& notes) {
  const ShapeSpec& s = *body.shape;
  switch (s.kind) {
    case ShapeKind::kBox: {
      MassProperties p = box_properties(s.size, density);
      const Eigen::Matrix3d R = body.orientation.toRotationMatrix();
      p.inertia = R * p.inertia * R.transpose();
      p.centre = s.centre;
      return p;
    }
    case ShapeKind::kTube: return tube_properties(s.from, s.to, s.diameter, s.wall, density);
    case ShapeKind::kRod: return rod_properties(s.from, s.to, s.diameter, density);
    case ShapeKind::kDisc: return turned(disc_properties(s.radius, s.thickness, density), s.axis, s.centre);
    case ShapeKind::kDish: return turned(dish_properties(s, density), s.axis, s.centre);
    case ShapeKind::kSphere: return turned(sphere_properties(s.radius, density), Eigen::Vector3d::UnitZ(), s.centre);
    case ShapeKind::kCylinder: return turned(disc_properties(s.radius, s.length, density), s.axis, s.centre);
    case ShapeKind::kCapsule: return capsule_properties(s.from, s.to, s.diameter, density);
    case ShapeKind::kMesh: {
      const TriangleMesh mesh = mesh_of_shape(s);
      notes = mesh.notes;
      return polyhedron_properties(mesh, density, s.file);
    }
    case ShapeKind::kPoints: break;
  }
  return point_properties(s.points);
}

// Mass, mass centre and inertia of a model of another code, where the scene does not state them. False: refused.
bool resolve_by_model(BodySpec& body, Findings& findings) {
  const EntryFindings at(findings, body.source);
  const FlexibleSpec& spec = *body.flexible;
  MassProperties p;
  try {
    if (spec.file.empty()) {
      p = mass_properties(read_matrix_model(matrix_files(spec)));
    } else {
      const ReducedBody reduced = read_modal_body(spec.file, BasisOptions(), body.name);
      const Body model(body.name, std::make_shared<const ModalBody>(reduced.body));
      p = {model.mass(), reduced.p_DBo, model.rigid_inertia()};
    }
  } catch (const InputError& e) {
    findings.coded_error(body.source, "flexible", e.what());
    return false;
  }
  if (!at.given("mass")) body.mass = p.mass;
  if (!at.given("position")) body.position = p.centre;
  const Eigen::Matrix3d R = body.orientation.toRotationMatrix();
  if (!at.given("inertia")) body.inertia = R.transpose() * p.inertia * R;
  return true;
}

// The body's numbers; where the mass is not known yet, for mass 1. False: unknown, which is reported.
bool resolve_body(const Scene& scene, BodySpec& body, Findings& findings) {
  const EntryFindings at(findings, body.source);
  const bool mass_given = at.given("mass"), inertia_given = at.given("inertia");
  const bool of_model = body.flexible && (!body.flexible->file.empty() ||
                                          (!body.flexible->stiffness_matrix.empty() &&
                                           !body.flexible->mass_matrix.empty() && !body.flexible->node_file.empty()));
  if (!body.shape && of_model && !body.mass_is_remainder && !(mass_given && inertia_given && at.given("position")))
    return !findings.has_errors() && resolve_by_model(body, findings);
  if (!body.shape) {
    for (const char* key : {"mass", "inertia", "position"})
      at.missing_if(!at.given(key), key, "give it, or give a shape (with a material, or with the mass)");
    return body.source.good("mass") && inertia_given && at.given("position");
  }
  if (!check_shape(body, findings)) return false;
  if (mass_given && !body.mass_is_remainder && !(body.mass > 0.0)) return false;  // reported when it was read
  double density = 1.0;
  if (!mass_given) {
    const bool points = body.shape->kind == ShapeKind::kPoints;
    if (body.material.empty() || points) {
      at.error(
          kMissingKey, "mass",
          std::string("is missing; give it") + (points ? ": points have no volume" : ", or a material for the shape"));
      return false;
    }
    check_material_name(scene, body, at);
    const MaterialSpec* material = scene.material_or_null(body.material);
    density = material != nullptr ? material->density : 0.0;
    if (!(density > 0.0)) return false;  // unknown or refused
  }
  MassProperties p;
  try {
    std::vector<std::string> notes;
    p = shape_properties(body, density, notes);
    for (const std::string& note : notes) at.warning(kMeshFewDigits, "shape", note);
  } catch (const InputError& e) {
    findings.coded_error(body.source, "shape", e.what());
    return false;
  }
  if (mass_given && !body.mass_is_remainder) p = with_mass(p, body.mass);
  if (body.mass_is_remainder) p = with_mass(p, 1.0);
  body.mass = p.mass;
  if (!at.given("position")) body.position = p.centre;
  const Eigen::Matrix3d R = body.orientation.toRotationMatrix();
  if (!inertia_given) body.inertia = R.transpose() * p.inertia * R;
  return true;
}

void resolve_remainder(Scene& scene, Findings& findings) {
  BodySpec* rest = nullptr;
  double others = 0.0;
  for (BodySpec& body : scene.bodies) {
    if (!body.mass_is_remainder) {
      others += body.mass;
    } else if (rest) {
      findings.error(kTotalMass, body.source, "mass", "is the remainder, as for \"", rest->name,
                     "\"; only one body can have it");
    } else {
      rest = &body;
    }
  }
  if (!rest) {
    if (scene.total_mass && std::abs(others - *scene.total_mass) > 1e-6 * *scene.total_mass && !findings.has_errors())
      findings.error(kTotalMass, scene.source, "total_mass", "is ", *scene.total_mass, " kg, but the bodies weigh ",
                     others, " kg; remove it, or let one body have mass = \"remainder\"");
    return;
  }
  const EntryFindings at(findings, rest->source);
  const double mass = scene.total_mass.value_or(0.0) - others;
  if (!scene.total_mass) {
    at.error(kNeedsOtherKey, "mass", "is the remainder of total_mass, which is missing at the top of the scene");
  } else if (!(mass > 0.0)) {
    at.error(kTotalMass, "mass", "is the remainder, but the other bodies weigh ", others, " kg of the total_mass of ",
             *scene.total_mass, " kg");
  } else {
    rest->mass = mass;
    if (!rest->source.given("inertia")) rest->inertia *= mass;
  }
}

// A real body: symmetric positive definite, and no principal value above the sum of the other two.
void check_inertia(const BodySpec& body, Findings& findings) {
  const Eigen::Vector3d e = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia).eigenvalues();
  const EntryFindings at(findings, body.source);
  if (!(e[0] > 0.0)) {
    at.error(kInertia, "inertia", "is not positive definite (smallest principal value ", e[0],
             " kg m2), expected [Ixx, Iyy, Izz] > 0, in kg m2 about the mass centre");
  } else if (e[2] > (e[0] + e[1]) * (1.0 + 1e-9)) {
    at.error(kInertia, "inertia", "has a largest principal value of ", e[2],
             " kg m2, expected at most the sum of the other two, ", e[0] + e[1], " kg m2");
  }
}

// Mass, mass centre and inertia of every body: from numbers, or from shape and material; "remainder" last.
void resolve_masses(Scene& scene, Findings& findings) {
  bool known = true;
  for (BodySpec& body : scene.bodies) known = resolve_body(scene, body, findings) && known;
  if (!known) return;  // the masses are unknown, which is reported
  resolve_remainder(scene, findings);
  for (const BodySpec& body : scene.bodies) {
    if (body.mass > 0.0 && body.source.refused.count("inertia") == 0) check_inertia(body, findings);
  }
}

// Walks that copy an entry, turn it, and replace "{array}" in its texts.

constexpr int kMostCopies = 1000;

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// Calls action for every text of a member.
template <class Action>
void for_each_text(const FieldRef& ref, const Action& action) {
  if (std::string* text = member<std::string>(ref)) action(*text);
  if (auto* texts = member<std::vector<std::string>>(ref)) std::for_each(texts->begin(), texts->end(), action);
  if (auto* named = member<NamedTexts>(ref)) std::for_each(named->texts->begin(), named->texts->end(), action);
  if (auto* pair = member<std::array<std::string, 2>>(ref)) std::for_each(pair->begin(), pair->end(), action);
}

// Which copies of an array an entry asks for: "{leg}" all, "{leg=2}" one, "{leg!2!3}" all others (toml_file.h).
struct Copies {
  bool any = false;
  std::string mark;  // the second or third form; else empty
  bool makes(int k) const {
    if (mark.empty()) return any;
    const std::string body = mark.substr(mark.find_first_of("=!"));
    const bool named = body.find(concat(body.front(), k, "!")) != std::string::npos ||
                       body.find(concat(body.front(), k, "}")) != std::string::npos;
    return body.front() == '=' ? named : !named;
  }
};

template <class T>
Copies copies_of(T& entry, const std::string& array) {
  Copies out;
  FieldWalk walk([&](const std::string&, const FieldRef& ref, const Rule&, const FieldWalk&) {
    for_each_text(ref, [&](const std::string& text) {
      for (std::size_t at = text.find("{" + array); at != std::string::npos; at = text.find("{" + array, at + 1)) {
        const std::size_t end = at + 1 + array.size(), close = text.find('}', at);
        if (close == std::string::npos || (text[end] != '}' && text[end] != '=' && text[end] != '!')) continue;
        out.any = true;
        if (text[end] != '}') out.mark = text.substr(at, close - at + 1);
      }
    });
  });
  visit_fields(walk, entry);
  return out;
}

template <class T>
void make_copy(T& entry, const std::vector<std::string>& marks, int index, const Eigen::Quaterniond& turn) {
  const std::string number = std::to_string(index);
  const auto name_it = [&](std::string& text) {
    for (const std::string& mark : marks)
      if (!mark.empty()) replace_all(text, mark, number);
  };
  const auto turn_vector = [&](Eigen::Vector3d& v) { v = turn * v; };
  FieldWalk walk([&](const std::string&, const FieldRef& ref, const Rule& rule, const FieldWalk&) {
    for_each_text(ref, name_it);
    if (Source* source = member<Source>(ref)) name_it(source->path);
    if (auto* orientation = member<Eigen::Quaterniond>(ref)) *orientation = (turn * *orientation).normalized();
    if (rule.meaning != Meaning::kPoint && rule.meaning != Meaning::kDirection && rule.meaning != Meaning::kFree)
      return;
    if (auto* v = member<Eigen::Vector3d>(ref)) turn_vector(*v);
    if (auto* v = member<std::optional<Eigen::Vector3d>>(ref); v && *v) turn_vector(**v);
    if (auto* list = member<std::vector<Eigen::Vector3d>>(ref)) std::for_each(list->begin(), list->end(), turn_vector);
    if (auto* pair = member<std::array<Eigen::Vector3d, 2>>(ref))
      std::for_each(pair->begin(), pair->end(), turn_vector);
  });
  visit_fields(walk, entry);
}

// Copies that differ follow the entry of the others, and are put where they belong among them.
template <class T>
void copy_entries(std::vector<T>& entries, const ArraySpec& array) {
  const std::string mark = "{" + array.name + "}";
  std::vector<T> result;
  std::vector<int> numbers;  // of the last entry's copies, which end the result
  for (T& entry : entries) {
    const Copies copies = copies_of(entry, array.name);
    const bool joins = copies.mark.find('=') != std::string::npos;
    if (!joins) numbers.clear();
    if (!copies.any) result.push_back(entry);
    for (int k = 1; copies.any && k <= array.count; ++k) {
      if (!copies.makes(k)) continue;
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(array.start + (k - 1) * array.step, array.axis));
      const auto place = std::lower_bound(numbers.begin(), numbers.end(), k);
      const auto before = static_cast<std::ptrdiff_t>(numbers.end() - place);
      numbers.insert(place, k);
      make_copy(*result.insert(result.end() - before, entry), {mark, copies.mark}, k, turn);
    }
  }
  entries = std::move(result);
}

// Names in lists that were not copied with an entry: ["footpad_{leg}"] becomes ["footpad_1", "footpad_2", ...].
void expand_names(Scene& scene, const ArraySpec& array) {
  const std::string mark = "{" + array.name + "}";
  FieldWalk walk([&](const std::string&, const FieldRef& ref, const Rule&, const FieldWalk&) {
    auto* names = member<std::vector<std::string>>(ref);
    if (auto* named = member<NamedTexts>(ref); named && named->names->empty()) names = named->texts;
    if (!names) return;
    std::vector<std::string> result;
    for (const std::string& name : *names) {
      const bool copied = name.find(mark) != std::string::npos;
      if (!copied) result.push_back(name);
      for (int k = 1; copied && k <= array.count; ++k) replace_all(result.emplace_back(name), mark, std::to_string(k));
    }
    *names = result;
  });
  visit_fields(walk, scene);
}

// Braces that remain name no array.
void report_unknown_arrays(Scene& scene, const std::vector<std::string>& arrays, Findings& findings) {
  FieldWalk walk([&](const std::string& key, const FieldRef& ref, const Rule& rule, const FieldWalk& at) {
    if (rule.meaning != Meaning::kName) return;
    for_each_text(ref, [&](const std::string& text) {
      const std::size_t open = text.find('{');
      if (open == std::string::npos) return;
      const std::string name = text.substr(open + 1, text.find('}', open) - open - 1);
      findings.error(code::kUnknownArray, *at.source(), at.local(key), "\"", text, "\" names no array.",
                     known_names("arrays", name, arrays));
    });
  });
  visit_fields(walk, scene);
}

// Replaces every entry (body, joint, strut, spring, force, drive, gear, boundary, contact, initial velocity) in which
// "{leg}" occurs by `count` copies: "{leg}" becomes 1, 2, ...; points, directions and orientations turn about the array's
// axis through the origin of D. In lists of names elsewhere a name with "{leg}" becomes all of its names. Braces that name
// no array are findings.
void apply_arrays(Scene& scene, Findings& findings) {
  std::vector<std::string> names;
  for (const ArraySpec& array : scene.arrays) {
    names.push_back(array.name);
    if (array.count > kMostCopies) {
      findings.error(code::kTooManyCopies, array.source, "count", "is ", array.count, ", expected at most ",
                     kMostCopies);
      continue;
    }
    copy_entries(scene.bodies, array);
    copy_entries(scene.joints, array);
    copy_entries(scene.struts, array);
    copy_entries(scene.cables, array);
    copy_entries(scene.springs, array);
    copy_entries(scene.forces, array);
    copy_entries(scene.drives, array);
    copy_entries(scene.gears, array);
    copy_entries(scene.boundaries, array);
    copy_entries(scene.contacts, array);
    copy_entries(scene.initial.bodies, array);
    expand_names(scene, array);
  }
  report_unknown_arrays(scene, names, findings);
}

// flexible.segments = N: a tube or rod as N bodies in a row with fixed joints. Each bends little in its own frame, so that
// the frames describe what linear modes in one floating frame omit: stiffening by tension, and large bending. theory 1.4.

// In addition to the static shapes, which describe most of a short segment.
constexpr int kModesOfASegment = 2;

struct Cut {
  BodySpec whole;
  int count = 1;
  Eigen::Vector3d from, axis;  // axis: whole length [m]

  std::string name(int k) const { return concat(whole.name, "_", k + 1); }
  Eigen::Vector3d at(int k) const { return from + axis * k / count; }
  Eigen::Vector3d centre(int k) const { return from + axis * (k + 0.5) / count; }
  // The segment that a point of D belongs to; at a cut, the earlier one.
  int segment_at(const Eigen::Vector3d& point) const {
    const double share = (point - from).dot(axis) / axis.squaredNorm() * count;
    constexpr double kAtTheCut = 1e-9;
    return std::clamp(static_cast<int>(std::ceil(share - kAtTheCut)) - 1, 0, count - 1);
  }
};

bool may_be_cut(const BodySpec& body, Findings& findings) {
  const int before = findings.error_count();
  const FlexibleSpec& f = *body.flexible;
  const bool round = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod);
  const bool of_shape = f.file.empty() && f.mesh.empty() && f.nodes.empty() && f.stiffness_matrix.empty();
  if (!round || !of_shape)
    findings.error(
        kSegments, body.source, "flexible.segments",
        "divides a tube or rod along its axis, but this body has another elastic model; remove it, or define "
        "the bodies and joints one by one");
  for (const char* key : {"inertia", "position", "orientation"})
    if (body.source.given(key))
      findings.error(kSegments, body.source, key, "follows from the shape of each segment; remove it");
  if (body.mass_is_remainder)
    findings.error(kSegments, body.source, "mass",
                   "is the remainder, expected a number, or none, for a body in segments");
  return findings.error_count() == before;
}

std::vector<BodySpec> bodies_of(const Cut& cut) {
  std::vector<BodySpec> bodies;
  for (int k = 0; k < cut.count; ++k) {
    BodySpec body = cut.whole;
    body.name = cut.name(k);
    body.mass = cut.whole.mass / cut.count;
    body.shape->from = cut.at(k);
    body.shape->to = cut.at(k + 1);
    FlexibleSpec& f = *body.flexible;
    f.segments = 1;
    f.elements = std::max(2, (cut.whole.flexible->elements + cut.count - 1) / cut.count);
    if (!f.modes && !f.max_frequency) f.modes = kModesOfASegment;
    bodies.push_back(body);
  }
  return bodies;
}

void join(Scene& scene, const Cut& cut) {
  for (int k = 1; k < cut.count; ++k) {
    JointSpec joint;
    joint.source = cut.whole.source;
    joint.name = concat(cut.name(k - 1), "_", k + 1);
    joint.type = JointType::kFixed;
    joint.bodies = {cut.name(k - 1), cut.name(k)};
    joint.point_a = joint.point_b = cut.at(k);
    scene.joints.push_back(joint);
  }
}

// Joints, struts, springs and forces of the whole act on the segment at their point.
void attach(Scene& scene, const Cut& cut, Findings& findings) {
  const auto pick = [&](std::string& name, const Eigen::Vector3d& point) {
    if (name == cut.whole.name) name = cut.name(cut.segment_at(point));
  };
  for (JointSpec& joint : scene.joints) {
    pick(joint.bodies[0], joint.point_a);
    pick(joint.bodies[1], joint.point_b);
  }
  for (StrutSpec& strut : scene.struts)
    for (std::size_t end = 0; end < 2; ++end) pick(strut.bodies[end], strut.points[end]);
  for (CableSpec& cable : scene.cables)
    for (CableGuideSpec& guide : cable.path) pick(guide.body, guide.point);
  for (SpringSpec& spring : scene.springs) {
    const bool acts = spring.bodies[0] == cut.whole.name || spring.bodies[1] == cut.whole.name;
    if (acts && !spring.source.given("point"))
      findings.error(kPointOfAction, spring.source, "point", "is missing; \"", cut.whole.name,
                     "\" is in segments, of which one is turned");
    for (std::string& name : spring.bodies) pick(name, spring.point);
  }
  for (ForceSpec& force : scene.forces) {
    if (force.body == cut.whole.name && !force.point)
      findings.error(kPointOfAction, force.source, "point", "is missing; \"", cut.whole.name,
                     "\" is in segments, of which one is pushed");
    else
      pick(force.body, force.point.value_or(Eigen::Vector3d::Zero()));
  }
}

void replace_name(std::vector<std::string>& names, const Cut& cut) {
  const auto found = std::find(names.begin(), names.end(), cut.whole.name);
  if (found == names.end()) return;
  std::vector<std::string> segments;
  for (int k = 0; k < cut.count; ++k) segments.push_back(cut.name(k));
  names.insert(names.erase(found), segments.begin(), segments.end());
}

// Every entry of the whole becomes one of each segment; change(entry, k) adapts it.
template <class Entry, class Change>
void repeat(std::vector<Entry>& entries, const Cut& cut, const Change& change) {
  std::vector<Entry> result;
  for (const Entry& entry : entries) {
    if (entry.body != cut.whole.name) {
      result.push_back(entry);
      continue;
    }
    for (int k = 0; k < cut.count; ++k) {
      result.push_back(entry);
      result.back().body = cut.name(k);
      change(result.back(), k);
    }
  }
  entries = std::move(result);
}

void cut_boundaries(Scene& scene, const Cut& cut, Findings& findings) {
  for (const BoundarySpec& boundary : scene.boundaries) {
    if (boundary.body != cut.whole.name) continue;
    if (boundary.surface && !boundary.surface->file.empty())
      findings.error(kSegments, boundary.source, "surface.file", "is one surface, but \"", cut.whole.name,
                     "\" is in segments; use beams, or give each segment (", cut.name(0), ", ...) a surface");
    if (boundary.beams && !boundary.beams->points.empty())
      findings.error(kSegments, boundary.source, "beams.points", "are one chain, but \"", cut.whole.name,
                     "\" is in segments; remove them: beams follow the axis");
  }
  repeat(scene.boundaries, cut, [&](BoundarySpec& boundary, int) {
    if (boundary.beams) boundary.beams->segments = (boundary.beams->segments + cut.count - 1) / cut.count;
  });
  if (scene.ground.plane) replace_name(scene.ground.plane->bodies, cut);
  if (scene.ground.law) replace_name(scene.ground.law->bodies, cut);
}

void cut_initial_velocities(Scene& scene, const Cut& cut) {
  const InitialSpec& initial = scene.initial;
  const Eigen::Matrix3d R_WD = rotation_from_rpy(initial.roll, initial.pitch, initial.yaw);
  const Eigen::Vector3d middle = cut.from + 0.5 * cut.axis;
  repeat(scene.initial.bodies, cut, [&](BodyVelocitySpec& start, int k) {
    if (start.velocity && start.angular_velocity)
      *start.velocity += start.angular_velocity->cross(R_WD * (cut.centre(k) - middle));
  });
}

// A body with flexible.segments = N becomes N bodies "NAME_1" ... "NAME_N" with fixed joints between them; joints, struts,
// springs and forces on it act on the segment at their point.
void resolve_segments(Scene& scene, Findings& findings) {
  std::vector<BodySpec> bodies;
  for (const BodySpec& body : scene.bodies) {
    const bool whole = !body.flexible || body.flexible->segments == 1;
    if (whole || !may_be_cut(body, findings)) {
      bodies.push_back(body);
      continue;
    }
    const Cut cut{body, body.flexible->segments, body.shape->from, body.shape->to - body.shape->from};
    for (BodySpec& segment : bodies_of(cut)) bodies.push_back(std::move(segment));
    attach(scene, cut, findings);
    join(scene, cut);
    cut_boundaries(scene, cut, findings);
    cut_initial_velocities(scene, cut);
    replace_name(scene.output.bodies, cut);
    for (const ControllerSpec& controller : scene.controllers)
      if (controller.body == body.name)
        findings.error(kUnknownBody, controller.source, "body", "\"", body.name,
                       "\" is in segments; name one of them, such as \"", cut.name(0), "\"");
  }
  scene.bodies = std::move(bodies);
}

// The coordinates that types of joints leave free, and the members of specs that belong to them.

template <class T, class Owner>
const std::optional<T>& one_of(const Owner& owner, Coordinate coordinate) {
  static const std::optional<T> nothing;
  switch (coordinate) {
    case Coordinate::kAngle: return owner.angle;
    case Coordinate::kDisplacement: return owner.displacement;
    case Coordinate::kDisplacementX: return owner.displacement_x;
    case Coordinate::kDisplacementY: return owner.displacement_y;
  }
  return nothing;
}

}  // namespace

double total_mass(const Scene& scene) {
  double sum = 0.0;
  for (const BodySpec& body : scene.bodies) sum += body.mass;
  return sum;
}

bool stands_still(const Scene& scene, const std::string& body) {
  if (!scene.initial.groups || body == "ground") return false;
  const InitialGroupsSpec& groups = *scene.initial.groups;
  const bool chosen = !groups.still.empty();  // the other group is given otherwise
  const std::vector<std::string>& names = chosen ? groups.still : groups.moving;
  return (std::find(names.begin(), names.end(), body) != names.end()) == chosen;
}

Eigen::Vector3d mass_centre(const Scene& scene) {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double mass = 0.0;
  for (const BodySpec& body : scene.bodies) {
    if (stands_still(scene, body.name)) continue;
    moment += body.mass * body.position;
    mass += body.mass;
  }
  return mass > 0.0 ? Eigen::Vector3d(moment / mass) : Eigen::Vector3d::Zero();
}

void resolve_scene(Scene& scene, Findings& findings) {
  apply_arrays(scene, findings);
  resolve_paths(scene, findings);
  resolve_joint_points(scene, findings);
  resolve_segments(scene, findings);
  resolve_script_meshes(scene, findings);
  resolve_masses(scene, findings);
  if (scene.particles && scene.particles->box) resolve_grain_sizes(scene, findings);
  resolve_terrain(scene, findings);
  resolve_box(scene, findings);
  scene.solver.atol = scene.solver.atol_position();
  if (!scene.flexible) {
    for (BodySpec& body : scene.bodies) {
      if (body.flexible) body.flexible->enabled = false;
    }
  }
}

std::vector<Coordinate> coordinates_of(JointType type) {
  const JointTraits traits = traits_of(type);
  std::vector<Coordinate> out;
  if (traits.turns) out.push_back(Coordinate::kAngle);
  if (traits.slides) out.push_back(Coordinate::kDisplacement);
  if (traits.slides_across) {
    out.push_back(Coordinate::kDisplacementX);
    out.push_back(Coordinate::kDisplacementY);
  }
  return out;
}

bool has_coordinate(JointType type, Coordinate coordinate) {
  const std::vector<Coordinate> has = coordinates_of(type);
  return std::find(has.begin(), has.end(), coordinate) != has.end();
}

std::string coordinate_names(JointType type) {
  std::vector<std::string> names;
  for (const Coordinate coordinate : coordinates_of(type)) names.push_back(concat("\"", name_of(coordinate), "\""));
  if (names.size() < 2) return joined(names);
  const std::string last = names.back();
  names.pop_back();
  return joined(names) + " or " + last;
}

const std::optional<CoordinateSpec>& JointSpec::acting_on(Coordinate coordinate) const {
  return one_of<CoordinateSpec>(*this, coordinate);
}

const std::optional<double>& InitialJointSpec::value(Coordinate coordinate) const {
  return one_of<double>(*this, coordinate);
}

}  // namespace footfall
