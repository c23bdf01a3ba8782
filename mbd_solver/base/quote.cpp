// Quoting for gnuplot, shells and HTML.

#include "mbd_solver/base/quote.h"

namespace footfall {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

std::string gnuplot_text(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += '\'';
    quoted += is_control(c) ? ' ' : c;
  }
  return quoted + "'";
}

std::string shell_word(const std::string& text) {
  bool plain = !text.empty();
  for (const char c : text)
    plain = plain && !is_control(c) && std::string(" \"'\\$&|;<>(){}[]*?!#~`").find(c) == std::string::npos;
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string html_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (!is_control(c) || c == '\n' || c == '\t') {
      out += c;
    }
  }
  return out;
}

}  // namespace footfall
