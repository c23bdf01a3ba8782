#pragma once
// Runs of LIGGGHTS for tests, alone, with the scripted partner or with mbd_solver: scripts and what came out.

#include <sstream>
#include <string>
#include <vector>

#include "tests/coupled/stl.h"
#include "tests/support/liggghts_output.h"
#include "tests/support/run_folder.h"

namespace footfall::test {

// Stock LIGGGHTS as Debian installs it.
inline const char* const kStock = LIGGGHTS_EXECUTABLE;

// Head of a script: a box, two materials (1 soil, 2 steel), Hertz contact with friction and rolling resistance.
inline std::string script_head(const std::string& box, const std::string& processors = "* * *", double dt = 5e-5) {
  std::ostringstream s;
  s << "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel "
       "yes\nunits si\n"
       "hard_particles yes\nprocessors "
    << processors << "\nregion reg block " << box
    << " units box\ncreate_box 2 reg\nneighbor 0.01 bin\nneigh_modify delay 0\n"
       "fix m1 all property/global youngsModulus peratomtype 35e6 207e9\n"
       "fix m2 all property/global poissonsRatio peratomtype 0.25 0.1\n"
       "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.1 0.4 0.4 0.4\n"
       "fix m4 all property/global coefficientFriction peratomtypepair 2 0.44 0.3 0.3 0.3\n"
       "fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.2 0.1 0.1 0.1\n"
       "pair_style gran model hertz tangential history rolling_friction cdt\npair_coeff * *\ntimestep "
    << dt << "\n";
  return s.str();
}

// A loose bed of about 850 grains of radius 2 cm, a floor at z = 0, gravity: enough for contacts of every kind, seconds
// to run.
inline std::string small_bed(const std::string& processors = "* * *") {
  return script_head("-0.3 0.3 -0.3 0.3 -0.05 0.6", processors) +
         "fix grav all gravity 9.81 vector 0 0 -1\n"
         "fix floor all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 "
         "zplane 0.0\n"
         "lattice sc 0.041\nregion grains block -0.25 0.25 -0.25 0.25 0.02 0.21 units box\ncreate_atoms 1 "
         "region grains\n"
         "set group all diameter 0.04 density 2600\ndisplace_atoms all random 0.0004 0.0004 0.0004 15485863 "
         "units box\n"
         "fix integr all nve/sphere\n";
}

inline std::string mesh_wall(const std::string& mesh = "m") {
  return "fix wm all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes 1 meshes " + mesh +
         "\n";
}

// All state of all grains, every bit.
inline std::string dump_every(int steps, const std::string& name) {
  return "dump d all custom " + std::to_string(steps) + " " + name +
         ".* id x y z vx vy vz omegax omegay omegaz fx fy fz\ndump_modify d sort id format \"%d %.17g %.17g "
         "%.17g %.17g %.17g "
         "%.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\n";
}

// Programs and files of one test with beams.
class BeamRun : public RunFolder {
 public:
  explicit BeamRun(const std::string& name) : RunFolder("beam_" + name) {}

  // Unmodified LIGGGHTS.
  Outcome stock(const std::string& script, int ranks = 1) const;
  // liggghts_mbd with a scripted partner (the statements of its motion file: scripted_partner.cpp).
  Outcome coupled(const std::string& script, const std::string& motion, int ranks = 1) const;
  // liggghts_mbd with mbd_solver on a scene whose [particles] script is "in.coupled"; results go to file("out").
  Outcome scene(const std::string& script, const std::string& scene, int ranks = 1) const;

  // What `dump ... custom` wrote.
  Dump dump(const std::string& file) const { return read_dumps(read(file)); }
  // Numbers of a text file, line by line, without lines that begin with #.
  Rows table(const std::string& file) const;
  // The partner's table: numbers of each window on the one body of the motion, without its name.
  Rows loads() const;
  std::string file(const std::string& name) const { return (path() / name).string(); }
};

// A dump of all grains every N steps to `file`: id, the given columns, with all digits.
std::string dump_command(const std::string& file, int every, const std::string& columns);

struct ContactMaterial {
  double restitution = 0.3;
  double friction = 0.44;
  double rolling = 0.05;
};

// Box, style and two materials (1 grains, 2 beams, both with the same constants) [SI]; no `timestep`.
std::string preamble(const std::string& region, const ContactMaterial& material = {});
// The same without the box, for use after read_restart.
std::string materials(const ContactMaterial& material = {});

// Statements for a chain through these nodes ("x y z"), its segments of this radius; the first node has number `first`.
std::string chain(const std::vector<std::string>& nodes, double radius, int first = 0, int number = 0);

}  // namespace footfall::test
