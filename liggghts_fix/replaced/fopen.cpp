// fopen, by which LIGGGHTS writes: a file that the kernel refuses to the script of a scene (kMayWrite) ends the run with a
// message. LIGGGHTS does not check all of its files.

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "coupler/abort_guard.h"
#include "coupler/base/codes.h"
#include "coupler/base/confinement.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"
#include "liggghts_fix/replaced/next_definition.h"

extern "C" FILE* fopen(const char* path, const char* mode) {
  static const auto library_fopen = footfall::next_definition<FILE* (*)(const char*, const char*)>("fopen");
  // A hard link is another name of a file that may be elsewhere, which the kernel's rules of paths do not see.
  struct stat status {};
  if (*mode == 'w' && footfall::script_is_confined() && lstat(path, &status) == 0 && S_ISREG(status.st_mode) &&
      status.st_nlink > 1)
    unlink(path);
  FILE* const file = library_fopen(path, mode);
  const bool refused = file == nullptr && errno == EACCES && std::strpbrk(mode, "wa+") != nullptr;
  if (!refused || !footfall::script_is_confined()) return file;
  const std::string error = footfall::with_code(
      footfall::code::kScriptWritesElsewhere,
      "the script writes " + std::string(path, strnlen(path, 500)) + ", expected a file below " +
          footfall::joined(footfall::folders_of_script(), " or ") +
          " (${out}/NAME) that may be written; correct the script, or trust it with --trust-script");
  std::fprintf(stderr, "liggghts_mbd: ERROR: %s\n", error.c_str());
  footfall::note_failure(error);
  footfall::abort_both_programs(footfall::kExitBadInput);
}
