#include "mbd_solver/model/linear_range.h"

#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {

double lowest_frequency(const ModalBody& body) {
  FOOTFALL_DEMAND(body.mode_count() > 0);
  return std::sqrt(body.stiffness.minCoeff());
}

double extent(const ModalBody& body) {
  return (body.rho0.rowwise().maxCoeff() - body.rho0.rowwise().minCoeff()).norm();
}

}  // namespace footfall
