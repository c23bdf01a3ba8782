#pragma once
// Springs, dampers, struts of every law and bushings for a random mechanism.

#include "tests/validation/mechanism_plan.h"
#include "tests/validation/random_numbers.h"

namespace footfall::test {

// Zero to three elements between bodies, or between a body and the ground unless the mechanism is free of it. Marks
// the plan rough when a law among them has kinks.
void add_random_forces(Plan& plan, Numbers& numbers, bool free);

// What acts on the coordinates of its hinges, cylinders and slides: drives of every kind, with rotors ...
void add_random_drives(Plan& plan, Numbers& numbers);
// ... and with limits, losses, brakes, friction and stops: laws with kinks. Marks the plan rough.
void add_random_limits(Plan& plan, Numbers& numbers);

}  // namespace footfall::test
