// A program of somebody else that uses the multibody solver: reads a scene, moves its mechanism to a time, says where a body is.
#include <cstdio>

#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/simulation.h"

int main(int, char** argv) {
  const footfall::Scene scene = footfall::read_scene(argv[1], {});
  footfall::Simulation simulation(scene, std::atof(argv[2]), nullptr, "");
  const volatile std::sig_atomic_t never = 0;
  simulation.run([](const footfall::Sample&) {}, never, {});
  std::printf("t = %g s, z = %.6f m\n", simulation.state().time, simulation.state().q[2]);
}
