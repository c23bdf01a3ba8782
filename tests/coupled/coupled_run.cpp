#include "tests/coupled/coupled_run.h"

#include <sstream>

namespace footfall::test {
namespace {

constexpr int kLimit = 110;  // of one run [s]; ctest's own is 120

std::string coupled_with(int ranks, const std::string& partner) {
  return "-np " + std::to_string(ranks) + " " + RunFolder::program("liggghts_mbd") + " -in in.coupled : -np 1 " +
         RunFolder::program(partner);
}

}  // namespace

Outcome BeamRun::stock(const std::string& script, int ranks) const {
  write("in.stock", script);
  return alone("liggghts", ranks, "-in in.stock", kLimit);
}

Outcome BeamRun::coupled(const std::string& script, const std::string& motion, int ranks) const {
  write("in.coupled", script);
  write("motion.txt", motion);
  return mpirun(coupled_with(ranks, "scripted_partner motion motion.txt out loads.csv"), kLimit);
}

Outcome BeamRun::scene(const std::string& script, const std::string& scene, int ranks) const {
  write("in.coupled", script);
  write("scene.toml", scene);
  return mpirun(coupled_with(ranks, "mbd_solver scene.toml --out out --quiet"), kLimit);
}

Rows BeamRun::table(const std::string& file) const {
  Rows rows;
  std::istringstream in(read(file));
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != '#') rows.push_back(numbers_of(line));
  return rows;
}

Rows BeamRun::loads() const {
  const Table table(path() / "loads.csv");
  Rows rows(table.rows());
  for (const char* name : {"window", "fx", "fy", "fz", "mx", "my", "mz", "q", "work", "contacts"})
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(table[name][i]);
  return rows;
}

std::string dump_command(const std::string& file, int every, const std::string& columns) {
  std::istringstream words(columns);
  std::string format = "%d", word;
  while (words >> word) format += " %.17g";
  return "dump d_" + file + " all custom " + std::to_string(every) + " " + file + " id " + columns +
         "\ndump_modify d_" + file + " format \"" + format + "\"\n";
}

std::string preamble(const std::string& region, const ContactMaterial& material) {
  return "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel "
         "yes\nunits si\n"
         "region box block " +
         region + " units box\ncreate_box 2 box\nneighbor 0.01 bin\nneigh_modify delay 0\n" + materials(material);
}

std::string materials(const ContactMaterial& material) {
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
