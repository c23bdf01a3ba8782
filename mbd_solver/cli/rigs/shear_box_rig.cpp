// Shear box: means over the last 40 % of a run, in the plane between tray and frame, of area A.
//
//   tau = |F_x| / A,   sigma = (-F_z - W / 2) / A,   tau = c + sigma tan(phi)
//
// F: force of the grains on the tray. W: weight of the grains, half of which lie below the plane; it is what tray, frame and
// lid feel together, -sum F_z. A is not corrected for how far the frame has been drawn.
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/rigs/rig_curves.h"

namespace footfall {

namespace {

constexpr double kDrawn = 0.6;   // of the time: what follows is judged
constexpr double kInside = 2.0;  // inner width of box_tray.stl, in its scale

double load_of(const Scene& scene) {
  for (const ForceSpec& force : scene.forces)
    if (force.name == "load" && force.force && !force.force->polynomial.empty()) return force.force->polynomial.front();
  throw InputError(scene.file + ": this rig needs a force named \"load\", a polynomial of time");
}

}  // namespace

void demand_box(const Scene& scene) {
  mesh_of(scene, "tray", "box_tray.stl");
  body_of(scene, "frame");
  body_of(scene, "lid");
  load_of(scene);
}

RigSample evaluate_box(const std::vector<RigRun>& runs) {
  RigSample sample;
  RigCurve line{"stress in the plane", {}, {}};
  Eigen::MatrixXd A(static_cast<Eigen::Index>(runs.size()), 2);
  Eigen::VectorXd tau(A.rows());
  std::vector<RigAnswer> ratios;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double area = std::pow(kInside * mesh_of(runs[i].scene, "tray", "box_tray.stl").scale, 2);
    const History history = history_of(runs[i]);
    const double down = -late_mean(history, "tray.contact.fz", kDrawn);
    const double weight =
        down - late_mean(history, "frame.contact.fz", kDrawn) - late_mean(history, "lid.contact.fz", kDrawn);
    const double sigma = (down - 0.5 * weight) / area;
    const auto row = static_cast<Eigen::Index>(i);
    tau(row) = std::abs(late_mean(history, "tray.contact.fx", kDrawn)) / area;
    A.row(row) << 1.0, sigma;
    line.x.push_back(sigma), line.y.push_back(tau(row));
    const std::string at = ", load of " + number_text(load_of(runs[i].scene), 4) + " N";
    ratios.push_back({"sigma" + at, "Pa", sigma});
    ratios.push_back({"tau / sigma" + at, "", tau(row) / sigma});
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Eigen::Vector2d c = Eigen::Vector2d::Constant(kNone);
  const LineFit fit = least_squares(A, tau);
  if (fit.valid) c = fit.c;
  if (A.rows() == 2) c = A.colPivHouseholderQr().solve(tau);
  sample.curves = {line};
  sample.answers = {{"friction angle phi", "deg", std::atan(c(1)) * 180.0 / kPi}, {"cohesion c", "Pa", c(0)}};
  if (fit.valid) sample.answers.push_back({"R^2", "", fit.r_squared});
  sample.answers.insert(sample.answers.end(), ratios.begin(), ratios.end());
  return sample;
}

}  // namespace footfall
