#pragma once
// Everything that changes while a model runs, as plain numbers, and its inputs from outside. A State that is saved and
// restored resumes a run bit for bit, because integrators restart at a checkpoint in both runs.

#include <Eigen/Dense>
#include <cmath>
#include <optional>
#include <vector>

#include "coupler/body_motion.h"
#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

// Estimated errors of the time integrals of a State: the sums of differences to an embedded rule of lower order, with their
// signs; and the integral of all |powers|, the scale of these errors.
struct WorkError {
  Dissipated dissipated;      // [J]
  Eigen::VectorXd load_work;  // [J]
  Supplied supplied;          // [J]
  double scale = 0.0;         // [J]

  void add(const WorkError& more) {
    for (std::size_t k = 0; k < dissipated.by_kind.size(); ++k) dissipated.by_kind[k] += more.dissipated.by_kind[k];
    for (std::size_t k = 0; k < supplied.by_kind.size(); ++k) supplied.by_kind[k] += more.supplied.by_kind[k];
    load_work += more.load_work;
    scale += more.scale;
  }
  // The sum of their sizes [J].
  double total() const {
    double sum = load_work.lpNorm<1>();
    for (const double error : dissipated.by_kind) sum += std::abs(error);
    for (const double error : supplied.by_kind) sum += std::abs(error);
    return sum;
  }
  template <class Archive>
  void visit(Archive& archive) {
    archive("dissipated", dissipated);
    archive("load_work", load_work);
    archive("supplied", supplied);
    archive("scale", scale);
  }
};

struct State {
  double time = 0.0;  // [s]
  Eigen::VectorXd q;  // [r; L; a] per body
  Eigen::VectorXd v;  // [dr; w; da] per body
  Eigen::VectorXd z;  // inner states of the force elements
  // Time integrals since the start, accumulated by the integrator:
  Dissipated dissipated;      // [J]
  Eigen::VectorXd load_work;  // work of the external loads on each body [J]
  Supplied supplied;          // work of prescribed motions, forces and drives [J]
  WorkError work_error;       // of these integrals
  // Angles of the joints that count turns (Layout::joint_angle), followed from step to step [rad]; -1, or the first joint whose
  // angle may be off by whole turns, because it turned too fast in one step.
  Eigen::VectorXd angles;
  int uncertain_angle = -1;
  // The history of force elements (ForceElement::remembers); empty: the history at the start.
  Eigen::VectorXd memory;
  // Next internal step to try [s]; 0: chosen by the integrator.
  double step = 0.0;
};

// A load on one body that is constant during one window.
struct ExternalLoad {
  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();  // force, constant in W [N]
  Eigen::Vector3d T_B = Eigen::Vector3d::Zero();  // moment about Bo, constant in the body frame B [N m]
  Eigen::VectorXd Q_a;                            // modal forces; empty means zero
  std::optional<TangentLoad> tangent;             // varies with the motion within the window
};

// Constants of one window.
struct Inputs {
  std::vector<ExternalLoad> loads;  // one per body, in the order of the model; empty means no loads at all
  // Outputs of controllers [-], then signals. Entries of continuous signals are unused.
  Eigen::VectorXd values;
};

}  // namespace footfall
