// fclose, which notes files that could not be written completely.

#include <cstdio>

#include "liggghts_fix/replaced/next_definition.h"
#include "liggghts_fix/replaced/written_files.h"

namespace {

bool g_watches = false;
bool g_lost = false;

}  // namespace

void footfall::watch_written_files() {
  g_lost = false;
  g_watches = true;
}

bool footfall::written_file_lost() {
  g_watches = false;
  return g_lost;
}

extern "C" int fclose(FILE* file) {
  static const auto library_fclose = footfall::next_definition<int (*)(FILE*)>("fclose");
  if (!g_watches) return library_fclose(file);
  const bool lost_before = std::ferror(file) != 0;
  const int result = library_fclose(file);
  g_lost = g_lost || lost_before || result != 0;
  return result;
}
