// MJCF, by the compiled model of MuJoCo: its defaults, classes, compiler flags and inertias of geoms are applied
// there. The reference configuration is qpos0, with free joints where the first keyframe has them, or this keyframe
// if draw() selects it. Equations: mujoco.readthedocs.io, Computation.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <set>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/import/codes.h"
#include "mbd_solver/import/mjcf_source.h"
#include "mbd_solver/scene/mesh_reader.h"

namespace footfall {
namespace {

using Model = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using Data = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

constexpr int kCamPoints = 33;        // of a gear whose ratio changes
constexpr double kHolds = 1e-6;       // parts of a loop that are so near are together [m or rad]
constexpr double kHoldsInKey = 1e-4;  // in a keyframe, whose numbers have few digits

Eigen::Vector3d vector(const mjtNum* v) { return {v[0], v[1], v[2]}; }
Eigen::Matrix3d rotation(const mjtNum* q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

[[noreturn]] void refuse(const char* message) {
  throw InputError(code::kRobotRefused, std::string("MuJoCo: ") + message);
}
void overhear(const char*) {}

// Compiles the text; parts that only later versions know are removed and listed.
Model compiled(MjcfSource& source) {
  mju_user_error = refuse;
  mju_user_warning = overhear;
  while (true) {
    const std::string text = source.text();
    const auto vfs = std::make_unique<mjVFS>();
    mj_defaultVFS(vfs.get());
    mj_makeEmptyFileVFS(vfs.get(), "robot.xml", static_cast<int>(text.size()));
    std::memcpy(vfs->filedata[0], text.data(), text.size());
    char error[1000] = "";
    Model model(nullptr, mj_deleteModel);
    try {
      model.reset(mj_loadXML("robot.xml", vfs.get(), error, sizeof error));
    } catch (const InputError& e) {
      std::snprintf(error, sizeof error, "%s", e.what());
    }
    mj_deleteVFS(vfs.get());
    if (model) return model;
    source.take_out(error);
  }
}

class MjcfRobot {
 public:
  MjcfRobot(const MjcfSource& source, const mjModel& m, const ImportOptions& options, Robot& robot)
      : source_(source),
        m_(m),
        options_(options),
        d_(mj_makeData(&m), mj_deleteData),
        robot_(robot),
        bodies_(source.bodies()) {
    if (static_cast<int>(bodies_.size()) != m.nbody) bodies_.assign(m.nbody, source.root());
    joints_of_.assign(m.njnt, {-1, ""});
  }

  void read() {
    const std::string title = source_.root().attribute("model").value();
    robot_.name = title.empty() ? "MuJoCo model" : title;
    robot_.gravity = (m_.opt.disableflags & mjDSBL_GRAVITY) != 0 ? Eigen::Vector3d(0, 0, 0) : vector(m_.opt.gravity);
    if (m_.opt.density != 0.0 || m_.opt.viscosity != 0.0 || vector(m_.opt.wind).norm() > 0.0)
      leave_out(source_.root().child("option"), "a scene has no medium: density, viscosity and wind are zero");
    draw();
    for (int b = 1; b < m_.nbody; ++b) add_body(b);
    add_world();
    add_equalities();
    add_actuators();
    add_contact_pairs();
    for (const pugi::xml_node& tendon : source_.children_of("tendon"))
      leave_out(tendon, "a scene has no tendons; a strut between two points, or a gear, may replace it");
    add_velocities();
  }

 private:
  void leave_out(const pugi::xml_node& node, const std::string& why, bool looks = false) {
    robot_.leave_out(source_.origin(node), title_of(node), why, looks);
  }

  std::string name_of(int object, int id, const char* otherwise) const {
    const char* name = mj_id2name(&m_, object, id);
    return name != nullptr && *name != 0 ? name : otherwise + std::to_string(id);
  }

  // The k-th child of this kind of the body's element; the element itself where the file has another number of them.
  pugi::xml_node child_of(int body, std::initializer_list<const char*> kinds, int k, int count) const {
    std::vector<pugi::xml_node> found;
    for (const pugi::xml_node& child : bodies_[body].children())
      for (const char* kind : kinds)
        if (std::string(child.name()) == kind) found.push_back(child);
    return static_cast<int>(found.size()) == count ? found[k] : bodies_[body];
  }
  pugi::xml_node joint_node(int j) const {
    const int body = m_.jnt_bodyid[j];
    return child_of(body, {"joint", "freejoint"}, j - m_.body_jntadr[body], m_.body_jntnum[body]);
  }
  pugi::xml_node geom_node(int g) const {
    const int body = m_.geom_bodyid[g];
    return child_of(body, {"geom"}, g - m_.body_geomadr[body], m_.body_geomnum[body]);
  }

  void place(mjData& d, const mjtNum* qpos) const {
    mju_copy(d.qpos, qpos, m_.nq);
    mj_normalizeQuat(&m_, d.qpos);
    mj_kinematics(&m_, &d);
  }

  bool has(mjtJoint type) const {
    return std::find(m_.jnt_type, m_.jnt_type + m_.njnt, static_cast<int>(type)) != m_.jnt_type + m_.njnt;
  }

  // The first keyframe is the reference configuration if [initial.joints] could not reach it, because all else follows by the
  // smallest motion: with ball joints, loops, couplings across several coordinates, or free bodies next to bodies that the world
  // holds. Likewise if bodies move, with velocities of the reference configuration, and for robots put on a ground below them.
  void draw() {
    robot_.drawn = "qpos0";
    place(*d_, m_.qpos0);
    if (m_.nkey == 0) return;
    const Data key(mj_makeData(&m_), mj_deleteData);
    place(*key, m_.key_qpos);
    moves_ = std::any_of(m_.key_qvel, m_.key_qvel + m_.nv, [](mjtNum v) { return v != 0.0; });
    const auto trees = std::count(m_.body_parentid + 1, m_.body_parentid + m_.nbody, 0);
    const bool tied = std::find(m_.eq_active, m_.eq_active + m_.neq, mjtByte{1}) != m_.eq_active + m_.neq;
    starts_ = !tied || holds(*key, kHoldsInKey) || !holds(*d_, kHolds);
    if (!starts_)
      leave_out(source_.children_of("keyframe").front(),
                "loops or couplings do not hold there: only its free bodies are where it has them");
    bool turned = false;  // [initial.joints] turns by half a turn at most
    for (int j = 0; j < m_.njnt; ++j)
      turned = turned || (m_.jnt_type[j] == mjJNT_HINGE && std::abs(moved(*key, j)) > kPi);
    const bool put = !options_.ground.empty();
    if (starts_ && (tied || moves_ || put || turned || has(mjJNT_BALL) || (has(mjJNT_FREE) && trees > 1))) {
      robot_.drawn = "the first keyframe";
      place(*d_, m_.key_qpos);
      return;
    }
    std::vector<mjtNum> qpos(m_.qpos0, m_.qpos0 + m_.nq);
    for (int j = 0; j < m_.njnt; ++j)
      if (m_.jnt_type[j] == mjJNT_FREE) std::copy_n(m_.key_qpos + m_.jnt_qposadr[j], 7, &qpos[m_.jnt_qposadr[j]]);
    place(*d_, qpos.data());
  }

  // Distance or angle between the parts that an equality holds together.
  double gap_of(const mjData& d, int e) const {
    const mjtNum* data = m_.eq_data + mjNEQDATA * e;
    const int a = m_.eq_obj1id[e], b = m_.eq_obj2id[e];
    if (m_.eq_type[e] == mjEQ_JOINT) return b < 0 ? 0.0 : std::abs(moved(d, a) - coupled(data, moved(d, b)));
    if (m_.eq_type[e] != mjEQ_CONNECT && m_.eq_type[e] != mjEQ_WELD) return 0.0;
    const RigidFrame X_a = placed(d, a), X_b = placed(d, b);
    // connect: the anchor in body 1, then in body 2. weld: in body 2, then in body 1, then the rotation of 2 in 1.
    if (m_.eq_type[e] == mjEQ_CONNECT) return (X_a * vector(data) - X_b * vector(data + 3)).norm();
    return std::max((X_b * vector(data) - X_a * vector(data + 3)).norm(),
                    (X_a.R.transpose() * X_b.R - rotation(data + 6)).norm());
  }
  bool holds(const mjData& d, double tolerance) const {
    for (int e = 0; e < m_.neq; ++e)
      if (m_.eq_active[e] != 0 && gap_of(d, e) > tolerance) return false;
    return true;
  }
  bool drawn_at_key() const { return robot_.drawn != "qpos0"; }

  // Coordinate of a joint since qpos0, and of a joint coupled to it.
  double moved(const mjData& d, int j) const { return d.qpos[m_.jnt_qposadr[j]] - m_.qpos0[m_.jnt_qposadr[j]]; }
  static double coupled(const mjtNum* a, double q) { return a[0] + q * (a[1] + q * (a[2] + q * (a[3] + q * a[4]))); }

  static RigidFrame placed(const mjData& d, int body) {
    return {vector(d.xpos + 3 * body), rotation(d.xquat + 4 * body)};
  }
  RigidFrame placed(int body) const { return placed(*d_, body); }

  // Link of a body: bodies count from 1, the world is the ground.
  int link_of(int body) const { return body == 0 ? -1 : links_.at(body); }

  void add_body(int b) {
    RobotLink link;
    link.origin = source_.origin(bodies_[b]);
    link.name = name_of(mjOBJ_BODY, b, "body");
    link.mass = m_.body_mass[b];
    link.centre = vector(m_.body_ipos + 3 * b);
    const Eigen::Matrix3d R = rotation(m_.body_iquat + 4 * b);
    link.inertia = R * vector(m_.body_inertia + 3 * b).asDiagonal() * R.transpose();
    link.X_DL = placed(b);
    for (int g = m_.body_geomadr[b]; g < m_.body_geomadr[b] + m_.body_geomnum[b]; ++g) add_geom(link, g);
    if (m_.body_mocapid[b] >= 0)
      leave_out(bodies_[b], "is moved by another program (mocap): it is fixed where it is drawn");
    std::vector<int> joints;
    for (int j = m_.body_jntadr[b]; j >= 0 && j < m_.body_jntadr[b] + m_.body_jntnum[b]; ++j) joints.push_back(j);
    const int parent = link_of(m_.body_parentid[b]);
    if (joints.size() > 1 && !add_common_joint(joints, parent, link))
      add_chain(joints, parent, link);
    else if (joints.size() <= 1) {
      links_[b] = add_link(link);
      if (joints.empty()) {
        RobotJoint weld;
        weld.origin = link.origin;
        weld.name = link.name + "_weld";
        weld.parent = parent;
        weld.child = links_[b];
        weld.point = link.X_DL.p;
        robot_.joints.push_back(weld);
      } else {
        add_joint(joints[0], parent, links_[b]);
      }
    } else {
      return;
    }
  }

  int add_link(const RobotLink& link) {
    robot_.links.push_back(link);
    return static_cast<int>(robot_.links.size()) - 1;
  }

  RobotCoordinate coordinate(int j, const char* name) {
    const int q = m_.jnt_qposadr[j], v = m_.jnt_dofadr[j];
    RobotCoordinate c;
    c.name = name;
    c.zero = d_->qpos[q];
    if (m_.jnt_limited[j] != 0) {
      c.lower = m_.jnt_range[2 * j];
      c.upper = m_.jnt_range[2 * j + 1];
    }
    c.damping = m_.dof_damping[v];
    c.friction = m_.dof_frictionloss[v];
    c.armature = m_.dof_armature[v];
    c.stiffness = m_.jnt_stiffness[j];
    c.rest = m_.qpos_spring[q];
    if (m_.nkey > 0 && starts_) c.start = m_.key_qpos[q];
    return c;
  }

  RobotJoint joint_base(int j, int parent, int child) {
    RobotJoint joint;
    joint.origin = source_.origin(joint_node(j));
    joint.name = name_of(mjOBJ_JOINT, j, "joint");
    joint.parent = parent;
    joint.child = child;
    joint.point = vector(d_->xanchor + 3 * j);
    joint.axis = vector(d_->xaxis + 3 * j).normalized();
    return joint;
  }

  // Properties of a joint of several degrees of freedom that a scene cannot represent.
  void list_lost(int j, int degrees, const char* kind) {
    const int v = m_.jnt_dofadr[j];
    std::vector<std::string> lost;
    double damping = 0.0, friction = 0.0, armature = 0.0;
    for (int k = v; k < v + degrees; ++k) {
      damping += m_.dof_damping[k];
      friction += m_.dof_frictionloss[k];
      armature += m_.dof_armature[k];
    }
    if (damping > 0.0) lost.emplace_back("damping");
    if (friction > 0.0) lost.emplace_back("frictionloss");
    if (armature > 0.0) lost.emplace_back("armature");
    if (m_.jnt_stiffness[j] > 0.0) lost.emplace_back("stiffness");
    if (m_.jnt_limited[j] != 0) lost.emplace_back("range");
    if (!lost.empty()) leave_out(joint_node(j), concat("has as a ", kind, " joint no ", joined(lost), " in a scene"));
  }

  void add_joint(int j, int parent, int child) {
    if (m_.jnt_type[j] == mjJNT_FREE) {
      list_lost(j, 6, "free");
      free_joints_.push_back(j);
      robot_.links[child].remark = "moves freely";
      return;
    }
    RobotJoint joint = joint_base(j, parent, child);
    if (m_.jnt_type[j] == mjJNT_BALL) {
      joint.kind = RobotJointKind::kSpherical;
      list_lost(j, 3, "ball");
    } else {
      const bool slides = m_.jnt_type[j] == mjJNT_SLIDE;
      joint.kind = slides ? RobotJointKind::kPrismatic : RobotJointKind::kRevolute;
      joint.coordinates.push_back(coordinate(j, slides ? "displacement" : "angle"));
      joints_of_[j] = {static_cast<int>(robot_.joints.size()), joint.coordinates[0].name};
    }
    robot_.joints.push_back(joint);
  }

  // Several joints of a body that are one joint of a scene: a slide and a hinge along one line; two slides and a hinge normal to
  // both.
  bool add_common_joint(const std::vector<int>& joints, int parent, const RobotLink& link) {
    std::vector<int> slides, hinges;
    for (const int j : joints) (m_.jnt_type[j] == mjJNT_SLIDE ? slides : hinges).push_back(j);
    if (hinges.size() != 1 || m_.jnt_type[hinges[0]] != mjJNT_HINGE) return false;
    const int hinge = hinges[0];
    RobotJoint joint = joint_base(hinge, parent, -1);
    const auto axis = [&](int j) { return Eigen::Vector3d(vector(d_->xaxis + 3 * j).normalized()); };
    std::vector<std::pair<int, const char*>> coordinates{{hinge, "angle"}};
    if (slides.size() == 1 && axis(slides[0]).dot(joint.axis) > 1.0 - 1e-12) {
      joint.kind = RobotJointKind::kCylindrical;
      coordinates.emplace_back(slides[0], "displacement");
    } else if (slides.size() == 2 && joints.back() == hinge &&
               (axis(slides[0]).cross(axis(slides[1])) - joint.axis).norm() < 1e-9) {
      joint.kind = RobotJointKind::kPlanar;
      joint.axis2 = axis(slides[0]);
      coordinates.emplace_back(slides[0], "displacement_x");
      coordinates.emplace_back(slides[1], "displacement_y");
    } else if (slides.size() == 2 && joints.back() == hinge &&
               (axis(slides[0]).cross(axis(slides[1])) + joint.axis).norm() < 1e-9) {
      joint.kind = RobotJointKind::kPlanar;  // y is the first one: z cross x is then the second's
      joint.axis2 = axis(slides[1]);
      coordinates.emplace_back(slides[1], "displacement_x");
      coordinates.emplace_back(slides[0], "displacement_y");
    } else {
      return false;
    }
    links_[body_of(hinge)] = joint.child = add_link(link);
    for (const auto& [j, name] : coordinates) {
      joint.coordinates.push_back(coordinate(j, name));
      joints_of_[j] = {static_cast<int>(robot_.joints.size()), name};
      if (j != hinge) joint.remark += (joint.remark.empty() ? "with " : ", ") + name_of(mjOBJ_JOINT, j, "joint");
    }
    robot_.joints.push_back(joint);
    return true;
  }

  int body_of(int j) const { return m_.jnt_bodyid[j]; }

  // One joint after the other, with links without mass between them.
  void add_chain(const std::vector<int>& joints, int parent, const RobotLink& link) {
    for (std::size_t k = 0; k < joints.size(); ++k) {
      int child = -1;
      if (k + 1 == joints.size()) {
        links_[body_of(joints[k])] = child = add_link(link);
      } else {
        RobotLink between;
        between.origin = source_.origin(joint_node(joints[k]));
        between.name = link.name + "_after_" + name_of(mjOBJ_JOINT, joints[k], "joint");
        between.X_DL = link.X_DL;
        child = add_link(between);
        between_.push_back({child, {joints.begin() + k + 1, joints.end()}});
      }
      add_joint(joints[k], parent, child);
      parent = child;
    }
  }

  // --- Geometry.

  static TriangleMesh ellipsoid(const Eigen::Vector3d& half) {
    TriangleMesh mesh = sphere_mesh(1.0, 0.5);
    for (Eigen::Vector3d& x : mesh.vertices) x = x.cwiseProduct(half);
    return mesh;
  }

  // The convex hull with which MuJoCo collides, where it has made one, otherwise the mesh itself.
  TriangleMesh mesh_of(int id, bool hull) const {
    TriangleMesh mesh;
    const float* v = m_.mesh_vert + 3 * m_.mesh_vertadr[id];
    for (int k = 0; k < m_.mesh_vertnum[id]; ++k) mesh.vertices.emplace_back(v[3 * k], v[3 * k + 1], v[3 * k + 2]);
    if (hull && m_.mesh_graphadr[id] >= 0) {
      const int* graph = m_.mesh_graph + m_.mesh_graphadr[id];
      const int vertices = graph[0], faces = graph[1];
      const int* face = graph + 2 + 3 * vertices + 3 * faces;  // 2, vert_edgeadr, vert_globalid, edge_localid
      for (int k = 0; k < faces; ++k) mesh.triangles.emplace_back(face[3 * k], face[3 * k + 1], face[3 * k + 2]);
    } else {
      const int* face = m_.mesh_face + 3 * m_.mesh_faceadr[id];
      for (int k = 0; k < m_.mesh_facenum[id]; ++k)
        mesh.triangles.emplace_back(face[3 * k], face[3 * k + 1], face[3 * k + 2]);
    }
    return mesh;
  }

  void add_geom(RobotLink& link, int g) {
    RobotGeometry made;
    made.origin = source_.origin(geom_node(g));
    made.name = name_of(mjOBJ_GEOM, g, "geom");
    made.X_LG = {vector(m_.geom_pos + 3 * g), rotation(m_.geom_quat + 4 * g)};
    const Eigen::Vector3d size = vector(m_.geom_size + 3 * g);
    const bool collides = m_.geom_contype[g] != 0 || m_.geom_conaffinity[g] != 0;
    switch (m_.geom_type[g]) {
      case mjGEOM_SPHERE:
        made.kind = GeometryKind::kSphere;
        made.radius = size[0];
        break;
      case mjGEOM_CAPSULE:
      case mjGEOM_CYLINDER:
        made.kind = m_.geom_type[g] == mjGEOM_CAPSULE ? GeometryKind::kCapsule : GeometryKind::kCylinder;
        made.radius = size[0];
        made.length = 2.0 * size[1];
        break;
      case mjGEOM_BOX:
        made.kind = GeometryKind::kBox;
        made.size = 2.0 * size;
        break;
      case mjGEOM_ELLIPSOID:
        made.kind = GeometryKind::kMesh;
        made.mesh = ellipsoid(size);
        break;
      case mjGEOM_MESH:
        made.kind = GeometryKind::kMesh;
        made.mesh = mesh_of(m_.geom_dataid[g], collides);
        break;
      default:
        leave_out(geom_node(g), "moves with a body; a scene has planes and height fields on the ground only");
        return;
    }
    if (collides) {
      link.friction = std::max(link.friction.value_or(0.0), m_.geom_friction[3 * g]);
      colliding_[m_.geom_bodyid[g]].push_back(g);
    }
    (collides ? link.collisions : link.visuals).push_back(made);
  }

  void add_world() {
    for (int g = 0; g < m_.ngeom; ++g) {
      if (m_.geom_bodyid[g] != 0) continue;
      const bool collides = m_.geom_contype[g] != 0 || m_.geom_conaffinity[g] != 0;
      const Eigen::Matrix3d R = rotation(m_.geom_quat + 4 * g);
      const bool level = m_.geom_type[g] == mjGEOM_PLANE && std::abs(R(2, 2)) > 1.0 - 1e-12;
      const int field = m_.geom_type[g] == mjGEOM_HFIELD ? m_.geom_dataid[g] : -1;
      if (field >= 0 && collides && !robot_.map && R.isIdentity(1e-12) && m_.hfield_nrow[field] > 1 &&
          m_.hfield_ncol[field] > 1) {
        add_map(g);
      } else if (level && collides && !robot_.plane) {
        robot_.plane = true;
        robot_.plane_height = m_.geom_pos[3 * g + 2];
        if (!robot_.map) robot_.plane_friction = m_.geom_friction[3 * g];
      } else {
        leave_out(geom_node(g),
                  "is fixed in the world; the ground of a scene is one level plane, one map of heights along x "
                  "and y, or grains",
                  !collides);
      }
    }
    if (robot_.map && !options_.ground.empty())
      leave_out(source_.root(), "the height field is not taken: --ground was given");
    else if (robot_.map && robot_.plane)
      leave_out(source_.root(), "the plane is not taken: the ground of the scene is the height field");
  }

  // Row k of the heights is the k-th along y; they are shares of the third size.
  void add_map(int g) {
    const int id = m_.geom_dataid[g], rows = m_.hfield_nrow[id], columns = m_.hfield_ncol[id];
    const mjtNum* size = m_.hfield_size + 4 * id;
    const Eigen::Vector3d p = vector(m_.geom_pos + 3 * g);
    RobotMap map;
    map.origin = source_.origin(geom_node(g));
    map.label = "height field \"" + name_of(mjOBJ_HFIELD, id, "hfield") + "\"";
    map.x = Eigen::VectorXd::LinSpaced(columns, p[0] - size[0], p[0] + size[0]);
    map.y = Eigen::VectorXd::LinSpaced(rows, p[1] - size[1], p[1] + size[1]);
    map.heights.resize(rows, columns);
    const Eigen::MatrixXd given = source_.elevation(name_of(mjOBJ_HFIELD, id, ""));
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c)
        map.heights(r, c) =
            p[2] + size[2] * (given.size() > 0 ? given(r, c) : m_.hfield_data[m_.hfield_adr[id] + r * columns + c]);
    robot_.map = std::move(map);
    robot_.plane_friction = m_.geom_friction[3 * g];
  }

  void add_contact_pairs() {
    robot_.touches_itself = true;
    std::set<int> excluded(m_.exclude_signature, m_.exclude_signature + m_.nexclude);
    struct Masks {
      int body, types, affinities;
    };
    std::vector<Masks> masks;  // of all shapes of a body together: one common bit suffices
    for (const auto& [body, shapes] : colliding_) {
      masks.push_back({body, 0, 0});
      for (const int g : shapes) {
        masks.back().types |= m_.geom_contype[g];
        masks.back().affinities |= m_.geom_conaffinity[g];
      }
    }
    for (const Masks& a : masks)
      for (const Masks& b : masks) {
        if (b.body <= a.body) continue;
        const bool touch = (a.types & b.affinities) != 0 || (b.types & a.affinities) != 0;
        const bool out = !excluded.empty() && excluded.count(((a.body + 1) << 16) + b.body + 1) > 0;
        if (!touch || out || m_.body_weldid[a.body] == m_.body_weldid[b.body])
          robot_.apart.emplace_back(link_of(a.body), link_of(b.body));
      }
    for (const pugi::xml_node& node : source_.children_of("contact"))
      if (std::string(node.name()) == "pair") leave_out(node, "give the scene an entry of [[contacts]] with its law");
    if (colliding_.size() > 1 && robot_.apart.size() < colliding_.size() * (colliding_.size() - 1) / 2)
      robot_.leave_out(source_.origin(source_.root()), "contact laws between links of the robot",
                       "a run ends when they meet; give those that may meet an entry of [[contacts]]");
  }

  // --- Loops, couplings, motors.

  void add_equalities() {
    const std::vector<pugi::xml_node> nodes = source_.children_of("equality");
    for (int e = 0; e < m_.neq; ++e) {
      const pugi::xml_node node = static_cast<int>(nodes.size()) == m_.neq ? nodes[e] : source_.root();
      const mjtNum* data = m_.eq_data + mjNEQDATA * e;
      if (m_.eq_active[e] == 0) {
        leave_out(node, "is not active");
        continue;
      }
      RobotJoint loop;
      loop.origin = source_.origin(node);
      loop.name = name_of(mjOBJ_EQUALITY, e, "loop");
      loop.loop = true;
      if (m_.eq_type[e] == mjEQ_CONNECT || m_.eq_type[e] == mjEQ_WELD) {
        const int a = m_.eq_obj1id[e], b = m_.eq_obj2id[e];
        const bool connect = m_.eq_type[e] == mjEQ_CONNECT;
        loop.kind = connect ? RobotJointKind::kSpherical : RobotJointKind::kFixed;
        loop.parent = link_of(a);
        loop.child = link_of(b);
        loop.point = placed(connect ? a : b) * vector(data);
        const double gap = gap_of(*d_, e);
        if (gap > (drawn_at_key() ? kHoldsInKey : kHolds)) {
          leave_out(node, "does not hold where the robot is drawn (its parts are " + number_text(gap, 3) +
                              " m or rad apart): it is left out");
          continue;
        }
        robot_.joints.push_back(loop);
        continue;
      }
      if (m_.eq_type[e] != mjEQ_JOINT) {
        leave_out(node, "a scene couples joints, not tendons");
        continue;
      }
      add_coupling(node, e, loop.name);
    }
  }

  // q1 = a0 + a1 q2 + a2 q2^2 + ..., both counted from qpos0.
  void add_coupling(const pugi::xml_node& node, int e, const std::string& name) {
    const int j1 = m_.eq_obj1id[e], j2 = m_.eq_obj2id[e];
    const mjtNum* a = m_.eq_data + mjNEQDATA * e;
    const auto [first, coordinate1] = joints_of_[j1];
    if (first < 0 || (j2 >= 0 && joints_of_[j2].first < 0) || a[0] != 0.0 || j2 < 0) {
      leave_out(node, "a scene couples two coordinates that are zero together");
      return;
    }
    const auto [second, coordinate2] = joints_of_[j2];
    if (gap_of(*d_, e) > (drawn_at_key() ? kHoldsInKey : kHolds)) {
      leave_out(node, "does not hold where the robot is drawn");
      return;
    }
    RobotGear gear;
    gear.origin = source_.origin(node);
    gear.name = name;
    gear.joints = {first, second};
    gear.coordinates = {coordinate1, coordinate2};
    gear.factors = {1.0, -a[1]};
    if (a[2] != 0.0 || a[3] != 0.0 || a[4] != 0.0) {
      const double zero = m_.qpos0[m_.jnt_qposadr[j2]];
      const bool limited = m_.jnt_limited[j2] != 0;
      const double from = limited ? m_.jnt_range[2 * j2] - zero : -kPi,
                   to = limited ? m_.jnt_range[2 * j2 + 1] - zero : kPi;
      for (int k = 0; k < kCamPoints; ++k) {
        const double q = from + (to - from) * k / (kCamPoints - 1);
        gear.curve.emplace_back(q - moved(*d_, j2), coupled(a, q));
      }
      gear.factors = {1.0, -1.0};
    } else if (a[1] == 0.0) {
      leave_out(node, "holds a joint: let it be of the type fixed");
      return;
    }
    robot_.gears.push_back(gear);
  }

  // Force on the joint, g times the actuator's force: g (k c + b0 + b1 g q + b2 g v), c the control.
  void add_actuators() {
    const std::vector<pugi::xml_node> nodes = source_.children_of("actuator");
    for (int i = 0; i < m_.nu; ++i) {
      const pugi::xml_node node = static_cast<int>(nodes.size()) == m_.nu ? nodes[i] : source_.root();
      const int transmission = m_.actuator_trntype[i], j = m_.actuator_trnid[2 * i];
      if ((transmission != mjTRN_JOINT && transmission != mjTRN_JOINTINPARENT) || joints_of_[j].first < 0) {
        leave_out(node, "acts on no single coordinate of a joint");
        continue;
      }
      const double k = m_.actuator_gainprm[mjNGAIN * i], g = m_.actuator_gear[6 * i];
      const mjtNum* b = m_.actuator_biasprm + mjNBIAS * i;
      const bool affine = m_.actuator_biastype[i] == mjBIAS_AFFINE;
      const double b0 = affine ? b[0] : 0.0, b1 = affine ? b[1] : 0.0, b2 = affine ? b[2] : 0.0;
      const bool usual = m_.actuator_gaintype[i] == mjGAIN_FIXED && (affine || m_.actuator_biastype[i] == mjBIAS_NONE);
      if (!usual || b1 > 0.0 || b2 > 0.0 || g == 0.0 || m_.actuator_dyntype[i] == mjDYN_INTEGRATOR ||
          m_.actuator_dyntype[i] == mjDYN_MUSCLE) {
        leave_out(node, "is no motor of a scene (torque, speed or position)");
        continue;
      }
      if (m_.actuator_dyntype[i] != mjDYN_NONE)
        leave_out(node,
                  "acts at once: its filter of the control is left out; give the command a signal with a lowpass");
      double control = m_.nkey > 0 ? m_.key_ctrl[i] : 0.0;
      double largest = 0.0;
      if (m_.actuator_ctrllimited[i] != 0) {
        const double lo = m_.actuator_ctrlrange[2 * i], hi = m_.actuator_ctrlrange[2 * i + 1];
        control = std::clamp(control, lo, hi);
        largest = std::max(std::abs(lo), std::abs(hi)) * std::abs(k * g);
      }
      RobotDrive drive;
      drive.origin = source_.origin(node);
      drive.name = name_of(mjOBJ_ACTUATOR, i, "motor");
      drive.joint = joints_of_[j].first;
      drive.coordinate = joints_of_[j].second;
      if (b1 < 0.0) {
        drive.kind = RobotDriveKind::kPosition;
        drive.kp = -b1 * g * g;
        drive.kd = -b2 * g * g;
        drive.command = (k * control + b0) / (-b1 * g);
        if (drive.kd > 0.0) drive.remark = "damps against the rate of a command that changes";
      } else if (b2 < 0.0) {
        drive.kind = RobotDriveKind::kSpeed;
        drive.kp = -b2 * g * g;
        drive.command = (k * control + b0) / (-b2 * g);
      } else {
        drive.command = g * (k * control + b0);
        if (largest > 0.0) drive.max_torque = largest;
        drive.remark =
            number_text(g * k, 6) + " times the control" + (control != 0.0 ? ", which remains as in the keyframe" : "");
      }
      if (m_.actuator_forcelimited[i] != 0) {
        const double lo = m_.actuator_forcerange[2 * i], hi = m_.actuator_forcerange[2 * i + 1];
        const double force = std::max(std::abs(lo), std::abs(hi)) * std::abs(g);
        if (force > 0.0) drive.max_torque = std::min(drive.max_torque.value_or(force), force);
        if (std::abs(lo + hi) > 1e-9 * (hi - lo))
          leave_out(node, "has in a scene the larger limit of force in both directions");
      }
      robot_.drives.push_back(drive);
    }
  }

  // Velocities of all bodies in the keyframe: of free bodies, in qvel of the origin of their frame, and of joints.
  void add_velocities() {
    if (!moves_) return;
    const pugi::xml_node key = source_.children_of("keyframe").front();
    if (!drawn_at_key()) {
      leave_out(key, "qvel: the robot starts at rest");
      return;
    }
    mju_copy(d_->qvel, m_.key_qvel, m_.nv);
    if (options_.fix_base && !free_joints_.empty()) {
      mju_zero(d_->qvel + m_.jnt_dofadr[free_joints_.front()], 6);
      leave_out(key, "qvel: the base is fixed, by --fix-base");
    }
    mj_comPos(&m_, d_.get());
    mj_comVel(&m_, d_.get());
    for (const auto& [body, link] : links_) {
      mjtNum twist[6];  // angular, then of the frame's origin, both along the axes of the world
      mj_objectVelocity(&m_, d_.get(), mjOBJ_XBODY, body, twist, 0);
      robot_.links[link].angular_velocity = vector(twist);
      robot_.links[link].velocity = vector(twist + 3);
    }
    for (const auto& [link, beyond] : between_) add_velocity_before(link, beyond);
  }

  // The link moves as the body beyond these joints would if the joints did not move: v - w_j x (p - p_j), w - w_j of each.
  void add_velocity_before(int link, const std::vector<int>& joints) {
    const int body = body_of(joints.back());
    const RobotLink& whole = robot_.links[link_of(body)];
    Eigen::Vector3d v = *whole.velocity, w = *whole.angular_velocity;
    for (const int j : joints) {
      const mjtNum* rate = d_->qvel + m_.jnt_dofadr[j];
      if (m_.jnt_type[j] == mjJNT_SLIDE) {
        v -= *rate * vector(d_->xaxis + 3 * j);
        continue;
      }
      const bool ball = m_.jnt_type[j] == mjJNT_BALL;
      const Eigen::Vector3d turn =
          ball ? Eigen::Vector3d(placed(body).R * vector(rate)) : Eigen::Vector3d(*rate * vector(d_->xaxis + 3 * j));
      w -= turn;
      v -= turn.cross(whole.X_DL.p - vector(d_->xanchor + 3 * j));
    }
    robot_.links[link].velocity = v;
    robot_.links[link].angular_velocity = w;
  }

  const MjcfSource& source_;
  const mjModel& m_;
  const ImportOptions& options_;
  Data d_;              // in the reference configuration
  bool starts_ = true;  // joints start in the first keyframe
  bool moves_ = false;  // it has velocities
  Robot& robot_;
  std::vector<pugi::xml_node> bodies_;                  // by body
  std::map<int, int> links_;                            // of bodies
  std::vector<std::pair<int, std::string>> joints_of_;  // joint and coordinate, by joint of the model
  std::map<int, std::vector<int>> colliding_;           // geoms of bodies
  std::vector<int> free_joints_;
  std::vector<std::pair<int, std::vector<int>>> between_;  // links within a body, and its joints beyond each
};

}  // namespace

Robot read_mjcf(const std::string& file, const ImportOptions& options) {
  Robot robot;
  robot.format = "MJCF";
  robot.file = file;
  MjcfSource source(file, options, robot);
  const Model model = compiled(source);
  MjcfRobot(source, *model, options, robot).read();
  return robot;
}

}  // namespace footfall
