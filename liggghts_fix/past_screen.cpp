// LIGGGHTS 3.8 prints "version 3 8" by printf, on every rank, when it reads a restart file (ReadRestart::header): past
// its screen, so that `-screen none` does not silence it. This stands before the C library's function, which the
// library of Debian calls for its printf.
#include "liggghts_fix/past_screen.h"

#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace {

bool g_silent = false;

}  // namespace

void footfall::silence_what_goes_past_the_screen() { g_silent = true; }

extern "C" int __printf_chk(int, const char* format, ...) {
  if (g_silent && std::strcmp(format, "version %d %d\n") == 0) return 0;
  va_list arguments;
  va_start(arguments, format);
  const int printed = std::vprintf(format, arguments);
  va_end(arguments);
  return printed;
}
