#include "coupler/schemes/frozen.h"

namespace footfall {

void Frozen::predict(const BodyMotion& start, double, BodyMotion& out) const {
  out.r = start.r;
  out.L = start.L;
  out.a = start.a;
  out.dr.setZero();
  out.w.setZero();
  out.da.setZero();
}

}  // namespace footfall
