#pragma once
// The way down a formula of the shares, one parameter at a time: steps in both directions of every parameter, as long as
// one of them is better, then shorter ones. For surfaces with kinks, whose values cost nothing.

#include <functional>
#include <vector>

#include "mbd_solver/cli/calibrate/calibration.h"

namespace footfall {

// Each share stays between those of `least` and `most`. `steps`: from long to short. `value`: infinite where a set is not
// allowed.
struct DescentBounds {
  Shares least, most;
};
Shares down_from(Shares u, const DescentBounds& bounds, const std::vector<double>& steps,
                 const std::function<double(const Shares&)>& value);

}  // namespace footfall
