// Progress lines: when the next one is due, and how long the work will still take.

#include "mbd_solver/base/live_line.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "coupler/base/clock.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

constexpr double kTerminalPause = 0.2;  // between two versions of the line [s]
constexpr double kFilePause = 1.0;      // between two lines in a file [s]
constexpr double kFirstGuess = 1.0;     // before this time there is no estimate [s]
constexpr double kFirstShare = 1e-3;    // nor before this share of the work

int whole_percent(double share) { return static_cast<int>(std::floor(100.0 * std::clamp(share, 0.0, 1.0) + 1e-9)); }

}  // namespace

bool LiveLine::due(double share) {
  if (quiet_) return false;
  if (!terminal_ && whole_percent(share) <= percent_) return false;
  const double now = wall_clock();
  if (now - last_ < (terminal_ ? kTerminalPause : kFilePause)) return false;
  last_ = now;
  percent_ = whole_percent(share);
  return true;
}

void LiveLine::show(const std::string& text) {
  if (quiet_) return;
  // \033[K clears the rest of a longer line.
  std::printf(terminal_ ? "\r%s\033[K" : "%s\n", text.c_str());
  std::fflush(stdout);
  open_ = terminal_;
}

void LiveLine::finish(bool clear) {
  if (open_) std::printf(clear ? "\r\033[K" : "\n");
  open_ = false;
  std::fflush(stdout);
}

std::string percent_text(double share) { return std::to_string(whole_percent(share)) + " %"; }

std::string time_left(const Pace& pace) {
  if (pace.spent < kFirstGuess || pace.done_since < kFirstShare || pace.share >= 1.0) return "";
  const double left = (1.0 - pace.share) * pace.spent / pace.done_since;
  if (left < 100.0) return "about " + number_text(std::max(1.0, std::round(left))) + " s left";
  if (left < 6000.0) return "about " + number_text(std::round(left / 60.0)) + " min left";
  const double hours = left / 3600.0;
  return "about " + (hours < 99.5 ? number_text(hours, 2) : number_text(std::round(hours))) + " h left";
}

std::string time_text(double time, double t_end, const Pace& pace) {
  const std::string left = time_left(pace);
  return "t = " + fixed_text(time, 4) + " of " + number_text(t_end) + " s (" + percent_text(pace.share) + ")" +
         (left.empty() ? "" : ", " + left);
}

}  // namespace footfall
