#pragma once
// Shows `footfall` that LIGGGHTS makes steps, however little it prints: the time of a file changes about once a second.

namespace footfall {

// Environment variable of liggghts_mbd: that file.
inline constexpr const char* kPulse = "FOOTFALL_PULSE";

// Opens the file that the environment names; without one nothing happens.
void open_pulse();
// Called in every step.
void pulse();

}  // namespace footfall
