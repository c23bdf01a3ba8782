// Collects history, bodies and grains of a run into one page. All frames are read first, for the box of all positions.
#include "mbd_solver/app/view_page.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/difference/pair_page.h"
#include "mbd_solver/app/packed_series.h"
#include "mbd_solver/app/run_folder.h"
#include "mbd_solver/app/scenery/scenery.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/scene/force_spec.h"
#include "mbd_solver/session/observe/terrain_patch.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

const Eigen::VectorXd* cell_numbers(const VtkFrame& frame, const std::string& name) {
  for (const auto& [key, values] : frame.cell_numbers)
    if (key == name && values.size() == static_cast<Eigen::Index>(frame.triangles.size() + frame.lines.size()))
      return &values;
  return nullptr;
}

// `most` of all, evenly spread, with the first and the last.
template <class One>
std::vector<One> thinned(const std::vector<One>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<One> chosen;
  for (std::size_t i = 0; i < most; ++i)
    chosen.push_back(all[i * (all.size() - 1) / std::max<std::size_t>(1, most - 1)]);
  return chosen;
}

// The bodies whose stress is known; others are drawn in their own colour, not in the colour of zero stress.
std::set<int> stressed_bodies(const std::vector<MechanismShape>& frames) {
  std::set<int> stressed;
  for (const MechanismShape& shape : frames) {
    const Eigen::VectorXd* stress = cell_numbers(shape.frame, "von_mises_Pa");
    const Eigen::VectorXd* body = cell_numbers(shape.frame, "body");
    for (Eigen::Index i = 0; stress != nullptr && body != nullptr && i < stress->size(); ++i)
      if ((*stress)(i) > 0.0) stressed.insert(static_cast<int>((*body)(i)));
  }
  return stressed;
}

// Four columns per mark (session/observe/marks.h); none in a drawing without them.
Eigen::Matrix3Xd marks_of(const VtkFrame& frame) {
  for (const auto& [name, vectors] : frame.field_vectors)
    if (name == "marks") return vectors;
  return Eigen::Matrix3Xd(3, 0);
}

// run.marks: times, list of {kind, type, name, bodies}, view; and the chunk marks: frame by frame, 12 numbers per mark.
void add_marks(const std::vector<double>& times, const std::vector<MechanismShape>& frames, PageParts& parts) {
  const VtkFrame& first = frames.front().frame;
  Json list = Json::array();
  for (const auto& [name, texts] : first.texts)
    if (name == "mark_names")
      for (const std::string& text : texts) {
        const std::vector<std::string> words = split(text, '\t');
        if (words.size() != 5) return;
        list.push_back({{"kind", words[0]}, {"type", words[1]}, {"name", words[2]}, {"bodies", {words[3], words[4]}}});
      }
  if (list.empty() || marks_of(first).cols() != 4 * static_cast<Eigen::Index>(list.size())) return;
  std::vector<float> numbers;
  Box box;
  for (const MechanismShape& shape : frames) {
    const Eigen::Matrix3Xd vectors = marks_of(shape.frame);
    numbers.insert(numbers.end(), vectors.data(), vectors.data() + vectors.size());
    if (&shape == &frames.front())
      for (Eigen::Index j = 0; j < vectors.cols(); ++j)
        if (j % 4 < 2) box.include(vectors.col(j));
  }
  parts.run["marks"] = {{"times", times}, {"list", list}};
  add_box(box, box, parts.run["marks"]);
  parts.chunks.emplace_back("marks", packed_numbers(numbers));
}

void add_cells(const MechanismShape& first, PageParts& parts) {
  std::vector<std::uint32_t> triangles, lines, bodies;
  for (const Eigen::Vector3i& t : first.frame.triangles)
    for (int k = 0; k < 3; ++k) triangles.push_back(static_cast<std::uint32_t>(t(k)));
  for (const Eigen::Vector2i& l : first.frame.lines)
    for (int k = 0; k < 2; ++k) lines.push_back(static_cast<std::uint32_t>(l(k)));
  const Eigen::VectorXd* body = cell_numbers(first.frame, "body");
  for (std::size_t i = 0; i < first.frame.triangles.size() + first.frame.lines.size(); ++i)
    bodies.push_back(body != nullptr ? static_cast<std::uint32_t>((*body)(static_cast<Eigen::Index>(i))) : 0u);
  const std::vector<float> radius(first.line_radius.begin(), first.line_radius.end());
  parts.chunks.emplace_back("bodies-triangles", packed_numbers(triangles));
  parts.chunks.emplace_back("bodies-lines", packed_numbers(lines));
  parts.chunks.emplace_back("bodies-cells", packed_numbers(bodies));
  parts.chunks.emplace_back("bodies-radius", packed_numbers(radius));
}

}  // namespace

void add_bodies(const std::string& run, const Json& summary, FrameLimits& limits, PageParts& parts) {
  parts.run["bodies"] = parts.run["marks"] = nullptr;
  const MechanismShapes shapes(run, summary);
  parts.run["bodyNames"] = shapes.body_names();
  if (shapes.empty()) return;
  if (!shapes.drawn())
    limits.notes.push_back(
        "The run drew no bodies: only coupled surfaces are shown, without bending. Run it with --set output.vtk=true "
        "to see all.");
  const std::vector<double> times = shapes.drawn() ? shapes.times() : thinned(shapes.times(), limits.moments);
  std::vector<MechanismShape> frames;
  for (const double t : times) {
    frames.push_back(shapes.near(t));
    const VtkFrame& frame = frames.back().frame;
    const VtkFrame& first = frames.front().frame;
    if (frame.points.cols() != first.points.cols() || frame.triangles.size() != first.triangles.size() ||
        frame.lines.size() != first.lines.size() || marks_of(frame).cols() != marks_of(first).cols())
      throw InputError(code::kRunDamaged, run +
                                              ": drawings of the bodies with different numbers of points; "
                                              "the folder may hold files of two runs");
    if (!frame.points.allFinite() || !marks_of(frame).allFinite())
      throw InputError(code::kRunDamaged, run + ": a drawing of the bodies has a point that is not finite");
  }
  add_shapes(times, frames, parts);
}

void add_shapes(const std::vector<double>& times, const std::vector<MechanismShape>& frames, PageParts& parts) {
  parts.run["bodies"] = parts.run["marks"] = nullptr;
  add_marks(times, frames, parts);
  Box box;
  double stress = 0.0;  // largest of all frames [Pa]
  for (const MechanismShape& shape : frames) {
    const VtkFrame& frame = shape.frame;
    for (Eigen::Index j = 0; j < frame.points.cols(); ++j) box.include(frame.points.col(j));
    if (const Eigen::VectorXd* values = cell_numbers(frame, "von_mises_Pa"); values != nullptr && values->size() > 0)
      stress = std::max(stress, values->maxCoeff());
  }
  const std::size_t points = static_cast<std::size_t>(frames.front().frame.points.cols());
  const std::size_t cells = frames.front().frame.triangles.size() + frames.front().frame.lines.size();
  if (points == 0) return;

  Json& bodies = parts.run["bodies"];
  bodies = {{"points", points},
            {"cells", cells},
            {"times", times},
            {"stress", stress},
            {"stressed", stressed_bodies(frames)}};
  add_box(box, box, bodies);
  add_cells(frames.front(), parts);
  PackedSeries series(3 * points + (stress > 0.0 ? cells : 0));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const VtkFrame& frame = frames[k].frame;
    std::vector<std::uint16_t> values;
    values.reserve(3 * points + cells);
    for (int axis = 0; axis < 3; ++axis)
      for (Eigen::Index j = 0; j < frame.points.cols(); ++j)
        values.push_back(box.number_of(axis, frame.points(axis, j)));
    if (stress > 0.0) {
      const Eigen::VectorXd* of_cell = cell_numbers(frame, "von_mises_Pa");
      for (std::size_t i = 0; i < cells; ++i) {
        const double share = of_cell != nullptr ? (*of_cell)(static_cast<Eigen::Index>(i)) / stress : 0.0;
        values.push_back(static_cast<std::uint16_t>(65535.0 * std::clamp(share, 0.0, 1.0)));
      }
    }
    parts.add_frame("bodies", k, series.add(values));
  }
}

namespace {

constexpr double kShown = 0.999;  // share of the grains within the colour scale

// A frame in memory until the box of all is known; single precision is finer than the steps of a page.
struct LeanFrame {
  std::vector<int> id;        // ascending
  Eigen::Matrix3Xf x;         // [m]
  Eigen::MatrixXf numbers;    // a row per number, a column per grain
  std::vector<float> radius;  // [m]
};

struct Number {
  const char* name;
  const char* unit;
  const Eigen::Matrix3Xd BedFrame::*vector;  // its length is the number
};
const Number kNumbers[] = {{"speed", "m/s", &BedFrame::v}, {"force", "N", &BedFrame::f}};

LeanFrame lean(const BedFrame& bed, const std::vector<Number>& numbers, const std::string& file) {
  LeanFrame frame{bed.id, bed.x.cast<float>(), {}, {bed.radius.begin(), bed.radius.end()}};
  frame.numbers.resize(numbers.size(), bed.x.cols());
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const Eigen::Matrix3Xd& vectors = bed.*numbers[j].vector;
    if (vectors.cols() != bed.x.cols())
      throw InputError(code::kRunDamaged,
                       file + ": lacks the " + numbers[j].name + " of grains, which the first dump has");
    frame.numbers.row(j) = vectors.colwise().norm().cast<float>();
  }
  if (!frame.x.allFinite() || !frame.numbers.allFinite())
    throw InputError(code::kRunDamaged, file + ": has a number that is not finite");
  return frame;
}

// The value that one in a thousand exceeds.
double upper(std::vector<float> values) {
  if (values.empty()) return 0.0;
  const auto k = static_cast<std::ptrdiff_t>(kShown * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[k];
}

std::size_t most_frames(const FrameLimits& limits, std::size_t grains) {
  const double room = limits.most_grains / static_cast<double>(std::max<std::size_t>(grains, 1));
  const std::size_t most = std::max<std::size_t>(2, static_cast<std::size_t>(room));
  return limits.frames > 0 ? std::min(most, static_cast<std::size_t>(limits.frames)) : most;
}

// Calls action(column in the frame, place among the grains of all frames).
template <class Action>
void for_each_place(const std::vector<int>& all, const LeanFrame& frame, const Action& action) {
  std::size_t place = 0;
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    while (all[place] != frame.id[i]) ++place;
    action(i, place);
  }
}

using Dumps = std::vector<std::pair<long, std::string>>;  // step, file

struct FrameBed {
  std::vector<double> times;  // [s]
  std::vector<LeanFrame> frames;
  std::vector<Number> numbers;
  std::vector<int> ids;  // of all frames, ascending
};

FrameBed read_bed(const Dumps& dumps, double dt) {
  FrameBed bed;
  for (const auto& [step, file] : dumps) {
    const BedFrame frame = read_bed_frame(file);
    if (bed.numbers.empty())  // the first dumps may have no grains
      for (const Number& number : kNumbers)
        if ((frame.*number.vector).cols() > 0) bed.numbers.push_back(number);
    bed.times.push_back(static_cast<double>(step) * dt);
    bed.frames.push_back(lean(frame, bed.numbers, file));
    if (frame.id == bed.ids) continue;
    std::vector<int> both;
    std::set_union(bed.ids.begin(), bed.ids.end(), frame.id.begin(), frame.id.end(), std::back_inserter(both));
    bed.ids = std::move(both);
  }
  for (LeanFrame& frame : bed.frames)
    if (frame.x.cols() == 0) frame.numbers.resize(bed.numbers.size(), 0);
  return bed;
}

// Displacement of the grains since the first frame, at the end of the colour scale [m].
double farthest(const FrameBed& bed) {
  double most = 0.0;
  std::vector<Eigen::Vector3f> start(bed.ids.size());
  std::vector<bool> known(bed.ids.size(), false);
  for_each_place(bed.ids, bed.frames.front(), [&](Eigen::Index i, std::size_t place) {
    start[place] = bed.frames.front().x.col(i);
    known[place] = true;
  });
  for (const LeanFrame& frame : bed.frames) {
    std::vector<float> distance;
    for_each_place(bed.ids, frame, [&](Eigen::Index i, std::size_t place) {
      if (known[place]) distance.push_back((frame.x.col(i) - start[place]).norm());
    });
    most = std::max(most, upper(std::move(distance)));
  }
  return most;
}

}  // namespace

void add_grains(const std::string& run, double dt, FrameLimits& limits, PageParts& parts) {
  parts.run["grains"] = nullptr;
  const std::map<long, std::string> dumps = find_bed_frames(run);
  if (dumps.empty()) return;
  add_dumps(dumps,
            std::max(read_bed_frame(dumps.begin()->second).count(), read_bed_frame(dumps.rbegin()->second).count()), dt,
            limits, parts);
}

void add_dumps(const std::map<long, std::string>& dumps, int count, double dt, FrameLimits& limits, PageParts& parts) {
  const std::size_t most = most_frames(limits, count);
  const FrameBed bed = read_bed(thinned(Dumps(dumps.begin(), dumps.end()), most), dt);
  const std::size_t n = bed.ids.size();
  if (bed.frames.size() < dumps.size())
    limits.notes.push_back("The run dumped its grains " + std::to_string(dumps.size()) + " times; " +
                           std::to_string(bed.frames.size()) + " of them are shown, evenly spread.");

  Box box, view;
  std::vector<float> radius(n, 0.0f);
  for (const LeanFrame& frame : bed.frames) {
    for (Eigen::Index i = 0; i < frame.x.cols(); ++i) box.include(frame.x.col(i).cast<double>());
    if (view.is_empty()) view = box;
    for_each_place(bed.ids, frame, [&](Eigen::Index i, std::size_t place) { radius[place] = frame.radius[i]; });
  }
  std::vector<double> largest, shown;
  for (std::size_t j = 0; j < bed.numbers.size(); ++j) {
    double all = 0.0, most_of_all = 0.0;
    for (const LeanFrame& frame : bed.frames) {
      const Eigen::VectorXf row = frame.numbers.row(j);
      if (row.size() > 0) all = std::max(all, static_cast<double>(row.maxCoeff()));
      most_of_all = std::max(most_of_all, upper({row.begin(), row.end()}));
    }
    largest.push_back(all > 0.0 ? all : 1.0);
    shown.push_back(most_of_all > 0.0 ? most_of_all : largest.back());
  }

  Json& grains = parts.run["grains"];
  grains = {{"count", n}, {"times", bed.times}, {"farthest", farthest(bed)}, {"numbers", Json::array()}};
  add_box(box, view, grains);
  for (std::size_t j = 0; j < bed.numbers.size(); ++j)
    grains["numbers"].push_back(
        {{"name", bed.numbers[j].name}, {"unit", bed.numbers[j].unit}, {"largest", largest[j]}, {"shown", shown[j]}});
  parts.chunks.emplace_back("grains-radius", packed_numbers(radius));
  if (limits.with_ids)
    parts.chunks.emplace_back("grains-ids", packed_numbers(std::vector<std::uint32_t>(bed.ids.begin(), bed.ids.end())));
  PackedSeries series(n * (3 + bed.numbers.size()));
  for (std::size_t k = 0; k < bed.frames.size(); ++k) {
    const LeanFrame& frame = bed.frames[k];
    std::vector<std::uint16_t> values(n * (3 + bed.numbers.size()), 0);
    std::fill_n(values.begin(), n, kAbsent);
    for_each_place(bed.ids, frame, [&](Eigen::Index i, std::size_t place) {
      for (int axis = 0; axis < 3; ++axis)
        values[static_cast<std::size_t>(axis) * n + place] = box.number_of(axis, static_cast<double>(frame.x(axis, i)));
      for (std::size_t j = 0; j < bed.numbers.size(); ++j)
        values[(3 + j) * n + place] = root_number(static_cast<double>(frame.numbers(j, i)), largest[j]);
    });
    parts.add_frame("grains", k, series.add(values));
  }
}

namespace {

// The page may load nothing, whatever it contains; the page of a run in progress may read the events of its server.
std::string policy_of(const PageParts& parts) {
  const std::string alone =
      "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";
  return parts.run.contains("live") ? alone + "; connect-src 'self'" : alone;
}

bool touches_grains(const Json& scene) {
  return scene.contains("ground") && scene.at("ground").value("kind", "") == "particles";
}

// Reports what the page lacks, and how to get it.
std::vector<std::string> missing_of(const Json& summary, const PageParts& parts) {
  std::vector<std::string> missing;
  const Json scene = summary.value("scene", Json::object());
  if (parts.run.at("grains").is_null() && touches_grains(scene))
    missing.push_back("The run has no dumps of grains, so none are shown. " + how_to_dump(scene));
  if (parts.run.at("bodies").is_null())
    missing.push_back(parts.run.at("marks").is_null()
                          ? "There are no drawings of bodies: output.vtk was false, or no body of the scene has a "
                            "shape or a boundary."
                          : "No body of the scene has a shape or a boundary: only symbols are shown.");
  return missing;
}

// run.requirements: name, result, limits and verdict of each; run.peaks: name, value and time [s] (or null) of key numbers.
void add_judgement(const Json& summary, PageParts& parts) {
  parts.run["requirements"] = parts.run["peaks"] = Json::array();
  const std::vector<std::string> lines = requirement_lines(summary);
  const Json list = summary.value("requirements", Json::array());
  for (std::size_t i = 0; i < lines.size(); ++i)
    parts.run["requirements"].push_back({lines[i], list.at(i).value("verdict", "")});
  for (const KeyNumber& one : key_numbers(summary))
    parts.run["peaks"].push_back({one.name, one.value, one.time >= 0.0 ? Json(one.time) : Json()});
}

std::string view_of(const ViewArguments& a, const fs::path& folder) {
  const Json summary = read_summary((folder / "summary.json").string());
  PageParts parts;
  FrameLimits limits;
  limits.frames = a.frames;
  const double dt = summary.value("dt_dem_s", 0.0);
  parts.run["grains"] = nullptr;
  if (dt > 0.0) add_grains(folder.string(), dt, limits, parts);
  add_bodies(folder.string(), summary, limits, parts);
  if (const auto terrain = read_whole_file((folder / kTerrainFile).string()); terrain && parts.run["grains"].is_null())
    parts.run["terrain"] = Json::parse(*terrain);
  const Json scene = summary.value("scene", Json::object());
  add_surroundings(scene, parts);
  add_static_meshes(scene, parts, limits.notes);
  if (parts.run["grains"].is_null() && touches_grains(scene)) add_bed_block(scene, parts);
  const History history = read_history((folder / "history.csv").string());
  if (history.column("time").empty()) throw InputError(code::kNoRun, without_summary(a.run, "history.csv has no rows"));
  add_history(history, first_columns(history, summary.value("observed_body", "")), parts);
  std::vector<std::string> notes = missing_of(summary, parts);
  notes.insert(notes.end(), limits.notes.begin(), limits.notes.end());
  for (const std::string& note : a.quiet ? std::vector<std::string>() : notes)
    std::fprintf(stderr, "footfall: %s\n", note.c_str());
  const std::string given = scene.value("title", "");
  std::string shown = given.empty() ? folder.filename().string() : given;
  if (!a.other.empty()) {
    const RunPair pair(a.run, a.other);
    add_second_run(pair, true, parts);
    shown = pair.a.name + " and " + pair.b.name;
  }
  parts.run["title"] = shown;
  add_judgement(summary, parts);
  return page_text(shown, folder.filename().string(), summary, notes, parts);
}

}  // namespace

void add_surroundings(const Json& scene, PageParts& parts) {
  parts.run["gravity"] = scene.value("gravity", std::vector<double>{0, 0, 0});
  Json& planes = parts.run["planes"] = Json::array();
  const auto add = [&](const Json& plane) {
    planes.push_back({{"point", plane.value("point", std::vector<double>{0, 0, 0})},
                      {"normal", plane.value("normal", std::vector<double>{0, 0, 1})}});
  };
  const Json ground = scene.value("ground", Json::object());
  if (!parts.run.contains("terrain")) {  // else this is drawn instead
    if (ground.value("kind", "") == "plane") add(ground.value("plane", Json::object()));
    if (ground.value("kind", "") == "soil") add(ground.value("law", Json::object()));
  }
  for (const Json& contact : scene.value("contacts", Json::array()))
    if (const Json between = contact.value("between", Json::array()); between.size() == 2 && between[1] == kPlaneWord)
      add(contact);
}

std::string page_text(const std::string& title, const std::string& place, const Json& summary,
                      const std::vector<std::string>& notes, const PageParts& parts) {
  std::string head, missing;
  std::vector<std::string> warnings;
  if (const std::string status = summary.value("status", "unknown"); status != "done")
    warnings.push_back("This run is not complete: " + end_text(summary));
  for (const Json& text : summary.value("warnings", Json::array())) warnings.push_back(text.get<std::string>());
  if (!warnings.empty()) {
    head += "<details class=\"warning\"><summary>" + std::to_string(warnings.size()) +
            (warnings.size() == 1 ? " warning: " : " warnings: ") + html_with_code(warnings.front()) + "</summary>";
    for (const std::string& text : warnings) head += "<p>" + html_with_code(text) + "</p>";
    head += "</details>";
  }
  for (const std::string& note : notes) missing += "<p>" + html_with_code(note) + "</p>";
  return "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
         "charset=\"utf-8\"/>\n<meta http-equiv=\"Content-Security-Policy\" content=\"" +
         policy_of(parts) + "\"/>\n<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>" +
         html_text(title) + "</title>\n<link rel=\"icon\" href=\"data:,\"/>\n</head>\n<body>\n<header><h1>" +
         html_text(title) + "</h1><span>" + html_text(place) + "</span>" + head +
         "</header>\n<div id=\"footfall-stage\"><div id=\"footfall-panel\"></div><div "
         "id=\"footfall-caption\"></div><div id=\"footfall-loading\" "
         "hidden=\"\"></div><div id=\"footfall-missing\"" +
         (missing.empty() ? " hidden=\"\"" : "") + ">" + missing +
         "</div></div>\n<div id=\"footfall-plots\"></div>\n<div id=\"footfall-bar\"></div>\n<div id=\"footfall-fault\" "
         "hidden=\"\"></div>\n" +
         parts.elements(kViewScript) + "</body>\n</html>\n";
}

std::string how_to_dump(const Json& scene) {
  if (!touches_grains(scene)) return "It has no grains.";
  return scene.value("particles", Json::object()).contains("box")
             ? "Run it with `--set particles.box.frame_interval=0.01`."
             : "Run it with `--set particles.variables.frames=0.01` if its script has this variable; otherwise add to "
               "the script: `dump grains all custom 500 ${out}/grains_*.txt id type x y z vx vy vz fx fy fz radius`.";
}

std::string write_view(const ViewArguments& arguments) {
  const fs::path folder = fs::absolute(arguments.run).lexically_normal();
  if (!fs::exists(folder / "summary.json") || !fs::exists(folder / "history.csv"))
    throw InputError(code::kNoRun,
                     without_summary(arguments.run, "no summary.json and history.csv; expected the folder of a run"));
  const std::string text = with_summary_of(arguments.run, [&] { return view_of(arguments, folder); });
  const std::string file = arguments.file.empty()
                               ? (folder / (arguments.other.empty() ? kViewPage : "view_pair.html")).string()
                               : arguments.file;
  write_whole_file(file, text, "is the disk full?");
  return file;
}

bool has_frames(const std::string& run) {
  const fs::path folder(run);
  return fs::exists(folder / "bodies.pvd") || fs::exists(folder / "motion") || !find_bed_frames(run).empty();
}

}  // namespace footfall
