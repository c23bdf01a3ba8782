// Beds of grains in the cache. A bed is made in a draft folder next to its place and renamed when it is whole, so that
// neither a kill nor a second run leaves half a bed. bed.seal holds sizes and checksums of its files.
#include "mbd_solver/bed/bed.h"

#include <pwd.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>

#include "coupler/base/clock.h"
#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/number.h"
#include "coupler/base/pulse.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/fingerprint.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/bed/script_safety.h"
#include "mbd_solver/launch/confined_programs.h"
#include "mbd_solver/launch/launch_limits.h"
#include "mbd_solver/launch/program_watch.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/particle_script.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr const char* kAdvice = "set FOOTFALL_CACHE to a folder that can be written";

// ---- Seal ----

constexpr const char* kSeal = "bed.seal";
constexpr const char* kSealHead = "footfall-seal 2";
constexpr const char* kOldSealHead = "footfall-seal 1";  // without conditions

// The name of a bed's folder, or of its draft, is the key of the conditions under which it is made.
std::string key_in(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name.substr(0, name.find('.'));
}

std::string seal_of(const fs::path& folder) {
  std::string text = concat(kSealHead, "\nconditions ", key_in(folder), "\n");
  for (const char* name : {kBedRestart, kBedGrains})
    if (const auto bytes = read_whole_file((folder / name).string()))
      text += concat(name, " ", bytes->size(), " ", fingerprint(*bytes), "\n");
  return text;
}

// Of files that LIGGGHTS has just written, without looking whether they got to the disk: why they cannot be whole.
std::string unwritten_part(const fs::path& folder) {
  rlimit limit{};
  const bool limited = getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  std::error_code error;
  for (const char* name : {kBedRestart, kBedGrains}) {
    const std::uintmax_t size = fs::file_size(folder / name, error);
    if (!error && size == 0) return concat(name, " is empty");
    if (!error && limited && size >= limit.rlim_cur) return concat(name, " has reached the limit of file sizes");
  }
  constexpr std::uintmax_t kLeast = 1 << 16;  // bytes; a disk that has refused bytes has less
  const fs::space_info space = fs::space(folder, error);
  return !error && space.available < kLeast ? "the disk is full" : "";
}

// ---- Drafts ----

// Debian's version of the library that liggghts_mbd uses; "unknown" without dpkg.
std::string liggghts_version() {
  const std::string version = output_of({Rights::of_user(), {"dpkg-query", "-W", "-f", "${Version}", "libliggghts3"}});
  return version.empty() ? "unknown" : version;
}

std::string host() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return name;
}

constexpr const char* kPart = ".part";

// KEY.partPID@HOST: whose it is.
fs::path draft_name(const fs::path& target) { return concat(target.string(), kPart, getpid(), "@", host()); }

// Drafts of this machine whose process has been killed.
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

// The folder in which a bed is made; removed unless the bed is stored.
class Draft {
 public:
  // Moves a damaged bed out of the way.
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
  // Renames it to its final name; a bed that another run has stored meanwhile is as good.
  void store_as(const fs::path& target) {
    std::error_code error;
    fs::rename(folder_, target, error);
    if (error && !fs::exists(target / kBedRestart))
      throw InputError(code::kBedNotStored, target.string(), ": cannot be created: ", error.message());
  }

 private:
  fs::path folder_;
};

// As it is shown: without the values of variables that have many.
std::string shown(Command command) {
  constexpr std::ptrdiff_t kMost = 20;
  std::vector<std::string>& words = command.words;
  for (auto name = words.begin(); (name = std::find(name, words.end(), "-var")) != words.end(); ++name) {
    const auto last = std::find(name + 1, words.end(), "-var");
    if (last - name > kMost) *words.erase(name + 3, last - 1) = "...";
  }
  return shell_line(command);
}

void make_bed(const BedSpec& spec, int ranks, bool quiet, bool trusted, double limit, const fs::path& folder) {
  const std::string restart = (folder / kBedRestart).string(), log = (folder / "liggghts.log").string();
  require_room_to_launch(ranks);
  Command command = mpirun();
  command.environment[kAllOrNothing] = "1";
  command.output = (folder / "output.txt").string();
  add_program(command, ranks, built_program("liggghts_mbd"), script_arguments(spec.script, spec.variables));
  command.words.insert(command.words.end(), {"-var", "bed", restart, "-log", log, "-screen", "none"});
  LiveLine live(quiet, isatty(STDOUT_FILENO) == 1);
  if (!quiet) std::printf("Making the bed (once): %s\n", shown(command).c_str());
  std::fflush(stdout);
  limit_script(command, trusted, {folder.string()});
  SuspendedWatch suspended(limit);
  ReadingWatch reading(log, limit);
  const std::string pulse = (folder / ".pulse").string();
  write_whole_file_unsynced(pulse, "", kAdvice);
  command.environment[kPulse] = pulse;
  ProgramWatch steps(limit, pulse, "", log);
  const double started = wall_clock();
  const auto show = [&] {
    const LogProgress progress = log_progress(log);
    if (live.due(progress.share())) {
      const std::string left =
          progress.runs > 1 ? "" : time_left({progress.share(), progress.share(), wall_clock() - started});
      live.show("bed: " + progress.text() + (left.empty() ? "" : ", " + left));
    }
    std::string stuck = reading();
    if (stuck.empty()) stuck = suspended();
    return stuck.empty() ? steps() : stuck;
  };
  const ChildEnd end = run_child(command, "", show);
  fs::remove(pulse);
  live.finish(true);
  const std::string output = read_whole_file(command.output).value_or("");
  // What is given up is asked to end as well.
  if (!end.given_up.empty()) throw PartnerError("making the bed: " + end.given_up);
  if (end.interrupted || was_asked_to_end(end.code) ||
      (end.code == kExitFailed && output.find(kStoppedLine) != std::string::npos && liggghts_errors(log).empty()))
    throw Interrupted(code::kBedInterrupted, "interrupted while making the bed; nothing of it is stored");
  if (!liggghts_errors(log).empty() && spec.script == shipped_file("inputs/box/in.bed"))
    throw InputError(
        code::kBedScriptFailed, "the bed of [particles.box] could not be made: LIGGGHTS ended with \"",
        liggghts_errors(log),
        "\". Grains that are lost or too fast mostly have forces that a step cannot resolve: lower "
        "box.material.cohesion, give a smaller box.time_step, or leave out what differs from the defaults");
  if (!liggghts_errors(log).empty())
    throw InputError(code::kBedScriptFailed, "the bed's script ", spec.script, " failed in LIGGGHTS, at ",
                     why_liggghts_stopped(log, spec.script, spec.variables));
  if (end.code == kExitBadInput)
    throw InputError(code::kBedScriptFailed, "the bed's script ", spec.script, " failed in LIGGGHTS\n", output);
  if (end.code != 0)
    throw PartnerError(code::kBedProgramEnded, "making the bed: LIGGGHTS ended with exit code ", end.code, " on ",
                       spec.script, "\n", output);
  if (!fs::exists(restart))
    throw InputError(code::kBedWithoutRestart, "the bed's script ", spec.script,
                     " ended without writing the restart file; add the command: write_restart ${bed}");
  if (const std::string damage = unwritten_part(folder); !damage.empty())
    throw PartnerError(code::kBedNotStored, "making the bed: ", damage,
                       "; nothing of the bed is stored. Free space in ", folder.parent_path().string(),
                       ", or set FOOTFALL_CACHE to another folder");
  seal_bed(folder.string());
  write_whole_file((folder / kBedCost).string(), "{\"cpu_s\": " + number_text(end.cpu, 6) + "}\n", kAdvice);
}

Bed bed_in(const fs::path& folder) {
  Bed bed;
  bed.restart = (folder / kBedRestart).string();
  const std::string grains = (folder / kBedGrains).string();
  if (fs::exists(grains)) bed.grains = grains;
  return bed;
}

}  // namespace

void seal_bed(const std::string& folder) {
  write_whole_file((fs::path(folder) / kSeal).string(), seal_of(folder), kAdvice);
}

void require_own_bed(const std::string& folder) {
  for (const std::string name : {"", kSeal, kBedRestart, kBedGrains}) {
    const std::string file = name.empty() ? folder : (fs::path(folder) / name).string();
    struct stat status {};
    if (lstat(file.c_str(), &status) != 0) continue;
    const bool link = S_ISLNK(status.st_mode), ours = status.st_uid == geteuid() || status.st_uid == 0;
    if (ours && !link) continue;
    throw InputError(
        code::kBedOfAnother, file,
        link ? ": is a link" : concat(": belongs to another user (number ", status.st_uid, ")"),
        ", expected a bed that you have made; set FOOTFALL_CACHE to a folder of your own, or remove that bed");
  }
}

std::string damage_of_bed(const std::string& folder) {
  const fs::path at(folder);
  const auto seal = read_whole_file((at / kSeal).string());
  if (!seal) return concat(kSeal, " is missing");
  TextReader lines(*seal, kSeal, code::kBedOfAnother);
  const std::string unreadable = concat(kSeal, " cannot be read");
  if (!lines.next() || (lines.line() != kSealHead && lines.line() != kOldSealHead)) return unreadable;
  if (lines.line() == kSealHead) {
    const std::vector<std::string> words = lines.next() ? blank_words(lines.line()) : std::vector<std::string>();
    if (words.size() < 2 || words[0] != "conditions") return unreadable;
    if (words[1] != key_in(at)) return "it was made under other conditions (" + words[1] + ")";
  }
  bool restart = false;
  while (lines.next()) {
    const std::vector<std::string_view>& words = lines.fields(Separators::kBlanks);
    long held = 0;
    if (words.size() < 3 || !read_whole(words[1], held)) return unreadable;
    const std::string name(words[0]), sum(words[2]);
    const std::size_t size = held;
    const auto bytes = read_whole_file((at / name).string());
    if (!bytes) return name + " is missing";
    if (bytes->size() != size) return concat(name, " has ", bytes->size(), " bytes; it was made with ", size);
    if (fingerprint(*bytes) != sum) return name + " has changed since it was made (checksum)";
    restart = restart || name == kBedRestart;
  }
  return restart ? "" : concat(kSeal, " does not name ", kBedRestart);
}

std::string cache_folder() {
  if (const char* own = std::getenv("FOOTFALL_CACHE")) return own;
  if (const char* xdg = std::getenv("XDG_CACHE_HOME")) return concat(xdg, "/footfall");
  const char* home = std::getenv("HOME");
  const passwd* const user = home != nullptr && *home != '\0' ? nullptr : getpwuid(geteuid());
  if (user != nullptr) home = user->pw_dir;
  // Not in /tmp: a bed there may be anybody's.
  if (home == nullptr || *home == '\0')
    throw InputError(code::kNoCacheFolder,
                     "HOME is not set, so there is no folder for beds of grains; set FOOTFALL_CACHE "
                     "to a folder of your own");
  return concat(home, "/.cache/footfall");
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

bool bed_is_made(const std::string& folder) {
  if (!fs::exists(folder)) return false;
  require_own_bed(folder);
  return damage_of_bed(folder).empty();
}

Bed prepare_bed(const BedSpec& spec, int ranks, bool quiet, bool trusted, double limit) {
  const fs::path target = bed_folder(spec);
  remove_dead_drafts(target.parent_path());
  if (!bed_is_made(target)) {
    if (!trusted) require_safe_script(spec.script, spec.variables, {"bed", "here"});
    // Of two runs that need the same bed the second waits, and uses it.
    make_folder(target.parent_path().string(), kAdvice);
    const FileLock lock = FileLock::wait_for(target.string() + ".lock", [&] {
      std::fprintf(stderr, "footfall: another run makes this bed (process %d); waiting for it\n",
                   owner_of(target.string() + ".lock"));
    });
    if (bed_is_made(target)) return bed_in(target);
    if (fs::exists(target)) {
      const std::string text =
          "the bed in " + target.string() + " is damaged: " + damage_of_bed(target) + "; it is made again";
      std::fprintf(stderr, "footfall: warning: %s\n", with_code(code::kBedDamaged, text).c_str());
      const Draft away(target, draft_name(target));
    }
    const SignalsHeld signals;  // until the draft is removed or stored
    Draft draft(draft_name(target));
    make_bed(spec, ranks, quiet, trusted, limit, draft.folder());
    draft.store_as(target);
  }
  if (!quiet) std::printf("Bed: %s\n", (target / kBedRestart).c_str());
  return bed_in(target);
}

std::map<std::string, std::string> elastic_constants(const std::string& log) {
  std::map<std::string, std::string> constants;
  for (TextReader lines = TextReader::if_there(log); lines.next();) {
    std::istringstream words(lines.line().substr(0, lines.line().find('#')));
    std::string fix, id, group, style, property, text;
    words >> fix >> id >> group >> style >> property;
    if (fix != "fix" || style != "property/global" || (property != "youngsModulus" && property != "poissonsRatio"))
      continue;
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double number = read_number(word.c_str(), &end);
      text += (text.empty() ? "" : " ") + (*end == '\0' ? number_text(number, 12) : word);
    }
    if (text.find('$') == std::string::npos) constants[property] = text;
  }
  return constants;
}

std::string different_material(const std::string& bed_log, const std::string& run_log) {
  const std::map<std::string, std::string> of_run = elastic_constants(run_log);
  std::string text;
  for (const auto& [property, value] : elastic_constants(bed_log)) {
    const auto other = of_run.find(property);
    if (other == of_run.end() || other->second == value) continue;
    text +=
        (text.empty() ? "" : "; ") + property + ": the bed was made with " + value + ", the run has " + other->second;
  }
  return text;
}

void BedMaterialCheck::operator()() {
  if (bed_log_.empty()) return;
  const std::optional<std::string> log = read_whole_file(run_log_);
  if (!log || log->find("Setting up run") == std::string::npos) return;
  const std::string different = different_material(bed_log_, run_log_);
  bed_log_.clear();
  if (different.empty()) return;
  const std::string text = different +
                           " (from the logs of LIGGGHTS). The grains have settled differently than they would in the "
                           "run; give both scripts the same constants unless this is meant";
  std::fprintf(stderr, "footfall: warning: %s\n", with_code(code::kBedMaterialDiffers, text).c_str());
}

}  // namespace footfall
