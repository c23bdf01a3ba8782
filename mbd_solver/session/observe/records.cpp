// MomentumRecord sums m v over the nodes of all bodies. MotionRecord fits a rigid motion (Kabsch) to the nodes of each
// surface and writes it with the mean force.

#include "mbd_solver/session/observe/records.h"

#include <cstdio>
#include <filesystem>
#include <locale>
#include <sstream>

#include "coupler/base/codes.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/run_directory.h"
#include "coupler/message_fields.h"

namespace footfall {
namespace {

// Of all bodies together, in W.
struct MomentumSum {
  double mass = 0.0;                                 // [kg]
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();  // sum of m v [N s]
  double size = 0.0;                                 // sum of |m v| [N s]
};

// For flexible bodies summed over nodes: m_j (dr + w x A rho_j + A Phi_j da), rho_j = rho0_j + Phi_j a (theory 1.2).
MomentumSum momentum_of(const Model& model, const Kinematics& kinematics) {
  MomentumSum sum;
  const auto add = [&sum](double m, const Eigen::Vector3d& v) {
    sum.linear += m * v;
    sum.size += m * v.norm();
  };
  for (int i = 0; i < model.body_count(); ++i) {
    const BodyKinematics& b = kinematics.of(i);
    sum.mass += model.body(i).mass();
    if (b.modes == 0) {
      add(model.body(i).mass(), b.dr);
      continue;
    }
    const ModalBody& modal = *model.body(i).modal();
    if (modal.mass.size() > 0) {  // mean axes: Bo is the mass centre
      add(model.body(i).mass(), b.dr);
      continue;
    }
    for (int j = 0; j < modal.node_count(); ++j) {
      const auto Phi = modal.Phi.middleRows(3 * j, 3);
      const Eigen::Vector3d arm = b.A * (modal.rho0.col(j) + Phi * b.a);
      const Eigen::Vector3d bends = b.A * (Phi * b.da);
      add(modal.node_mass[j], b.dr + b.w.cross(arm) + bends);
    }
  }
  return sum;
}

// Whether only gravity and grains act on the mechanism: no joint and no force element is attached to the ground, and no
// force is applied.
bool is_free(const Model& model) {
  for (int i = 0; i < model.joint_count(); ++i)
    if (model.joint(i).m1.body == kGround || model.joint(i).m2.body == kGround) return false;
  for (int i = 0; i < model.force_count(); ++i)
    for (const int body : model.force(i).bodies())
      if (body == kGround) return false;
  return true;
}

}  // namespace

MomentumRecord::MomentumRecord(const Subject& subject, const std::string& folder)
    : subject_(subject), path_(folder + "/mechanism.csv") {
  make_folder(folder);
  open_file(file_, path_, FileStart::kNew);
  file_.precision(17);
  file_ << "time,px,py,pz,size,mass,gx,gy,gz,free,reacts";
  for (const int i : subject.agreement->boundaries) {
    const std::string& name = subject.mechanism.boundaries[i].boundary.name();
    for (const char* what : {"fx", "fy", "fz", "mx", "my", "mz", "received"}) file_ << "," << name << "." << what;
  }
  file_ << "\n";
  if (!file_.flush()) throw InputError(code::kFileNotWritten, path_ + ": cannot be written");
}

void MomentumRecord::write(const Sample& sample) {
  const Model& model = subject_.mechanism.model;
  const MomentumSum sum = momentum_of(model, sample.kinematics);
  const auto put = [this](const Eigen::Vector3d& v) { file_ << "," << v.x() << "," << v.y() << "," << v.z(); };
  file_ << sample.state.time;
  put(sum.linear);
  file_ << "," << sum.size << "," << sum.mass;
  put(model.gravity());
  file_ << "," << is_free(model) << "," << subject_.agreement->scheme->requires_tangent();
  for (const int i : subject_.agreement->boundaries) {
    const int body = subject_.mechanism.boundaries[i].body;
    const ExternalLoad& load = sample.inputs.loads[body];
    put(load.F_W);
    put(load.T_B);
    file_ << "," << sample.state.load_work(body);
  }
  file_ << "\n";
  if (!file_.flush()) throw InputError(code::kFileNotWritten, path_ + ": cannot be written: is the disk full?");
}

namespace {

namespace fs = std::filesystem;

constexpr double kRoundOff = 1e-14;  // of the largest coordinate

void write_stl(const std::string& path, const std::string& name, const Eigen::Matrix3Xd& x,
               const std::vector<Eigen::Vector3i>& triangles) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(17);
  const auto point = [&](const char* word, const Eigen::Vector3d& p) {
    out << word << " " << p.x() << " " << p.y() << " " << p.z() << "\n";
  };
  out << "solid " << name << "\n";
  for (const Eigen::Vector3i& t : triangles) {
    const Eigen::Vector3d a = x.col(t(0)), b = x.col(t(1)), c = x.col(t(2));
    point("facet normal", (b - a).cross(c - a).normalized());
    out << "outer loop\n";
    for (const Eigen::Vector3d& corner : {a, b, c}) point("vertex", corner);
    out << "endloop\nendfacet\n";
  }
  out << "endsolid " << name << "\n";
  write_whole_file(path, out.str());
}

}  // namespace

// Kabsch: R from the singular value decomposition of the points' covariance, without reflection.
RigidFit fit_rigid(const Eigen::Matrix3Xd& x0, const Eigen::Matrix3Xd& x) {
  RigidFit fit;
  fit.centre0 = x0.rowwise().mean();
  fit.centre = x.rowwise().mean();
  const Eigen::Matrix3d covariance = (x.colwise() - fit.centre) * (x0.colwise() - fit.centre0).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d signs(1.0, 1.0, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0);
  fit.R = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  const Eigen::Matrix3Xd moved = (fit.R * (x0.colwise() - fit.centre0)).colwise() + fit.centre;
  fit.residual = (x - moved).colwise().norm().maxCoeff();
  // The last bits depend on the order of sums in LIGGGHTS: a resumed run would differ from an uninterrupted one.
  if (fit.residual < kRoundOff * x.cwiseAbs().maxCoeff()) fit.residual = 0.0;
  return fit;
}

MotionRecord::MotionRecord(const Subject& subject, const Kinematics& start, const std::string& folder,
                           Beginning beginning)
    : scheme_(*subject.agreement->scheme) {
  const std::vector<std::string> names = {"time", "x", "y", "z", "rx", "ry", "rz", "bend", "fx", "fy", "fz"};
  const std::vector<std::string> units = {"s", "m", "m", "m", "rad", "rad", "rad", "m", "N", "N", "N"};
  for (const int i : subject.agreement->boundaries) {
    const BodyBoundary& entry = subject.mechanism.boundaries[i];
    const ModalBoundary& boundary = entry.boundary;
    if (boundary.triangles().empty()) continue;
    if (surfaces_.empty()) make_folder(folder);
    const std::string file = (fs::path(folder) / boundary.name()).string();
    const BodyMotion rest(boundary.mode_count());
    const Eigen::Matrix3Xd unset(3, boundary.node_count());
    Surface surface{&entry, rest,  rest,
                    unset,  unset, std::make_unique<HistoryWriter>(file + ".csv", names, units, beginning)};
    fill_motion(start.of(entry.body), surface.motion);
    boundary.node_positions(surface.motion, surface.x0);
    if (beginning == Beginning::kNew) write_stl(file + ".stl", boundary.name(), surface.x0, boundary.triangles());
    surfaces_.push_back(std::move(surface));
  }
}

void MotionRecord::write(const Sample& sample) {
  const double H = sample.state.time - time_;
  for (Surface& surface : surfaces_) {
    const int body = surface.boundary->body;
    surface.predicted = surface.motion;
    if (started_) scheme_.predict(surface.motion, H, surface.predicted);
    fill_motion(sample.kinematics.of(body), surface.motion);
    // Scheme tangent presents to the grains the motion that it expects to compute.
    const bool expected = scheme_.requires_tangent();
    surface.boundary->boundary.node_positions(expected ? surface.motion : surface.predicted, surface.x);
    const RigidFit fit = fit_rigid(surface.x0, surface.x);
    const Eigen::AngleAxisd turn(fit.R);
    const Eigen::Vector3d r = turn.angle() * turn.axis();
    const Eigen::Vector3d& f = sample.contact[body].F_W;
    surface.file->write({sample.state.time, fit.centre.x(), fit.centre.y(), fit.centre.z(), r.x(), r.y(), r.z(),
                         fit.residual, f.x(), f.y(), f.z()});
  }
  time_ = sample.state.time;
  started_ = true;
}

void MotionRecord::visit(Archive& archive) {
  archive("time", time_);
  archive("started", started_);
  for (Surface& surface : surfaces_) archive("surface", surface);
}

void MotionRecord::Surface::visit(Archive& archive) {
  archive("motion", motion);
  archive("predicted", predicted);
  archive("x0", x0);
  long position = archive.restores() ? 0 : file->position();
  archive("position", position);
  if (archive.restores()) file->resume_at(position);
}

void MotionRecord::flush() {
  for (const Surface& surface : surfaces_) surface.file->flush();
}

}  // namespace footfall
