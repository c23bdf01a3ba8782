#pragma once
// Settings by which the user of a scene can correct a coupling interval that is too long, or grains that are too soft.

#include <functional>
#include <string>

#include "mbd_solver/scene/scene.h"

namespace footfall {

struct CouplingAdvice {
  // Windows of n DEM steps: "`--set particles.variables.every=2`", or "`every 2`" where no variable sets them.
  std::function<std::string(int n)> interval;
  std::string shorter_step;  // of the grains: "a smaller timestep in the script"
  // Grains f times as stiff. Their time step shrinks by sqrt(f), as the Rayleigh time does.
  std::function<std::string(double f)> stiffer;
};

// scene: must outlive the advice, which reads the script only when advice is needed.
CouplingAdvice coupling_advice(const Scene& scene, bool chooses_windows);

}  // namespace footfall
