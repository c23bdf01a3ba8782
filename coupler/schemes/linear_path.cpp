#include "coupler/schemes/linear_path.h"

namespace footfall {

void predict_linear(const BodyMotion& start, double tau, BodyMotion& out) {
  out.r = start.r + tau * start.dr;
  out.L = turned(start.L, tau * start.w);
  out.a = start.a + tau * start.da;
  out.dr = start.dr;
  out.w = start.w;
  out.da = start.da;
}

}  // namespace footfall
