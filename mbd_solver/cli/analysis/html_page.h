#pragma once
// One HTML page that needs nothing else: style, tables and pictures stand in it. It is well-formed XML as well.

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

}  // namespace footfall
