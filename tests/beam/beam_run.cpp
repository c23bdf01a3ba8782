#include "tests/beam/beam_run.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace footfall::test {
namespace {

std::string quoted(const std::string& word) { return "'" + word + "'"; }

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

RunFolder::RunFolder(const std::string& name) : path_(std::string(FOOTFALL_BINARY_DIR) + "/tests/beam/runs/" + name) {
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
  const std::string full = "cd " + quoted(path_) +
                           " && OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe " +
                           command + " > output.txt 2>&1";
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

Outcome RunFolder::scene(const std::string& script, const std::string& scene, int ranks) const {
  write("in.coupled", script);
  write("scene.toml", scene);
  return run("-np " + std::to_string(ranks) + " " + quoted(LIGGGHTS_MBD) + " -in in.coupled : -np 1 " +
             quoted(MBD_SOLVER) + " scene.toml --out out --quiet");
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

Rows RunFolder::table(const std::string& file) const {
  std::ifstream in(path(file));
  Rows rows;
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream numbers(line);
    std::vector<double>& row = rows.emplace_back();
    for (double value; numbers >> value;) row.push_back(value);
  }
  return rows;
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

double relative_difference(const Dump& expected, const Dump& found) {
  const double different = std::numeric_limits<double>::infinity();
  std::vector<double> largest;  // of each column
  for (const auto& [step, rows] : expected)
    for (const auto& row : rows) {
      largest.resize(row.size(), 0.0);
      for (std::size_t k = 0; k < row.size(); ++k) largest[k] = std::max(largest[k], std::abs(row[k]));
    }
  double worst = 0.0;
  if (found.size() != expected.size()) return different;
  for (const auto& [step, rows] : expected) {
    const auto same_step = found.find(step);
    if (same_step == found.end() || same_step->second.size() != rows.size()) return different;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::vector<double>& row = same_step->second[i];
      if (row.size() != rows[i].size() || row[0] != rows[i][0]) return different;
      for (std::size_t k = 1; k < row.size(); ++k) {
        const double difference = std::abs(row[k] - rows[i][k]);
        if (difference != 0.0) worst = std::max(worst, difference / largest[k]);
      }
    }
  }
  return worst;
}

std::string dump_command(const std::string& file, int every, const std::string& columns) {
  std::istringstream words(columns);
  std::string format = "%d", word;
  while (words >> word) format += " %.17g";
  return "dump d_" + file + " all custom " + std::to_string(every) + " " + file + " id " + columns +
         "\ndump_modify d_" + file + " format \"" + format + "\"\n";
}

std::string preamble(const std::string& region, const Material& material) {
  return "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel "
         "yes\nunits si\n"
         "region box block " +
         region + " units box\ncreate_box 2 box\nneighbor 0.01 bin\nneigh_modify delay 0\n" + materials(material);
}

std::string materials(const Material& material) {
  const auto pairs = [](const std::string& name, double value) {
    std::string line = " all property/global " + name + " peratomtypepair 2";
    for (int i = 0; i < 4; ++i) line += " " + std::to_string(value);
    return line + "\n";
  };
  return "fix m1 all property/global youngsModulus peratomtype 35e6 35e6\n"
         "fix m2 all property/global poissonsRatio peratomtype 0.25 0.25\n"
         "fix m3" +
         pairs("coefficientRestitution", material.restitution) + "fix m4" +
         pairs("coefficientFriction", material.friction) + "fix m5" +
         pairs("coefficientRollingFriction", material.rolling) +
         "fix m6 all property/global characteristicVelocity scalar 1.0\n"
         "fix m7" +
         pairs("cohesionEnergyDensity", 2e4) + "fix m8" + pairs("coefficientRollingViscousDamping", 0.1);
}

std::string chain(const std::vector<std::string>& nodes, double radius, int first, int number) {
  std::ostringstream text;
  for (const std::string& node : nodes) text << "node " << node << "\n";
  for (int i = first; i + 1 < first + static_cast<int>(nodes.size()); ++i)
    text << "segment " << i << " " << i + 1 << " " << radius << " " << number << "\n";
  return text.str();
}

}  // namespace footfall::test
