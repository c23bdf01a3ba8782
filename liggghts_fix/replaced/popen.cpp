// popen, by which LIGGGHTS starts programs for packed files and movies: refused for scripts of scenes (kNoPrograms).

#include <cstdio>
#include <string>

#include "coupler/abort_guard.h"
#include "coupler/base/errors.h"
#include "coupler/programs.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/replaced/next_definition.h"

extern "C" FILE* popen(const char* command, const char* type) {
  if (footfall::programs_are_refused()) {
    const std::string program(command, strnlen(command, 60));
    const std::string error =
        footfall::with_code(footfall::code::kScriptRunsProgram,
                            "the script runs a program (" + program + "), which scripts of scenes must not do");
    std::fprintf(stderr, "liggghts_mbd: ERROR: %s\n", error.c_str());
    footfall::abort_both_programs(footfall::kExitBadInput);
  }
  return footfall::next_definition<FILE* (*)(const char*, const char*)>("popen")(command, type);
}
