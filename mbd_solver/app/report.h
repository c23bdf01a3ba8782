#pragma once
// One HTML page that needs nothing else: style, tables and pictures stand in it. It is well-formed XML as well.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace footfall {

class HtmlPage {
 public:
  explicit HtmlPage(const std::string& title);

  // Texts are plain: characters that mean something in HTML are escaped here.
  void section(const std::string& heading);  // also an entry of the contents
  void paragraph(const std::string& text);
  void warning(const std::string& text);
  void link(const std::string& file, const std::string& label, const std::string& text);  // "label: text"
  // Interactive plots: what PageParts::elements makes, and the place that their script fills.
  void plots(const std::string& elements);
  // The first row is the head, when `head`. Cells that are numbers stand to the right.
  void table(const std::vector<std::vector<std::string>>& rows, bool head = true);
  void preformatted(const std::string& text);
  // Opened by a click. Lines that hold one of `marks` are marked.
  void folded(const std::string& label, const std::string& text, const std::vector<std::string>& marks = {});
  // PNG or SVG file, put into the page; its name without ending is the caption unless one is given. Throws InputError
  // when it cannot be read.
  void picture(const std::string& path, const std::string& caption = "");

  // The browser reads the page anew after so long [s].
  void refresh(int seconds) { refresh_ = seconds; }

  std::string text() const;

 private:
  std::string title_, contents_, body_;
  int refresh_ = 0;
  int sections_ = 0;
};

std::string base64(const std::string& bytes);

// Parts of report.html that pages of runs and of sweeps share.

using Rows = std::vector<std::vector<std::string>>;  // of a table

constexpr const char* kLedgerPicture = "ledger.png";  // stands in a section of its own

std::string short_text(double value);  // five digits

// A picture that gnuplot began and did not draw is empty.
bool has_content(const std::string& file);
std::vector<std::string> pictures_in(const std::string& folder);
// The PNG files of a folder under a heading; nothing when there are none.
void show_pictures(const std::string& folder, const std::string& heading, HtmlPage& page);

// What was assumed, the scene file with those that it is built on, the scripts of the grains, and the scene with its
// defaults.
void show_scene(const nlohmann::ordered_json& summary, HtmlPage& page);
void show_versions(const nlohmann::ordered_json& summary, HtmlPage& page);

// report.html of a run.

// Its text; makes the ledger, plots and view.html that the run lacks. `run`: absolute path of the folder. Throws
// InputError for damaged files.
std::string run_page(const std::string& run);

// footfall report DIR: one page for a run or a sweep, DIR/report.html, that can be read without network and sent to
// somebody.

// Writes the page and returns its path. Throws InputError for a folder that is neither a run nor a sweep.
std::string write_report(const std::string& folder);

}  // namespace footfall
