// A script of a scene runs no programs when footfall starts LIGGGHTS (FOOTFALL_NO_PROGRAMS): its `shell` command is
// ours, and so is the pipe to programs for packed files and movies. Without the variable both are as they always were.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

#include "coupler/abort_guard.h"
#include "coupler/base/errors.h"
#include "input.h"

namespace {

bool programs_are_refused() { return std::getenv("FOOTFALL_NO_PROGRAMS") != nullptr; }

// What the name stands for in the libraries behind us.
template <class Function>
Function next_after_us(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// Called on all ranks alike. LIGGGHTS calls it by its name, which the linker finds here first.
void LAMMPS_NS::Input::shell() {
  if (programs_are_refused())
    throw footfall::InputError(
        "the script runs a program with `shell`, which no script of a scene may do; do it before the run, or say "
        "--trust-script to footfall");
  next_after_us<void (*)(LAMMPS_NS::Input*)>("_ZN9LAMMPS_NS5Input5shellEv")(this);
}

extern "C" FILE* popen(const char* command, const char* type) {
  if (programs_are_refused()) {
    std::fprintf(stderr, "liggghts_mbd: ERROR: the script runs a program (%.60s), which no script of a scene may do\n",
                 command);
    footfall::abort_both_programs(footfall::kExitBadInput);
  }
  return next_after_us<FILE* (*)(const char*, const char*)>("popen")(command, type);
}
