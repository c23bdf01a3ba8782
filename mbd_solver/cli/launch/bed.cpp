#include "mbd_solver/cli/launch/bed.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/fingerprint.h"
#include "coupler/base/folder.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRestart = "bed.restart";

// Debian's version of the library that liggghts_mbd uses; the file's size and date where there is no dpkg.
std::string liggghts_version() {
  std::string version;
  if (FILE* pipe = popen("dpkg-query -W -f '${Version}' libliggghts3 2>/dev/null", "r")) {
    char buffer[128];
    while (std::fgets(buffer, sizeof buffer, pipe)) version += buffer;
    pclose(pipe);
  }
  return version.empty() ? "unknown" : version;
}

// "step 5000 of 15000" from a LIGGGHTS log that is being written: the last thermo row and the last run command.
std::string log_progress(const std::string& log) {
  std::ifstream file(log);
  std::string line;
  long step = -1, last = -1;
  while (std::getline(file, line)) {
    long number = 0;
    char rest = 0;
    if (std::sscanf(line.c_str(), "run %ld %c", &number, &rest) == 1 && number > 0) last = number;
    double columns[2];
    if (std::sscanf(line.c_str(), "%ld %lf %lf", &number, &columns[0], &columns[1]) == 3) step = number;
  }
  if (step < 0) return "setting up";
  return "step " + std::to_string(step) + (last > 0 ? " of " + std::to_string(last) : "");
}

Bed bed_in(const fs::path& folder) {
  Bed bed;
  bed.restart = (folder / kRestart).string();
  const std::string grains = bed.restart + ".grains";
  if (fs::exists(grains)) bed.grains = grains;
  return bed;
}

// The folder in which a bed grows; gone again unless it is kept.
class Draft {
 public:
  explicit Draft(fs::path folder) : folder_(std::move(folder)) {
    make_folder(folder_.string(), "set FOOTFALL_CACHE to a folder that can be written");
  }
  ~Draft() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  const fs::path& folder() const { return folder_; }
  // Gives it its final name at once; when somebody else was faster, theirs is as good.
  void keep(const fs::path& target) {
    std::error_code error;
    fs::rename(folder_, target, error);
    if (error && !fs::exists(target / kRestart))
      throw InputError(target.string() + ": cannot be made: " + error.message());
  }

 private:
  fs::path folder_;
};

void make_bed(const BedSpec& spec, int ranks, bool quiet, Draft& draft) {
  const std::string restart = (draft.folder() / kRestart).string(), log = (draft.folder() / "liggghts.log").string();
  Command command = mpirun();
  command.output = (draft.folder() / "output.txt").string();
  command.words.insert(command.words.end(), {"-np", std::to_string(ranks), built_program("liggghts_mbd")});
  const std::vector<std::string> script = script_arguments(spec.script, spec.variables);
  command.words.insert(command.words.end(), script.begin(), script.end());
  command.words.insert(command.words.end(), {"-var", "bed", restart, "-log", log, "-screen", "none"});
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  if (!quiet) std::printf("Making the bed, once: %s\n", shell_line(command).c_str());
  std::fflush(stdout);
  const auto show = [&] {
    if (quiet || !terminal) return;
    std::printf("\rbed: %-40s", log_progress(log).c_str());
    std::fflush(stdout);
  };
  const ChildEnd end = run_child(command, "", show);
  if (!quiet && terminal) std::printf("\r%-46s\r", "");
  if (end.interrupted) throw Interrupted{};
  const std::string errors = liggghts_errors(log);
  if (!errors.empty()) throw InputError("the bed's script " + spec.script + " failed in LIGGGHTS:\n" + errors);
  if (end.code != 0) {
    throw PartnerError("making the bed: LIGGGHTS ended with code " + std::to_string(end.code) + " on " + spec.script +
                       "\n" + read_whole_file(command.output).value_or(""));
  }
  if (!fs::exists(restart))
    throw InputError("the bed's script " + spec.script +
                     " ended without writing the restart file; it must say: write_restart ${bed}");
}

}  // namespace

std::string liggghts_errors(const std::string& log) {
  std::ifstream file(log);
  std::string line, errors, before;
  while (std::getline(file, line)) {
    if (line.rfind("ERROR", 0) == 0 || line.rfind("Fix couple", 0) == 0) errors += (errors.empty() ? "" : "\n") + line;
  }
  return errors;
}

std::string cache_folder() {
  if (const char* own = std::getenv("FOOTFALL_CACHE")) return own;
  if (const char* xdg = std::getenv("XDG_CACHE_HOME")) return std::string(xdg) + "/footfall";
  const char* home = std::getenv("HOME");
  return (home ? std::string(home) : std::string("/tmp")) + "/.cache/footfall";
}

std::string bed_key(const BedSpec& spec, const std::string& version) {
  std::string text = version + "\n" + ScriptText(spec.script, spec.variables).contents();
  for (const auto& [name, value] : spec.variables) text += name + "=" + value + "\n";
  return fingerprint(text);
}

std::string bed_folder(const BedSpec& spec) {
  static const std::string version = liggghts_version();
  return (fs::path(cache_folder()) / "beds" / bed_key(spec, version)).string();
}

bool bed_is_made(const std::string& folder) { return fs::exists(fs::path(folder) / kRestart); }

Bed prepare_bed(const BedSpec& spec, int ranks, bool quiet) {
  const fs::path target = bed_folder(spec);
  if (!bed_is_made(target)) {
    Draft draft(target.string() + ".part" + std::to_string(getpid()));
    make_bed(spec, ranks, quiet, draft);
    draft.keep(target);
  }
  if (!quiet) std::printf("Bed: %s\n", (target / kRestart).c_str());
  return bed_in(target);
}

}  // namespace footfall
