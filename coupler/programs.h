#pragma once
// The two programs of a coupled run, as messages name them.

namespace footfall {

inline constexpr const char* kGrainsProgram = "liggghts_mbd";
inline constexpr const char* kMechanismProgram = "mbd_solver";
inline constexpr const char* kStartBoth = "mpirun -np N liggghts_mbd -in SCRIPT : -np 1 mbd_solver SCENE";

}  // namespace footfall
