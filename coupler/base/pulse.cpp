// futimens() on a file that was opened at the start: the time of a file can be changed without any right to write.

#include "coupler/base/pulse.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cstdlib>

#include "coupler/base/clock.h"

namespace footfall {
namespace {

constexpr double kInterval = 1.0;  // [s]

int g_file = -1;
double g_last = 0.0;  // wall clock [s]

}  // namespace

void open_pulse() {
  if (const char* path = std::getenv(kPulse)) g_file = open(path, O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
}

void pulse() {
  if (g_file < 0) return;
  const double now = wall_clock();
  if (now - g_last < kInterval) return;
  g_last = now;
  futimens(g_file, nullptr);
}

}  // namespace footfall
