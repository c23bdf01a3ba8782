#pragma once
// The straight path, of css, css-trapezoid and tangent.

#include "coupler/body_motion.h"

namespace footfall {

// r + dr tau,  exp(w tau) L,  a + da tau;  its rates stay.
void predict_linear(const BodyMotion& start, double tau, BodyMotion& out);

}  // namespace footfall
