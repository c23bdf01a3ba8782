#pragma once
// Runs of LIGGGHTS for tests: a folder, a script, a motion for the beams, and what came out.

#include <string>
#include <vector>

#include "tests/support/liggghts_output.h"
#include "tests/support/run_folder.h"

namespace footfall::test {

// Programs and files of one test with beams.
class BeamRun : public RunFolder {
 public:
  explicit BeamRun(const std::string& name) : RunFolder("beam_" + name) {}

  // Unmodified LIGGGHTS.
  Outcome stock(const std::string& script, int ranks = 1) const;
  // liggghts_mbd with a scripted partner (its statements: beam_partner.cpp).
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

struct Material {
  double restitution = 0.3;
  double friction = 0.44;
  double rolling = 0.05;
};

// Box, style and two materials (1 grains, 2 beams, both with the same constants) [SI]; no `timestep`.
std::string preamble(const std::string& region, const Material& material = {});
// The same without the box, for use after read_restart.
std::string materials(const Material& material = {});

// Statements for a chain through these nodes ("x y z"), its segments of this radius; the first node has number `first`.
std::string chain(const std::vector<std::string>& nodes, double radius, int first = 0, int number = 0);

}  // namespace footfall::test
