#pragma once
// Quotes text of scenes, file names and results for other programs: whatever it contains, they read it as text.

#include <string>

namespace footfall {

// A string of a gnuplot script with its quotes. In single quotes gnuplot runs no `command` and replaces no \n;
// characters that would end the line become blanks.
std::string gnuplot_text(const std::string& text);

// One word of a shell command; quoted only where necessary.
std::string shell_word(const std::string& text);

// Text between tags or in an attribute. Control characters, which HTML does not know, are left out.
std::string html_text(const std::string& text);

}  // namespace footfall
