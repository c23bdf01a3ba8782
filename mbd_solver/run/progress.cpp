#include "mbd_solver/run/progress.h"

#include <unistd.h>

#include <cstdlib>

#include "coupler/base/clock.h"

namespace footfall {
namespace {

constexpr double kTerminalPause = 0.2;  // between two versions of the line [s]
constexpr double kFilePause = 5.0;      // between two lines in a file [s]

// Under mpirun this program writes to a pseudo-terminal of mpirun's, whatever stands behind: the front door says what
// it is.
bool on_terminal() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr) return std::getenv("FOOTFALL_TERMINAL") != nullptr;
  return isatty(STDOUT_FILENO) == 1;
}

}  // namespace

Progress::Progress(double t_end, bool quiet)
    : t_end_(t_end), quiet_(quiet), terminal_(on_terminal()), started_(wall_clock()) {}

void Progress::show(double time, long windows, double contact_force) {
  if (quiet_) return;
  const double wall = wall_clock();
  if (wall - last_ < (terminal_ ? kTerminalPause : kFilePause)) return;
  last_ = wall;
  const double spent = wall - started_;
  const double factor = spent > 0.0 ? time / spent : 0.0;  // simulated per real second
  const double left = factor > 0.0 ? (t_end_ - time) / factor : 0.0;
  std::printf("%st = %.4f of %g s | %.2e x real time | %.0f s left | %ld windows | contact %.2f kN%s",
              terminal_ ? "\r" : "", time, t_end_, factor, left, windows, contact_force / 1e3,
              terminal_ ? "   " : "\n");
  std::fflush(stdout);
  open_ = terminal_;
}

void Progress::finish() {
  if (open_) std::printf("\n");
  open_ = false;
  std::fflush(stdout);
}

}  // namespace footfall
