#include "mbd_solver/bed/bed.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"
#include "mbd_solver/base/fingerprint.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/bed/process.h"
#include "mbd_solver/bed/programs.h"
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

namespace fs = std::filesystem;

namespace {

constexpr const char* kSeal = "bed.seal";
constexpr const char* kSealHead = "footfall-seal 1";

// The number at this place; nothing behind the end.
template <class T>
std::optional<T> number_at(const std::string& bytes, std::size_t place) {
  if (place > bytes.size() || bytes.size() - place < sizeof(T)) return {};
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

// LIGGGHTS' write_restart.cpp: a flag (int) before each value, in this order. Those before the number of grains are
// texts behind their length, integers of 64 bits, or int.
struct Header {
  std::int32_t processes = 0;
  std::int64_t grains = 0;
  std::string version, style;
};
std::optional<Header> read_header(const std::string& bytes) {
  enum Flag { kVersion = 0, kUnits = 4, kStep = 5, kProcesses = 7, kStyle = 22, kGrains = 23 };
  Header header;
  std::size_t place = 0;
  for (std::int32_t flag = kVersion; flag <= kGrains; ++flag) {
    if (number_at<std::int32_t>(bytes, place) != flag) return {};
    place += sizeof flag;
    if (flag == kVersion || flag == kUnits || flag == kStyle) {
      const std::int32_t length = number_at<std::int32_t>(bytes, place).value_or(-1);
      constexpr std::int32_t kLongest = 1000;
      if (length < 1 || length > kLongest) return {};
      place += sizeof length;
      if (bytes.size() < place + static_cast<std::size_t>(length)) return {};
      const std::string text = bytes.substr(place, static_cast<std::size_t>(length) - 1);
      if (flag == kVersion) header.version = text;
      if (flag == kStyle) header.style = text;
      if (text == "hybrid") return header;  // its parts follow
      place += static_cast<std::size_t>(length);
    } else if (flag == kStep || flag == kGrains) {
      const std::optional<std::int64_t> value = number_at<std::int64_t>(bytes, place);
      if (!value) return {};
      if (flag == kGrains) header.grains = *value;
      place += sizeof *value;
    } else {
      const std::optional<std::int32_t> value = number_at<std::int32_t>(bytes, place);
      if (!value) return {};
      if (flag == kProcesses) header.processes = *value;
      place += sizeof *value;
    }
  }
  return header;
}

// The grains of one process: `count` numbers from `place` on, of each grain first how many it has, then x y z. How many
// grains they are; nothing when the numbers are no such chain.
std::optional<std::int64_t> grains_in(const std::string& bytes, std::size_t place, std::int64_t count) {
  std::int64_t grains = 0;
  for (std::int64_t k = 0; k < count; ++grains) {
    const auto at = [&](std::int64_t i) {
      return number_at<double>(bytes, place + sizeof(double) * static_cast<std::size_t>(i)).value_or(std::nan(""));
    };
    const double length = at(k);
    constexpr double kShortest = 4.0;
    if (!(length >= kShortest && length <= static_cast<double>(count - k) && length == std::floor(length))) return {};
    for (int axis = 1; axis <= 3; ++axis)
      if (!std::isfinite(at(k + axis))) return {};
    k += static_cast<std::int64_t>(length);
  }
  return grains;
}

// The file ends with one block for each process: a count (int) and so many numbers. Walks them from the end, as what
// stands before them has no known length: a place whose count reaches exactly to the end of the block is its start.
bool ends_with_blocks(const std::string& bytes, std::size_t end, std::int32_t blocks, std::int64_t grains) {
  if (blocks == 0) return grains == 0;
  for (std::int64_t count = 1; sizeof(std::int32_t) + sizeof(double) * static_cast<std::size_t>(count) <= end;
       ++count) {
    const std::size_t start = end - sizeof(std::int32_t) - sizeof(double) * static_cast<std::size_t>(count);
    if (number_at<std::int32_t>(bytes, start) != count) continue;
    const std::optional<std::int64_t> found = grains_in(bytes, start + sizeof(std::int32_t), count);
    if (found && *found <= grains && ends_with_blocks(bytes, start, blocks - 1, grains - *found)) return true;
  }
  // A process without grains comes last: any zero looks like its count.
  return end >= sizeof(std::int32_t) && number_at<std::int32_t>(bytes, end - sizeof(std::int32_t)) == 0 &&
         ends_with_blocks(bytes, end - sizeof(std::int32_t), blocks - 1, grains);
}

std::string seal_of(const fs::path& folder) {
  std::string text = std::string(kSealHead) + "\n";
  for (const char* name : {kBedRestart, kBedGrains})
    if (const auto bytes = read_whole_file((folder / name).string()))
      text += std::string(name) + " " + std::to_string(bytes->size()) + " " + fingerprint(*bytes) + "\n";
  return text;
}

std::string against_seal(const fs::path& folder, const std::string& seal) {
  std::istringstream lines(seal);
  std::string line;
  if (!std::getline(lines, line) || line != kSealHead) return std::string(kSeal) + " cannot be read";
  bool restart = false;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string name, sum;
    std::size_t size = 0;
    if (!(words >> name >> size >> sum)) return std::string(kSeal) + " cannot be read";
    const auto bytes = read_whole_file((folder / name).string());
    if (!bytes) return name + " is missing";
    if (bytes->size() != size)
      return name + " has " + std::to_string(bytes->size()) + " bytes, it was made with " + std::to_string(size);
    if (fingerprint(*bytes) != sum) return name + " has changed since it was made (checksum)";
    restart = restart || name == kBedRestart;
  }
  return restart ? "" : std::string(kSeal) + " does not name " + kBedRestart;
}

}  // namespace

void seal_bed(const std::string& folder) {
  write_whole_file((fs::path(folder) / kSeal).string(), seal_of(folder),
                   "set FOOTFALL_CACHE to a folder that can be written");
}

std::string damage_of_bed(const std::string& folder) {
  const fs::path at(folder);
  if (!fs::exists(at / kBedRestart)) return std::string(kBedRestart) + " is missing";
  if (const auto seal = read_whole_file((at / kSeal).string())) return against_seal(at, *seal);
  const std::string damage = damage_of_restart((at / kBedRestart).string());
  return damage.empty() && fs::exists(at / kBedGrains) ? damage_of_dump((at / kBedGrains).string()) : damage;
}

std::string damage_of_restart(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  const auto bytes = read_whole_file(path);
  if (!bytes) return name + " cannot be read";
  if (bytes->empty()) return name + " is empty";
  const std::optional<Header> header = read_header(*bytes);
  if (!header || header->version.find("LIGGGHTS") == std::string::npos)
    return name + " does not begin as a restart file of LIGGGHTS does";
  if (header->style != "granular" && header->style != "sphere") return "";
  if (header->processes < 1 || header->grains < 0 ||
      !ends_with_blocks(*bytes, bytes->size(), header->processes, header->grains))
    return name + " does not hold the " + std::to_string(header->grains) + " grains that it begins with";
  return "";
}

std::string damage_of_dump(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  const auto text = read_whole_file(path);
  if (!text) return name + " cannot be read";
  std::istringstream lines(*text);
  std::string line;
  long expected = 0, found = 0, number = 0;
  enum { kElsewhere, kCount, kAtoms } part = kElsewhere;
  while (std::getline(lines, line)) {
    ++number;
    if (line.rfind("ITEM:", 0) == 0) {
      part = line == "ITEM: NUMBER OF ATOMS" ? kCount : line.rfind("ITEM: ATOMS", 0) == 0 ? kAtoms : kElsewhere;
      if (part == kAtoms) found = 0;
    } else if (part == kCount) {
      expected = std::strtol(line.c_str(), nullptr, 10);
    } else if (part == kAtoms) {
      ++found;
      const char* at = line.c_str();
      for (char* end = nullptr;; at = end) {
        const double value = std::strtod(at, &end);
        if (end == at) break;
        if (!std::isfinite(value)) return name + ":" + std::to_string(number) + ": \"" + line + "\" is not finite";
      }
    }
  }
  if (found != expected)
    return name + " holds " + std::to_string(found) + " grains, it begins with " + std::to_string(expected);
  return "";
}

std::map<std::string, std::string> elastic_constants(const std::string& log) {
  std::map<std::string, std::string> constants;
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string fix, id, group, style, property, text;
    words >> fix >> id >> group >> style >> property;
    if (fix != "fix" || style != "property/global" || (property != "youngsModulus" && property != "poissonsRatio"))
      continue;
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
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
        (text.empty() ? "" : "; ") + property + ": the bed was poured with " + value + ", the run has " + other->second;
  }
  return text;
}

void BedWatch::operator()() {
  if (bed_log_.empty()) return;
  const std::optional<std::string> log = read_whole_file(run_log_);
  if (!log || log->find("Setting up run") == std::string::npos) return;
  const std::string different = different_material(bed_log_, run_log_);
  bed_log_.clear();
  if (different.empty()) return;
  std::fprintf(
      stderr,
      "footfall: warning: %s (as LIGGGHTS' logs say): the grains lie otherwise than they would in the run; make "
      "them agree if this is not meant\n",
      different.c_str());
}

}  // namespace footfall
