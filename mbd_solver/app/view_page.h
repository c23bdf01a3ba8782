#pragma once
// footfall view: DIR/view.html, one file that plays a run in 3D with plots next to it, without network.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/app/mechanism_shape.h"
#include "mbd_solver/app/report.h"

namespace footfall {

struct FrameLimits {
  int frames = 0;                  // of the grains, at most; 0: as many as `most_grains` allows
  double most_grains = 1.5e7;      // grains times frames: about 100 MB of page at most
  std::size_t moments = 201;       // of recorded surfaces
  std::vector<std::string> notes;  // parts that were left out
  bool with_ids = false;           // also a chunk grains-ids
};

// The dumps of grains in `run`, evenly thinned to the limits: run.grains (count, times, box, view, numbers) and chunks
// grains-radius, grains-K; run.grains is null without dumps. dt: DEM time step [s]. Throws InputError for damaged files.
void add_grains(const std::string& run, double dt, FrameLimits& limits, PageParts& parts);

// The same for these dumps, by step, of grains of at most `count` a dump.
void add_dumps(const std::map<long, std::string>& dumps, int count, double dt, FrameLimits& limits, PageParts& parts);

// The mechanism (MechanismShapes): run.bodies (points, cells, times, box, view, stress) and run.bodyNames, and chunks
// bodies-triangles, -lines, -cells, -radius, bodies-K; run.marks (times, list, box, view) and the chunk marks. Each is null where
// nothing was drawn.
void add_bodies(const std::string& run, const nlohmann::ordered_json& summary, FrameLimits& limits, PageParts& parts);

// The same for frames of equal size at these times [s].
void add_shapes(const std::vector<double>& times, const std::vector<MechanismShape>& frames, PageParts& parts);

// run.gravity [m/s2], and run.planes: {point [m], normal} of the ground and of contacts with planes. scene: as in summary.json.
void add_surroundings(const nlohmann::ordered_json& scene, PageParts& parts);

// The page of these parts. place: the folder or file that it shows. notes: what it lacks. Status and warnings come from the
// summary.
std::string page_text(const std::string& title, const std::string& place, const nlohmann::ordered_json& summary,
                      const std::vector<std::string>& notes, const PageParts& parts);

inline constexpr const char* kViewPage = "view.html";  // in the folder of a run

struct ViewArguments {
  std::string run;         // folder of a run
  std::string other = "";  // of a second one, as a ghost; empty: none
  int frames = 0;          // dumps of grains, at most; 0: as many as fit into about 100 MB
  std::string file = "";   // of the page; empty: DIR/view.html, of two runs DIR/view_pair.html
  bool quiet = false;      // what the page lacks is on the page alone
};

// Writes the page and returns its path. Throws InputError for a folder without a run, or damaged files.
std::string write_view(const ViewArguments& arguments);

// True when there are grains or bodies to be played.
bool has_frames(const std::string& run);

// What gives a run of this scene dumps of grains: a sentence.
std::string how_to_dump(const nlohmann::ordered_json& scene);

}  // namespace footfall
