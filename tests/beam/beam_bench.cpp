// What contacts with beams cost, measured (not a test: times depend on the machine and on who else uses it).
// Grains held against a bent tube: as a beam, and as a mesh of 384 facets around, both coupled and moving.
// Prints the loop time of LIGGGHTS per contact and step, the smallest of several runs that take turns. What
// beams away from the grains cost: tests/bench/far_beam.sh.
//   beam_bench [runs]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <stdexcept>

#include "tests/beam/beam_run.h"
#include "tests/beam/tube.h"

namespace {

using namespace footfall::test;

const char* const kModel = "model hertz tangential history rolling_friction cdt";

double loop_time(const Outcome& outcome) {  // of the last `run` [s]
  const std::string words = "Loop time of ";
  const std::size_t at = outcome.text.rfind(words);
  if (outcome.exit_code != 0 || at == std::string::npos) throw std::runtime_error(outcome.text);
  return std::stod(outcome.text.substr(at + words.size()));
}

// The smallest time of each case, in `runs` rounds.
std::vector<double> compare(int runs, const std::vector<std::function<Outcome()>>& cases) {
  std::vector<double> best(cases.size(), 1e300);
  for (int i = 0; i < runs; ++i)
    for (std::size_t k = 0; k < cases.size(); ++k) best[k] = std::min(best[k], loop_time(cases[k]()));
  return best;
}

void beam_and_mesh(int runs) {
  const BeamRun folder("bench_tube");
  const BentTube tube;
  const int steps = 5000, around = 384;
  const double r = 5e-4, overlap = 5e-5;
  std::ostringstream grains;
  grains.precision(17);
  int id = 0;
  for (int s = 0; s < tube.segments; ++s)
    for (int k = 0; k < 96; ++k) {
      const Eigen::Vector3d x = tube.beside(s, 0.2 + 0.006 * k, 2.0 * M_PI * k / 96.0, tube.radius + r - overlap);
      grains << "create_atoms 1 single " << x.transpose() << "\ngroup g id " << ++id << "\nset group g diameter "
             << 2.0 * r << " density 2600\ngroup g delete\n";
    }
  const std::string held = preamble("-0.1 0.2 -0.1 0.1 -0.1 0.2") +
                           "neighbor 0.001 bin\ntimestep 1e-8\npair_style gran " + kModel + "\npair_coeff * *\n" +
                           grains.str() + "neigh_modify exclude type 1 1\n";
  const std::string moving = "velocity 0.001 0.002 0\nspin 0.001 0 0\n",
                    end = "end " + std::to_string(steps * 1e-8) + "\nbody arm\n";
  tube.write_stl(folder.file("tube.stl"), around);
  const std::string run = "run " + std::to_string(steps) + "\n";
  const auto time = compare(
      runs, {[&] {
               return folder.coupled(held + "fix w all wall/gran/beam " + kModel +
                                         " type 2 body arm\nfix mbd all couple/mbd every 100\n" + run,
                                     end + chain(tube.nodes(), tube.radius) + moving);
             },
             [&] {
               return folder.coupled(
                   held + "fix tube all mesh/surface file tube.stl type 2\nfix w all wall/gran " + kModel +
                       " mesh n_meshes 1 meshes tube\nfix mbd all couple/mbd every 100 mesh tube arm\n" + run,
                   end + tube.surface_statements(around) + moving);
             },
             [&] {
               return folder.stock(held + "fix tube all mesh/surface file tube.stl type 2\nfix w all wall/gran " +
                                   kModel + " mesh n_meshes 1 meshes tube\n" + run);
             },
             [&] { return folder.stock(held + run); }});
  // What the grains cost without any wall is nobody's contact.
  const auto per_contact = [&](double t) { return 1e6 * (t - time[3]) / (static_cast<double>(steps) * id); };
  std::printf("bent tube, time per contact and step: moving beam %.3g us\n", per_contact(time[0]));
  std::printf("  mesh of %d facets around, moving: %.3g us, %.1f times as much\n", around, per_contact(time[1]),
              per_contact(time[1]) / per_contact(time[0]));
  std::printf("  the same mesh at rest, on stock LIGGGHTS: %.3g us, %.1f times\n", per_contact(time[2]),
              per_contact(time[2]) / per_contact(time[0]));
}

}  // namespace

int main(int argc, char** argv) {
  const int runs = argc > 1 ? std::atoi(argv[1]) : 5;
  try {
    beam_and_mesh(runs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
