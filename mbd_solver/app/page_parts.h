#pragma once
// The data of an interactive page for its scripts: one JSON with all small values, and chunks of compressed numbers by name, which
// web/src/page.js reads. In report.cpp, as all that writes HTML.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

struct PageParts {
  using Chunk = std::pair<std::string, std::string>;  // name, text of packed_series.h

  nlohmann::ordered_json run;
  std::vector<Chunk> chunks;                             // needed for the first picture
  std::map<std::size_t, std::vector<Chunk>> later = {};  // by frame

  // The chunk NAME-k of frame k.
  void add_frame(const std::string& name, std::size_t k, std::string text);

  // As elements of a page: the JSON, the script, the chunks, frame by frame. The script draws while the browser still reads
  // frames. Well-formed XML, whatever the texts contain.
  std::string elements(const std::string& script) const;
};

// Text for a page: characters with a meaning in HTML are escaped, and what is between ` is code.
std::string html_with_code(const std::string& text);

// The history's columns in single precision, times in double. More than 4000 rows are reduced (plot_script.h,
// drawn_values). `shown`: the columns plotted at first.
void add_history(const History& history, const std::vector<std::string>& shown, PageParts& parts);

// These figures of a history, reduced as it is, as one more group in run.figures (web/src/figures.js). Returns the number of the
// group.
std::size_t add_figures(const std::vector<Figure>& figures, const History& history, PageParts& parts);

// The columns plotted at first, at most six: acceleration of the monitored body, contact forces or forces of struts,
// otherwise what there is.
std::vector<std::string> first_columns(const History& history, const std::string& observed);

// The scripts of web/dist, built into the program.
extern const char* const kViewScript;    // of view.html: three.js, uPlot and web/src
extern const char* const kReportScript;  // of report.html: uPlot and web/src

}  // namespace footfall
