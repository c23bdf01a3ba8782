#pragma once
// A control surface: one voltage of a fuzzy system over two of its inputs, the other two held, as in [Lin25
// Figure 4].

#include <string_view>

#include "mbd_solver/model/controllers/fuzzy.h"

namespace footfall {

struct ControlSurface {
  Eigen::VectorXd first;    // values of the first input, in its unit (fuzzy.h)
  Eigen::VectorXd second;   // values of the second input
  Eigen::MatrixXd voltage;  // first x second [-]
};

// output: 0 for U1. first, second: names of two different inputs ("a", "da", "alpha", "beta"), each over its
// whole range on `points` points. held: the values of the other two inputs. Throws InputError for an unknown
// name or output.
ControlSurface control_surface(const FuzzySystem& system, int output, std::string_view first, std::string_view second,
                               int points = 41, const FuzzyInput& held = {0.0, 0.0, 0.0, 0.0});

}  // namespace footfall
