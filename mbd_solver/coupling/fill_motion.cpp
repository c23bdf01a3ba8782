#include "mbd_solver/coupling/fill_motion.h"

namespace footfall {

void fill_motion(const BodyKinematics& body, BodyMotion& motion) {
  motion.r = body.r;
  motion.L = body.L;
  motion.dr = body.dr;
  motion.w = body.w;
  motion.ddr = body.ddr;
  motion.dw = body.dw;
  if (motion.mode_count() == 0) return;
  motion.a = body.a;
  motion.da = body.da;
  motion.dda = body.dda;
}

}  // namespace footfall
