// Writes a stock script from the run's own one: `fix couple/mbd` becomes velocities per window for stock movers. Then both
// beds are measured at their common steps.
#include "mbd_solver/app/compare_command.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <optional>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/input_file.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/mechanism_shape.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/run_command.h"
#include "mbd_solver/app/run_folder.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/bed/bed_measures.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/bed/script_safety.h"
#include "mbd_solver/launch/confined_programs.h"
#include "mbd_solver/launch/launch_limits.h"
#include "mbd_solver/launch/program_watch.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& line) { return blank_words(std::string_view(line).substr(0, line.find('#'))); }

// Lines of a script, continued ones (&) joined; included files are inserted only if they couple.
std::vector<std::string> logical_lines(const std::string& path, const std::string& here, int depth = 0) {
  TextReader text(path, code::kNoRun, "the script of the coupled run", kLargestText, TextReader::Ends::kNewline);
  std::vector<std::string> lines;
  std::string whole;
  while (text.next()) {
    const std::string& line = text.line();
    const std::size_t end = line.find_last_not_of(" \t\r");
    const bool continued = end != std::string::npos && line[end] == '&';
    whole += continued ? line.substr(0, end) : line;
    if (continued) continue;
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

// Replaces ${NAME} of every known variable, twice for variables within others.
std::string with_all(std::string line, const Variables& variables) {
  for (int pass = 0; pass < 2; ++pass)
    for (const auto& [name, value] : variables) line = with(line, name, value);
  return line;
}

// Writes out loops over meshes,
//   variable NAME index VALUES / label L / lines / next NAME / jump SELF L
// and replaces variables in lines that couple. variables: of the run's command line; the script's are added.
std::vector<std::string> written_out(const std::vector<std::string>& lines, Variables& variables) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Words w = words_of(lines[i]);
    if (w.size() > 3 && w[0] == "variable" && w[2] == "index") {
      std::string value = joined(Words(w.begin() + 3, w.end()), " ");
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

// The pose at any time, linear between two recorded ones.
std::vector<double> pose_at(const RecordedMotion& motion, double t) {
  const auto after = std::lower_bound(motion.time.begin(), motion.time.end(), t);
  if (after == motion.time.begin()) return motion.pose.front();
  if (after == motion.time.end()) return motion.pose.back();
  const std::size_t k = after - motion.time.begin();
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

// One velocity per line and span of `every` steps. The three movers turn the mesh one after the other, with the components
// of the angular velocity.
void write_velocities(const RecordedMotion& motion, int mesh, double span, int spans, Replay& replay) {
  std::string text[6];
  std::vector<double> before = pose_at(motion, 0.0);
  for (int k = 0; k <= spans; ++k) {  // `next` after the last span needs one more line
    const std::vector<double> after = pose_at(motion, (k + 1) * span);
    const Eigen::AngleAxisd turn(rotation_of(after) * rotation_of(before).transpose());
    const Eigen::Vector3d spin = turn.angle() * turn.axis() / span;
    for (int c = 0; c < 3; ++c) {
      text[c] += number((after[c] - before[c]) / span) + "\n";
      text[3 + c] += number(spin[c]) + "\n";
    }
    before = after;
  }
  for (int c = 0; c < 6; ++c) replay.files[variable(mesh, c) + ".txt"] = text[c];
}

// The lines that replace `fix couple/mbd`.
std::string movers(const Words& coupling, const std::string& motion_folder, const std::string& out, double dt,
                   Replay& replay) {
  std::vector<std::pair<std::string, RecordedMotion>> meshes;
  for (std::size_t i = 5; i + 2 < coupling.size(); ++i)
    if (coupling[i] == "mesh") meshes.emplace_back(coupling[i + 1], read_motion(motion_folder, coupling[i + 2]));
  if (meshes.empty())
    throw InputError(code::kNotCoupled, "the run moved no mesh of its script, so stock LIGGGHTS has nothing to replay");
  const std::vector<double>& time = meshes.front().second.time;
  double shortest = time.back();
  for (std::size_t k = 1; k + 1 < time.size(); ++k) shortest = std::min(shortest, time[k] - time[k - 1]);
  replay.steps = static_cast<int>(std::lround(time.back() / dt));
  replay.every = std::max(1, static_cast<int>(std::lround(shortest / dt)));
  const int spans = (replay.steps + replay.every - 1) / replay.every;

  std::ostringstream text;
  text << "# The motion of the coupled run: velocities for every " << replay.every
       << " steps, by the movers of stock LIGGGHTS.\n";
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

Replay stock_replay(const std::string& script, const std::string& motion, const std::string& out, double dt,
                    Variables variables) {
  Replay replay;
  std::map<std::string, std::string> geometry;  // fix couple/mbd/geometry -> body
  std::vector<std::string> gone;                // ids of fixes that are left out
  std::ostringstream text;
  text << "# Written by footfall compare: " << script << " for stock LIGGGHTS.\n";
  const auto counted = [&](const std::string& count) {
    return variables.count(count) > 0 && variables.at(count) != "0";
  };
  const bool flows = counted("source_count") || counted("sink_count");  // of a box by numbers, on the command line
  for (const char* const count : {"source_count", "sink_count"})
    if (flows) text << "variable " << count << " delete\nvariable " << count << " index 0\n";
  if (flows)
    replay.notes.push_back(
        "sources and sinks: stock LIGGGHTS has none of these styles, so its bed keeps the grains of the start");
  bool coupled = false;
  for (const std::string& line :
       written_out(logical_lines(script, fs::path(script).parent_path().string()), variables)) {
    Words w = words_of(line);
    const std::string style = w.size() > 3 && w[0] == "fix" ? w[3] : "";
    if (style == "couple/mbd/geometry" && w.size() > 5) {
      geometry[w[1]] = w[5];
    } else if (style.rfind("mesh/surface", 0) == 0) {
      w[3] = "mesh/surface/stress";  // computes the forces
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
      const bool has = !style.empty() || counted("beam_count");
      if (has) replay.notes.push_back("fix " + (style.empty() ? "beams" : w[1]) + ": stock LIGGGHTS has no beam walls");
    } else if (style == "insert/exact" || style == "remove/region") {
      if (w[1].find("${") == std::string::npos)  // else a loop of the box by numbers, told above
        replay.notes.push_back("fix " + w[1] + ": stock LIGGGHTS has no " + style);
      gone.push_back(w[1]);
    } else if (std::find(w.begin(), w.end(), "bed/follow") != w.end()) {
      if (!style.empty() || (variables.count("follow") > 0 && variables.at("follow") == "1"))
        replay.notes.push_back(
            "fix bed/follow: the bed of stock LIGGGHTS does not follow, and a body that has gone its length meets its "
            "own rut");
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
    throw InputError(code::kNotCoupled,
                     script + ": no line \"fix ID all couple/mbd ...\"; only a coupled run can be replayed");
  replay.script = text.str();
  return replay;
}

namespace {

constexpr double kFirstContact = 0.1;  // span over which impulses are compared [s]
constexpr int kRings = 30;             // of the crater's profile, each as wide as the smallest grain

std::string text(const char* format, ...) {
  char buffer[600];
  va_list words;
  va_start(words, format);
  std::vsnprintf(buffer, sizeof buffer, format, words);
  va_end(words);
  return buffer;
}

double first_contact(const ComparedBody& body) {
  for (std::size_t k = 0; k < body.time.size(); ++k)
    if (body.force[k].norm() > 0.0) return k > 0 ? body.time[k - 1] : body.time[0];
  return std::numeric_limits<double>::infinity();
}

Eigen::Vector3d impulse(const ComparedBody& body, double from, double to) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double before = 0.0;
  for (std::size_t k = 0; k < body.time.size(); ++k) {
    const double begin = std::max(before, from), end = std::min(body.time[k], to);
    if (end > begin) sum += (end - begin) * body.force[k];
    before = body.time[k];
  }
  return sum;
}

double peak(const ComparedBody& body) {
  double largest = 0.0;
  for (const Eigen::Vector3d& f : body.force) largest = std::max(largest, f.norm());
  return largest;
}

Eigen::Vector3d place_at(const SurfacePath& surface, double t) {
  const auto after = std::lower_bound(surface.time.begin(), surface.time.end(), t - 1e-12);
  const std::size_t k =
      std::min<std::ptrdiff_t>(after - surface.time.begin(), static_cast<std::ptrdiff_t>(surface.time.size()) - 1);
  return surface.place[k];
}

double mean_packing(const BedFrame& bed, const std::vector<SurfacePath>& surfaces, double t) {
  double sum = 0.0;
  for (const SurfacePath& surface : surfaces)
    sum += packing_fraction(bed, place_at(surface, t), 0.8 * surface.radius, surface.radius) /
           static_cast<double>(surfaces.size());
  return sum;
}

void compare_forces(const ComparedRun& a, const ComparedRun& b, const std::vector<SurfacePath>& surfaces,
                    Comparison& result) {
  result.table += text("impulse of the grains, first %.2g s of contact\n  %-16s %14s %14s %11s   peak force\n",
                       kFirstContact, "body", a.label.c_str(), b.label.c_str(), "difference");
  Eigen::Vector3d all_a = Eigen::Vector3d::Zero(), all_b = all_a;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const double begin = std::min(first_contact(a.bodies[i]), first_contact(b.bodies[i]));
    const double common = std::min(a.bodies[i].time.back(), b.bodies[i].time.back());
    if (!(begin < common)) {
      result.table += text("  %-16s no contact\n", surfaces[i].body.c_str());
      continue;
    }
    if (begin <= a.bodies[i].time.front()) result.touches_at_start = true;
    const double end = std::min(begin + kFirstContact, common);
    const Eigen::Vector3d J_a = impulse(a.bodies[i], begin, end), J_b = impulse(b.bodies[i], begin, end);
    const double difference = (J_a - J_b).norm() / std::max(J_a.norm(), 1e-300);
    result.worst_impulse = std::max(result.worst_impulse, difference);
    all_a += J_a;
    all_b += J_b;
    result.table += text("  %-16s %10.4g N s %10.4g N s %9.2f %%   %.4g and %.4g N\n", surfaces[i].body.c_str(),
                         J_a.norm(), J_b.norm(), 100.0 * difference, peak(a.bodies[i]), peak(b.bodies[i]));
  }
  if (surfaces.size() > 1 && all_a.norm() > 0.0)
    result.table += text("  %-16s %10.4g N s %10.4g N s %9.2f %%\n", "all bodies", all_a.norm(), all_b.norm(),
                         100.0 * (all_a - all_b).norm() / all_a.norm());
  result.forces = "time";
  for (const SurfacePath& surface : surfaces)
    result.forces += "," + surface.body + " " + a.label + "," + surface.body + " " + b.label;
  result.forces += "\n";
  if (surfaces.empty()) return;
  // At the windows of the first run; of the other run the impulse over each of them.
  double before = 0.0;
  for (std::size_t k = 0; k < a.bodies[0].time.size(); ++k) {
    const double t = a.bodies[0].time[k];
    if (t <= before || t > b.bodies[0].time.back() + 1e-12) continue;
    result.forces += text("%.9g", t);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      result.forces += text(",%.7g,%.7g", impulse(a.bodies[i], before, t).norm() / (t - before),
                            impulse(b.bodies[i], before, t).norm() / (t - before));
    result.forces += "\n";
    before = t;
  }
}

void compare_profiles(const BedFrame& bed_a, const BedFrame& bed_b, const ComparedRun& a, const ComparedRun& b,
                      const SurfacePath& surface, double t, Comparison& result) {
  const double width = 2.0 * *std::min_element(bed_a.radius.begin(), bed_a.radius.end());
  const Eigen::Vector2d centre = place_at(surface, t).head<2>();
  const std::vector<double> p_a = surface_profile(bed_a, centre, width, kRings),
                            p_b = surface_profile(bed_b, centre, width, kRings);
  result.profile = "distance," + a.label + "," + b.label + "\n";
  double sum = 0.0, deepest_a = std::numeric_limits<double>::infinity(), deepest_b = deepest_a;
  int count = 0;
  for (int k = 0; k < kRings; ++k) {
    const double z_a = p_a[k], z_b = p_b[k];
    if (std::isnan(z_a) || std::isnan(z_b)) continue;
    result.profile += text("%.6g,%.6g,%.6g\n", (k + 0.5) * width, z_a, z_b);
    sum += std::abs(z_a - z_b);
    deepest_a = std::min(deepest_a, z_a);
    deepest_b = std::min(deepest_b, z_b);
    ++count;
  }
  if (count > 0)
    result.table += text(
        "crater around %s at %.3g s: lowest ring at %.4g and %.4g m, mean difference of the rings %.2g m (diameter of "
        "the smallest grain %.2g m)\n",
        surface.body.c_str(), t, deepest_a, deepest_b, sum / count, width);
}

}  // namespace

std::string verdict_of(const Comparison& c, double bend) {
  constexpr double kEqual = 1e-3;    // difference of impulses
  constexpr double kScatter = 0.05;  // standard deviation of peak forces between samples of a bed: 4 %
  constexpr double kBent = 0.02;     // of the radius of a grain
  const bool apart = c.first_apart >= 0.0, bent = c.smallest_radius > 0.0 && bend > kBent * c.smallest_radius;
  const std::string size = "the impulses of the first " + number_text(kFirstContact, 2) + " s differ by at most " +
                           number_text(100.0 * c.worst_impulse, 2) + " %";
  std::string causes;
  const auto add = [&](const std::string& cause) { causes += (causes.empty() ? "" : "; ") + cause; };
  if (apart) add("chaos: the first grain differs by a tenth of its radius at " + number_text(c.first_apart, 3) + " s");
  if (bent) add("facets: a mesh bent by up to " + number_text(1e3 * bend, 2) + " mm, which the replay cannot");
  if (c.touches_at_start) add("overlap at the start: a body touches the bed in its first window");
  if (c.worst_impulse <= kEqual && !apart) return "equal: " + size;
  if (c.worst_impulse <= kScatter)
    return "within scatter: " + size + ", no more than two samples of a bed do (" +
           (causes.empty() ? "rounding" : causes) + ")";
  return "differs: " + size + ", more than two samples of a bed do; " +
         (causes.empty() ? "neither chaos, bending nor contact at the start explains it: see where compare/forces.csv "
                           "begins to differ"
                         : "possible cause: " + causes);
}

Comparison compare_beds(const ComparedRun& a, const ComparedRun& b, const std::vector<SurfacePath>& surfaces,
                        double dt) {
  Comparison result;
  compare_forces(a, b, surfaces, result);
  const std::map<long, std::string> frames_a = find_bed_frames(a.frames), frames_b = find_bed_frames(b.frames);
  result.beds = "time";
  for (const char* figure : {"kinetic energy", "coordination number", "packing", "displacement"})
    result.beds += std::string(",") + figure + " " + a.label + "," + figure + " " + b.label;
  result.beds += ",distance median,distance largest,share distant\n";
  BedFrame start_a, start_b, last_a, last_b;
  double last = 0.0, one_in_hundred = -1.0;
  double& first_grain = result.first_apart;
  std::vector<std::string> rows;
  for (const auto& [step, file_a] : frames_a) {
    const auto same = frames_b.find(step);
    if (same == frames_b.end()) continue;
    last_a = read_bed_frame(file_a);
    last_b = read_bed_frame(same->second);
    if (last_a.count() == 0 || last_b.count() == 0) continue;
    if (!result.has_beds) start_a = last_a, start_b = last_b;
    result.has_beds = true;
    const double t = static_cast<double>(step) * dt;
    const Separation apart = separation(last_a, last_b);
    const double numbers[11] = {kinetic_energy(last_a),
                                kinetic_energy(last_b),
                                coordination_number(last_a),
                                coordination_number(last_b),
                                mean_packing(last_a, surfaces, t),
                                mean_packing(last_b, surfaces, t),
                                separation(start_a, last_a).mean,
                                separation(start_b, last_b).mean,
                                apart.median,
                                apart.largest,
                                apart.share_apart};
    result.beds += text("%.9g", t);
    for (const double value : numbers) result.beds += text(",%.7g", value);
    result.beds += "\n";
    rows.push_back(
        text("  %-7.4g %11.4g %11.4g   %9.2g %9.3f\n", t, numbers[0], numbers[1], numbers[8], 100.0 * numbers[10]));
    if (first_grain < 0.0 && apart.share_apart > 0.0) first_grain = t;
    if (one_in_hundred < 0.0 && apart.share_apart > 0.01) one_in_hundred = t;
    last = t;
  }
  if (!result.has_beds) {
    result.table +=
        "the runs have no dumps of grains at a common step, so the beds cannot be compared (dump id x y z vx vy vz "
        "radius)\n";
    return result;
  }
  result.table += text("\nbeds: %s and %s (all measures: beds.csv)\n  %-7s %23s   %s\n  %-7s %23s   %s\n",
                       a.label.c_str(), b.label.c_str(), "time", "kinetic energy", "distance of the same grains", "[s]",
                       "[J/kg]", "median [m], % over r/10");
  // Of many rows some, evenly spread, with the last.
  constexpr std::size_t kMostRows = 10;
  const std::size_t shown = std::min(rows.size(), kMostRows);
  for (std::size_t i = 0; i < shown; ++i)
    result.table += rows[shown == rows.size() ? i : i * (rows.size() - 1) / (shown - 1)];
  result.smallest_radius = *std::min_element(last_a.radius.begin(), last_a.radius.end());
  if (!surfaces.empty()) compare_profiles(last_a, last_b, a, b, surfaces.front(), last, result);
  if (first_grain < 0.0) {
    result.table += text("until %.3g s no grain differs by a tenth of its radius\n", last);
  } else {
    result.table +=
        text("chaos: the first grain differs by a tenth of its radius at %.3g s, one in a hundred ", first_grain);
    result.table += one_in_hundred < 0.0 ? text("not before %.3g s\n", last) : text("at %.3g s\n", one_in_hundred);
  }
  return result;
}

namespace {

void write(const fs::path& file, const std::string& text) {
  write_whole_file(file.string(), text, "is the disk full?");
}

// The summary of a coupled run with recorded motion.
Json coupled_summary(const std::string& run) {
  const fs::path summary = fs::path(run) / "summary.json";
  if (!fs::exists(summary))
    throw InputError(code::kNoRun, without_summary(run, "no summary.json; expected the folder of a run"));
  const Json json = read_summary(summary.string());
  if (!json.contains("dt_dem_s")) throw InputError(code::kNotCoupled, run + ": a run without grains has no bed");
  if (recorded_bodies((fs::path(run) / "motion").string()).empty())
    throw InputError(code::kNotCoupled, run +
                                            ": no recorded motion of a surface (motion/BODY.csv); only runs with "
                                            "coupled meshes can be compared");
  return json;
}

// A coupled run from its recorded motion; `surfaces`, unless null: the paths of its coupled surfaces.
ComparedRun coupled_run(const std::string& label, const std::string& run, const std::vector<std::string>& bodies,
                        std::vector<SurfacePath>* surfaces) {
  ComparedRun result{label, run, {}};
  const fs::path folder = fs::path(run) / "motion";
  for (const std::string& body : bodies) {
    const RecordedMotion motion = read_motion(folder.string(), body);
    ComparedBody& compared = result.bodies.emplace_back();
    compared.time = motion.time;
    for (const std::vector<double>& f : motion.force) compared.force.emplace_back(f[0], f[1], f[2]);
    if (surfaces == nullptr) continue;
    SurfacePath& surface = surfaces->emplace_back(SurfacePath{body, 0.0, motion.time, {}});
    for (const std::vector<double>& pose : motion.pose) surface.place.emplace_back(pose[0], pose[1], pose[2]);
    for (const Eigen::Vector3d& x : read_mesh((folder / (body + ".stl")).string()).vertices)
      surface.radius = std::max(surface.radius, (x - surface.place.front()).head<2>().norm());
  }
  return result;
}

// forces.txt of fix ave/time: step, then fx fy fz of each body.
ComparedRun stock_run(const fs::path& out, std::size_t bodies, double dt) {
  ComparedRun result{"stock", out.string(), std::vector<ComparedBody>(bodies)};
  CsvReader csv((out / "forces.txt").string(), "the forces of stock LIGGGHTS", CsvReader::Separators::kAny);
  while (csv.next()) {
    csv.require_width(1 + 3 * bodies);
    if (csv.number(0) == 0.0) continue;
    for (std::size_t i = 0; i < bodies; ++i) {
      result.bodies[i].time.push_back(csv.number(0) * dt);
      result.bodies[i].force.emplace_back(csv.number(3 * i + 1), csv.number(3 * i + 2), csv.number(3 * i + 3));
    }
  }
  if (result.bodies.empty() || result.bodies[0].time.empty())
    throw InputError(code::kReplayFailed, (out / "forces.txt").string() + ": stock LIGGGHTS wrote no forces");
  return result;
}

// A folder for the shared memory of one MPI job, gone with it: the only place in /dev/shm that it may write to.
class SharedMemoryFolder {
 public:
  explicit SharedMemoryFolder(Command& mpirun) {
    if (::mkdtemp(folder_.data()) == nullptr) folder_.clear();
    if (!folder_.empty()) mpirun.environment["OMPI_MCA_btl_vader_backing_directory"] = folder_;
  }
  ~SharedMemoryFolder() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  SharedMemoryFolder(const SharedMemoryFolder&) = delete;
  SharedMemoryFolder& operator=(const SharedMemoryFolder&) = delete;

 private:
  std::string folder_ = "/dev/shm/footfall-XXXXXX";
};

// coupling.timeout of the run [s].
double time_limit(const Json& summary) {
  const Json coupling = summary.at("scene").value("coupling", Json::object());
  return coupling.value("timeout", CouplingSpec().timeout);
}

void run_stock(const std::string& liggghts, const Json& particles, const fs::path& out, bool trusted, double limit,
               bool quiet) {
  require_room_to_launch(particles.value("ranks", 1));
  const std::string script = particles.at("script");
  const Variables variables = particles.value("variables", Variables());
  const std::vector<std::string> rest = script_arguments(script, variables);
  std::vector<std::string> words = {"-in", (out / "in.stock").string()};
  words.insert(words.end(), rest.begin() + 2, rest.end());  // without -in SCRIPT
  words.insert(words.end(), {"-var", "out", short_path(out.string())});
  const std::string grains = particles.at("grains").is_string() ? particles.at("grains").get<std::string>() : "";
  constexpr const char* kEnding = ".grains";
  if (ends_with(grains, kEnding))
    words.insert(words.end(), {"-var", "bed", grains.substr(0, grains.size() - std::strlen(kEnding))});
  words.insert(words.end(), {"-log", (out / "liggghts.log").string()});

  Command command = mpirun();
  const int ranks = particles.value("ranks", 1);
  if (trusted) {
    add_program(command, ranks, liggghts, words);
  } else {
    words.insert(words.begin(), {"confined", liggghts});
    add_program(command, ranks, built_program("footfall"), words);
    command.rights.add(liggghts);
  }
  command.output = (out / "output.txt").string();
  if (!quiet) std::printf("%s\n", shell_line(command).c_str());
  std::fflush(stdout);
  limit_script(command, trusted, {out.string()});
  std::optional<SharedMemoryFolder> memory;
  if (!trusted) memory.emplace(command);
  const std::string log = (out / "liggghts.log").string();
  ProgramWatch progress(limit, out.string(), "", log);
  const ChildEnd end = run_child(command, "", [&] { return progress(); });
  if (!end.given_up.empty()) throw PartnerError("stock LIGGGHTS: " + end.given_up);
  if (!liggghts_errors(log).empty())
    throw InputError(code::kReplayFailed,
                     "stock LIGGGHTS stopped at " + why_liggghts_stopped(log, (out / "in.stock").string(), variables));
  if (end.code != 0)
    throw PartnerError(code::kReplayFailed,
                       "stock LIGGGHTS ended with exit code " + std::to_string(end.code) + "; see " + command.output);
}

// bend: the largest distance of a node from the motion that was replayed [m].
std::string limits_of_replay(const std::string& run, const Replay& replay, double& bend) {
  std::string worst;
  for (const std::string& body : replay.bodies) {
    const RecordedMotion motion = read_motion((fs::path(run) / "motion").string(), body);
    const double most = *std::max_element(motion.bend.begin(), motion.bend.end());
    if (worst.empty() || most > bend) worst = body;
    bend = std::max(bend, most);
  }
  std::string all =
      text("stock movers cannot bend a mesh: nodes were up to %.2g mm (%s) from the replayed rigid motion\n",
           1e3 * bend, worst.c_str());
  for (const std::string& note : replay.notes) all += "left out of the replay: " + note + "\n";
  return all;
}

// Draws columns of a CSV file in pairs, run a as a line, run b as dots. Returns the name of the script.
std::string plot_script(const fs::path& folder, const std::string& name, const std::string& data, const std::string& x,
                        const std::string& y, int first, int pairs) {
  std::ostringstream gp;
  gp << "set xlabel " << gnuplot_text(x) << "\nset ylabel " << gnuplot_text(y)
     << "\nset grid lc rgb '#e0e0e0'\nset key outside right noenhanced\n"
     << "array c[8] = ['#0072b2','#d55e00','#009e73','#cc79a7','#e69f00','#56b4e9','#f0e442','#000000']\nplot ";
  for (int k = 0; k < pairs; ++k)
    gp << (k > 0 ? ", " : "") << gnuplot_text("../" + data) << " using 1:" << first + 2 * k
       << " with lines lw 1.5 lc rgb c[" << k % 8 + 1 << "] title columnheader(" << first + 2 * k
       << "), '' using 1:" << first + 2 * k + 1 << " with points pt 6 ps 0.5 lc rgb c[" << k % 8 + 1
       << "] title columnheader(" << first + 2 * k + 1 << ")";
  return write_drawing(folder.string(), name, {900, 480}, csv_setup(), gp.str() + "\n");
}

int compare(const std::string& run, const std::string& other, bool trust_script, bool quiet) {
  const Json summary = coupled_summary(run);
  const double dt = summary.at("dt_dem_s");
  const fs::path out = fs::absolute(fs::path(run) / "compare").lexically_normal();
  if (other.empty()) {
    const Json& particles = summary.at("scene").at("particles");
    const std::string script = particles.value("script", "");
    require_one_word("the folder of the comparison", short_path(out.string()));
    require_one_word("the script of the run", short_path(script));
    if (!trust_script) require_safe_script(script, particles.value("variables", Variables()), {"out", "here"});
  }
  const std::string liggghts = other.empty() ? installed_program("liggghts", "liggghts") : "";
  std::error_code ignored;
  fs::remove_all(out, ignored);
  make_folder((out / "plots").string(), "is the disk full?");

  std::vector<std::string> bodies;
  ComparedRun second;
  std::string remark;
  double bend = 0.0;
  if (other.empty()) {
    const std::string motion = short_path((fs::path(run) / "motion").string());
    const Json& particles = summary.at("scene").at("particles");
    const Replay replay = stock_replay(particles.at("script"), motion, short_path(out.string()), dt,
                                       particles.value("variables", Variables()));
    write(out / "in.stock", replay.script);
    for (const auto& [name, text] : replay.files) write(out / name, text);
    run_stock(liggghts, particles, out, trust_script, time_limit(summary), quiet);
    bodies = replay.bodies;
    second = stock_run(out, bodies.size(), dt);
    remark = limits_of_replay(run, replay, bend);
  } else {
    const Json theirs = coupled_summary(other);
    if (theirs.at("dt_dem_s") != summary.at("dt_dem_s"))
      throw InputError(code::kNotComparable, other + ": DEM time step " + theirs.at("dt_dem_s").dump() + " s, but " +
                                                 run + " has " + summary.at("dt_dem_s").dump() +
                                                 " s; the runs have no common steps");
    for (const std::string& body : recorded_bodies((fs::path(run) / "motion").string()))
      if (fs::exists(fs::path(other) / "motion" / (body + ".csv"))) bodies.push_back(body);
    second = coupled_run(other, other, bodies, nullptr);
  }
  std::vector<SurfacePath> surfaces;
  const ComparedRun first = coupled_run(other.empty() ? "coupled" : run, run, bodies, &surfaces);
  const Comparison comparison = compare_beds(first, second, surfaces, dt);

  const std::string table = "verdict: " + verdict_of(comparison, bend) + "\n" + comparison.table + remark;
  write(out / "comparison.txt", table);
  write(out / "beds.csv", comparison.beds);
  write(out / "forces.csv", comparison.forces);
  std::vector<std::string> scripts = {plot_script(out / "plots", "forces", "forces.csv", "time [s]",
                                                  "force of the grains [N]", 2, static_cast<int>(bodies.size()))};
  if (comparison.has_beds) {
    write(out / "profile.csv", comparison.profile);
    struct Plot {
      const char *name, *axis;
      int column;
    };
    constexpr Plot kPlots[] = {{"kinetic_energy", "kinetic energy of the grains [J/kg]", 2},
                               {"coordination", "neighbours with a gap below 1 % of the radius", 4},
                               {"packing", "solid fraction under the bodies", 6},
                               {"displacement", "mean displacement of the grains [m]", 8},
                               {"distance", "distance of the same grains [m]", 10}};
    for (const Plot& plot : kPlots)
      scripts.push_back(plot_script(out / "plots", plot.name, "beds.csv", "time [s]", plot.axis, plot.column, 1));
    scripts.push_back(plot_script(out / "plots", "crater", "profile.csv", "distance from the body [m]",
                                  "height of the surface [m]", 2, 1));
  }
  const std::vector<std::string> pictures = run_gnuplot((out / "plots").string(), scripts);
  if (!quiet) {
    std::printf("\n%sFiles: %s\n", table.c_str(), short_path((out / "comparison.txt").string()).c_str());
    for (const char* name : {"beds.csv", "forces.csv", "profile.csv", "in.stock"})
      if (fs::exists(out / name)) std::printf("       %s\n", short_path((out / name).string()).c_str());
    for (const std::string& picture : pictures) std::printf("       %s\n", short_path(picture).c_str());
  }
  return kExitDone;
}

}  // namespace

int compare_command(const std::string& run, const std::string& other, bool trust_script, bool quiet) {
  return with_summary_of(run, [&] { return compare(run, other, trust_script, quiet); });
}

}  // namespace footfall
