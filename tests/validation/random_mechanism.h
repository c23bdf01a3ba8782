#pragma once
// Random mechanisms in families: trees and loops, with every joint and every strut law among them, and loops that have
// more conditions than they need. The seed alone decides.

#include "tests/validation/mechanism_plan.h"

namespace footfall::test {

enum class Family {
  kTree,           // hangs on the ground by joints of every kind
  kFreeTree,       // the same without ground
  kLoop,           // ground to ground, its conditions independent
  kFreeLoop,       // a ring without ground
  kFourBar,        // planar, four hinges: three conditions too many
  kParallelogram,  // a row of them, or a slider-crank: planar as well
  kOverclosed,     // Bennett, Bricard, Sarrus: spatial loops that move only because of their measures
  kDrivenLoop,     // ground to ground, the first hinge driven
  kMotorLoop,      // motors and rotors on every hinge, cylinder and slide of a loop
  kLimitLoop,      // the same with limits, losses, brakes, friction and stops
  kGearLoop,       // two or three coordinates of a loop in a gear
  kRollingLoop     // from a hinge on the ground to a wheel that rolls on it, or on which a plane rolls
};
constexpr Family kFamilies[] = {Family::kTree,      Family::kFreeTree,      Family::kLoop,       Family::kFreeLoop,
                                Family::kFourBar,   Family::kParallelogram, Family::kOverclosed, Family::kDrivenLoop,
                                Family::kMotorLoop, Family::kLimitLoop,     Family::kGearLoop,   Family::kRollingLoop};
const char* name_of(Family family);

// Settled: the start fits the joints. seed = 1, 2, ... within its family.
Plan random_mechanism(Family family, unsigned seed);

}  // namespace footfall::test
