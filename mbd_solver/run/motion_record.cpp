#include "mbd_solver/run/motion_record.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "coupler/errors.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

void write_stl(const std::string& path, const std::string& name, const Eigen::Matrix3Xd& x, const std::vector<Eigen::Vector3i>& triangles) {
  std::ofstream out(path);
  out.precision(17);
  const auto point = [&](const char* word, const Eigen::Vector3d& p) { out << word << " " << p.x() << " " << p.y() << " " << p.z() << "\n"; };
  out << "solid " << name << "\n";
  for (const Eigen::Vector3i& t : triangles) {
    const Eigen::Vector3d a = x.col(t(0)), b = x.col(t(1)), c = x.col(t(2));
    point("facet normal", (b - a).cross(c - a).normalized());
    out << "outer loop\n";
    for (const Eigen::Vector3d& corner : {a, b, c}) point("vertex", corner);
    out << "endloop\nendfacet\n";
  }
  out << "endsolid " << name << "\n";
  if (!out.flush()) throw InputError(path + ": cannot be written; is the disk full?");
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
  fit.left_over = (x - moved).colwise().norm().maxCoeff();
  return fit;
}

MotionRecord::MotionRecord(Simulation& simulation, const std::string& folder) {
  const Mechanism& mechanism = simulation.mechanism();
  std::vector<std::string> names = {"time", "x", "y", "z", "rx", "ry", "rz", "bend", "fx", "fy", "fz"};
  std::vector<std::string> units = {"s", "m", "m", "m", "rad", "rad", "rad", "m", "N", "N", "N"};
  for (const int i : simulation.partner()->coupled()) {
    const BodyBoundary& entry = mechanism.boundaries[static_cast<std::size_t>(i)];
    if (entry.boundary.triangles().empty()) continue;
    if (surfaces_.empty()) {
      std::error_code error;
      fs::create_directories(folder, error);
      if (error) throw InputError(folder + ": cannot be made: " + error.message() + "; choose another folder with --out");
    }
    const std::string file = (fs::path(folder) / entry.boundary.name()).string();
    Surface surface{&entry, simulation.equations().layout().body_q[static_cast<std::size_t>(entry.body)], {},
                    std::make_unique<HistoryWriter>(file + ".csv", names, units)};
    surface.x0 = nodes(surface, simulation.state());
    write_stl(file + ".stl", entry.boundary.name(), surface.x0, entry.boundary.triangles());
    surfaces_.push_back(std::move(surface));
  }
}

Eigen::Matrix3Xd MotionRecord::nodes(const Surface& surface, const State& state) const {
  const ModalBoundary& boundary = surface.boundary->boundary;
  BodyMotion motion(boundary.mode_count());
  motion.r = state.q.segment<3>(surface.q);
  motion.L = state.q.segment<4>(surface.q + 3);
  motion.a = state.q.segment(surface.q + 7, boundary.mode_count());
  Eigen::Matrix3Xd x(3, boundary.node_count());
  boundary.node_positions(motion, x);
  return x;
}

void MotionRecord::write(const Sample& sample) {
  for (const Surface& surface : surfaces_) {
    const RigidFit fit = fit_rigid(surface.x0, nodes(surface, sample.state));
    const Eigen::AngleAxisd turn(fit.R);
    const Eigen::Vector3d r = turn.angle() * turn.axis();
    const Eigen::Vector3d& f = sample.contact[static_cast<std::size_t>(surface.boundary->body)].F_W;
    surface.file->write({sample.state.time, fit.centre.x(), fit.centre.y(), fit.centre.z(), r.x(), r.y(), r.z(), fit.left_over, f.x(), f.y(), f.z()});
  }
}

void MotionRecord::flush() {
  for (const Surface& surface : surfaces_) surface.file->flush();
}

}  // namespace footfall
