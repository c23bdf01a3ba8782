#include "coupler/schemes/css.h"

#include "coupler/schemes/linear_path.h"

namespace footfall {

void Css::predict(const BodyMotion& start, double tau, BodyMotion& out) const { predict_linear(start, tau, out); }

}  // namespace footfall
