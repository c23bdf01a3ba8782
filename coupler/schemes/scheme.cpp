// Parts of several schemes: gaps between predicted and computed motion, and the straight path.

#include "coupler/schemes/scheme.h"

namespace footfall {

Vector6d PredictedPath::gap(const BodyMotion& computed) const {
  Vector6d gap;
  gap << computed.r - r_end, rotation_vector(L_end, computed.L);
  return gap;
}

Vector6d PredictedPath::end_from_mean() const {
  Vector6d way;
  way << r_end - r_mean, rotation_vector(L_mean, L_end);
  return way;
}

void predict_linear(const BodyMotion& start, double tau, BodyMotion& out) {
  out.r = start.r + tau * start.dr;
  out.L = turned(start.L, tau * start.w);
  out.a = start.a + tau * start.da;
  out.dr = start.dr;
  out.w = start.w;
  out.da = start.da;
}

}  // namespace footfall
