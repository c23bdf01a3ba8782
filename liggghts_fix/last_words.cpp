#include "liggghts_fix/last_words.h"

#include <mpi.h>
#include <unistd.h>

#include <cctype>

#include "coupler/programs.h"

namespace {

std::FILE* g_screen = nullptr;
int g_kept = -1;  // the same file: LIGGGHTS closes its screen before it ends on an error
std::string g_log;

// Calls say(line) for every line that says ERROR, with its end.
template <class Say>
void each_error(Say say) {
  if (g_kept < 0) return;
  std::string text;
  char part[4096];
  for (ssize_t got = 0; (got = pread(g_kept, part, sizeof part, static_cast<off_t>(text.size()))) > 0;)
    text.append(part, static_cast<std::size_t>(got));
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    const std::size_t found = text.find('\n', at);
    end = found == std::string::npos ? text.size() : found + 1;
    if (text.compare(at, 5, "ERROR") == 0) say(text.substr(at, end - at));
  }
}

void say_errors() {
  if (g_kept < 0) return;
  std::FILE* log = std::fopen(g_log.c_str(), "a");
  each_error([&](const std::string& line) {
    std::fputs(line.c_str(), stderr);
    if (log) std::fputs(line.c_str(), log);
  });
  if (log) std::fclose(log);
}

}  // namespace

std::FILE* footfall::screen_kept_for_last_words(const std::string& log) {
  g_log = log;
  if (!g_screen) {
    g_screen = std::tmpfile();
    if (g_screen) g_kept = dup(fileno(g_screen));
  }
  return g_screen;
}

std::string footfall::errors_on_screen() {
  std::string all;
  each_error([&](std::string line) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) line.pop_back();
    all += (all.empty() ? "" : "; ") + line;
  });
  return all;
}

// The profiling interface, as in program_world.cpp.
extern "C" int MPI_Abort(MPI_Comm comm, int code) {
  std::fflush(nullptr);
  say_errors();
  footfall::note_failure();
  return PMPI_Abort(comm, code);
}
