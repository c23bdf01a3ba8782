// __printf_chk, the checked printf that Debian's library calls: LIGGGHTS 3.8 prints "version 3 8" on every rank when it
// reads a restart file (ReadRestart::header), past its screen, so that `-screen none` does not hide it.

#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "liggghts_fix/replaced/screen.h"

namespace {

bool g_hidden = false;

}  // namespace

void footfall::hide_restart_version() { g_hidden = true; }

extern "C" int __printf_chk(int, const char* format, ...) {
  if (g_hidden && std::strcmp(format, "version %d %d\n") == 0) return 0;
  va_list arguments;
  va_start(arguments, format);
  const int printed = std::vprintf(format, arguments);
  va_end(arguments);
  return printed;
}
