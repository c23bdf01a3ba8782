// The page is written to a temporary folder, opened in the browser and photographed; a video is a sequence of JPEG pictures in a
// pipe to ffmpeg. Files appear under their names once they are complete.
#include "mbd_solver/app/film/film.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/interrupt.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/film/page_camera.h"
#include "mbd_solver/app/grain_pictures.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/scenery/scenery.h"
#include "mbd_solver/app/view_page.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/base/child_process.h"
#include "mbd_solver/base/live_line.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/bed/depth_image.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/session/observe/drawing.h"
#include "mbd_solver/session/observe/terrain_patch.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr double kShortest = 5.0, kLongest = 30.0;  // video of a run whose speed was not given [s]
constexpr double kMostPictures = 50000.0;
constexpr double kLineWithoutDiameter = 0.006;  // radius of a line whose body has no diameter [m]
constexpr int kSmallest = 64, kLargest = 8192;  // [pixels]

std::string extension_of(const std::string& file) {
  std::string text = fs::path(file).extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

void require_writable(const std::string& option, const std::string& file) {
  const fs::path folder = fs::absolute(file).parent_path();
  if (!fs::is_directory(folder) || access(folder.c_str(), W_OK) != 0)
    throw InputError(code::kWrongOption, option + ": \"" + file + "\" cannot be written: \"" + folder.string() +
                                             "\" is no folder that can be written; create it, or name another file");
  if (fs::is_directory(file))
    throw InputError(code::kWrongOption, option + ": \"" + file + "\" is a folder, expected the name of a file");
}

PageSize size_of_picture(const FilmArguments& a, bool even) {
  PageSize size;
  if (a.size.size() == 2) size = {a.size[0], a.size[1]};
  for (const int pixels : {size.width, size.height})
    if (pixels < kSmallest || pixels > kLargest || (even && pixels % 2 != 0))
      throw InputError(code::kWrongOption, "--size: is " + std::to_string(size.width) + "," +
                                               std::to_string(size.height) + ", expected width,height from " +
                                               std::to_string(kSmallest) + " to " + std::to_string(kLargest) +
                                               " pixels" + (even ? ", both even for a video" : ""));
  return size;
}

// What follows the # of the address.
std::string link_of(const FilmArguments& a) {
  std::string link = "picture=1";
  if (!a.camera.empty()) {
    link += "&camera=";
    for (std::size_t k = 0; k < a.camera.size(); ++k) link += (k > 0 ? "," : "") + number_text(a.camera[k]);
  }
  return a.show.empty() ? link : link + "&" + a.show;
}

// The entries of --show: key and value.
std::vector<std::pair<std::string, std::string>> entries_of(const std::string& show) {
  std::vector<std::pair<std::string, std::string>> entries;
  for (const std::string& part : split(show, '&')) {
    const std::size_t equals = part.find('=');
    entries.emplace_back(part.substr(0, equals), equals == std::string::npos ? "" : part.substr(equals + 1));
  }
  return entries;
}

void require_known_entries(const std::string& show) {
  constexpr const char* kKeys[] = {"grains", "bodies", "track", "hide", "names", "clip"};
  if (show.empty()) return;
  for (const auto& [key, value] : entries_of(show))
    if (std::find(std::begin(kKeys), std::end(kKeys), key) == std::end(kKeys) || value.empty())
      throw InputError(code::kWrongOption,
                       "--show: is \"" + show + "\", where \"" + key +
                           "\" is no entry; expected entries such as grains=force&names=1 of grains, "
                           "bodies, track, hide, names and clip");
}

// What a page chooses from: it ignores values that it does not have.
void require_followed(PageCamera& camera, const std::string& show) {
  constexpr const char* kChoices[][2] = {
      {"grains", "grainColour"}, {"bodies", "bodyColour"}, {"track", "track"}, {"clip", "clip"}};
  if (show.empty()) return;
  for (const auto& [key, value] : entries_of(show)) {
    for (const auto& [name, select] : kChoices) {
      if (key != name) continue;
      const Json known = camera.evaluate(std::string("[...(footfall.controls.") + select +
                                         "?.options ?? [])].map((option) => option.value)");
      const std::string wanted = key == "clip" ? value.substr(0, value.find(',')) : value;
      std::vector<std::string> values;
      for (const Json& one : known)
        if (!one.get<std::string>().empty()) values.push_back(one.get<std::string>());
      const auto has = [&](const std::string& one) {
        return std::find(values.begin(), values.end(), one) != values.end();
      };
      if (has(wanted) || has("body:" + wanted)) continue;
      throw InputError(code::kWrongOption, "--show: " + key + " is \"" + wanted + "\", expected " +
                                               (values.empty() ? "none: this page has nothing to choose there"
                                                               : "one of " + joined(values)));
    }
  }
}

// A page in a folder of its own.
struct FilmPage {
  ScratchFolder folder{"footfall_film"};
  std::string file = folder.path() + "/view.html";
};

struct Span {
  double start, end;  // [s]
};

// The page of a run before the camera, and the times that it shows.
struct ShownRun {
  ShownRun(const FilmArguments& a, const PageSize& size)
      : camera(write_view({a.run, a.other, a.frames, page.file}), link_of(a), size),
        times(camera.evaluate("[footfall.player.start, footfall.player.end]")),
        span{times.at(0).get<double>(), times.at(1).get<double>()} {
    // picture(t) draws at once; the page must not draw each time again with the next turn of the screen.
    camera.evaluate("void (footfall.stage.wish = () => {})");
    require_followed(camera, a.show);
  }
  FilmPage page;
  PageCamera camera;
  const Json times;
  const Span span;
};

double within_run(const char* option, double t, const Span& span) {
  const double tiny = 1e-9 * (span.end - span.start);
  if (!(t >= span.start - tiny && t <= span.end + tiny))
    throw InputError(code::kOutOfData, std::string(option) + ": is " + number_text(t) +
                                           ", expected a time of the run, from " + number_text(span.start) + " to " +
                                           number_text(span.end) + " s");
  return std::clamp(t, span.start, span.end);
}

std::string hidden_name(const std::string& file) {
  const fs::path path(file);
  return (path.parent_path() / ("." + path.stem().string() + ".part" + path.extension().string())).string();
}

void write_picture(const std::string& file, const std::string& bytes) {
  write_whole_file(file, bytes, "is the disk full?");
  std::printf("%s\n", short_path(file).c_str());
}

}  // namespace

int draw_page_picture(const FilmArguments& a) {
  if (extension_of(a.file) != ".png")
    throw InputError(code::kWrongOption, "--png: is \"" + a.file + "\", expected the name of a .png file");
  require_writable("--png", a.file);
  const PageSize size = size_of_picture(a, false);
  require_known_entries(a.show);
  if (chromium_program().empty())
    throw InputError(code::kProgramMissing,
                     "--png needs Chromium, which draws the page: apt install chromium. `view --pictures` draws grains "
                     "without it");
  end_on_signals("footfall");
  work_is_under_way();
  ShownRun shown(a, size);
  const Span& span = shown.span;
  const double t = a.at < 0.0 ? 0.5 * (span.start + span.end) : within_run("--at", a.at, span);
  shown.camera.evaluate("footfall.picture(" + number_text(t, 12) + ")");
  write_picture(a.file, shown.camera.picture("png"));
  return kExitDone;
}

namespace {

// ffmpeg with a pipe at its standard input. The file is complete, or it is not there.
class Encoder {
 public:
  Encoder(const std::string& program, const std::string& file, double rate) : part_(hidden_name(file)), file_(file) {
    std::vector<std::string> words = {program, "-loglevel",  "error",           "-y", "-f", "image2pipe", "-c:v",
                                      "mjpeg", "-framerate", number_text(rate), "-i", "-"};
    const std::vector<std::string> webm = {"-c:v",     "libvpx-vp9", "-crf", "31",      "-b:v", "0",        "-deadline",
                                           "realtime", "-cpu-used",  "6",    "-row-mt", "1",    "-pix_fmt", "yuv420p"};
    const std::vector<std::string> mp4 = {"-c:v", "libx264",  "-preset", "veryfast",  "-crf",
                                          "20",   "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
    const std::vector<std::string>& codec = extension_of(file) == ".webm" ? webm : mp4;
    words.insert(words.end(), codec.begin(), codec.end());
    words.push_back(part_);
    start(words);
  }
  ~Encoder() {
    if (to_ >= 0) close(to_);
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      wait_for_end(pid_);
    }
    std::error_code ignored;
    fs::remove(part_, ignored);
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  void add(const std::string& picture) {
    for (std::size_t sent = 0; sent < picture.size();) {
      const ssize_t n = ::write(to_, picture.data() + sent, picture.size() - sent);
      if (n < 0 && errno == EINTR && interrupted() == 0) continue;
      if (n <= 0) fail();
      sent += static_cast<std::size_t>(n);
    }
  }
  void finish() {
    close(std::exchange(to_, -1));
    std::error_code error;
    if (wait_for_end(std::exchange(pid_, -1)) != 0) fail();
    fs::rename(part_, file_, error);
    if (error) fail();
  }

 private:
  void start(const std::vector<std::string>& words) {
    int down[2];
    if (pipe2(down, O_CLOEXEC) != 0) fail();
    std::signal(SIGPIPE, SIG_IGN);
    Command command{Rights::writing({words[0]}, {folder_.path(), fs::absolute(part_).parent_path().string()}), words};
    command.output = log_;
    pid_ = start_program(command, {{down[0], STDIN_FILENO}}, Orphan::kIsKilled);
    close(down[0]);
    to_ = down[1];
  }
  [[noreturn]] void fail() const {
    const std::string log = read_whole_file(log_).value_or("");
    throw FileError(code::kVideoFailed,
                    file_ + ": ffmpeg wrote no video" +
                        (log.empty() ? "; is the disk full?" : ": " + log.substr(0, log.find('\n'))));
  }

  ScratchFolder folder_{"footfall_ffmpeg"};
  std::string log_ = folder_.path() + "/log", part_, file_;
  pid_t pid_ = -1;
  int to_ = -1;
};

// 1, 2 or 5 times a power of ten, so that the video lasts kShortest to about twice that; faster for runs beyond kLongest.
double fitting_slowness(double seconds) {
  double power = 1.0;
  if (seconds > kLongest) {
    for (;; power *= 10.0)
      for (const double k : {1.0, 2.0, 5.0})
        if (seconds <= kLongest * k * power) return 1.0 / (k * power);
  }
  for (;; power *= 10.0)
    for (const double k : {1.0, 2.0, 5.0})
      if (seconds * k * power >= kShortest || power > 1e9) return k * power;
}

}  // namespace

int make_video(const FilmArguments& a) {
  const std::string kind = extension_of(a.file);
  if (kind != ".mp4" && kind != ".webm")
    throw InputError(code::kWrongOption, "--video: is \"" + a.file + "\", expected the name of a .mp4 or .webm file");
  require_writable("--video", a.file);
  const PageSize size = size_of_picture(a, true);
  require_known_entries(a.show);
  const std::string ffmpeg = program_in_path({"ffmpeg"});
  std::string missing;
  if (chromium_program().empty()) missing = "chromium";
  if (ffmpeg.empty()) missing += (missing.empty() ? "" : " ") + std::string("ffmpeg");
  if (!missing.empty())
    throw InputError(code::kProgramMissing,
                     "--video needs Chromium, which draws the page, and ffmpeg; missing: apt install " + missing);
  end_on_signals("footfall");
  work_is_under_way();
  ShownRun shown(a, size);
  const Span& span = shown.span;
  const double from = within_run("--from", std::max(a.from, a.from == 0.0 ? span.start : a.from), span);
  const double to = a.to < 0.0 ? span.end : within_run("--to", a.to, span);
  if (!(to > from))
    throw InputError(code::kOutOfData,
                     "--to: is " + number_text(to) + ", expected a time after --from, " + number_text(from) + " s");
  const double slow = a.slow > 0.0 ? a.slow : fitting_slowness(to - from);
  const double count = std::floor((to - from) * slow * a.rate + 1e-6) + 1.0;
  if (count > kMostPictures || count < 2.0)
    throw InputError(code::kOutOfData, "--slow, --fps: " + number_text(count) + " pictures, expected 2 to " +
                                           number_text(kMostPictures) + "; choose other values");
  Encoder encoder(ffmpeg, a.file, a.rate);
  LiveLine line(false, isatty(STDOUT_FILENO) == 1);
  shown.camera.evaluate("footfall.slow = " + number_text(slow, 12));
  const double begun = wall_clock();
  for (double k = 0.0; k < count; ++k) {
    shown.camera.evaluate("footfall.picture(" + number_text(std::min(to, from + k / (slow * a.rate)), 12) + ")");
    encoder.add(shown.camera.picture("jpeg"));
    const Pace pace{(k + 1.0) / count, (k + 1.0) / count, wall_clock() - begun};
    if (isatty(STDOUT_FILENO) == 1 && line.due(pace.share))
      line.show("picture " + number_text(k + 1.0) + " of " + number_text(count) + ", " + time_left(pace));
  }
  line.finish(true);
  encoder.finish();
  std::printf("%s\n", short_path(a.file).c_str());
  return kExitDone;
}

namespace {

struct Reference {
  MechanismShape shape;
  std::vector<std::string> bodies;
};

// The mechanism where a run would place it, before its joints are closed; on a bed that is not made yet, at height zero.
Reference reference_of(Scene scene) {
  if (scene.touches_particles() && scene.particles->grains.empty() && !scene.particles->surface_height)
    scene.particles->surface_height = 0.0;
  const Mechanism mechanism = build_mechanism(scene);
  const Layout layout(mechanism.model);
  Drawing drawing({scene, mechanism, layout});
  Reference reference{{drawing.reference_frame(), {}}, {}};
  std::vector<double> radius;
  for (const BodySpec& body : scene.bodies) {
    reference.bodies.push_back(body.name);
    radius.push_back(body.shape && body.shape->diameter > 0.0 ? 0.5 * body.shape->diameter : kLineWithoutDiameter);
  }
  const VtkFrame& frame = reference.shape.frame;
  const Eigen::VectorXd& body = frame.cell_numbers[1].second;
  for (std::size_t k = 0; k < frame.lines.size(); ++k)
    reference.shape.line_radius.push_back(radius[static_cast<std::size_t>(body(frame.triangles.size() + k))]);
  return reference;
}

std::string title_of(const Scene& scene) {
  return scene.title.empty() ? fs::path(scene.folder).filename().string() : scene.title;
}

// Folder and name of the scene's file: a page that is passed on names no other folders of this machine.
std::string place_of_file(const Scene& scene) {
  const fs::path file = fs::absolute(scene.file).lexically_normal();
  return (file.parent_path().filename() / file.filename()).string();
}

std::string reference_page(const Scene& scene) {
  const Reference reference = reference_of(scene);
  PageParts parts;
  parts.run["grains"] = nullptr;
  parts.run["bodyNames"] = reference.bodies;
  parts.run["title"] = title_of(scene);
  add_shapes({0.0}, {reference.shape}, parts);
  if (const std::string terrain = terrain_text(scene, build_mechanism(scene)); !terrain.empty())
    parts.run["terrain"] = nlohmann::ordered_json::parse(terrain);
  const nlohmann::ordered_json json = nlohmann::ordered_json::parse(scene_json(scene));
  std::vector<std::string> notes;
  add_surroundings(json, parts);
  add_static_meshes(json, parts, notes);
  add_bed_block(json, parts);
  return page_text(title_of(scene), place_of_file(scene), {{"status", "done"}}, notes, parts);
}

// Bodies, struts and joints with their axes in parallel projection, by the renderer of `view --pictures` and gnuplot.
void draw_plainly(const Scene& scene, const std::string& file) {
  constexpr Colour kBody{205, 208, 214}, kTube{143, 166, 189};
  const Reference reference = reference_of(scene);
  const VtkFrame& frame = reference.shape.frame;
  const Eigen::Matrix3Xd& marks = frame.field_vectors.front().second;
  std::vector<Eigen::Vector3d> places;
  for (Eigen::Index j = 0; j < frame.points.cols(); ++j) places.emplace_back(frame.points.col(j));
  for (Eigen::Index j = 0; j < marks.cols(); ++j)
    if (j % 4 < 2) places.emplace_back(marks.col(j));
  Eye eye{eye_axes(-65.0 * kPi / 180.0, 24.0 * kPi / 180.0), Eigen::Vector2d::Constant(1e300),
          Eigen::Vector2d::Constant(-1e300)};
  for (const Eigen::Vector3d& x : places) {
    const Eigen::Vector2d seen = (eye.R_EW * x).head<2>();
    eye.low_E = eye.low_E.cwiseMin(seen);
    eye.high_E = eye.high_E.cwiseMax(seen);
  }
  const double size = std::max(1e-6, (eye.high_E - eye.low_E).norm());
  eye.low_E.array() -= 0.06 * size;
  eye.high_E.array() += 0.06 * size;
  DepthImage image(eye, PageSize{1600, 1000}.width);
  const auto point = [&](int j) { return Eigen::Vector3d(frame.points.col(j)); };
  for (const Eigen::Vector3i& t : frame.triangles) image.triangle(point(t(0)), point(t(1)), point(t(2)), kBody);
  for (std::size_t k = 0; k < frame.lines.size(); ++k)
    image.capsule(point(frame.lines[k](0)), point(frame.lines[k](1)), reference.shape.line_radius[k], kTube);
  draw_marks(frame, image);
  const ScratchFolder folder("footfall_picture");
  image.write(folder.path() + "/reference.rgb");
  const std::string width = std::to_string(image.width()), height = std::to_string(image.height());
  write_whole_file(folder.path() + "/reference.gp",
                   "set terminal pngcairo size " + width + "," + std::to_string(image.height() + 50) +
                       " font \"DejaVu Sans,15\"\nset output \"reference.png\"\nset encoding utf8\nset title " +
                       gnuplot_text(title_of(scene) + ", reference configuration") +
                       " noenhanced\nunset border\nunset tics\nunset key\nset xrange [0:" + width +
                       "]\nset yrange [0:" + height + "]\nset size ratio -1\nplot \"reference.rgb\" binary array=(" +
                       width + "," + height + ") flipy format='%uchar' using 1:2:3 with rgbimage\n",
                   "is the disk full?");
  run_gnuplot(folder.path(), {"reference.gp"});
  write_picture(file, read_whole_file(folder.path() + "/reference.png").value_or(""));
}

}  // namespace

int draw_reference(const Scene& scene, const std::string& file) {
  const std::string kind = extension_of(file);
  if (kind != ".png" && kind != ".html")
    throw InputError(code::kWrongOption, "--picture: is \"" + file + "\", expected the name of a .png or .html file");
  require_writable("--picture", file);
  if (kind == ".html") {
    write_picture(file, reference_page(scene));
    return kExitDone;
  }
  if (chromium_program().empty()) {
    draw_plainly(scene, file);
    return kExitDone;
  }
  end_on_signals("footfall");
  work_is_under_way();
  const FilmPage page;
  write_whole_file(page.file, reference_page(scene), "is the disk full?");
  PageCamera camera(page.file, "picture=1&names=1", PageSize{1600, 1000});
  camera.evaluate("footfall.picture(0)");
  write_picture(file, camera.picture("png"));
  return kExitDone;
}

}  // namespace footfall
