#pragma once
// Where the floating frame with linear modes holds. It has no geometric stiffening (centrifugal tension does not
// stiffen bending) and takes deflections as small. Measured in tests/physics/rotating_beam_test.cpp and
// large_deflection_test.cpp; theory 1.4.

#include <Eigen/Dense>

#include "mbd_solver/model/modal_body.h"

namespace footfall {

// |w| over the lowest elastic angular frequency of the free body: up to here bending frequencies err by less than one
// percent, held at an end or free; the error grows with the square.
constexpr double kSpinRange = 0.04;
// Largest deflection from mean axes over the extent of the body: up to here it errs by less than one percent; the error
// grows with the square.
constexpr double kDeflectionRange = 0.01;

// Lowest elastic angular frequency of the free body [rad/s]; the body has modes.
double lowest_frequency(const ModalBody& body);
// Diagonal of the box around the nodes, undeformed [m].
double extent(const ModalBody& body);

}  // namespace footfall
