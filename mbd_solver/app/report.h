#pragma once
// footfall report: one HTML page about a run or a sweep, which needs neither network nor other files; and the page itself,
// for others that write one.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

// The data of an interactive page for its scripts: one JSON with all small values, and chunks of compressed numbers by name, which
// web/src/page.js reads.
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

// A page that contains its style, tables and pictures. It is also well-formed XML.
class HtmlPage {
 public:
  explicit HtmlPage(const std::string& title);

  // Texts are plain; characters with a meaning in HTML are escaped here.
  void section(const std::string& heading);  // also an entry of the contents
  void subsection(const std::string& heading);
  void paragraph(const std::string& text);
  void warning(const std::string& text);
  void link(const std::string& file, const std::string& label, const std::string& text);  // "label: text"
  // What web/src/report.js draws of the page's data.
  PageParts& data() { return data_; }
  void plots();                                // any column, of add_history
  void mechanism(const std::string& caption);  // of the first frame of add_shapes, with run.bodyNames and run.gravity
  void figures(const std::vector<Figure>& figures, const History& history);
  // `head`: the first row is the head. Numbers are aligned to the right. classes, one per row or none: met, missed, open.
  void table(const std::vector<std::vector<std::string>>& rows, bool head = true,
             const std::vector<std::string>& classes = {});
  void preformatted(const std::string& text);
  // Folded until clicked. Lines that contain one of `marks` are marked.
  void folded(const std::string& label, const std::string& text, const std::vector<std::string>& marks = {});
  // A PNG or SVG file; the caption is its name without ending unless given. Throws InputError.
  void picture(const std::string& path, const std::string& caption = "");
  // The browser continues to this address.
  void forward_to(const std::string& address) { address_ = address; }

  std::string text() const;

 private:
  std::string title_, contents_, body_, address_;
  PageParts data_;
  int sections_ = 0;
};

// ---- the sheet of a design review (review_sheet.cpp): printed after a run, and first on the page ----

// All requirements of this summary.json are met; also without any.
bool requirements_met(const nlohmann::ordered_json& summary);

// One line per requirement: "name: 3.2 g, at most 5 g: met, margin 1.8 g (36 %)".
std::vector<std::string> requirement_lines(const nlohmann::ordered_json& summary);

// A number with its unit, of a size that can be read: 1234.5, "N" -> "1.234 kN".
std::string readable(double value, const std::string& unit);

// A section of them, first on the page of a run; none without any.
void show_requirements(const nlohmann::ordered_json& summary, HtmlPage& page);

// The key numbers of a run with their errors: name, value, and the time [s] of a peak; below zero: of none.
struct KeyNumber {
  std::string name, value;
  double time = -1.0;
};
std::vector<KeyNumber> key_numbers(const nlohmann::ordered_json& summary);

// The tables of the sheet for the run in `folder`.
void show_sheet(const std::string& folder, const nlohmann::ordered_json& summary, HtmlPage& page);

// Of many runs, by name: per requirement the worst case, and how many runs meet it.
using NamedSummaries = std::vector<std::pair<std::string, nlohmann::ordered_json>>;
void show_worst_cases(const NamedSummaries& runs, HtmlPage& page);

// Writes DIR/report.html and returns its path; makes ledger.csv and view.html where the run lacks them. Throws
// InputError for a folder that is neither a run nor a sweep, or damaged files.
std::string write_report(const std::string& folder);

}  // namespace footfall
