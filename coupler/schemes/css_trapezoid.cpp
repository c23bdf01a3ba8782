#include "coupler/schemes/css_trapezoid.h"

#include "coupler/schemes/linear_path.h"

namespace footfall {

void CssTrapezoid::predict(const BodyMotion& start, double tau, BodyMotion& out) const {
  predict_linear(start, tau, out);
}

}  // namespace footfall
