// MPI_Abort of a rank on which LIGGGHTS has met an error: the error is first copied to the log and to stderr.

#include <mpi.h>
#include <unistd.h>

#include <cctype>

#include "coupler/base/errors.h"
#include "coupler/programs.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/replaced/screen.h"

namespace {

std::FILE* g_screen = nullptr;
int g_copy = -1;  // the same file: LIGGGHTS closes its screen before it ends on an error
std::string g_log;

// Calls visit(line) for every line that begins with ERROR, including its end.
template <class Visit>
void for_each_error(Visit visit) {
  if (g_copy < 0) return;
  std::string text;
  char part[4096];
  for (ssize_t got = 0; (got = pread(g_copy, part, sizeof part, static_cast<off_t>(text.size()))) > 0;)
    text.append(part, static_cast<std::size_t>(got));
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    const std::size_t found = text.find('\n', at);
    end = found == std::string::npos ? text.size() : found + 1;
    if (text.compare(at, 5, "ERROR") == 0) visit(text.substr(at, end - at));
  }
}

void print_errors() {
  if (g_copy < 0) return;
  std::FILE* log = std::fopen(g_log.c_str(), "a");
  for_each_error([&](const std::string& line) {
    std::fputs(line.c_str(), stderr);
    if (log) std::fputs(line.c_str(), log);
  });
  if (log) std::fclose(log);
}

}  // namespace

std::FILE* footfall::open_hidden_screen(const std::string& log) {
  g_log = log;
  if (!g_screen) {
    g_screen = std::tmpfile();
    if (g_screen) g_copy = dup(fileno(g_screen));
  }
  return g_screen;
}

std::string footfall::errors_on_screen() {
  std::string all;
  for_each_error([&](std::string line) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) line.pop_back();
    all += (all.empty() ? "" : "; ") + line;
  });
  return all;
}

std::string footfall::own_error(const std::string& errors) {
  return with_code(code::kLiggghtsError, "LIGGGHTS ended with an error of its own" +
                                             (errors.empty() ? "; see its output and log file" : ": " + errors));
}

extern "C" int MPI_Abort(MPI_Comm comm, int code) {
  std::fflush(nullptr);
  print_errors();
  const std::string errors = footfall::errors_on_screen();
  footfall::note_failure(errors.empty() ? "" : footfall::own_error(errors));
  return PMPI_Abort(comm, code);
}
