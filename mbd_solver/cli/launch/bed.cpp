#include "mbd_solver/cli/launch/bed.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/file_lock.h"
#include "coupler/base/fingerprint.h"
#include "coupler/base/folder.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "coupler/programs.h"
#include "mbd_solver/cli/launch/bed_seal.h"
#include "mbd_solver/cli/launch/liggghts_log.h"
#include "mbd_solver/cli/launch/process.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/launch/script_trace.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr double kSilence = 300.0;  // how long a program that makes a bed may be stopped, or read a restart file [s]
constexpr const char* kAdvice = "set FOOTFALL_CACHE to a folder that can be written";

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

Bed bed_in(const fs::path& folder) {
  Bed bed;
  bed.restart = (folder / kBedRestart).string();
  const std::string grains = (folder / kBedGrains).string();
  if (fs::exists(grains)) bed.grains = grains;
  return bed;
}

std::string host() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return name;
}

constexpr const char* kPart = ".part";

// KEY.partPID@HOST: whose it is.
fs::path draft_name(const fs::path& target) {
  return target.string() + kPart + std::to_string(getpid()) + "@" + host();
}

// What a front door that was killed has left: drafts of this machine whose process is gone.
void remove_dead_drafts(const fs::path& beds) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(beds, ignored)) {
    const std::string name = entry.path().filename().string();
    const std::size_t part = name.find(kPart);
    if (part == std::string::npos) continue;
    char* end = nullptr;
    const long pid = std::strtol(name.c_str() + part + std::strlen(kPart), &end, 10);
    const bool ours = *end == '\0' || end == "@" + host();
    if (ours && pid > 0 && kill(static_cast<pid_t>(pid), 0) != 0 && errno == ESRCH) fs::remove_all(entry, ignored);
  }
}

std::string free_space(const fs::path& folder) {
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  return error ? "an unknown space" : number_text(static_cast<double>(space.available) / 1e6) + " MB";
}

// The folder in which a bed grows; gone again unless it is kept.
class Draft {
 public:
  // Takes a bed that is not to be found any more.
  Draft(const fs::path& target, fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    fs::rename(target, folder_, error);
  }
  explicit Draft(fs::path folder) : folder_(std::move(folder)) { make_folder(folder_.string(), kAdvice); }
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
    if (error && !fs::exists(target / kBedRestart))
      throw InputError(target.string() + ": cannot be made: " + error.message());
  }

 private:
  fs::path folder_;
};

void make_bed(const BedSpec& spec, int ranks, bool quiet, Draft& draft) {
  const std::string restart = (draft.folder() / kBedRestart).string(), log = (draft.folder() / "liggghts.log").string();
  Command command = mpirun();
  command.environment[kAllOrNothing] = "1";
  command.output = (draft.folder() / "output.txt").string();
  command.words.insert(command.words.end(), {"-np", std::to_string(ranks), built_program("liggghts_mbd")});
  const std::vector<std::string> script = script_arguments(spec.script, spec.variables);
  command.words.insert(command.words.end(), script.begin(), script.end());
  command.words.insert(command.words.end(), {"-var", "bed", restart, "-log", log, "-screen", "none"});
  LiveLine live(quiet, isatty(STDOUT_FILENO) == 1);
  if (!quiet) std::printf("Making the bed, once: %s\n", shell_line(command).c_str());
  std::fflush(stdout);
  StoppedWatch stopped(kSilence);
  ReadingWatch reading(log, kSilence);
  const double started = wall_clock();
  const auto show = [&] {
    const LogProgress progress = log_progress(log);
    if (live.due(progress.share())) {
      const std::string left =
          progress.runs > 1 ? "" : time_left({progress.share(), progress.share(), wall_clock() - started});
      live.show("bed: " + progress.text() + (left.empty() ? "" : ", " + left));
    }
    const std::string stuck = reading();
    return stuck.empty() ? stopped() : stuck;
  };
  const ChildEnd end = run_child(command, "", show);
  live.finish(true);
  const std::string said = read_whole_file(command.output).value_or("");
  if (end.interrupted || was_asked_to_end(end.code) ||
      (end.code == kExitFailed && said.find(kStoppedWord) != std::string::npos && liggghts_errors(log).empty()))
    throw Interrupted("interrupted while making the bed; nothing is kept");
  if (!end.given_up.empty()) throw PartnerError("making the bed: " + end.given_up);
  if (!liggghts_errors(log).empty())
    throw InputError("the bed's script " + spec.script + " failed in LIGGGHTS, at " +
                     why_liggghts_stopped(log, spec.script, spec.variables));
  if (end.code != 0) {
    throw PartnerError("making the bed: LIGGGHTS ended with code " + std::to_string(end.code) + " on " + spec.script +
                       "\n" + said);
  }
  if (!fs::exists(restart))
    throw InputError("the bed's script " + spec.script +
                     " ended without writing the restart file; it must say: write_restart ${bed}");
  // LIGGGHTS does not ask whether what it writes gets to the disk.
  if (const std::string damage = damage_of_bed(draft.folder().string()); !damage.empty())
    throw PartnerError("making the bed: " + damage + ": nothing is kept. Is the disk full? " +
                       draft.folder().parent_path().string() + " has " + free_space(draft.folder()) + " left");
  seal_bed(draft.folder().string());
  write_whole_file((draft.folder() / kBedCost).string(), "{\"cpu_s\": " + number_text(end.cpu, 6) + "}\n", kAdvice);
}

}  // namespace

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

bool bed_is_made(const std::string& folder) { return fs::exists(folder) && damage_of_bed(folder).empty(); }

Bed prepare_bed(const BedSpec& spec, int ranks, bool quiet) {
  const fs::path target = bed_folder(spec);
  remove_dead_drafts(target.parent_path());
  if (!bed_is_made(target)) {
    // Two runs that need the same bed: the second waits, and uses it.
    make_folder(target.parent_path().string(), kAdvice);
    const FileLock lock = FileLock::wait_for(target.string() + ".lock", [&] {
      std::fprintf(stderr, "footfall: another run makes this bed (process %d); waiting for it\n",
                   owner_of(target.string() + ".lock"));
    });
    if (bed_is_made(target)) return bed_in(target);
    if (fs::exists(target)) {
      std::fprintf(stderr, "footfall: warning: the bed in %s is damaged: %s; it is made again\n", target.c_str(),
                   damage_of_bed(target).c_str());
      const Draft away(target, draft_name(target));
    }
    const SignalsHeld signals;  // until the draft is gone or kept
    Draft draft(draft_name(target));
    make_bed(spec, ranks, quiet, draft);
    draft.keep(target);
  }
  if (!quiet) std::printf("Bed: %s\n", (target / kBedRestart).c_str());
  return bed_in(target);
}

}  // namespace footfall
