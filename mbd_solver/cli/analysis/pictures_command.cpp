#include "mbd_solver/cli/analysis/pictures_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/made_files.h"
#include "coupler/base/pi.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/analysis/grain_picture.h"
#include "mbd_solver/cli/analysis/mechanism_shape.h"
#include "mbd_solver/cli/analysis/replay_script.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr double kDegree = kPi / 180.0;

// Where the foremost coupled surface is [m]; without any, the middle of the bed.
double foremost(const fs::path& motion, const BedFrame& bed, double t) {
  double y = std::numeric_limits<double>::infinity();
  for (const std::string& body : recorded_bodies(motion.string())) {
    const RecordedMotion record = read_motion(motion.string(), body);
    y = std::min(y, record.pose[nearest(record.time, t)][1]);
  }
  return std::isfinite(y) ? y : 0.5 * (bed.x.row(1).minCoeff() + bed.x.row(1).maxCoeff());
}

struct Moment {
  double time;  // [s]
  BedFrame bed;
  MechanismShape shape;
};

std::vector<Moment> read_moments(const PicturesArguments& a, const Json& summary) {
  const std::map<long, std::string> frames = find_bed_frames(a.run);
  if (frames.empty() || !summary.contains("dt_dem_s"))
    throw InputError(a.run +
                     ": holds no dumps of grains; run the scene with frames, as --set particles.variables.frames=0.05 "
                     "does for inputs/landing_mr");
  const double dt = summary.at("dt_dem_s");
  std::vector<double> times;
  std::vector<std::string> files;
  for (const auto& [step, file] : frames) {
    times.push_back(static_cast<double>(step) * dt);
    files.push_back(file);
  }
  std::set<std::size_t> chosen;
  for (const double t : a.times) {
    if (!(t >= 0.0))
      throw InputError("--times: is " + std::to_string(t) + ", expected times of the run, from 0 to " +
                       std::to_string(times.back()) + " s");
    chosen.insert(nearest(times, t));
  }
  const MechanismShapes shapes(a.run, summary);
  if (!shapes.drawn())
    std::fprintf(
        stderr,
        "footfall: the run drew no bodies (--set output.vtk=true does); only what touches the grains is shown\n");
  std::vector<Moment> moments;
  for (const std::size_t k : chosen)
    moments.push_back({times[k], read_bed_frame(files[k]), shapes.empty() ? MechanismShape{} : shapes.near(times[k])});
  return moments;
}

int draw_pictures(const PicturesArguments& a) {
  const fs::path folder(a.run);
  if (!fs::exists(folder / "summary.json"))
    throw InputError(a.run + ": holds no summary.json; expected the folder of a run");
  if (!a.view.empty() && a.view.size() != 2)
    throw InputError("--view: expected two angles: azimuth,elevation in degrees");
  const Json summary = read_summary((folder / "summary.json").string());
  const std::vector<Moment> moments = read_moments(a, summary);

  GrainView view;
  view.width = a.width;
  const bool cut = a.cut || !a.cut_at.empty();
  if (cut)
    view.cut =
        a.cut_at.empty() ? foremost(folder / "motion", moments.front().bed, moments.front().time) : a.cut_at.front();
  std::vector<const BedFrame*> beds;
  std::vector<const MechanismShape*> shapes;
  for (const Moment& moment : moments) {
    beds.push_back(&moment.bed);
    shapes.push_back(&moment.shape);
  }
  const std::vector<double> angles = !a.view.empty() ? a.view
                                     : cut           ? std::vector<double>{-90, 12}
                                                     : std::vector<double>{-65, 28};
  view.eye = eye_around({beds.front()}, shapes, view.cut, angles[0] * kDegree, angles[1] * kDegree);
  view.fastest = a.fastest > 0.0 ? a.fastest : colour_range(beds);

  const MadeFiles made(a.run);
  const std::string out = (folder / "pictures").string();
  const std::string title = summary.contains("scene") ? summary.at("scene").value("title", "") : "";
  std::vector<std::string> scripts;
  for (const Moment& moment : moments) {
    char name[64], words[160];
    std::snprintf(name, sizeof name, "%s_%.4fs", cut ? "cut" : "grains", moment.time);
    std::snprintf(words, sizeof words, "%s%st = %.4g s", title.substr(0, 100).c_str(), title.empty() ? "" : ", ",
                  moment.time);
    std::string said = words;
    if (cut) {
      std::snprintf(words, sizeof words, ", cut at y = %.3g m", view.cut);
      said += words;
    }
    scripts.push_back(write_grain_picture(out, name, said, moment.bed, moment.shape, view));
  }
  for (const std::string& picture : run_gnuplot(out, scripts)) std::printf("%s\n", short_path(picture).c_str());
  return kExitDone;
}

}  // namespace

int pictures_command(const PicturesArguments& a) {
  return with_summary_of(a.run, [&] { return draw_pictures(a); });
}

}  // namespace footfall
