// LAMMPS_NS::Input::shell, the script command `shell`: refused for scripts of scenes (kNoPrograms).

#include "coupler/base/errors.h"
#include "coupler/programs.h"
#include "input.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/replaced/next_definition.h"

// Called on all ranks together.
void LAMMPS_NS::Input::shell() {
  if (footfall::programs_are_refused())
    throw footfall::InputError(
        footfall::code::kScriptRunsProgram,
        "the script runs a program with `shell`, which scripts of scenes must not do; run it beforehand, or give "
        "footfall the option --trust-script");
  footfall::next_definition<void (*)(Input*)>("_ZN9LAMMPS_NS5Input5shellEv")(this);
}
