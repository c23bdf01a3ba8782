// LAMMPS_NS::Run::command: a loop of the script (`jump`), or a `run N every M`, may go on after the end of the scene, which
// it does not know. Its further runs are left out.

#include <cstdio>
#include <cstring>

#include "lammps.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"
#include "run.h"
#include "signal_handling.h"

namespace LAMMPS_NS {

void Run::command(int narg, char** arg, bigint steps) {
  static const auto command =
      footfall::next_definition<void (*)(Run*, int, char**, bigint)>("_ZN9LAMMPS_NS3Run7commandEiPPcl");
  footfall::DemLink* const link = footfall::find_dem_link(lmp);
  constexpr int kMost = 1000;  // a loop that ends by itself has ended by then
  const bool couples = modify->n_fixes_style_strict("couple/mbd") > 0;
  const int left_out = link != nullptr && link->finished() ? link->runs().left_out(couples) : 0;
  if (left_out > 0) {
    for (FILE* const out : {screen, logfile})
      if (out != nullptr && left_out == 1)
        std::fputs("couple/mbd: the scene has ended: further runs of this loop are left out\n", out);
    if (left_out < kMost) return;
    link->runs().end_script();
    SignalHandler::request_quit = true;
    return;
  }
  bool repeats = false;
  for (int i = 1; i < narg; ++i) repeats = repeats || std::strcmp(arg[i], "every") == 0;
  if (link != nullptr) link->runs().set_repeats(repeats);
  command(this, narg, arg, steps);
}

}  // namespace LAMMPS_NS
