#include "mbd_solver/cli/analysis/compare_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"
#include "coupler/base/made_files.h"
#include "coupler/base/quote.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/bed_comparison.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/analysis/replay_script.h"
#include "mbd_solver/cli/launch/bed.h"
#include "mbd_solver/cli/launch/liggghts_log.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/launch/script_safety.h"
#include "mbd_solver/cli/launch/script_trace.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/scene/mesh_reader.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

void write(const fs::path& file, const std::string& text) {
  write_whole_file(file.string(), text, "is the disk full?");
}

// The summary of a coupled run that recorded its motion.
Json coupled_summary(const std::string& run) {
  const fs::path summary = fs::path(run) / "summary.json";
  if (!fs::exists(summary))
    throw InputError(run + ": holds no summary.json; expected the folder of a run (footfall run ... --out " + run +
                     ")");
  const Json json = read_summary(summary.string());
  if (!json.contains("dt_dem_s")) throw InputError(run + ": this run touched no grains; there are no beds to compare");
  if (recorded_bodies((fs::path(run) / "motion").string()).empty())
    throw InputError(
        run + ": no motion of a surface was recorded (motion/BODY.csv); only runs with coupled meshes can be compared");
  return json;
}

ComparedRun coupled_run(const std::string& label, const std::string& run, const std::vector<std::string>& bodies) {
  ComparedRun result{label, run, {}};
  for (const std::string& body : bodies) {
    const RecordedMotion motion = read_motion((fs::path(run) / "motion").string(), body);
    ComparedBody& compared = result.bodies.emplace_back();
    compared.time = motion.time;
    for (const std::vector<double>& f : motion.force) compared.force.emplace_back(f[0], f[1], f[2]);
  }
  return result;
}

std::vector<SurfacePath> surfaces_of(const std::string& run, const std::vector<std::string>& bodies) {
  std::vector<SurfacePath> surfaces;
  for (const std::string& body : bodies) {
    const fs::path folder = fs::path(run) / "motion";
    const RecordedMotion motion = read_motion(folder.string(), body);
    SurfacePath& surface = surfaces.emplace_back();
    surface.body = body;
    surface.time = motion.time;
    for (const std::vector<double>& pose : motion.pose) surface.place.emplace_back(pose[0], pose[1], pose[2]);
    for (const Eigen::Vector3d& x : read_mesh((folder / (body + ".stl")).string()).vertices)
      surface.radius = std::max(surface.radius, (x - surface.place.front()).head<2>().norm());
  }
  return surfaces;
}

// forces.txt of fix ave/time: step, then fx fy fz of each body.
ComparedRun stock_run(const fs::path& out, const Replay& replay, double dt) {
  ComparedRun result{"stock", out.string(), std::vector<ComparedBody>(replay.bodies.size())};
  std::ifstream file(out / "forces.txt");
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    double step = 0.0;
    if (line.empty() || line[0] == '#' || !(words >> step)) continue;
    if (step == 0.0) continue;
    for (ComparedBody& body : result.bodies) {
      Eigen::Vector3d f;
      words >> f.x() >> f.y() >> f.z();
      body.time.push_back(step * dt);
      body.force.push_back(f);
    }
    if (!words)
      throw InputError((out / "forces.txt").string() + ": \"" + line +
                       "\": expected a step and three forces for each body");
  }
  if (result.bodies.empty() || result.bodies[0].time.empty())
    throw InputError((out / "forces.txt").string() + ": stock LIGGGHTS wrote no forces");
  return result;
}

void run_stock(const std::string& liggghts, const Json& particles, const fs::path& out, bool quiet) {
  Command command = mpirun();
  command.words.insert(command.words.end(), {"-np", std::to_string(particles.value("ranks", 1)), liggghts, "-in",
                                             (out / "in.stock").string()});
  const std::string script = particles.at("script");
  std::map<std::string, std::string> variables = particles.value("variables", std::map<std::string, std::string>{});
  const std::vector<std::string> rest = script_arguments(script, variables);
  command.words.insert(command.words.end(), rest.begin() + 2, rest.end());  // without -in SCRIPT
  command.words.insert(command.words.end(), {"-var", "out", out.string()});
  const std::string grains = particles.at("grains").is_string() ? particles.at("grains").get<std::string>() : "",
                    ending = ".grains";
  if (grains.size() > ending.size() && grains.compare(grains.size() - ending.size(), ending.size(), ending) == 0)
    command.words.insert(command.words.end(), {"-var", "bed", grains.substr(0, grains.size() - ending.size())});
  command.words.insert(command.words.end(), {"-log", (out / "liggghts.log").string()});
  command.output = (out / "output.txt").string();
  if (!quiet) std::printf("%s\n", shell_line(command).c_str());
  std::fflush(stdout);
  const ChildEnd end = run_child(command);
  const std::string log = (out / "liggghts.log").string();
  if (!liggghts_errors(log).empty())
    throw InputError("stock LIGGGHTS stopped at " + why_liggghts_stopped(log, (out / "in.stock").string(), variables));
  if (end.code != 0)
    throw PartnerError("stock LIGGGHTS ended with code " + std::to_string(end.code) + "; see " + command.output);
}

std::string where_movers_end(const std::string& run, const Replay& replay) {
  double bend = 0.0;
  std::string worst;
  for (const std::string& body : replay.bodies) {
    const RecordedMotion motion = read_motion((fs::path(run) / "motion").string(), body);
    const double most = *std::max_element(motion.bend.begin(), motion.bend.end());
    if (worst.empty() || most > bend) worst = body;
    bend = std::max(bend, most);
  }
  char text[300];
  std::snprintf(text, sizeof text,
                "stock movers turn and shift a mesh, but cannot bend it: nodes were up to %.2g mm (%s) from the rigid "
                "motion that was replayed\n",
                1e3 * bend, worst.c_str());
  std::string all = text;
  for (const std::string& note : replay.notes) all += "left out of the replay: " + note + "\n";
  return all;
}

// Curves of a CSV in pairs, run a as a line, run b as dots; name of the script.
std::string plot_script(const fs::path& folder, const std::string& name, const std::string& data, const std::string& x,
                        const std::string& y, int first, int pairs) {
  std::ostringstream gp;
  gp << "set datafile separator ','\nset datafile columnheaders\nset terminal pngcairo size 900,480 font 'DejaVu "
        "Sans,11'\nset output "
     << gnuplot_text(name + ".png") << "\nset xlabel " << gnuplot_text(x) << "\nset ylabel " << gnuplot_text(y)
     << "\nset grid lc rgb '#e0e0e0'\nset key outside right noenhanced\n"
     << "array c[8] = ['#0072b2','#d55e00','#009e73','#cc79a7','#e69f00','#56b4e9','#f0e442','#000000']\nplot ";
  for (int k = 0; k < pairs; ++k)
    gp << (k > 0 ? ", " : "") << gnuplot_text("../" + data) << " using 1:" << first + 2 * k
       << " with lines lw 1.5 lc rgb c[" << k % 8 + 1 << "] title columnheader(" << first + 2 * k
       << "), '' using 1:" << first + 2 * k + 1 << " with points pt 6 ps 0.5 lc rgb c[" << k % 8 + 1
       << "] title columnheader(" << first + 2 * k + 1 << ")";
  write(folder / (name + ".gp"), gp.str() + "\n");
  return name + ".gp";
}

int compare(const std::string& run, const std::string& other, bool trust_script, bool quiet) {
  const Json summary = coupled_summary(run);
  const double dt = summary.at("dt_dem_s");
  const fs::path out = fs::absolute(fs::path(run) / "compare").lexically_normal();
  // Stock LIGGGHTS will run the script; the summary may come from somebody else.
  if (other.empty() && !trust_script) {
    const Json& particles = summary.at("scene").at("particles");
    demand_safe_script(particles.value("script", ""),
                       particles.value("variables", std::map<std::string, std::string>{}));
  }
  const std::string liggghts = other.empty() ? installed_program("liggghts", "liggghts") : "";  // stock, not ours
  remove_made_files(run, "compare/");
  const MadeFiles made(run);
  make_folder((out / "plots").string(), "is the disk full?");

  std::vector<std::string> bodies;
  ComparedRun second;
  std::string remark;
  if (other.empty()) {
    const std::string motion = fs::absolute(fs::path(run) / "motion").lexically_normal().string();
    const Json& particles = summary.at("scene").at("particles");
    const Replay replay = stock_replay(particles.at("script"), motion, out.string(), dt,
                                       particles.value("variables", std::map<std::string, std::string>{}));
    write(out / "in.stock", replay.script);
    for (const auto& [name, text] : replay.files) write(out / name, text);
    run_stock(liggghts, summary.at("scene").at("particles"), out, quiet);
    bodies = replay.bodies;
    second = stock_run(out, replay, dt);
    remark = where_movers_end(run, replay);
  } else {
    const Json theirs = coupled_summary(other);
    if (theirs.at("dt_dem_s") != summary.at("dt_dem_s"))
      throw InputError(other + ": its grains were moved in steps of " + theirs.at("dt_dem_s").dump() + " s, those of " +
                       run + " in steps of " + summary.at("dt_dem_s").dump() +
                       " s: there are no common steps to compare");
    for (const std::string& body : recorded_bodies((fs::path(run) / "motion").string()))
      if (fs::exists(fs::path(other) / "motion" / (body + ".csv"))) bodies.push_back(body);
    second = coupled_run(other, other, bodies);
  }
  const ComparedRun first = coupled_run(other.empty() ? "coupled" : run, run, bodies);
  const Comparison comparison = compare_beds(first, second, surfaces_of(run, bodies), dt);

  const std::string table = comparison.table + remark;
  write(out / "comparison.txt", table);
  write(out / "beds.csv", comparison.beds);
  write(out / "forces.csv", comparison.forces);
  std::vector<std::string> scripts = {plot_script(out / "plots", "forces", "forces.csv", "time [s]",
                                                  "force of the grains [N]", 2, static_cast<int>(bodies.size()))};
  if (comparison.has_beds) {
    write(out / "profile.csv", comparison.profile);
    scripts.push_back(plot_script(out / "plots", "kinetic_energy", "beds.csv", "time [s]",
                                  "kinetic energy of the grains [J/kg]", 2, 1));
    scripts.push_back(plot_script(out / "plots", "coordination", "beds.csv", "time [s]",
                                  "neighbours nearer than 1 % of the radius", 4, 1));
    scripts.push_back(
        plot_script(out / "plots", "packing", "beds.csv", "time [s]", "solid fraction under the bodies", 6, 1));
    scripts.push_back(plot_script(out / "plots", "displacement", "beds.csv", "time [s]",
                                  "mean displacement of the grains [m]", 8, 1));
    scripts.push_back(
        plot_script(out / "plots", "apart", "beds.csv", "time [s]", "distance of the same grains [m]", 10, 1));
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
