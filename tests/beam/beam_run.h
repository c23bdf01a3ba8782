#pragma once
// Runs of LIGGGHTS for tests: a folder, a script, a motion for the beams, and what came out.

#include <map>
#include <string>
#include <vector>

namespace footfall::test {

struct Outcome {
  int code = 0;        // exit code of mpirun
  std::string output;  // both streams of all programs
};

// Rows of a dump or table, by time step; the first number of each row is the grain's id.
using Rows = std::vector<std::vector<double>>;
using Dump = std::map<long, Rows>;

// An empty folder of this name below the build tree, in which the programs run.
class RunFolder {
 public:
  explicit RunFolder(const std::string& name);

  // Unmodified LIGGGHTS.
  Outcome stock(const std::string& script, int ranks = 1) const;
  // liggghts_mbd with a scripted partner (its statements: beam_partner.cpp).
  Outcome coupled(const std::string& script, const std::string& motion, int ranks = 1) const;

  // liggghts_mbd with mbd_solver on a scene whose [particles] script is "in.coupled"; results go to
  // path("out").
  Outcome scene(const std::string& script, const std::string& scene, int ranks = 1) const;

  // What `dump ... custom` wrote, sorted by id.
  Dump dump(const std::string& file) const;
  // Numbers of a text file, line by line, without lines that begin with #.
  Rows table(const std::string& file) const;
  // The partner's table: numbers of each window on the one body of the motion, without its name.
  Rows loads() const;
  std::string path(const std::string& file) const { return path_ + "/" + file; }

 private:
  Outcome run(const std::string& command) const;
  void write(const std::string& file, const std::string& text) const;
  std::string path_;
};

// A dump of all grains every N steps to `file`: id, the given columns, with all digits.
std::string dump_command(const std::string& file, int every, const std::string& columns);

// Largest difference of two dumps of the same grains at the same steps, each column relative to its largest
// number in `expected`. Infinite when steps, grains or columns differ.
double relative_difference(const Dump& expected, const Dump& found);

struct Material {
  double restitution = 0.3;
  double friction = 0.44;
  double rolling = 0.05;
};

// Box, style and two materials (1 grains, 2 beams, both with the same constants) [SI]; no `timestep`.
std::string preamble(const std::string& region, const Material& material = {});
// The same without the box, for use after read_restart.
std::string materials(const Material& material = {});

// Statements for a chain through these nodes ("x y z"), its segments of this radius; the first node has
// number `first`.
std::string chain(const std::vector<std::string>& nodes, double radius, int first = 0, int number = 0);

}  // namespace footfall::test
