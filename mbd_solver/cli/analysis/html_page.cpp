#include "mbd_solver/cli/analysis/html_page.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/quote.h"
#include "coupler/base/whole_file.h"

namespace footfall {
namespace {

constexpr const char* kSheet =
    "body{font:15px/1.5 sans-serif;color:#222;max-width:1000px;margin:2em auto;padding:0 1em}"
    "h1{font-size:1.7em}h2{margin-top:2em;border-bottom:1px solid #ccc}table{border-collapse:collapse;margin:1em 0}"
    "td,th{padding:.2em .8em;border-bottom:1px solid "
    "#e4e4e4;text-align:left}td.n{text-align:right;font-variant-numeric:tabular-nums}"
    "pre{background:#f6f6f4;padding:.8em;overflow-x:auto;font-size:12.5px;line-height:1.4}mark{background:#ffe9a8}"
    "figure{margin:1.2em 0}figure img{max-width:100%}figcaption{color:#666}.warning{background:#fff0e0;border-left:4px "
    "solid #d55e00;padding:.4em .8em}"
    "nav a{margin-right:1em}summary{cursor:pointer}";

bool is_number(const std::string& text) {
  std::istringstream in(text);
  double value = 0.0;
  return static_cast<bool>(in >> value);
}

}  // namespace

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t block = 0;
    for (std::size_t k = 0; k < 3; ++k)
      block = (block << 8) | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kDigits[(block >> (18 - 6 * k)) & 63u] : '=';
  }
  return out;
}

HtmlPage::HtmlPage(const std::string& title) : title_(title) {}

void HtmlPage::section(const std::string& heading) {
  const std::string id = "s" + std::to_string(++sections_);
  contents_ += "<a href=\"#" + id + "\">" + html_text(heading) + "</a> ";
  body_ += "<h2 id=\"" + id + "\">" + html_text(heading) + "</h2>\n";
}

void HtmlPage::paragraph(const std::string& text) { body_ += "<p>" + html_text(text) + "</p>\n"; }

void HtmlPage::warning(const std::string& text) { body_ += "<p class=\"warning\">" + html_text(text) + "</p>\n"; }

void HtmlPage::link(const std::string& file, const std::string& label, const std::string& text) {
  body_ += "<p><a href=\"" + html_text(file) + "\">" + html_text(label) + "</a>: " + html_text(text) + "</p>\n";
}

void HtmlPage::plots(const std::string& elements) { body_ += "<div id=\"footfall-plots\"></div>\n" + elements; }

void HtmlPage::table(const std::vector<std::vector<std::string>>& rows, bool head) {
  body_ += "<table>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string cell = head && i == 0 ? "th" : "td";
    body_ += "<tr>";
    for (const std::string& text : rows[i])
      body_ += "<" + cell + (cell == "td" && is_number(text) ? " class=\"n\"" : "") + ">" + html_text(text) + "</" +
               cell + ">";
    body_ += "</tr>\n";
  }
  body_ += "</table>\n";
}

void HtmlPage::preformatted(const std::string& text) { body_ += "<pre>" + html_text(text) + "</pre>\n"; }

void HtmlPage::folded(const std::string& label, const std::string& text, const std::vector<std::string>& marks) {
  body_ += "<details><summary>" + html_text(label) + "</summary><pre>";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool marked = std::any_of(marks.begin(), marks.end(),
                                    [&](const std::string& m) { return line.find(m) != std::string::npos; });
    body_ += (marked ? "<mark>" : "") + html_text(line) + (marked ? "</mark>" : "") + "\n";
  }
  body_ += "</pre></details>\n";
}

void HtmlPage::picture(const std::string& path, const std::string& caption) {
  const std::string bytes = read_whole_file(path).value_or("");
  if (bytes.empty()) throw InputError(path + ": cannot be read; expected a picture");
  const std::filesystem::path name(path);
  const std::string kind = name.extension() == ".svg" ? "svg+xml" : "png";
  std::string words = caption.empty() ? name.stem().string() : caption;
  std::replace(words.begin(), words.end(), '_', ' ');
  body_ += "<figure><img alt=\"" + html_text(words) + "\" src=\"data:image/" + kind + ";base64," + base64(bytes) +
           "\"/><figcaption>" + html_text(words) + "</figcaption></figure>\n";
}

std::string HtmlPage::text() const {
  return "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
         "charset=\"utf-8\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
         "style-src "
         "'unsafe-inline'; img-src data:\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width\"/>\n" +
         (refresh_ > 0 ? "<meta http-equiv=\"refresh\" content=\"" + std::to_string(refresh_) + "\"/>\n" : "") +
         "<title>" + html_text(title_) + "</title>\n<style>" + kSheet + "</style>\n</head>\n<body>\n<h1>" +
         html_text(title_) + "</h1>\n<nav>" + contents_ + "</nav>\n" + body_ + "</body>\n</html>\n";
}

}  // namespace footfall
