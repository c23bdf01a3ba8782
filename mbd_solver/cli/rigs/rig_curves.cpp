#include "mbd_solver/cli/rigs/rig_curves.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "coupler/base/errors.h"

namespace footfall {

History history_of(const RigRun& run) {
  return read_history((std::filesystem::path(run.folder) / "history.csv").string());
}

const BodySpec& body_of(const Scene& scene, const std::string& name) {
  for (const BodySpec& body : scene.bodies)
    if (body.name == name) return body;
  throw InputError(scene.file + ": this rig needs a body named \"" + name + "\"");
}

const ShapeSpec& mesh_of(const Scene& scene, const std::string& name, const std::string& file) {
  const BodySpec& body = body_of(scene, name);
  if (body.shape && body.shape->kind == ShapeKind::kMesh && std::filesystem::path(body.shape->file).filename() == file)
    return *body.shape;
  throw InputError(scene.file + ": body \"" + name + "\": the rig expects the mesh " + file +
                   ", whose dimensions it knows; of another body it would make wrong pressures");
}

const BoxSpec& box_of(const Scene& scene) {
  if (!scene.particles || !scene.particles->box)
    throw InputError(scene.file + ": a rig needs a bed by [particles.box]");
  return *scene.particles->box;
}

double mean_surface(const RigRun& run) {
  const std::vector<double>& radius = box_of(run.scene).radius;
  return -*std::max_element(radius.begin(), radius.end());
}

double gravity_of(const RigRun& run) { return run.scene.gravity.norm(); }

Bins binned(const std::vector<double>& x, const std::vector<double>& y, double from, double to, int count) {
  Bins bins;
  if (!(to > from)) return bins;
  std::vector<double> sum_x(static_cast<std::size_t>(count)), sum_y = sum_x;
  std::vector<int> rows(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < from || x[i] > to) continue;
    const auto k =
        std::min(static_cast<std::size_t>(count - 1), static_cast<std::size_t>(count * (x[i] - from) / (to - from)));
    sum_x[k] += x[i], sum_y[k] += y[i], ++rows[k];
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k] == 0) continue;
    bins.x.push_back(sum_x[k] / rows[k]);
    bins.y.push_back(sum_y[k] / rows[k]);
  }
  return bins;
}

double late_mean(const History& history, const std::string& column, double from) {
  const std::vector<double>&time = history.columns.front(), &y = history.column(column);
  double sum = 0.0;
  int rows = 0;
  for (std::size_t i = 0; i < y.size(); ++i)
    if (time[i] >= from * time.back()) sum += y[i], ++rows;
  return rows > 0 ? sum / rows : std::numeric_limits<double>::quiet_NaN();
}

LineFit least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& y) {
  LineFit fit;
  fit.c = Eigen::VectorXd::Constant(A.cols(), std::numeric_limits<double>::quiet_NaN());
  fit.r_squared = std::numeric_limits<double>::quiet_NaN();
  if (A.rows() <= A.cols()) return fit;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  if (qr.rank() < A.cols()) return fit;
  fit.valid = true;
  fit.c = qr.solve(y);
  const double total = (y.array() - y.mean()).square().sum();
  fit.r_squared = total > 0.0 ? 1.0 - (y - A * fit.c).squaredNorm() / total : 1.0;
  return fit;
}

}  // namespace footfall
