#pragma once
// Runs LIGGGHTS, alone or with the scripted partner, in a folder of its own under the build tree, always with
// a time limit.

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/dem/stl.h"

namespace footfall::test {

struct Outcome {
  int exit_code = -1;  // 124: the time limit struck
  double seconds = 0.0;
  std::string text;  // standard output and error
};

// Columns of a CSV file by name.
class Table {
 public:
  explicit Table(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::string line, word;
    std::getline(in, line);
    std::vector<std::string> names;
    for (std::istringstream words(line); std::getline(words, word, ',');) names.push_back(word);
    while (std::getline(in, line)) {
      std::size_t column = 0;
      for (std::istringstream words(line); std::getline(words, word, ',');)
        columns_[names.at(column++)].push_back(std::stod(word));
    }
  }
  const std::vector<double>& operator[](const std::string& name) const {
    const auto found = columns_.find(name);
    if (found == columns_.end()) throw std::runtime_error("no column " + name);
    return found->second;
  }
  std::size_t rows() const { return columns_.empty() ? 0 : columns_.begin()->second.size(); }
  Eigen::Vector3d vector(std::size_t row, const std::string& x, const std::string& y, const std::string& z) const {
    return {(*this)[x][row], (*this)[y][row], (*this)[z][row]};
  }

 private:
  std::map<std::string, std::vector<double>> columns_;
};

// A clean folder for one test: of this process alone, because ctest runs several tests of one program at
// once.
class RunFolder {
 public:
  explicit RunFolder(const std::string& name)
      : path_(std::filesystem::path(FOOTFALL_BINARY_DIR) / "dem_runs" / (name + "_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  }
  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& file, const std::string& text) const { std::ofstream(path_ / file) << text; }
  std::string read(const std::string& file) const {
    std::ifstream in(path_ / file, std::ios::binary);
    if (!in) throw std::runtime_error("no file " + (path_ / file).string());
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  bool has(const std::string& file) const { return std::filesystem::exists(path_ / file); }

  Outcome command(const std::string& line, int limit_seconds) const {
    const auto start = std::chrono::steady_clock::now();
    const std::string whole = "cd '" + path_.string() + "' && timeout -k 2 " + std::to_string(limit_seconds) + " " +
                              line + " > output.txt 2>&1 < /dev/null";
    const int status = std::system(whole.c_str());
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    outcome.text = read("output.txt");
    return outcome;
  }
  static std::string program(const std::string& name) { return std::string(FOOTFALL_BINARY_DIR) + "/bin/" + name; }
  // Stock LIGGGHTS, or ours without a partner.
  Outcome alone(const std::string& liggghts, int ranks, const std::string& arguments, int limit = 60) const {
    return command("mpirun --oversubscribe -np " + std::to_string(ranks) + " " + liggghts + " " + arguments, limit);
  }
  Outcome coupled(int ranks, const std::string& arguments, const std::string& partner, int limit = 60) const {
    return command("mpirun --oversubscribe -np " + std::to_string(ranks) + " " + program("liggghts_mbd") + " " +
                       arguments + " : -np 1 " + program("scripted_partner") + " " + partner,
                   limit);
  }

 private:
  std::filesystem::path path_;
};

// Stock LIGGGHTS as Debian installs it.
inline const char* const kStock = LIGGGHTS_EXECUTABLE;

// Head of a script: a box, two materials (1 soil, 2 steel), Hertz contact with friction and rolling
// resistance.
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

// A loose bed of about 850 grains of radius 2 cm, a floor at z = 0, gravity: enough for contacts of every
// kind, seconds to run.
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

// Positions of the grains in a dump, by row.
inline std::vector<std::vector<double>> read_dump(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line) && line.rfind("ITEM: ATOMS", 0) != 0) {
  }
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) {
    std::vector<double> row;
    double value = 0.0;
    for (std::istringstream words(line); words >> value;) row.push_back(value);
    rows.push_back(row);
  }
  return rows;
}

// Lines of thermo output in a log file: the words of each line that starts with a step number.
inline std::vector<std::vector<std::string>> thermo_lines(const std::string& log) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(log);
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> words;
    std::istringstream split(line);
    for (std::string word; split >> word;) words.push_back(word);
    if (!words.empty() && words[0] == "Step") {
      inside = true;
    } else if (words.size() > 1 && words[0] == "Loop") {
      inside = false;
    } else if (inside) {
      lines.push_back(words);
    }
  }
  return lines;
}

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace footfall::test
