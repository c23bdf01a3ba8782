// Draws every grain and triangle with DepthImage, and writes the page around it as a gnuplot script.
#include "mbd_solver/app/grain_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/run_folder.h"
#include "mbd_solver/app/view_page.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {
namespace {

struct Stop {
  double share;  // of the fastest speed
  Colour colour;
};
constexpr Stop kSpeeds[] = {{0.0, {233, 223, 199}},
                            {0.1, {214, 178, 104}},
                            {0.3, {127, 174, 138}},
                            {0.65, {31, 111, 168}},
                            {1.0, {46, 20, 90}}};
constexpr double kOverlap = 0.25;  // lift of plates over the smallest radius: more than grains overlap with them
constexpr Colour kPlates{205, 208, 214}, kTubes{192, 57, 43};

Colour colour_of(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  std::size_t k = 1;
  while (k + 1 < std::size(kSpeeds) && kSpeeds[k].share < s) ++k;
  const double w = (s - kSpeeds[k - 1].share) / (kSpeeds[k].share - kSpeeds[k - 1].share);
  Colour c{};
  for (std::size_t i = 0; i < 3; ++i)
    c[i] = static_cast<std::uint8_t>(std::lround((1.0 - w) * kSpeeds[k - 1].colour[i] + w * kSpeeds[k].colour[i]));
  return c;
}

std::string palette() {
  std::string text = "set palette defined (";
  for (const Stop& stop : kSpeeds) {
    char entry[64];
    std::snprintf(entry, sizeof entry, "%s%g \"#%02x%02x%02x\"", stop.share > 0.0 ? ", " : "", stop.share,
                  stop.colour[0], stop.colour[1], stop.colour[2]);
    text += entry;
  }
  return text + ")\n";
}

double speed(const BedFrame& bed, Eigen::Index i) { return bed.v.cols() > i ? bed.v.col(i).norm() : 0.0; }

// The largest number up to `value` that is 1, 2 or 5 times a power of ten.
double round_below(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  return value >= 5.0 * power ? 5.0 * power : value >= 2.0 * power ? 2.0 * power : power;
}

struct GrainView {
  Eye eye;
  int width = 1600;      // of the drawing [pixels]
  double fastest = 1.0;  // speed at the end of the colour scale [m/s]
  double cut = -1e300;   // grains with y below this are left out [m]
};

// The eye that sees all beds and shapes. `azimuth`, `elevation` [rad].
Eye eye_around(const std::vector<const BedFrame*>& beds, const std::vector<const MechanismShape*>& shapes, double cut,
               double azimuth, double elevation) {
  Eye eye{eye_axes(azimuth, elevation), Eigen::Vector2d::Constant(1e300), Eigen::Vector2d::Constant(-1e300)};
  long grains = 0;
  const auto include = [&](const Eigen::Vector3d& x_W, double radius) {
    const Eigen::Vector2d x = (eye.R_EW * x_W).head<2>();
    eye.low_E = eye.low_E.cwiseMin(x - Eigen::Vector2d::Constant(radius));
    eye.high_E = eye.high_E.cwiseMax(x + Eigen::Vector2d::Constant(radius));
  };
  for (const BedFrame* bed : beds)
    for (Eigen::Index i = 0; i < bed->x.cols(); ++i)
      if (bed->x(1, i) >= cut) {
        include(bed->x.col(i), bed->radius[i]);
        ++grains;
      }
  for (const MechanismShape* shape : shapes)
    for (Eigen::Index j = 0; j < shape->frame.points.cols(); ++j) include(shape->frame.points.col(j), 0.0);
  const bool all = cut == GrainView{}.cut;  // nothing is cut away
  if (grains == 0 && (!all || eye.low_E.x() > eye.high_E.x()))
    throw InputError(code::kNothingToDraw, all ? std::string("the dumps at these times have no grains; choose others")
                                               : "--cut-at: no grain has y above " + std::to_string(cut) + " m");
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(0.02 * (eye.high_E - eye.low_E).maxCoeff());
  eye.low_E -= margin;
  eye.high_E += margin;
  return eye;
}

// The speed that one in a thousand grains exceeds, in the fastest of these frames, rounded up to 1, 2 or 5 times a power of ten
// [m/s].
double colour_range(const std::vector<const BedFrame*>& beds) {
  constexpr double kShown = 0.999;
  double fastest = 0.0;
  for (const BedFrame* bed : beds) {
    std::vector<double> speeds;
    for (Eigen::Index i = 0; i < bed->x.cols(); ++i) speeds.push_back(speed(*bed, i));
    if (speeds.empty()) continue;
    const auto k = static_cast<std::ptrdiff_t>(kShown * static_cast<double>(speeds.size() - 1));
    std::nth_element(speeds.begin(), speeds.begin() + k, speeds.end());
    fastest = std::max(fastest, speeds[k]);
  }
  if (!(fastest > 1e-6)) return 1.0;  // all at rest
  const double below = round_below(fastest);
  for (const double step : {1.0, 2.0, 2.5, 5.0})
    if (below * step >= fastest && round_below(below * step) == below * step) return below * step;
  return 10.0 * below;
}

// The point of a triangle that is nearest to p: inside, or on its nearest edge.
Eigen::Vector3d nearest_on_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                    const Eigen::Vector3d& p) {
  const Eigen::Vector3d n = (b - a).cross(c - a);
  const Eigen::Vector3d flat = n.squaredNorm() > 0.0 ? Eigen::Vector3d(p - n * (n.dot(p - a) / n.squaredNorm())) : a;
  const auto inside = [&](const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    return n.dot((v - u).cross(flat - u)) >= 0.0;
  };
  if (n.squaredNorm() > 0.0 && inside(a, b) && inside(b, c) && inside(c, a)) return flat;
  const auto on_edge = [&](const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    const double l = (v - u).squaredNorm();
    return Eigen::Vector3d(u + (l > 0.0 ? std::clamp((v - u).dot(p - u) / l, 0.0, 1.0) : 0.0) * (v - u));
  };
  Eigen::Vector3d best = on_edge(a, b);
  for (const Eigen::Vector3d& x : {on_edge(b, c), on_edge(c, a)})
    if ((x - p).norm() < (best - p).norm()) best = x;
  return best;
}

const std::vector<std::string>* texts_of(const VtkFrame& frame, const char* name) {
  for (const auto& [key, texts] : frame.texts)
    if (key == name) return &texts;
  return nullptr;
}

// The point of the drawing of a body that is nearest to p; p itself for a body without one.
Eigen::Vector3d nearest_drawn(const VtkFrame& frame, int number, const Eigen::Vector3d& p) {
  Eigen::VectorXd body;
  for (const auto& [key, values] : frame.cell_numbers)
    if (key == "body") body = values;
  const auto corner = [&](int j) { return Eigen::Vector3d(frame.points.col(j)); };
  const auto is_of_body = [&](std::size_t cell) {
    return static_cast<Eigen::Index>(cell) < body.size() && static_cast<int>(body(cell)) == number;
  };
  Eigen::Vector3d best = p;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Eigen::Vector3d& x) {
    if ((x - p).norm() < least) {
      best = x;
      least = (x - p).norm();
    }
  };
  for (std::size_t k = 0; k < frame.triangles.size(); ++k)
    if (const Eigen::Vector3i& t = frame.triangles[k]; is_of_body(k))
      offer(nearest_on_triangle(corner(t(0)), corner(t(1)), corner(t(2)), p));
  for (std::size_t k = 0; k < frame.lines.size(); ++k)
    if (const Eigen::Vector2i& l = frame.lines[k]; is_of_body(frame.triangles.size() + k))
      offer(nearest_on_triangle(corner(l(0)), corner(l(1)), corner(l(1)), p));
  return best;
}

}  // namespace

void draw_marks(const VtkFrame& frame, DepthImage& image) {
  constexpr Colour kStrut{224, 138, 30}, kJoint{31, 78, 121}, kBracket{110, 118, 128};
  const std::vector<std::string>* const names = texts_of(frame, "mark_names");
  const std::vector<std::string>* const bodies = texts_of(frame, "body_names");
  if (names == nullptr || bodies == nullptr || frame.field_vectors.empty()) return;
  const Eigen::Matrix3Xd& marks = frame.field_vectors.front().second;
  if (marks.cols() != 4 * static_cast<Eigen::Index>(names->size())) return;
  const auto vector = [&](std::size_t i, int k) {
    return Eigen::Vector3d(marks.col(4 * static_cast<Eigen::Index>(i) + k));
  };
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = Eigen::Vector3d::Constant(-1e300);
  for (std::size_t i = 0; i < names->size(); ++i) {
    low = low.cwiseMin(vector(i, 0));
    high = high.cwiseMax(vector(i, 0));
  }
  const double unit = 0.006 * (high - low).norm();  // half the width of a strut [m]
  for (std::size_t i = 0; i < names->size(); ++i) {
    const std::vector<std::string> words = split((*names)[i], '\t');
    if (words.size() == 5 && words[0] == "cable") image.capsule(vector(i, 0), vector(i, 1), 0.5 * unit, kStrut);
    if (words.size() != 5 || (words[0] != "joint" && words[0] != "strut")) continue;
    for (int end = 0; end < 2; ++end) {
      const auto body = std::find(bodies->begin(), bodies->end(), words[3 + end]);
      if (body == bodies->end()) continue;
      const Eigen::Vector3d x = nearest_drawn(frame, static_cast<int>(body - bodies->begin()), vector(i, end));
      if ((x - vector(i, end)).norm() > 2.0 * unit) image.capsule(vector(i, end), x, 0.8 * unit, kBracket);
    }
    if (words[0] == "strut") {
      image.capsule(vector(i, 0), vector(i, 1), unit, kStrut);
    } else {
      image.sphere(vector(i, 0), 2.0 * unit, kJoint);
      image.capsule(vector(i, 0) - 6.0 * unit * vector(i, 2), vector(i, 0) + 6.0 * unit * vector(i, 2), 0.45 * unit,
                    kJoint);
    }
  }
}

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// Writes NAME.rgb and NAME.gp into `folder`; the script draws NAME.png. Returns the name of the script.
std::string write_grain_picture(const std::string& folder, const std::string& name, const std::string& title,
                                const BedFrame& bed, const MechanismShape& shape, const GrainView& view) {
  DepthImage image(view.eye, view.width);
  for (Eigen::Index i = 0; i < bed.x.cols(); ++i)
    if (bed.x(1, i) >= view.cut) image.sphere(bed.x.col(i), bed.radius[i], colour_of(speed(bed, i) / view.fastest));
  const auto point = [&](int j) { return Eigen::Vector3d(shape.frame.points.col(j)); };
  const double lift = bed.radius.empty() ? 0.0 : kOverlap * *std::min_element(bed.radius.begin(), bed.radius.end());
  for (const Eigen::Vector3i& t : shape.frame.triangles)
    image.triangle(point(t(0)), point(t(1)), point(t(2)), kPlates, lift);
  for (std::size_t k = 0; k < shape.frame.lines.size(); ++k)
    image.capsule(point(shape.frame.lines[k](0)), point(shape.frame.lines[k](1)), shape.line_radius[k], kTubes);
  draw_marks(shape.frame, image);

  make_folder(folder);
  image.write((fs::path(folder) / (name + ".rgb")).string());
  constexpr int kTop = 60, kBottom = 50, kLeft = 20, kRight = 150;  // margins of the page [pixels]
  const int width = image.width() + kLeft + kRight, height = image.height() + kTop + kBottom;
  const double metres = view.eye.high_E(0) - view.eye.low_E(0), bar = round_below(0.3 * metres);
  const auto across = [&](double pixels) { return std::to_string(pixels / width); };
  const auto up = [&](double pixels) { return std::to_string(pixels / height); };
  const std::string file = (fs::path(folder) / (name + ".gp")).string();
  std::ostringstream script;
  script << "# gnuplot " << name << ".gp draws " << name << ".png from " << name << ".rgb\n"
         << "set terminal pngcairo size " << width << "," << height << " font \"DejaVu Sans,15\"\nset output "
         << gnuplot_text(name + ".png") << "\n"
         << "set encoding utf8\nset title " << gnuplot_text(title)
         << " noenhanced offset 0,-0.4\nunset border\nunset tics\nunset key\n"
         << "set lmargin at screen " << across(kLeft) << "\nset rmargin at screen " << across(kLeft + image.width())
         << "\nset bmargin at screen " << up(kBottom) << "\nset tmargin at screen " << up(kBottom + image.height())
         << "\n"
         << (bed.x.cols() == 0 ? "unset colorbox\n" : "") << palette() << "set cbrange [0:" << view.fastest
         << "]\nset cbtics nomirror\nset cblabel \"speed of the grains [m/s]\"\n"
         << (bed.x.cols() == 0 ? "# " : "") << "set colorbox user origin " << across(kLeft + image.width() + 15) << ","
         << up(kBottom + 0.15 * image.height()) << " size " << across(22) << "," << up(0.7 * image.height()) << "\n"
         << "set xrange [0:" << image.width() << "]\nset yrange [0:" << image.height() << "]\n"
         << "set arrow from screen " << across(kLeft + 20) << "," << up(28) << " to screen "
         << across(kLeft + 20 + bar / metres * image.width()) << "," << up(28) << " nohead lw 4\nset label "
         << gnuplot_text(number_text(bar) + " m") << " at screen " << across(kLeft + 35 + bar / metres * image.width())
         << "," << up(28) << " left\n"
         << "plot " << gnuplot_text(name + ".rgb") << " binary array=(" << image.width() << "," << image.height()
         << ") flipy format='%uchar' using 1:2:3 with rgbimage, \\\n"
         << "     '+' using (NaN):(NaN):(0) with points lc palette   # for the colour bar\n";
  write_whole_file(file, script.str(), "is the disk full?");
  return name + ".gp";
}

constexpr double kDegree = kPi / 180.0;

// y of the foremost coupled surface [m]; without any, of the middle of the bed.
double foremost(const fs::path& motion, const BedFrame& bed, double t) {
  double y = std::numeric_limits<double>::infinity();
  for (const std::string& body : recorded_bodies(motion.string())) {
    const RecordedMotion record = read_motion(motion.string(), body);
    y = std::min(y, record.pose[nearest(record.time, t)][1]);
  }
  if (!std::isfinite(y) && bed.count() == 0) return 0.0;
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
    throw InputError(code::kNoDumps, a.run + ": the run has no dumps of grains, which --pictures draws. " +
                                         how_to_dump(summary.value("scene", Json::object())) +
                                         " `view --png FILE` draws the mechanism without them.");
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
      throw InputError(code::kOutOfData, "--times: is " + number_text(t) + ", expected times of the run, from 0 to " +
                                             number_text(times.back()) + " s");
    chosen.insert(nearest(times, t));
  }
  const MechanismShapes shapes(a.run, summary);
  if (!shapes.drawn())
    std::fprintf(stderr,
                 "footfall: the run drew no bodies (--set output.vtk=true does); only coupled surfaces are shown\n");
  std::vector<Moment> moments;
  for (const std::size_t k : chosen)
    moments.push_back({times[k], read_bed_frame(files[k]), shapes.empty() ? MechanismShape{} : shapes.near(times[k])});
  return moments;
}

int draw_pictures(const PicturesArguments& a) {
  const fs::path folder(a.run);
  if (!fs::exists(folder / "summary.json"))
    throw InputError(code::kNoRun, without_summary(a.run, "no summary.json; expected the folder of a run"));
  const Json summary = read_summary((folder / "summary.json").string());
  const std::vector<Moment> moments = read_moments(a, summary);

  // The first of these moments with grains sets the view.
  const auto with_grains =
      std::find_if(moments.begin(), moments.end(), [](const Moment& moment) { return moment.bed.count() > 0; });
  const Moment& shown = with_grains == moments.end() ? moments.front() : *with_grains;
  GrainView view;
  view.width = a.width;
  const bool cut = a.cut || !a.cut_at.empty();
  if (cut) view.cut = a.cut_at.empty() ? foremost(folder / "motion", shown.bed, shown.time) : a.cut_at.front();
  std::vector<const BedFrame*> beds;
  std::vector<const MechanismShape*> shapes;
  for (const Moment& moment : moments) {
    beds.push_back(&moment.bed);
    shapes.push_back(&moment.shape);
  }
  const std::vector<double> angles = !a.camera.empty() ? a.camera
                                     : cut             ? std::vector<double>{-90, 12}
                                                       : std::vector<double>{-65, 28};
  // A bed that follows a body is elsewhere at each time.
  const std::vector<const BedFrame*> one = {&shown.bed};
  view.eye =
      eye_around(summary.contains("bed") ? beds : one, shapes, view.cut, angles[0] * kDegree, angles[1] * kDegree);
  view.fastest = a.fastest > 0.0 ? a.fastest : colour_range(beds);

  const std::string out = (folder / "pictures").string();
  const std::string title = summary.contains("scene") ? summary.at("scene").value("title", "") : "";
  std::vector<std::string> scripts;
  for (const Moment& moment : moments) {
    char name[64], words[160];
    std::snprintf(name, sizeof name, "%s_%.4fs", cut ? "cut" : "grains", moment.time);
    std::snprintf(words, sizeof words, "%s%st = %.4g s", title.substr(0, 100).c_str(), title.empty() ? "" : ", ",
                  moment.time);
    std::string heading = words;
    if (cut) {
      std::snprintf(words, sizeof words, ", cut at y = %.3g m", view.cut);
      heading += words;
    }
    scripts.push_back(write_grain_picture(out, name, heading, moment.bed, moment.shape, view));
  }
  for (const std::string& picture : run_gnuplot(out, scripts)) std::printf("%s\n", short_path(picture).c_str());
  return kExitDone;
}

}  // namespace

int draw_grain_pictures(const PicturesArguments& a) {
  return with_summary_of(a.run, [&] { return draw_pictures(a); });
}

}  // namespace footfall
