#include "tests/beam/beam_run.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace footfall::test {
namespace {

std::string quoted(const std::string& word) {
  return "'" + word + "'";
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

RunFolder::RunFolder(const std::string& name)
    : path_(std::string(FOOTFALL_BINARY_DIR) + "/tests/beam/runs/" + name) {
  std::filesystem::remove_all(path_);
  std::filesystem::create_directories(path_);
}

void RunFolder::write(const std::string& file, const std::string& text) const {
  std::ofstream out(path(file));
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + path(file));
}

Outcome RunFolder::run(const std::string& command) const {
  // Open MPI refuses root and more ranks than cores unless it is told that both are meant.
  const std::string full =
      "cd " + quoted(path_) +
      " && OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe " + command +
      " > output.txt 2>&1";
  const int status = std::system(full.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(path("output.txt"))};
}

Outcome RunFolder::stock(const std::string& script, int ranks) const {
  write("in.stock", script);
  return run("-np " + std::to_string(ranks) + " liggghts -in in.stock");
}

Outcome RunFolder::coupled(const std::string& script, const std::string& motion, int ranks) const {
  write("in.coupled", script);
  write("motion.txt", motion);
  return run("-np " + std::to_string(ranks) + " " + quoted(LIGGGHTS_MBD) + " -in in.coupled : -np 1 " +
             quoted(BEAM_PARTNER) + " motion.txt loads.csv");
}

Dump RunFolder::dump(const std::string& file) const {
  std::ifstream in(path(file));
  if (!in) throw std::runtime_error("no dump " + path(file) + "\n" + text_of(path("output.txt")));
  Dump dump;
  std::string line;
  Rows* rows = nullptr;
  while (std::getline(in, line)) {
    if (line.rfind("ITEM: TIMESTEP", 0) == 0) {
      std::getline(in, line);
      rows = &dump[std::stol(line)];
      rows->clear();
    } else if (line.rfind("ITEM: ATOMS", 0) == 0) {
      while (in.peek() != 'I' && std::getline(in, line)) {
        std::istringstream numbers(line);
        std::vector<double>& row = rows->emplace_back();
        for (double value; numbers >> value;) row.push_back(value);
      }
      std::sort(rows->begin(), rows->end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
    }
  }
  return dump;
}

Rows RunFolder::loads() const {
  std::ifstream in(path("loads.csv"));
  Rows rows;
  std::string line, word;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::vector<double>& row = rows.emplace_back();
    for (int column = 0; std::getline(words, word, ','); ++column)
      if (column != 1) row.push_back(std::stod(word));
  }
  return rows;
}

std::string dump_command(const std::string& file, int every, const std::string& columns) {
  std::istringstream words(columns);
  std::string format = "%d", word;
  while (words >> word) format += " %.17g";
  return "dump d_" + file + " all custom " + std::to_string(every) + " " + file + " id " + columns +
         "\ndump_modify d_" + file + " format \"" + format + "\"\n";
}

std::string preamble(const std::string& region, int types) {
  const auto each = [types](const std::string& value, int times) {
    std::string text;
    for (int i = 0; i < (times == 2 ? types * types : types); ++i) text += " " + value;
    return text;
  };
  const std::string pair = " peratomtypepair " + std::to_string(types);
  return "atom_style granular\natom_modify map array sort 0 0\nboundary f f f\nnewton off\ncommunicate "
         "single vel yes\nunits si\n"
         "region box block " +
         region + " units box\ncreate_box " + std::to_string(types) +
         " box\nneighbor 0.01 bin\nneigh_modify delay 0\n"
         "fix m1 all property/global youngsModulus peratomtype" +
         each("35e6", 1) + "\nfix m2 all property/global poissonsRatio peratomtype" + each("0.25", 1) +
         "\nfix m3 all property/global coefficientRestitution" + pair + each("0.3", 2) +
         "\nfix m4 all property/global coefficientFriction" + pair + each("0.44", 2) +
         "\nfix m5 all property/global coefficientRollingFriction" + pair + each("0.05", 2) +
         "\nfix m6 all property/global characteristicVelocity scalar 1.0"
         "\nfix m7 all property/global cohesionEnergyDensity" +
         pair + each("2e4", 2) + "\nfix m8 all property/global coefficientRollingViscousDamping" + pair +
         each("0.1", 2) + "\ntimestep 2e-5\n";
}

std::string straight_chain(const std::string& body, const std::vector<std::string>& nodes, double radius) {
  std::ostringstream text;
  text << "body " << body << "\n";
  for (const std::string& node : nodes) text << "node " << node << "\n";
  for (std::size_t i = 1; i < nodes.size(); ++i)
    text << "segment " << i - 1 << " " << i << " " << radius << " 0\n";
  return text.str();
}

}  // namespace footfall::test
