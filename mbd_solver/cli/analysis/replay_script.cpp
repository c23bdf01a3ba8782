#include "mbd_solver/cli/analysis/replay_script.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/output/history.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& line) {
  std::istringstream in(line.substr(0, line.find('#')));
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// Lines of a script, those that end with & joined with the next; files that it includes only where they couple.
std::vector<std::string> logical_lines(const std::string& path, const std::string& here, int depth = 0) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": cannot be read; it is the script of the coupled run");
  std::vector<std::string> lines;
  std::string line, whole;
  while (std::getline(file, line)) {
    const std::size_t end = line.find_last_not_of(" \t\r");
    const bool goes_on = end != std::string::npos && line[end] == '&';
    whole += goes_on ? line.substr(0, end) : line;
    if (goes_on) continue;
    lines.push_back(whole);
    whole.clear();
    const Words words = words_of(lines.back());
    if (words.size() < 2 || words[0] != "include" || depth > 8) continue;
    std::string included = words[1];
    const std::size_t at = included.find("${here}");
    if (at != std::string::npos) included.replace(at, 7, here);
    if (!fs::is_regular_file(included)) continue;
    const std::vector<std::string> more = logical_lines(included, here, depth + 1);
    const auto couples = [](const std::string& l) {
      return l.find("couple/mbd") != std::string::npos || l.find("wall/gran/beam") != std::string::npos;
    };
    if (std::none_of(more.begin(), more.end(), couples)) continue;
    lines.pop_back();
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

using Variables = std::map<std::string, std::string>;

std::string with(std::string line, const std::string& name, const std::string& value) {
  const std::string mark = "${" + name + "}";
  for (std::size_t at = line.find(mark); at != std::string::npos; at = line.find(mark, at + value.size()))
    line.replace(at, mark.size(), value);
  return line;
}

// ${NAME} of every known variable, twice for those that stand in another.
std::string with_all(std::string line, const Variables& variables) {
  for (int pass = 0; pass < 2; ++pass)
    for (const auto& [name, value] : variables) line = with(line, name, value);
  return line;
}

// Lines with their loops over meshes written out,
//   variable NAME index VALUES / label L / lines / next NAME / jump SELF L
// and with the values of variables where they couple. variables: those that the run was given; the script's own join them.
std::vector<std::string> written_out(const std::vector<std::string>& lines, Variables& variables) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Words w = words_of(lines[i]);
    if (w.size() > 3 && w[0] == "variable" && w[2] == "index") {
      std::string value;
      for (std::size_t k = 3; k < w.size(); ++k) value += (k == 3 ? "" : " ") + w[k];
      value.erase(std::remove(value.begin(), value.end(), '"'), value.end());
      variables.emplace(w[1], value);
      const Words label = i + 1 < lines.size() ? words_of(lines[i + 1]) : Words();
      std::size_t end = i + 2;
      if (label.size() > 1 && label[0] == "label")
        while (end < lines.size() && words_of(lines[end]) != Words{"jump", "SELF", label[1]}) ++end;
      if (label.size() > 1 && label[0] == "label" && end < lines.size()) {
        for (const std::string& one : words_of(with_all(variables[w[1]], variables)))
          for (std::size_t k = i + 2; k < end; ++k)
            if (words_of(lines[k]) != Words{"next", w[1]}) out.push_back(with(lines[k], w[1], one));
        i = end;
        continue;
      }
    }
    const bool couples = w.size() > 3 && w[0] == "fix" && w[3] == "couple/mbd";
    out.push_back(couples ? with_all(lines[i], variables) : lines[i]);
  }
  return out;
}

std::string number(double value) { return number_text(value, 15); }

Eigen::Matrix3d rotation(const std::vector<double>& pose) {
  const Eigen::Vector3d r(pose[3], pose[4], pose[5]);
  return r.norm() > 0.0 ? Eigen::AngleAxisd(r.norm(), r.normalized()).toRotationMatrix()
                        : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

// The pose at any time, straight between two recorded ones.
std::vector<double> pose_at(const RecordedMotion& motion, double t) {
  const auto after = std::lower_bound(motion.time.begin(), motion.time.end(), t);
  if (after == motion.time.begin()) return motion.pose.front();
  if (after == motion.time.end()) return motion.pose.back();
  const auto k = static_cast<std::size_t>(after - motion.time.begin());
  const double share = (t - motion.time[k - 1]) / (motion.time[k] - motion.time[k - 1]);
  std::vector<double> pose(6);
  for (std::size_t c = 0; c < 6; ++c) pose[c] = (1.0 - share) * motion.pose[k - 1][c] + share * motion.pose[k][c];
  return pose;
}

// A variable of the script for each of the three velocities and three angular velocities of mesh k.
std::string variable(int mesh, int component) {
  static const char* const kNames[6] = {"vx", "vy", "vz", "wx", "wy", "wz"};
  return "replay" + std::to_string(mesh) + "_" + kNames[component];
}

// One velocity per line and span of `every` steps. Turned by the three movers one after the other, so that the spin
// counts.
void write_velocities(const RecordedMotion& motion, int mesh, double span, int spans, Replay& replay) {
  std::string text[6];
  std::vector<double> before = pose_at(motion, 0.0);
  for (int k = 0; k <= spans; ++k) {  // one line more than is used: `next` after the last span
    const std::vector<double> after = pose_at(motion, (k + 1) * span);
    const Eigen::AngleAxisd turn(rotation(after) * rotation(before).transpose());
    const Eigen::Vector3d spin = turn.angle() * turn.axis() / span;
    for (int c = 0; c < 3; ++c) {
      text[c] += number((after[static_cast<std::size_t>(c)] - before[static_cast<std::size_t>(c)]) / span) + "\n";
      text[3 + c] += number(spin[c]) + "\n";
    }
    before = after;
  }
  for (int c = 0; c < 6; ++c) replay.files[variable(mesh, c) + ".txt"] = text[c];
}

// Takes the place of `fix couple/mbd`.
std::string movers(const Words& coupling, const std::string& motion_folder, const std::string& out, double dt,
                   Replay& replay) {
  std::vector<std::pair<std::string, RecordedMotion>> meshes;
  for (std::size_t i = 5; i + 2 < coupling.size(); ++i)
    if (coupling[i] == "mesh") meshes.emplace_back(coupling[i + 1], read_motion(motion_folder, coupling[i + 2]));
  if (meshes.empty())
    throw InputError("the run moved no mesh of its script; there is nothing that stock LIGGGHTS could replay");
  const std::vector<double>& time = meshes.front().second.time;
  double shortest = time.back();
  for (std::size_t k = 1; k + 1 < time.size(); ++k) shortest = std::min(shortest, time[k] - time[k - 1]);
  replay.steps = static_cast<int>(std::lround(time.back() / dt));
  replay.every = std::max(1, static_cast<int>(std::lround(shortest / dt)));
  const int spans = (replay.steps + replay.every - 1) / replay.every;

  std::ostringstream text;
  text << "# The motion of the coupled run: velocities for every " << replay.every
       << " steps, by the movers that stock LIGGGHTS has.\n";
  std::string forces;
  int mesh = 0;
  for (const auto& [id, motion] : meshes) {
    ++mesh;
    write_velocities(motion, mesh, replay.every * dt, spans, replay);
    for (int c = 0; c < 6; ++c)
      text << "variable " << variable(mesh, c) << " file " << (fs::path(out) / (variable(mesh, c) + ".txt")).string()
           << "\n";
    const std::vector<double>& start = motion.pose.front();
    const std::string move = "fix replay" + std::to_string(mesh);
    text << move << "_move all move/mesh mesh " << id << " linear/variable v_" << variable(mesh, 0) << " v_"
         << variable(mesh, 1) << " v_" << variable(mesh, 2) << "\n";
    const char* const axes[3] = {"1 0 0", "0 1 0", "0 0 1"};
    for (int c = 0; c < 3; ++c)
      text << move << "_turn" << c + 1 << " all move/mesh mesh " << id << " rotate/variable origin " << number(start[0])
           << " " << number(start[1]) << " " << number(start[2]) << " axis " << axes[c] << " omega v_"
           << variable(mesh, 3 + c) << "\n";
    for (int c = 1; c <= 3; ++c) forces += " f_" + id + "[" + std::to_string(c) + "]";
    replay.bodies.push_back(motion.body);
  }
  text << "fix replay_forces all ave/time 1 " << replay.every << " " << replay.every << forces << " file "
       << (fs::path(out) / "forces.txt").string() << "\nvariable replay_mass equal mass(all)";
  return text.str();
}

std::string final_run(const Replay& replay) {
  std::string next = "next";
  for (std::size_t mesh = 1; mesh <= replay.bodies.size(); ++mesh)
    for (int c = 0; c < 6; ++c) next += " " + variable(static_cast<int>(mesh), c);
  return "print \"replay: mass of the grains ${replay_mass}\"\nrun " + std::to_string(replay.steps) +
         " pre no post no every " + std::to_string(replay.every) + " \"" + next + "\"";
}

bool mentions(const std::string& line, const std::vector<std::string>& fixes) {
  return std::any_of(fixes.begin(), fixes.end(),
                     [&](const std::string& id) { return line.find("f_" + id + "[") != std::string::npos; });
}

}  // namespace

RecordedMotion read_motion(const std::string& folder, const std::string& body) {
  const History history = read_history((fs::path(folder) / (body + ".csv")).string());
  RecordedMotion motion;
  motion.body = body;
  motion.time = history.column("time");
  motion.bend = history.column("bend");
  for (std::size_t k = 0; k < motion.time.size(); ++k) {
    std::vector<double>& pose = motion.pose.emplace_back();
    for (const char* name : {"x", "y", "z", "rx", "ry", "rz"}) pose.push_back(history.column(name)[k]);
    std::vector<double>& force = motion.force.emplace_back();
    for (const char* name : {"fx", "fy", "fz"}) force.push_back(history.column(name)[k]);
  }
  if (motion.time.size() < 2)
    throw InputError(folder + "/" + body + ".csv: holds fewer than two windows; there is nothing to replay");
  return motion;
}

std::vector<std::string> recorded_bodies(const std::string& folder) {
  std::vector<std::string> bodies;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".csv") bodies.push_back(entry.path().stem().string());
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

Replay stock_replay(const std::string& script, const std::string& motion, const std::string& out, double dt,
                    Variables variables) {
  Replay replay;
  std::map<std::string, std::string> geometry;  // fix couple/mbd/geometry -> body
  std::vector<std::string> gone;                // ids of fixes that stock LIGGGHTS does not have
  std::ostringstream text;
  text << "# Written by footfall compare: " << script << " for stock LIGGGHTS.\n";
  bool coupled = false;
  for (const std::string& line :
       written_out(logical_lines(script, fs::path(script).parent_path().string()), variables)) {
    Words w = words_of(line);
    const std::string style = w.size() > 3 && w[0] == "fix" ? w[3] : "";
    if (style == "couple/mbd/geometry" && w.size() > 5) {
      geometry[w[1]] = w[5];
    } else if (style.rfind("mesh/surface", 0) == 0) {
      w[3] = "mesh/surface/stress";  // tells the forces
      if (w.size() > 5 && w[4] == "fix" && geometry.count(w[5]) > 0) {
        w[4] = "file";
        w[5] = (fs::path(motion) / (geometry[w[5]] + ".stl")).string();
      }
      text << joined(w, " ") << "\n";
    } else if (style == "couple/mbd") {
      gone.push_back(w[1]);
      coupled = true;
      text << movers(w, motion, out, dt, replay) << "\n";
    } else if (line.find("wall/gran/beam") != std::string::npos) {
      if (!style.empty()) gone.push_back(w[1]);
      const bool has = !style.empty() || (variables.count("beam_count") > 0 && variables.at("beam_count") != "0");
      if (has)
        replay.notes.push_back("fix " + (style.empty() ? "beams" : w[1]) + ": stock LIGGGHTS has no wall of beams");
    } else if (coupled && !w.empty() && w[0] == "run") {
      text << final_run(replay) << "\n";
      break;
    } else if (mentions(line, gone)) {
      if (w[0] != "thermo_style") continue;
      w.erase(std::remove_if(w.begin(), w.end(), [&](const std::string& word) { return mentions(word, gone); }),
              w.end());
      text << joined(w, " ") << "\n";
    } else {
      text << line << "\n";
    }
  }
  if (!coupled)
    throw InputError(script + ": has no line \"fix ID all couple/mbd ...\"; only a coupled run can be replayed");
  replay.script = text.str();
  return replay;
}

}  // namespace footfall
