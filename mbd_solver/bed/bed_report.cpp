// Reports about grains before a run: numbers of [particles.box], or what the text of a LIGGGHTS script states.
#include "mbd_solver/bed/bed_report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>

#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/assemble/grain_dump.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/bed/bed.h"
#include "mbd_solver/bed/bed_measures.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/grains/bed_parts.h"
#include "mbd_solver/scene/grains/grain_sizes.h"
#include "mbd_solver/scene/particle_script.h"

namespace footfall {
namespace fs = std::filesystem;

namespace {

constexpr double kLargeOverlap = 0.05;  // the limit of the run's warning [of the radius]

constexpr double kFewGrains = 200.0;  // per rank

// An estimate with two digits: 1583 -> "1600".
std::string round_count(double count) {
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(count)) - 1.0));
  return std::to_string(std::lround(count / unit) * std::lround(unit));
}

// Ranks exchange the grains at their borders in every step.
std::string ranks_text(double grains, int ranks) {
  if (ranks < 2 || grains >= kFewGrains * ranks) return "";
  const int better = std::max(1, static_cast<int>(grains / kFewGrains));
  return "  warning: " +
         with_code(code::kFewGrainsPerRank, "about ", round_count(grains), " grains on ", ranks,
                   " ranks are few: ranks wait for each other more than they save. Set particles.ranks = ", better) +
         "\n";
}

// Share of each sphere's volume that counts: overlaps within a clump count once [-].
std::vector<double> own_shares(const std::vector<GrainPlace>& spheres, const BoxSpec& box) {
  std::map<int, int> size;  // of each clump
  for (const GrainPlace& sphere : spheres) ++size[sphere.clump];
  std::vector<double> shares;
  for (const GrainPlace& sphere : spheres) {
    double share = 1.0, nearest = std::numeric_limits<double>::infinity();
    for (const double radius : all_radii(box))
      for (const std::string& name : box.clumps) {
        const Clump clump = clump_of(clump_shape(name), radius);
        const double away = std::abs(clump.radius - sphere.radius);
        if (clump.centres.cols() != size[sphere.clump] || away >= nearest) continue;
        nearest = away;
        share =
            clump.volume / (static_cast<double>(clump.centres.cols()) * 4.0 / 3.0 * kPi * std::pow(clump.radius, 3));
      }
    shares.push_back(share);
  }
  return shares;
}

// Share of the slab between two heights that grains fill [-].
double solid_fraction(const std::vector<GrainPlace>& grains, const std::vector<double>& shares, double low, double high,
                      double area) {
  double volume = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const GrainPlace& grain = grains[i];
    const double r = grain.radius;
    const double a = std::max(low - grain.centre.z(), -r), b = std::min(high - grain.centre.z(), r);
    if (b > a) volume += shares[i] * kPi * (r * r * (b - a) - (b * b * b - a * a * a) / 3.0);
  }
  return volume / (area * (high - low));
}

constexpr const char* kNotMade = "  the bed is not made yet; the first run makes it and stores it in the cache";

// Largest time steps for errors of means below 5 % and 1 %, as shares of the Rayleigh time, half of them of the Hertz time: the
// worst of six figures of pads on five samples of a bed, restitution 0.1, rolling friction cdt (docs/data/landing_errors.txt).
constexpr double kStepForFivePercent = 0.11, kStepForOnePercent = 0.065;

// `hertz`: infinite where no speed is known [s].
std::string step_proposal(double rayleigh, double hertz) {
  const double whole = std::min(rayleigh, 0.5 * hertz);
  return concat("; DEM step for 5 % error: ", rounded_down(kStepForFivePercent * whole),
                " s, for 1 %: ", rounded_down(kStepForOnePercent * whole), " s");
}

// ", mean speed 3e-05 m/s", where the file of the bed has speeds.
std::string speed_text(const std::vector<GrainPlace>& grains) {
  double sum = 0.0;
  for (const GrainPlace& grain : grains) sum += grain.speed;
  return sum < 0.0 ? "" : ", mean speed " + number_text(sum / static_cast<double>(grains.size()), 2) + " m/s";
}

std::string made_bed(const Scene& scene, const std::string& folder) {
  const BoxSpec& box = *scene.particles->box;
  if (!bed_is_made(folder)) return concat(kNotMade, "\n");
  const std::vector<GrainPlace> grains = read_grains((fs::path(folder) / kBedGrains).string());
  const double floor = box_floor(scene);
  double highest = floor;
  for (const GrainPlace& grain : grains) highest = std::max(highest, grain.centre.z() + grain.radius);
  const double inner = solid_fraction(grains, own_shares(grains, box), floor + 0.25 * box.depth,
                                      floor + 0.75 * box.depth, box.size[0] * box.size[1]);
  const BedContacts contacts = bed_contacts(grains);
  const std::size_t count = count_grains(grains);
  const std::string what = box.clumps.empty() ? " grains" : concat(" clumps of ", grains.size(), " spheres");
  std::string text = concat("  the bed is made: ", count, what, ", the highest reaches z = ", number_text(highest, 3),
                            " m, solid fraction ", number_text(inner, 2), " in its middle half");
  if (contacts.coordination > 0.0)
    text += ", " + number_text(contacts.coordination, 2) + " contacts per " + (box.clumps.empty() ? "grain" : "clump");
  text += ", overlaps up to " + share_text(contacts.largest_overlap) + " of the radius" + speed_text(grains) + "\n";
  if (contacts.largest_overlap > kLargeOverlap)
    text += "  warning: " +
            with_code(code::kBedOverlaps, "grains at rest overlap by more than ", share_text(kLargeOverlap),
                      " of their radius, the limit of their contact law: increase material.young (the time step falls "
                      "with its square root)") +
            "\n";
  return text + "  " + short_path(folder) + "\n";
}

// "surface at z = 0", or of a terrain.
std::string surface_text(const Scene& scene) {
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  if (!bed) return "surface at z = 0";
  const std::string rocks = bed->rocks.size() == 1 ? ", 1 rock" : concat(", ", bed->rocks.size(), " rocks");
  return "surface from z = " + number_text(bed->low, 3) + " to " + number_text(bed->high, 3) + " m, up to " +
         number_text(steepest_of_bed(scene) * 180.0 / kPi, 3) + " degrees steep" + (bed->rocks.empty() ? "" : rocks);
}

std::string clumps_text(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  std::vector<std::string> shapes;
  for (const std::string& name : box.clumps) {
    const Clump clump = clump_of(clump_shape(name), box.radius.front());
    shapes.push_back(
        concat(name, " (", clump.centres.cols(), " spheres of radius ", number_text(clump.radius, 3), " m)"));
  }
  const std::string rolling(name_of(rolling_model_of(scene)));
  return "  clumps: " + joined(shapes) +
         "; a clump has the mass of a sphere of its radius; rolling friction: " + rolling + "\n";
}

// "0.006 and 0.008", "0.006, 0.008 and 0.01", "0.0042 to 0.012 (5 radii)".
std::string sizes_text(const GrainSizesSpec& sizes) {
  constexpr std::size_t kListed = 3;
  const auto text = [](double radius) { return number_text(radius, 4); };
  const std::size_t n = sizes.radius.size();
  if (n > kListed) {
    const auto [least, most] = std::minmax_element(sizes.radius.begin(), sizes.radius.end());
    return concat(text(*least), " to ", text(*most), " (", n, " radii)");
  }
  std::string list = n < 2 ? number_text(sizes.radius.front()) : "";
  for (std::size_t i = 0; n > 1 && i < n; ++i)
    list += (i == 0      ? ""
             : i + 1 < n ? ", "
                         : " and ") +
            (n == 2 ? number_text(sizes.radius[i]) : text(sizes.radius[i]));
  return list;
}

std::string zone_text(const Scene& scene, const GrainZoneSpec& zone) {
  const std::size_t blocks = zone_places(scene, zone).size();
  std::string where;
  if (!zone.under.empty()) where = " under " + joined(zone.under);
  return concat("  zone", where, ": ", blocks > 1 ? concat(blocks, " blocks of ") : "", zone.size[0], " x ",
                zone.size[1], " m, ", zone.depth, " m deep, of radius ", sizes_text(zone), " m\n");
}

// A mesh drawn in millimetres and read in metres is larger than any body on a box of grains.
std::string in_millimetres(const Eigen::Matrix3Xd& x) {
  constexpr double kTooLarge = 20.0;  // [m]
  const double size = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
  if (size < kTooLarge) return "";
  return ". The body measures " + number_text(size, 3) + " m: set scale = 0.001 if its mesh is drawn in millimetres";
}

std::string toml_table(const std::map<std::string, std::string>& variables) {
  std::string text;
  for (const auto& [name, value] : variables) text += name + " = \"" + value + "\"\n";
  return text;
}

// Values in the text of the scripts; of several commands of a kind the last one counts, as in LIGGGHTS.
struct ScriptValues {
  std::optional<double> young, poisson;  // of the first type: [Pa], [-]
  std::optional<double> step;            // [s]
  std::string every;                     // DEM steps per window, as written
  double density = 0.0;                  // smallest of the particle templates [kg/m3]; 0: not given
  double smallest = 0.0, largest = 0.0;  // radii of the particle templates [m]; 0: not given
};

void read_template(const std::vector<std::string>& words, ScriptValues& values) {
  for (std::size_t i = 4; i + 2 < words.size(); ++i) {
    if (words[i + 1] != "constant") continue;
    const std::optional<double> value = as_number(words[i + 2]);
    if (!value || !(*value > 0.0)) continue;
    if (words[i] == "density") values.density = values.density > 0.0 ? std::min(values.density, *value) : *value;
    if (words[i] != "radius") continue;
    values.smallest = values.smallest > 0.0 ? std::min(values.smallest, *value) : *value;
    values.largest = std::max(values.largest, *value);
  }
}

void read_script(const std::string& file, const std::map<std::string, std::string>& variables, ScriptValues& values) {
  const ScriptText script(file, variables);
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] == "timestep" && w.size() > 1) values.step = command.conditional ? std::nullopt : as_number(w[1]);
    if (w[0] != "fix" || w.size() < 6) continue;
    if (w[3] == "property/global" && w.size() > 6 && w[5] == "peratomtype") {
      if (w[4] == "youngsModulus") values.young = as_number(w[6]);
      if (w[4] == "poissonsRatio") values.poisson = as_number(w[6]);
    }
    if (w[3].rfind("particletemplate/", 0) == 0) read_template(w, values);
    if (w[3] == "couple/mbd" && w[4] == "every") values.every = w[5];
  }
}

// "0.02 m", "0.02 to 0.04 m".
std::string radii_text(double smallest, double largest) {
  return number_text(smallest, 3) + (largest > smallest ? " to " + number_text(largest, 3) : "") + " m";
}

std::string step_text(const ScriptValues& values, double speed) {
  if (!values.step) return "";
  std::string text = concat("  time step: ", *values.step, " s");
  if (values.young && values.poisson && values.density > 0.0 && values.smallest > 0.0) {
    const ElasticGrain grain = {values.smallest, values.density, *values.young, *values.poisson};
    text += ", " + share_text(*values.step / rayleigh_time(grain)) + " of the Rayleigh time";
    double hertz = std::numeric_limits<double>::infinity();
    if (speed > 0.0) {
      hertz = hertz_time(grain, speed);
      text += ", " + share_text(*values.step / hertz) + " of the Hertz time at " + number_text(speed, 3) + " m/s";
    }
    text += step_proposal(rayleigh_time(grain), hertz);
  }
  if (!values.every.empty() && values.every.front() != '$')
    text += "; window: " + (values.every == "auto" ? "chosen during the run" : values.every + " steps");
  return text + "\n";
}

}  // namespace

std::string box_report(const Scene& scene) {
  const ParticlesSpec& particles = *scene.particles;
  const BoxSpec& box = *particles.box;
  const BoxNumbers n = box_numbers(scene);
  std::string text = concat("Bed: ", box.size[0], " x ", box.size[1], " m, ", box.depth,
                            " m deep: floor at z = ", box_floor(scene), " m, ", surface_text(scene), "; about ",
                            round_count(n.grains), " grains of radius ", sizes_text(box), " m\n");
  for (const GrainZoneSpec& zone : box.zones) text += zone_text(scene, zone);
  if (!box.clumps.empty()) text += clumps_text(scene);
  text += concat("  space for bodies: ", n.headroom, " m above the surface, ",
                 box.periodic ? "periodic along x and y\n" : concat(n.margin, " m around the walls\n"));
  if (!box.follow.empty()) {
    std::string slab;
    for (int axis = 0; axis < 2; ++axis)
      if (follows_along(box, axis))
        slab += (slab.empty() ? "" : " and ") + number_text(0.1 * box.size[axis], 3) + " m along " + "xy"[axis];
    text += "  follows body \"" + box.follow + "\" in steps of " + slab + ": at least " +
            number_text(follow_distance(box), 3) + " m of fresh bed from its origin on\n";
  }
  if (!box.walls) text += "  the run has no floor and no walls of its own: bodies of the scene take their place\n";
  text += concat("  time step: ", n.time_step, " s, ", share_text(n.time_step / n.rayleigh), " of the Rayleigh time, ",
                 share_text(n.time_step / n.hertz), " of the Hertz time", step_proposal(n.rayleigh, n.hertz),
                 "; window: ", box.every ? concat(*box.every, " steps\n") : "chosen during the run\n");
  return text + ranks_text(n.grains, particles.ranks) + made_bed(scene, bed_folder(*particles.bed));
}

void require_inside_box(const Scene& scene, const Mechanism& mechanism) {
  if (!scene.touches_particles() || !scene.particles->box) return;
  const BoxSpec& box = *scene.particles->box;
  const BoxNumbers n = box_numbers(scene);
  constexpr double kTolerance = 1e-6;  // of the box
  const std::optional<TerrainBed> terrain = terrain_bed(scene);
  const double roof = n.headroom + (terrain ? terrain->high : 0.0);
  // What is moved to a clearance is moved as a whole: another body may be the lowest one.
  const int lowest = mechanism.placement.lowest;
  const std::string lowest_name = lowest < 0 ? "" : mechanism.boundaries[lowest].boundary.name();
  const auto lifted = [&](const std::string& name) {
    if (!scene.initial.clearance || lowest_name.empty() || lowest_name == name) return std::string();
    return ". Its height follows from initial.clearance of body \"" + lowest_name + "\", the lowest one";
  };
  Eigen::Vector3d followed = Eigen::Vector3d::Zero();
  for (const BodyBoundary& entry : mechanism.boundaries)
    if (entry.boundary.name() == box.follow) followed = mechanism.model.initial(entry.body).r;
  for (const BodyBoundary& entry : mechanism.boundaries) {
    const BodyState& start = mechanism.model.initial(entry.body);
    const Eigen::Matrix3Xd x =
        (Eigen::Quaterniond(start.L[0], start.L[1], start.L[2], start.L[3]).toRotationMatrix() * entry.boundary.rho0())
            .colwise() +
        start.r;
    for (int axis = 0; axis < 2 && !box.periodic; ++axis) {
      const std::size_t k = axis;
      const double reach = 0.5 * box.size[k] + n.margin + kTolerance * box.size[k];
      const double farthest = (x.row(axis).array() - box.centre[k]).abs().maxCoeff();
      if (farthest > reach && entry.boundary.segments().empty())
        throw InputError(code::kOutsideBox, "body \"", entry.boundary.name(), "\" reaches ", number_text(farthest, 4),
                         " m from the middle of the bed along ", axis == 0 ? "x" : "y", ", the simulation box ",
                         number_text(reach, 4),
                         " m; increase particles.box.size or particles.box.margin, or move the body inside",
                         in_millimetres(x));
    }
    for (int axis = 0; axis < 2; ++axis) {
      if (!follows_along(box, axis)) continue;
      const double reach = (x.row(axis).array() - followed[axis]).abs().maxCoeff() +
                           2.0 * *std::max_element(box.radius.begin(), box.radius.end());
      if (reach > follow_distance(box))
        throw InputError(code::kOutsideBox, "body \"", entry.boundary.name(), "\" and a grain next to it reach ",
                         number_text(reach, 3), " m from the origin of body \"", box.follow, "\" along ", "xy"[axis],
                         ", which the bed follows; expected at most particles.box.follow_distance, ",
                         number_text(follow_distance(box), 3),
                         " m: make the bed longer (particles.box.size), or follow a body in the middle");
    }
    const double top = x.row(2).maxCoeff();
    if (top > roof * (1.0 + kTolerance) && entry.boundary.segments().empty())
      throw InputError(code::kOutsideBox, "body \"", entry.boundary.name(),
                       "\" reaches up to z = ", number_text(top, 4), " m, the simulation box to ", number_text(roof, 4),
                       " m; increase particles.box.headroom", lifted(entry.boundary.name()), in_millimetres(x));
  }
}

void store_box_scripts(const Scene& scene, const std::string& out) {
  if (!scene.touches_particles() || !scene.particles->box) return;
  const ParticlesSpec& particles = *scene.particles;
  const fs::path folder = fs::path(out) / "script";
  make_folder(folder.string(), "choose another folder with --out");
  const std::string bed = fs::path(particles.bed->script).filename().string();
  for (const std::string& name :
       {bed, std::string("in.grains"), std::string("material.lammps"), std::string("walls.lammps"),
        std::string("observed_walls.lammps"), std::string("energy.lammps")}) {
    const std::string source = box_script(name);
    const std::optional<std::string> text = read_whole_file(source);
    if (!text) throw InputError(code::kShippedFileMissing, source, ": cannot be read; install footfall again");
    write_whole_file((folder / name).string(), *text);
  }
  std::string text =
      "# The scripts that [particles.box] of the scene stood for. To edit them, copy this folder next to the scene "
      "and\n"
      "# replace [particles] and [particles.box] by these lines.\n";
  text += concat("[particles]\nscript = \"script/in.grains\"\nranks = ", particles.ranks,
                 "\nsurface_height = ", number_text(*particles.surface_height, 12),
                 "\nmax_time_step = ", number_text(particles.max_time_step, 12), "\n[particles.variables]\n",
                 toml_table(particles.variables), "[particles.bed]\nscript = \"script/", bed,
                 "\"\n[particles.bed.variables]\n", toml_table(particles.bed->variables));
  write_whole_file((folder / "particles.toml").string(), text);
}

std::string script_report(const Scene& scene) {
  const ParticlesSpec& particles = *scene.particles;
  ScriptValues values;
  if (particles.bed) read_script(particles.bed->script, particles.bed->variables, values);
  values.step.reset();
  read_script(particles.script, particles.variables, values);
  std::string few;
  std::string text = concat("Grains: ", short_path(particles.script), " on ", particles.ranks,
                            particles.ranks == 1 ? " rank" : " ranks");
  if (particles.bed) {
    const std::string folder = bed_folder(*particles.bed);
    const std::string grains = (fs::path(folder) / kBedGrains).string();
    if (!bed_is_made(folder)) {
      text += concat("\n", kNotMade);
    } else if (fs::exists(grains)) {
      const std::vector<GrainPlace> places = read_grains(grains);
      values.smallest = std::numeric_limits<double>::infinity();
      values.largest = 0.0;
      for (const GrainPlace& place : places) {
        values.smallest = std::min(values.smallest, place.radius);
        values.largest = std::max(values.largest, place.radius);
      }
      text += concat("\n  the bed is made: ", count_grains(places), " grains", speed_text(places), ", ",
                     short_path(folder));
      few = ranks_text(static_cast<double>(count_grains(places)), particles.ranks);
    }
  }
  text += "\n" + few;
  if (values.largest > 0.0) text += "  radius: " + radii_text(values.smallest, values.largest) + "\n";
  return text + step_text(values, scene.initial.velocity.norm());
}

}  // namespace footfall
