#pragma once
// What LIGGGHTS prints on standard output whatever its `-screen` says.

namespace footfall {

// From now on the version of each restart file that is read stays unsaid.
void silence_what_goes_past_the_screen();

}  // namespace footfall
