// What beams cost, measured (not a test: times depend on the machine and on who else uses it). Prints for
// each case the loop time of LIGGGHTS, the smallest of several runs that take turns:
//   1. a bed of 4913 grains on stock LIGGGHTS, and with a beam of 20 segments above it that comes down and
//   stays clear of it;
//   2. grains held against a bent tube: as a beam, and as a mesh of 384 facets around, both coupled and
//   moving. beam_bench [runs]
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
  const std::size_t at = outcome.output.rfind(words);
  if (outcome.code != 0 || at == std::string::npos) throw std::runtime_error(outcome.output);
  return std::stod(outcome.output.substr(at + words.size()));
}

// The smallest time of each case, in `runs` rounds.
std::vector<double> compare(int runs, const std::vector<std::function<Outcome()>>& cases) {
  std::vector<double> best(cases.size(), 1e300);
  for (int i = 0; i < runs; ++i)
    for (std::size_t k = 0; k < cases.size(); ++k) best[k] = std::min(best[k], loop_time(cases[k]()));
  return best;
}

void bed_below_a_beam(int runs) {
  const RunFolder folder("bench_bed");
  const std::string bed =
      preamble("-0.26 0.26 -0.26 0.26 0 0.8") + "timestep 2e-5\npair_style gran " + kModel +
      "\npair_coeff * *\nlattice sc 0.0299\nregion heap block -0.25 0.25 -0.25 0.25 0.014 0.51 units box\n"
      "create_atoms 1 region heap\nset group all diameter 0.03 density 2600\n"
      "velocity all set 0.1 0.05 0\nfix floor all wall/gran " +
      kModel +
      " primitive type 1 zplane 0\nfix g all gravity 9.81 vector 0 0 -1\nfix integr all nve/sphere\n";
  // Beams beside each other: their bodies, and their fixes.
  const auto beams = [](int count) {
    std::string text = "end 0.04\n";
    for (int b = 0; b < count; ++b) {
      std::vector<std::string> nodes;
      for (int i = 0; i <= 20; ++i)
        nodes.push_back(std::to_string(-0.25 + 0.025 * i) + " " + std::to_string(0.05 * b) + " 0.75");
      text += "body tine" + std::to_string(b) + "\n" + chain(nodes, 0.02) + "velocity 0 0 -2\n";
    }
    return text;
  };
  const auto walls = [](int count) {
    std::string text;
    for (int b = 0; b < count; ++b)
      text += "fix w" + std::to_string(b) + " all wall/gran/beam " + kModel + " type 2 body tine" +
              std::to_string(b) + "\n";
    return text + "fix mbd all couple/mbd every 10\nrun 2000\n";
  };
  const auto time = compare(runs, {[&] { return folder.stock(bed + "run 2000\n"); },
                                   [&] { return folder.coupled(bed + walls(1), beams(1)); },
                                   [&] { return folder.coupled(bed + walls(6), beams(6)); }});
  std::printf(
      "bed, 2000 steps: stock %.2f s; coupled, with a beam above it %.2f s (%+.1f %%); each further beam "
      "%+.2f %%\n",
      time[0], time[1], 100.0 * (time[1] / time[0] - 1.0), 100.0 * (time[2] / time[1] - 1.0) / 5.0);
}

void beam_and_mesh(int runs) {
  const RunFolder folder("bench_tube");
  const BentTube tube;
  const int steps = 5000, around = 384;
  const double r = 5e-4, overlap = 5e-5;
  std::ostringstream grains;
  grains.precision(17);
  int id = 0;
  for (int s = 0; s < tube.segments; ++s)
    for (int k = 0; k < 96; ++k) {
      const Eigen::Vector3d x =
          tube.beside(s, 0.2 + 0.006 * k, 2.0 * M_PI * k / 96.0, tube.radius + r - overlap);
      grains << "create_atoms 1 single " << x.transpose() << "\ngroup g id " << ++id
             << "\nset group g diameter " << 2.0 * r << " density 2600\ngroup g delete\n";
    }
  const std::string held = preamble("-0.1 0.2 -0.1 0.1 -0.1 0.2") +
                           "neighbor 0.001 bin\ntimestep 1e-8\npair_style gran " + kModel +
                           "\npair_coeff * *\n" + grains.str() + "neigh_modify exclude type 1 1\n";
  const std::string moving = "velocity 0.001 0.002 0\nspin 0.001 0 0\n",
                    end = "end " + std::to_string(steps * 1e-8) + "\nbody arm\n";
  tube.write_stl(folder.path("tube.stl"), around);
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
             }});
  const double contacts = static_cast<double>(steps) * id;
  std::printf(
      "bent tube, time per contact and step: beam %.3g us, mesh of %d facets around %.3g us: %.1f times\n",
      1e6 * time[0] / contacts, around, 1e6 * time[1] / contacts, time[1] / time[0]);
}

}  // namespace

int main(int argc, char** argv) {
  const int runs = argc > 1 ? std::atoi(argv[1]) : 5;
  try {
    bed_below_a_beam(runs);
    beam_and_mesh(runs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
