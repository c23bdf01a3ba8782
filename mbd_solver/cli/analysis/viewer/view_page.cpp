#include "mbd_solver/cli/analysis/viewer/view_page.h"

#include <cstdio>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/made_files.h"
#include "coupler/base/quote.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/viewer/assets.h"
#include "mbd_solver/cli/analysis/viewer/frames_of_run.h"
#include "mbd_solver/cli/grains/bed_frames.h"
#include "mbd_solver/output/summary.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Nothing may be loaded, whatever the page holds.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

bool touches_grains(const Json& scene) {
  return scene.contains("ground") && scene.at("ground").value("kind", "") == "particles";
}

// What the user may miss, and how to get it.
std::vector<std::string> missing_of(const Json& summary, const PageParts& parts) {
  std::vector<std::string> missing;
  const Json scene = summary.value("scene", Json::object());
  if (parts.run.at("grains").is_null() && touches_grains(scene))
    missing.push_back(
        "The run dumped no grains, so none are shown. Where its script knows the variable, run it with "
        "--set particles.variables.frames=0.01; else add a dump of id x y z vx vy vz radius to the script.");
  if (parts.run.at("bodies").is_null())
    missing.push_back(
        "There are no drawings of bodies: either output.vtk was false, or no body of the scene has a shape or a "
        "boundary.");
  return missing;
}

void add_plane(const Json& summary, PageParts& parts) {
  const Json scene = summary.value("scene", Json::object());
  if (!scene.contains("ground") || scene.at("ground").value("kind", "") != "plane") return;
  const Json& plane = scene.at("ground").value("plane", Json::object());
  parts.run["plane"] = {{"point", plane.value("point", std::vector<double>{0, 0, 0})},
                        {"normal", plane.value("normal", std::vector<double>{0, 0, 1})}};
}

std::string page_text(const std::string& title, const std::string& folder, const Json& summary,
                      const std::vector<std::string>& notes, const PageParts& parts) {
  std::string head, said;
  if (const std::string status = summary.value("status", "unknown"); status != "done")
    head += "<p class=\"warning\">" + html_text("This run is not complete: " + status) + "</p>";
  for (const Json& text : summary.value("warnings", Json::array()))
    head += "<p class=\"warning\">" + html_text(text.get<std::string>()) + "</p>";
  for (const std::string& note : notes) said += "<p>" + html_text(note) + "</p>";
  return "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
         "charset=\"utf-8\"/>\n<meta http-equiv=\"Content-Security-Policy\" content=\"" +
         std::string(kPolicy) + "\"/>\n<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>" +
         html_text(title) + "</title>\n<link rel=\"icon\" href=\"data:,\"/>\n</head>\n<body>\n<header><h1>" +
         html_text(title) + "</h1><span>" + html_text(folder) + "</span>" + head +
         "</header>\n<div id=\"footfall-stage\"><div id=\"footfall-panel\"></div><div id=\"footfall-loading\" "
         "hidden=\"\"></div><div id=\"footfall-missing\"" +
         (said.empty() ? " hidden=\"\"" : "") + ">" + said +
         "</div></div>\n<div id=\"footfall-plots\"></div>\n<div id=\"footfall-bar\"></div>\n<div id=\"footfall-fault\" "
         "hidden=\"\"></div>\n" +
         parts.elements(kViewScript) + "</body>\n</html>\n";
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
  add_plane(summary, parts);
  const History history = read_history((folder / "history.csv").string());
  if (history.column("time").empty())
    throw InputError((folder / "history.csv").string() + ": holds no row; the run ended before there was one");
  add_history(history, first_columns(history, summary.value("observed_body", "")), parts);
  std::vector<std::string> notes = missing_of(summary, parts);
  notes.insert(notes.end(), limits.notes.begin(), limits.notes.end());
  for (const std::string& note : notes) std::fprintf(stderr, "footfall: %s\n", note.c_str());
  const std::string title = summary.value("scene", Json::object()).value("title", "");
  return page_text(title.empty() ? folder.filename().string() : title, folder.filename().string(), summary, notes,
                   parts);
}

}  // namespace

std::string write_view(const ViewArguments& arguments) {
  const fs::path folder = fs::absolute(arguments.run).lexically_normal();
  if (!fs::exists(folder / "summary.json") || !fs::exists(folder / "history.csv"))
    throw InputError(arguments.run + ": holds no summary.json and history.csv; expected the folder of a run");
  const std::string text = with_summary_of(arguments.run, [&] { return view_of(arguments, folder); });
  const MadeFiles made(folder.string());
  const std::string file = (folder / "view.html").string();
  write_whole_file(file, text, "is the disk full?");
  return file;
}

bool has_frames(const std::string& run) {
  const fs::path folder(run);
  return fs::exists(folder / "bodies.pvd") || fs::exists(folder / "motion") || !find_bed_frames(run).empty();
}

}  // namespace footfall
