// import_peers FILE...: robots against their own readers and against MuJoCo.
//   read    mass, mass centre, inertia and placement of every link in the scene, against urdfdom and MuJoCo (URDF), sdformat
//           (SDF), MuJoCo (MJCF): the largest difference, relative to 1 m, the mass and the inertia of the link
//   swing   0.5 s of the robot with its root held, under gravity; fall: with its root free, moving and turning at the start. The
//           scene by this solver, the model by MuJoCo (RK4, at most 0.1 ms): the largest difference of a mass centre [m] or attitude [rad]
// Without contacts, limits, dry friction, loops and couplings on both sides: MuJoCo has soft ones. Exit code 1 above kRead or kMotion.
#include <mujoco/mujoco.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Dense>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <pugixml.hpp>
#include <sstream>
#ifdef FOOTFALL_SDFORMAT
#include <sdf/sdf.hh>
#endif

#include "mbd_solver/import/mjcf_source.h"
#include "mbd_solver/import/robot.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/simulation.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr double kRead = 1e-9, kMotion = 1e-5;
constexpr double kTime = 0.5, kStep = 1e-4;                             // [s]
const Eigen::Vector3d kVelocity(0.1, 0.2, 0.3), kTurn(0.5, -0.3, 0.7);  // of a free root at the start [m/s, rad/s]

using Model = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using Data = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

Model loaded(const std::string& text) {
  const auto vfs = std::make_unique<mjVFS>();
  mj_defaultVFS(vfs.get());
  mj_makeEmptyFileVFS(vfs.get(), "peer.xml", static_cast<int>(text.size()));
  std::memcpy(vfs->filedata[0], text.data(), text.size());
  char error[1000] = "";
  Model model(mj_loadXML("peer.xml", vfs.get(), error, sizeof error), mj_deleteModel);
  mj_deleteVFS(vfs.get());
  if (!model) throw std::runtime_error(error);
  return model;
}

// What MuJoCo does not read by itself, as the import prepares it: without what only later versions know.
Model loaded_of_later_version(const std::string& file, const ImportOptions& options) {
  Robot listed;
  listed.file = file;
  MjcfSource source(file, options, listed);
  while (true) try {
      return loaded(source.text());
    } catch (const std::runtime_error& e) {
      source.take_out(e.what());
    }
}

struct LinkValues {
  double mass;
  Eigen::Vector3d centre;   // in D
  Eigen::Matrix3d inertia;  // in axes of D
  Eigen::Matrix3d axes;
};
using Links = std::map<std::string, LinkValues>;

Eigen::Vector3d vec(const mjtNum* v) { return {v[0], v[1], v[2]}; }
Eigen::Matrix3d mat(const mjtNum* q) { return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix(); }

// drawn: as Robot::drawn of an MJCF; empty: all is at zero.
Links of_mujoco(const mjModel& m, const std::string& drawn) {
  const Data d(mj_makeData(&m), mj_deleteData);
  mju_copy(d->qpos, m.qpos0, m.nq);
  for (int j = 0; !drawn.empty() && m.nkey > 0 && j < m.njnt; ++j)
    if (m.jnt_type[j] == mjJNT_FREE) mju_copy(d->qpos + m.jnt_qposadr[j], m.key_qpos + m.jnt_qposadr[j], 7);
  if (drawn == "the first keyframe") mju_copy(d->qpos, m.key_qpos, m.nq);
  mj_normalizeQuat(&m, d->qpos);
  mj_kinematics(&m, d.get());
  Links links;
  for (int b = 1; b < m.nbody; ++b) {
    const char* name = mj_id2name(&m, mjOBJ_BODY, b);
    const Eigen::Matrix3d R = mat(d->xquat + 4 * b), R_I = R * mat(m.body_iquat + 4 * b);
    links[name != nullptr && *name != 0 ? name : "body" + std::to_string(b)] = {
        m.body_mass[b], vec(d->xpos + 3 * b) + R * vec(m.body_ipos + 3 * b),
        R_I * vec(m.body_inertia + 3 * b).asDiagonal() * R_I.transpose(), R};
  }
  return links;
}

// The text of a URDF without surfaces: urdfdom knows no capsules, MuJoCo demands the meshes.
std::string bare_urdf(const std::string& file, bool for_mujoco) {
  pugi::xml_document document;
  document.load_file(file.c_str());
  pugi::xml_node robot = document.document_element();
  while (robot.remove_child("material")) {
  }
  for (pugi::xml_node link : robot.children("link"))
    for (const char* name : {"visual", "collision"})
      while (link.remove_child(name)) {
      }
  if (for_mujoco) {
    pugi::xml_node compiler = robot.prepend_child("mujoco").append_child("compiler");
    compiler.append_attribute("fusestatic") = "false";
    compiler.append_attribute("discardvisual") = "true";
  }
  std::ostringstream text;
  document.save(text);
  return text.str();
}

Links of_urdfdom(const std::string& file) {
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(bare_urdf(file, false));
  Links links;
  if (!model) return links;
  const auto affine = [](const urdf::Pose& p) {
    Eigen::Affine3d X = Eigen::Affine3d::Identity();
    X.translate(Eigen::Vector3d(p.position.x, p.position.y, p.position.z));
    X.rotate(Eigen::Quaterniond(p.rotation.w, p.rotation.x, p.rotation.y, p.rotation.z));
    return X;
  };
  for (const auto& [name, link] : model->links_) {
    if (!link->inertial || !(link->inertial->mass > 0.0)) continue;
    Eigen::Affine3d X = Eigen::Affine3d::Identity();
    for (urdf::LinkSharedPtr at = link; at->parent_joint; at = at->getParent()) {
      const urdf::Joint& j = *at->parent_joint;
      Eigen::Affine3d X_J = affine(j.parent_to_joint_origin_transform);
      double q = 0.0, factor = 1.0;
      for (const urdf::Joint* leader = &j; leader != nullptr && leader->mimic;
           leader = model->getJoint(leader->mimic->joint_name).get()) {
        q += factor * leader->mimic->offset;
        factor *= leader->mimic->multiplier;
      }
      if (j.mimic && j.type != urdf::Joint::PRISMATIC)
        X_J.rotate(Eigen::AngleAxisd(q, Eigen::Vector3d(j.axis.x, j.axis.y, j.axis.z).normalized()));
      if (j.mimic && j.type == urdf::Joint::PRISMATIC)
        X_J.translate(q * Eigen::Vector3d(j.axis.x, j.axis.y, j.axis.z).normalized());
      X = X_J * X;
    }
    const urdf::Inertial& i = *link->inertial;
    Eigen::Matrix3d I;
    I << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
    const Eigen::Affine3d X_I = X * affine(i.origin);
    links[name] = {i.mass, X_I.translation(), X_I.linear() * I * X_I.linear().transpose(), X.linear()};
  }
  return links;
}

// The same file by MuJoCo's own reader of URDF, without surfaces. Empty where MuJoCo refuses it.
Links of_urdf_in_mujoco(const std::string& file) {
  try {
    return of_mujoco(*loaded(bare_urdf(file, true)), "");
  } catch (const std::exception&) {
    return {};
  }
}

#ifdef FOOTFALL_SDFORMAT
Links of_sdformat(const std::string& file) {
  sdf::Console::Instance()->SetQuiet(true);
  sdf::Root root;
  root.Load(file);
  Links links;
  const auto add = [&](const sdf::Model& model, const std::string& prefix) {
    ignition::math::Pose3d X_M = model.RawPose();
    model.SemanticPose().Resolve(X_M);
    for (std::uint64_t k = 0; k < model.LinkCount(); ++k) {
      const sdf::Link& link = *model.LinkByIndex(k);
      ignition::math::Pose3d X_L;
      link.SemanticPose().Resolve(X_L, "__model__");
      const ignition::math::Pose3d X = X_M * X_L, X_I = X * link.Inertial().Pose();
      const auto R = [](const ignition::math::Pose3d& p) {
        return Eigen::Quaterniond(p.Rot().W(), p.Rot().X(), p.Rot().Y(), p.Rot().Z()).toRotationMatrix();
      };
      Eigen::Matrix3d I;
      for (unsigned r = 0; r < 3; ++r)
        for (unsigned c = 0; c < 3; ++c) I(r, c) = link.Inertial().MassMatrix().Moi()(r, c);
      links[prefix + link.Name()] = {link.Inertial().MassMatrix().Mass(),
                                     {X_I.Pos().X(), X_I.Pos().Y(), X_I.Pos().Z()},
                                     R(X_I) * I * R(X_I).transpose(),
                                     R(X)};
    }
  };
  if (root.Model() != nullptr) add(*root.Model(), "");
  if (root.WorldCount() > 0)
    for (std::uint64_t k = 0; k < root.WorldByIndex(0)->ModelCount(); ++k)
      add(*root.WorldByIndex(0)->ModelByIndex(k),
          root.WorldByIndex(0)->ModelCount() > 1 ? root.WorldByIndex(0)->ModelByIndex(k)->Name() + "::" : "");
  return links;
}
#else
Links of_sdformat(const std::string&) { return {}; }  // no robot of this format is read
#endif

// The scene of a robot, read from its file in a folder of its own.
Scene scene_of(Robot robot, const ImportOptions& options) {
  const TemporaryFolder folder;
  for (const SceneFile& file : write_robot_scene(robot, options)) folder.write(file.name, file.content);
  return read_scene(folder.folder_.string());
}

struct Difference {
  double value = 0.0;
  std::size_t links = 0, other_inertias = 0;
};
// mended: links whose inertia is none of a body, and was changed.
Difference difference(const Scene& scene, const Robot& robot, const std::set<std::string>& mended, const Links& peer,
                      double digits = 1.0) {
  Difference d;
  for (const RobotLink& link : robot.links) {
    const auto found = peer.find(link.label);
    if (found == peer.end()) continue;
    const BodySpec& body = *scene.body(link.name);
    const LinkValues& p = found->second;
    const Eigen::Matrix3d R = body.orientation.toRotationMatrix(), I = R * body.inertia * R.transpose();
    ++d.links;
    d.value = std::max({d.value, std::abs(body.mass - p.mass) / p.mass, (R - p.axes).cwiseAbs().maxCoeff(),
                        (body.position - p.centre).cwiseAbs().maxCoeff() / std::max(1.0, p.centre.norm())});
    if (mended.count(link.label) > 0) {
      ++d.other_inertias;
    } else {
      d.value = std::max(d.value, digits * (I - p.inertia).cwiseAbs().maxCoeff() / p.inertia.cwiseAbs().maxCoeff());
    }
  }
  return d;
}

// --- Motions.

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  char one[40];
  for (const double v : values) {
    std::snprintf(one, sizeof one, "%.17g ", v);
    text += one;
  }
  return text;
}
std::string numbers(const Eigen::Vector3d& v) { return numbers({v[0], v[1], v[2]}); }

// MJCF of links and joints in the drawing, for formats that MuJoCo does not read.
class MjcfOf {
 public:
  explicit MjcfOf(const Robot& robot) : robot_(robot) {
    text_ = "<mujoco><compiler angle='radian'/><option gravity='" + numbers(robot.gravity) + "'/><worldbody>\n";
    for (std::size_t k = 0; k < robot.links.size(); ++k)
      if (above(static_cast<int>(k)) == nullptr) add(static_cast<int>(k), {}, nullptr);
    for (const RobotJoint& j : robot.joints)
      if (j.parent < 0) add(j.child, {}, &j);
    text_ += "</worldbody></mujoco>\n";
  }
  const std::string& text() const { return text_; }

 private:
  const RobotJoint* above(int link) const {
    for (const RobotJoint& j : robot_.joints)
      if (j.child == link) return &j;
    return nullptr;
  }

  void add(int index, const RigidFrame& X_DP, const RobotJoint* joint) {
    const RobotLink& link = robot_.links[index];
    const RigidFrame X = X_DP.inverse() * link.X_DL;
    const Eigen::Quaterniond q(X.R);
    const Eigen::Matrix3d& I = link.inertia;
    text_ += "<body name='" + link.name + "' pos='" + numbers(X.p) + "' quat='" +
             numbers({q.w(), q.x(), q.y(), q.z()}) + "'>" + "<inertial pos='" + numbers(link.centre) + "' mass='" +
             numbers({link.mass}) + "' fullinertia='" +
             numbers({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}) + "'/>\n";
    if (joint == nullptr) text_ += "<freejoint/>\n";
    if (joint != nullptr && joint->kind != RobotJointKind::kFixed) {
      const Eigen::Vector3d point = link.X_DL.inverse() * joint->point, axis = link.X_DL.R.transpose() * joint->axis;
      const auto one = [&](const std::string& type, const Eigen::Vector3d& along, const RobotCoordinate& c) {
        text_ += "<joint type='" + type + "' pos='" + numbers(point) + "' axis='" + numbers(along) + "' damping='" +
                 numbers({c.damping}) + "' stiffness='" + numbers({c.stiffness}) + "' springref='" +
                 numbers({c.rest - c.zero}) + "' armature='" + numbers({c.armature}) + "'/>\n";
      };
      switch (joint->kind) {
        case RobotJointKind::kRevolute: one("hinge", axis, joint->coordinates[0]); break;
        case RobotJointKind::kPrismatic: one("slide", axis, joint->coordinates[0]); break;
        case RobotJointKind::kCylindrical:
          one("slide", axis, joint->coordinates[1]);
          one("hinge", axis, joint->coordinates[0]);
          break;
        case RobotJointKind::kPlanar:
          one("slide", link.X_DL.R.transpose() * joint->axis2, {});
          one("slide", axis.cross(link.X_DL.R.transpose() * joint->axis2), {});
          one("hinge", axis, {});
          break;
        case RobotJointKind::kUniversal:
          one("hinge", axis, {});
          one("hinge", link.X_DL.R.transpose() * joint->axis2, {});
          break;
        default: text_ += "<joint type='ball' pos='" + numbers(point) + "'/>\n";
      }
    }
    for (const RobotJoint& j : robot_.joints)
      if (j.parent == index) add(j.child, link.X_DL, &j);
    text_ += "</body>\n";
  }

  const Robot& robot_;
  std::string text_;
};

// Without what the two solvers have in different forms.
void without_soft_parts(Robot& robot) {
  robot.gears.clear();
  auto& joints = robot.joints;
  joints.erase(std::remove_if(joints.begin(), joints.end(), [](const RobotJoint& j) { return j.loop; }), joints.end());
  for (RobotJoint& joint : joints)
    for (RobotCoordinate& c : joint.coordinates) {
      c.lower.reset();
      c.upper.reset();
      c.friction = 0.0;
    }
  for (RobotLink& link : robot.links) {
    link.velocity.reset();
    link.angular_velocity.reset();
  }
}

void without_soft_parts(mjModel& m, const Robot& robot) {
  m.opt.disableflags |= mjDSBL_CONTACT | mjDSBL_LIMIT | mjDSBL_FRICTIONLOSS | mjDSBL_EQUALITY;
  m.opt.integrator = mjINT_RK4;
  m.opt.density = m.opt.viscosity = 0.0;
  for (int t = 0; t < m.ntendon; ++t) m.tendon_stiffness[t] = m.tendon_damping[t] = 0.0;
  for (int j = 0; j < m.njnt; ++j) {
    const int dofs = m.jnt_type[j] == mjJNT_FREE ? 6 : m.jnt_type[j] == mjJNT_BALL ? 3 : 0;
    for (int v = m.jnt_dofadr[j]; v < m.jnt_dofadr[j] + dofs; ++v) m.dof_damping[v] = m.dof_armature[v] = 0.0;
    if (dofs > 0) m.jnt_stiffness[j] = 0.0;
  }
  for (int i = 0; i < m.nu; ++i) {  // motors that the scene does not have
    const char* name = mj_id2name(&m, mjOBJ_ACTUATOR, i);
    const std::string label = name != nullptr && *name != 0 ? name : "motor" + std::to_string(i);
    const bool taken =
        std::any_of(robot.drives.begin(), robot.drives.end(), [&](const RobotDrive& d) { return d.label == label; });
    if (!taken) {
      std::fill_n(m.actuator_gainprm + mjNGAIN * i, mjNGAIN, 0.0);
      std::fill_n(m.actuator_biasprm + mjNBIAS * i, mjNBIAS, 0.0);
    }
    m.actuator_dyntype[i] = mjDYN_NONE;
  }
}

// The largest rate of a damper, spring or motor on the inertia of its joint [1/s].
double largest_rate(const mjModel& m) {
  std::vector<double> damping(m.dof_damping, m.dof_damping + m.nv), stiffness(damping.size());
  for (int j = 0; j < m.njnt; ++j) {
    const int dofs = m.jnt_type[j] == mjJNT_FREE ? 6 : m.jnt_type[j] == mjJNT_BALL ? 3 : 1;
    for (int v = m.jnt_dofadr[j]; v < m.jnt_dofadr[j] + dofs; ++v) stiffness[v] = m.jnt_stiffness[j];
  }
  for (int i = 0; i < m.nu; ++i) {
    if (m.actuator_trntype[i] != mjTRN_JOINT) continue;
    const auto v = static_cast<std::size_t>(m.jnt_dofadr[m.actuator_trnid[2 * i]]);
    const double gear2 = m.actuator_gear[6 * i] * m.actuator_gear[6 * i];
    stiffness[v] += std::abs(m.actuator_biasprm[mjNBIAS * i + 1]) * gear2;
    damping[v] += std::abs(m.actuator_biasprm[mjNBIAS * i + 2]) * gear2;
  }
  double rate = 0.0;
  for (std::size_t v = 0; v < damping.size(); ++v)
    rate = std::max({rate, damping[v] * m.dof_invweight0[v], std::sqrt(stiffness[v] * m.dof_invweight0[v])});
  return rate;
}

// Goes on from d by kTime. Throws where MuJoCo loses the motion: it would start anew.
void advance(const mjModel& m, mjData& d) {
  for (long left = std::lround(kTime / m.opt.timestep); left > 0; --left) {
    mj_step(&m, &d);
    for (const int kind : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
      if (d.warning[kind].number > 0) throw std::runtime_error("MuJoCo loses the motion");
  }
  mj_forward(&m, &d);
}

struct Poses {
  std::vector<Eigen::Vector3d> centres;
  std::vector<Eigen::Matrix3d> axes;
};
Poses poses_of(const mjModel& m, const mjData& d) {
  Poses at;
  for (int b = 0; b < m.nbody; ++b) {
    at.centres.push_back(vec(d.xipos + 3 * b));
    at.axes.push_back(mat(d.xquat + 4 * b));
  }
  return at;
}

// Where all bodies are after kTime, by RK4. Where dampers on little inertia would take steps below kLeast (RK4 is stable up to 2.8 of a rate
// times the step), by its method that is implicit in velocities and of the first order: 2 x(h / 2) - x(h) is of the second.
Poses moved(mjModel& m, mjData& d) {
  constexpr double kLeast = 5e-6;
  const double step = std::min(kStep, 1.0 / std::max(largest_rate(m), 1.0));
  if (step >= kLeast) {
    m.opt.timestep = kTime / std::ceil(kTime / step - 1e-9);
    advance(m, d);
    return poses_of(m, d);
  }
  m.opt.integrator = mjINT_IMPLICIT;
  const Data fine(mj_copyData(nullptr, &m, &d), mj_deleteData);
  m.opt.timestep = 0.5 * kStep;
  advance(m, d);
  const Poses coarse = poses_of(m, d);
  m.opt.timestep = 0.25 * kStep;
  advance(m, *fine);
  Poses at = poses_of(m, *fine);
  for (std::size_t b = 0; b < at.axes.size(); ++b) {
    at.centres[b] += at.centres[b] - coarse.centres[b];
    at.axes[b] += at.axes[b] - coarse.axes[b];
  }
  return at;
}

// The largest difference of a mass centre or attitude after kTime.
double motion_difference(const Robot& robot, const Scene& given, mjModel& m) {
  Scene scene = given;
  scene.solver.rtol = 1e-10;
  scene.solver.atol = 1e-12;
  scene.solver.max_step = 0.01;
  scene.output.interval = kTime;
  scene.initial.settle = false;
  const Data d(mj_makeData(&m), mj_deleteData);
  mju_copy(d->qpos, m.nkey > 0 ? m.key_qpos : m.qpos0, m.nq);
  mj_normalizeQuat(&m, d->qpos);
  if (m.nkey > 0 && m.nu > 0) mju_copy(d->ctrl, m.key_ctrl, m.nu);
  mj_forward(&m, d.get());
  // One free tree moves and turns about its mass centre.
  int roots = 0;
  for (int b = 1; b < m.nbody; ++b) roots += m.body_parentid[b] == 0 ? 1 : 0;
  if (roots == 1 && m.njnt > 0 && m.jnt_type[0] == mjJNT_FREE && m.jnt_bodyid[0] == 1) {
    const Eigen::Vector3d com = vec(d->subtree_com + 3);
    const Eigen::Vector3d v = kVelocity + kTurn.cross(vec(d->qpos) - com), w = mat(d->qpos + 3).transpose() * kTurn;
    mju_copy(d->qvel, v.data(), 3);
    mju_copy(d->qvel + 3, w.data(), 3);
    scene.initial.velocity = kVelocity;
    scene.initial.angular_velocity = kTurn;
  }
  const Poses peer = moved(m, *d);
  Simulation run(scene, kTime, nullptr);
  const volatile std::sig_atomic_t never = 0;
  run.run([](const Sample&) {}, never);
  const Kinematics k = run.kinematics();
  double largest = 0.0;
  for (const RobotLink& link : robot.links) {
    int b = mj_name2id(&m, mjOBJ_BODY, link.label.c_str());
    if (b < 0) b = mj_name2id(&m, mjOBJ_BODY, link.name.c_str());
    if (b < 0 && link.label.rfind("body", 0) == 0) b = std::atoi(link.label.c_str() + 4);
    if (b <= 0 || b >= m.nbody) continue;
    const BodyKinematics& body = k.of(scene.body_index(link.name));
    const auto of_b = static_cast<std::size_t>(b);
    largest =
        std::max({largest, (body.r - peer.centres[of_b]).norm(), (body.A - peer.axes[of_b]).norm() / std::sqrt(2.0)});
  }
  return largest;
}

int carry_out(const std::string& file) {
  ImportOptions options;
  options.bare = true;
  const Robot raw = read_robot(file, options);
  Robot robot = raw;
  tidy_robot(robot, options);
  std::set<std::string> mended;
  for (const NotTaken& one : robot.not_taken)
    if (one.what.find("its inertia") != std::string::npos) mended.insert(one.what.substr(6, one.what.rfind('"') - 6));
  const Scene scene = scene_of(robot, options);
  std::size_t parts = 0;
  for (const NotTaken& one : robot.not_taken) parts += one.looks ? 0 : 1;
  double read = 0.0, swing = -1.0, fall = -1.0;
  std::size_t links = 0;
  // MuJoCo finds the principal axes of an inertia to six digits: of its readings, 1e-6 counts as 1e-9.
  const auto add = [&](const Links& peer, double digits = 1.0) {
    const Difference d = difference(scene, robot, mended, peer, digits);
    read = std::max(read, d.value);
    links = std::max(links, d.links);
  };
  Model m(nullptr, mj_deleteModel);
  if (robot.format == "URDF") {
    add(of_urdfdom(file));
    const bool at_offset = std::any_of(robot.joints.begin(), robot.joints.end(), [](const RobotJoint& j) {
      return j.coordinates.size() == 1 && j.coordinates[0].zero != 0.0;
    });
    if (!at_offset) add(of_urdf_in_mujoco(file), 1e-3);  // MuJoCo leaves mimic out
  } else if (robot.format == "SDF") {
    add(of_sdformat(file));
  } else {
    const fs::path here = fs::current_path();
    fs::current_path(fs::absolute(file).parent_path());
    pugi::xml_document document;
    document.load_file(fs::path(file).filename().c_str());
    document.document_element().prepend_child("compiler").append_attribute("autolimits") = "true";
    std::ostringstream text;
    document.save(text);
    try {
      m = loaded(text.str());
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: MuJoCo alone: %s\n", file.c_str(), e.what());
    }
    fs::current_path(here);
    if (!m) m = loaded_of_later_version(file, options);
    add(of_mujoco(*m, robot.drawn));
  }
  std::string problem;
  try {
    if (robot.format == "MJCF") {
      if (m) {
        without_soft_parts(*m, robot);
        Robot plain = robot;
        without_soft_parts(plain);
        swing = motion_difference(plain, scene_of(plain, options), *m);
      }
    } else {
      for (const bool held : {true, false}) {
        ImportOptions o = options;
        o.fix_base = held;
        Robot plain = raw;
        without_soft_parts(plain);
        const bool grounded =
            std::any_of(plain.joints.begin(), plain.joints.end(), [](const RobotJoint& j) { return j.parent < 0; });
        if (grounded && !held) continue;
        if (grounded) o.fix_base = false;
        tidy_robot(plain, o);
        const Model peer = loaded(MjcfOf(plain).text());
        without_soft_parts(*peer, plain);
        (held ? swing : fall) = motion_difference(plain, scene_of(plain, o), *peer);
      }
    }
  } catch (const std::exception& e) {
    problem = e.what();
  }
  const bool good = links > 0 && std::max(swing, fall) >= 0.0 && read <= kRead && swing <= kMotion && fall <= kMotion &&
                    problem.empty();
  std::printf("| %s | %s | %zu of %zu | %zu | %.1e | %.1e | %.1e | %zu | %s |\n", file.c_str(), robot.format.c_str(),
              links, robot.links.size(), robot.joints.size(), read, swing, fall, parts,
              good ? "yes" : ("no " + problem).c_str());
  std::fflush(stdout);
  return good ? 0 : 1;
}

}  // namespace
}  // namespace footfall

int main(int argc, char** argv) {
  int failed = 0;
  std::printf(
      "| file | format | links compared | joints | read | swing | fall | parts not taken | equal "
      "|\n|---|---|---|---|---|---|---|---|---|\n");
  for (int k = 1; k < argc; ++k) {
    try {
      failed += footfall::carry_out(argv[k]);
    } catch (const std::exception& e) {
      std::printf("| %s | | | | | | | | refused: %s |\n", argv[k], e.what());
      ++failed;
    }
  }
  return failed > 0 ? 1 : 0;
}
