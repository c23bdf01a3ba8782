#pragma once
// Text of scenes, file names and results as part of what other programs read: whatever it holds, it stays text there.

#include <string>

namespace footfall {

// A string of a gnuplot script, with its quotes. In single quotes gnuplot runs no `command` and replaces no \n;
// characters that would end the line become blanks.
std::string gnuplot_text(const std::string& text);

// One word of a shell's line; in quotes only where it needs them.
std::string shell_word(const std::string& text);

// Text between tags or in an attribute. Characters that HTML does not know are left out.
std::string html_text(const std::string& text);

}  // namespace footfall
