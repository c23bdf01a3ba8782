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

  // What `dump ... custom` wrote, sorted by id.
  Dump dump(const std::string& file) const;
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

// Box, style, and materials that stiff and soft tests share: grains and walls of type 1 and 2 [SI].
std::string preamble(const std::string& region, int types = 2);

// `count` statements for a chain along a straight line: nodes, segments of this radius.
std::string straight_chain(const std::string& body, const std::vector<std::string>& nodes, double radius);

}  // namespace footfall::test
