#pragma once
// What a page of a run holds for its scripts: one JSON with all that is small, and chunks of packed numbers by name.
// web/src/page.js takes them.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/run/output/history.h"

namespace footfall {

struct PageParts {
  using Chunk = std::pair<std::string, std::string>;  // name, text: base64, as packed_series.h makes it

  nlohmann::ordered_json run;
  std::vector<Chunk> chunks;                             // what the first picture needs
  std::map<std::size_t, std::vector<Chunk>> later = {};  // by frame

  // The chunk NAME-k of frame k.
  void add_frame(const std::string& name, std::size_t k, std::string text);

  // As elements of a page: the JSON, the script, the chunks, frame by frame. The script draws while a browser still
  // reads the frames. Well-formed XML as well, whatever the texts hold.
  std::string elements(const std::string& script) const;
};

// The history's columns in single precision, and the times as they are. Of more than 4000 rows the lowest and highest
// values of each span (reduced_rows.h). `shown`: the columns that are plotted at first.
void add_history(const History& history, const std::vector<std::string>& shown, PageParts& parts);

// The columns of a run that are worth a first look, at most six: acceleration of the observed body, contact forces or
// forces of struts, else what there is.
std::vector<std::string> first_columns(const History& history, const std::string& observed);

// Grains and bodies of a run, frame by frame, packed for a page.

struct FrameLimits {
  int frames = 0;                  // of the grains, at most; 0: as many as `most_grains` allows
  double most_grains = 1.5e7;      // grains times frames: about 100 MB of page at the very worst
  std::size_t moments = 201;       // of surfaces that were recorded window by window
  std::vector<std::string> notes;  // what was left out
};

// The dumps of grains in `run`, evenly thinned to the limits: run.grains (count, times, box, view, numbers) and chunks
// grains-radius, grains-K. Absent when there are none: run.grains is null. dt: of the grains [s]. Throws InputError for
// damaged files.
void add_grains(const std::string& run, double dt, FrameLimits& limits, PageParts& parts);

// The mechanism as MechanismShapes finds it: run.bodies (points, cells, times, box, view, stress) and run.bodyNames, and
// chunks bodies-triangles, -lines, -cells, -radius, bodies-K. run.bodies is null when there is nothing.
void add_bodies(const std::string& run, const nlohmann::ordered_json& summary, FrameLimits& limits, PageParts& parts);

// view.html: one file that plays a run in 3D, with plots in step. It needs no network, and forbids itself any.

struct ViewArguments {
  std::string run;  // folder of a run
  int frames = 0;   // dumps of the grains, at most; 0: all that a page of about 100 MB holds
};

// Writes RUN/view.html and returns its path. Throws InputError when the folder holds no run, or files of it are damaged.
std::string write_view(const ViewArguments& arguments);

// There are grains or bodies to be played.
bool has_frames(const std::string& run);

}  // namespace footfall
