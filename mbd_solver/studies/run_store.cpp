// Each run is a separate `footfall run`, several at once. Recipes are fingerprints of the scene as JSON and its files.
#include "mbd_solver/studies/run_store.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>
#include <thread>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/input_file.h"
#include "coupler/base/run_directory.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/fingerprint.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/bed/bed.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/particle_script.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/session/output/checkpoint_folder.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// Writes a line for every text in `value` that names a file, with the fingerprint of the file and of those it includes.
// With a root, names become relative to it, also in `value`.
void add_files(Json& value, const fs::path& root, std::ostream& text) {
  for (auto& inner : value)
    if (inner.is_structured()) {
      add_files(inner, root, text);
    } else if (std::error_code ignored; inner.is_string() && fs::is_regular_file(inner.get<std::string>(), ignored)) {
      const std::string print = fingerprint(ScriptText(inner.get<std::string>(), {}).contents());
      if (!root.empty()) inner = fs::path(inner.get<std::string>()).lexically_relative(root).string();
      text << inner.get<std::string>() << ' ' << print << '\n';
    }
}

// The message of mbd_solver about itself, otherwise the last line of the log.
std::string last_message(const std::string& log) {
  const std::string solver = "mbd_solver: ";
  std::string last, own;
  for (TextReader text = TextReader::if_there(log); text.next();) {
    const std::string& line = text.line();
    if (line.empty() || line.find(": warning:") != std::string::npos || line.find(": note:") != std::string::npos)
      continue;
    last = line;
    if (line.rfind(solver, 0) == 0) own = line.substr(solver.size());
  }
  return own.empty() ? last : own;
}

// Empty if the file does not exist, or is incomplete.
Json read_object(const std::string& file) {
  require_regular_file(file, kLargestText);
  const Json json = Json::parse(read_whole_file(file).value_or(""), nullptr, false);
  return json.is_object() ? json : Json::object();
}

// The text of an entry; empty if there is none.
std::string text_in(const Json& json, const char* key) {
  return json.contains(key) && json.at(key).is_string() ? json.at(key).get<std::string>() : "";
}

// The cost in a summary, or in a record.
RunCost cost_of(const Json& from) {
  RunCost cost;
  for (const auto& [key, time] : kTimes)
    if (from.contains(key) && from.at(key).is_number()) cost.*time = from.at(key).get<double>();
  return cost;
}

// At the time limit a run must end as by Ctrl-C, and is killed later.
std::vector<std::string> words_of(const RunRequest& request, const std::string& folder, bool resumes) {
  std::vector<std::string> words;
  if (request.time_limit > 0) words = {"timeout", "--foreground", "-k", "30", std::to_string(request.time_limit)};
  if (resumes) {
    words.insert(words.end(), {built_program("footfall"), "run", "--quiet", "--resume", folder});
    if (request.trusted) words.push_back("--trust-script");
    return words;
  }
  words.insert(words.end(), {built_program("footfall"), "run", request.scene, "--quiet", "--force", "--keep-every", "0",
                             "--out", folder});
  if (request.trusted) words.push_back("--trust-script");
  if (request.until > 0.0) words.insert(words.end(), {"--until", number_text(request.until)});
  for (const std::string& setting : request.settings) words.push_back("--set=" + setting);
  return words;
}

// False, 0, "" and empty lists are left out, so that a key that a later version adds with such a default changes no recipe.
void leave_out_empty(Json& json) {
  const auto empty = [](const Json& value) {
    return value.is_null() || value == false || (value.is_number() && value == 0.0) ||
           (value.is_string() && value.get_ref<const std::string&>().empty()) ||
           (value.is_structured() && value.empty());
  };
  if (!json.is_structured()) return;
  for (auto& value : json) leave_out_empty(value);
  if (!json.is_object()) return;  // places in a list count
  for (auto at = json.begin(); at != json.end();) at = empty(*at) ? json.erase(at) : std::next(at);
}

}  // namespace

std::string recipe_of(const Scene& scene, double until) {
  std::ostringstream text;
  Json values = Json::parse(scene_json(scene));
  if (!scene.touches_particles()) values.erase("particles");  // and its scripts
  text << "until " << until << '\n' << values.dump() << '\n';
  add_files(values, {}, text);
  return text.str();
}

std::string portable_recipe_of(const Scene& scene, double until) {
  std::ostringstream files;
  Json values = Json::parse(scene_json(scene));
  leave_out_empty(values);
  add_files(values, fs::absolute(scene.file).parent_path(), files);
  std::ostringstream text;
  text << "until " << until << '\n' << values.dump() << '\n' << files.str();
  return text.str();
}

std::size_t RunStore::add(const RunRequest& request) {
  const std::size_t number = runs_.size();
  Entry entry;
  entry.request = request;
  entry.home = number;
  try {
    const Scene scene = read_scene(request.scene, request.settings);
    entry.recipe = fingerprint(recipe_of(scene, request.until));
    entry.portable_recipe = fingerprint(portable_recipe_of(scene, request.until));
    entry.home = homes_.try_emplace({entry.recipe, request.repeats}, number).first->second;
    entry.has_checkpoints = scene.output.checkpoint_interval > 0.0;
    if (scene.touches_particles()) {
      entry.ranks = scene.particles->ranks;
      if (scene.particles->bed) entry.bed.push_back(*scene.particles->bed);
    }
  } catch (const InputError&) {
    if (!request.may_be_refused) throw;
  }
  runs_.push_back(entry);
  return number;
}

std::string RunStore::folder(std::size_t run) const {
  return (fs::path(folder_) / runs_[runs_[run].home].request.name).string();
}

bool RunStore::is_done(std::size_t run) const {
  const Entry& home = runs_[runs_[run].home];
  if (home.code >= 0) return home.code == kExitDone;
  if (!reuse_ || home.recipe.empty()) return false;
  return text_in(read_object(record_file(run)), "recipe") == home.recipe &&
         text_in(read_object(summary_file(run)), "status") == "done";
}

int RunStore::most_ranks() const {
  int most = 1;
  for (const Entry& entry : runs_) most = std::max(most, entry.ranks);
  return most;
}

int RunStore::at_once(int jobs) const {
  const int machine = static_cast<int>(std::thread::hardware_concurrency());
  return jobs > 0 ? jobs : std::max(1, machine / most_ranks());
}

std::vector<std::size_t> RunStore::beds_to_make(const std::vector<std::size_t>& runs, int sharing) const {
  std::vector<std::size_t> chosen;
  std::map<std::string, int> count;
  for (const std::size_t run : runs)
    for (const BedSpec& bed : runs_[run].bed)
      if (const std::string made = bed_folder(bed); ++count[made] == sharing && !bed_is_made(made))
        chosen.push_back(run);
  return chosen;
}

void RunStore::make_bed(std::size_t run, bool quiet) const {
  for (const BedSpec& bed : runs_[run].bed) prepare_bed(bed, runs_[run].ranks, quiet, runs_[run].request.trusted);
}

void RunStore::try_bed(std::size_t run) {
  try {
    make_bed(run, true);
  } catch (const InputError& e) {
    std::set<std::string> impossible;
    for (const BedSpec& bed : runs_[run].bed) impossible.insert(bed_folder(bed));
    make_folder(folder_);
    for (std::size_t k = 0; k < runs_.size(); ++k)
      for (const BedSpec& bed : runs_[k].bed) {
        if (impossible.count(bed_folder(bed)) == 0) continue;
        runs_[k].code = kExitBadInput;
        write_whole_file(folder(k) + ".log", std::string("footfall: ") + e.what() + "\n");
        make_folder(folder(k));
        GuardedPath(summary_file(k)).remove();  // of an earlier run
        note_end_of_run(folder(k), "failed", e.what());
      }
  }
}

// It was interrupted or killed after a checkpoint, and its recipe is unchanged. A checkpoint affects the last bits of later
// results, so only runs whose scene sets checkpoints are resumed; runs that are timed several times start again.
bool RunStore::can_resume(std::size_t run) const {
  const Entry& home = runs_[runs_[run].home];
  if (!reuse_ || !home.has_checkpoints || home.recipe.empty() || home.request.repeats > 1) return false;
  if (text_in(read_object(begun_file(run)), "recipe") != home.recipe) return false;
  const Json summary = read_object(summary_file(run));
  if (!summary.empty() && text_in(summary, "status") != "interrupted") return false;
  try {
    newest_checkpoint(folder(run));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::vector<std::size_t> RunStore::left(const std::vector<std::size_t>& runs) const {
  std::vector<std::size_t> left;
  std::set<std::size_t> homes;
  for (const std::size_t run : runs)
    if (!is_done(run) && homes.insert(runs_[run].home).second) left.push_back(runs_[run].home);
  return left;
}

void RunStore::record_end(Entry& entry, int code, double cpu, bool first) {
  entry.code = code;
  const Json summary = read_object(summary_file(entry.home));
  if (summary.empty()) return;
  RunCost cost = cost_of(summary);
  cost.cpu = cpu;
  if (first || cost.wall < entry.cost.wall) entry.cost = cost;
  if (code != kExitDone || entry.recipe.empty()) return;
  Json kept;
  for (const auto& [key, time] : kTimes) kept[key] = entry.cost.*time;
  write_whole_file(record_file(entry.home), Json{{"recipe", entry.recipe}, {"cost", kept}}.dump(1) + "\n");
}

bool RunStore::carry_out(const std::vector<std::size_t>& runs, int jobs,
                         const std::function<void(std::size_t)>& ended) {
  make_folder(folder_);
  std::vector<std::size_t> round = runs;
  for (int k = 1; !round.empty(); ++k) {
    std::vector<Command> commands;
    for (const std::size_t run : round) {
      GuardedPath(record_file(run)).remove();  // until it is done again
      const bool resumes = k == 1 && can_resume(run);
      write_whole_file(begun_file(run), Json{{"recipe", runs_[run].recipe}}.dump(1) + "\n");
      commands.push_back(
          {Rights::of_user(), words_of(runs_[run].request, folder(run), resumes), {}, folder(run) + ".log"});
    }
    std::vector<std::size_t> again;
    const bool interrupted = run_pool(commands, jobs, [&](int task, int ended_with, double cpu) {
      const int code =
          ended_with == kExitRequirements ? kExitDone : ended_with;  // the page of the sweep reports requirements
      const std::size_t run = round[task];
      record_end(runs_[run], code, cpu, k == 1);
      if (code == kExitDone && k < runs_[run].request.repeats)
        again.push_back(run);
      else
        ended(run);
    });
    if (interrupted) return false;
    round.swap(again);
  }
  return true;
}

RunEnd RunStore::end_of(std::size_t run) const {
  const Entry& home = runs_[runs_[run].home];
  RunEnd end;
  end.folder = folder(run);
  end.status = "missing";
  if (fs::exists(summary_file(run))) {
    const Json found = read_object(summary_file(run));
    end.status = text_in(found, "status");
    if (end.status.empty()) {  // incomplete: the run has failed
      end.status = "damaged";
    } else {
      end.summary = found;
      for (const Json& warning : found.value("warnings", Json::array()))
        if (warning.is_string()) end.warnings.push_back(warning);
    }
  }
  end.code = home.code < 0 ? (end.status == "done" ? kExitDone : kExitFailed) : home.code;
  if (end.code == kExitDone && end.status == "damaged") end.code = kExitFailed;
  const Json record = read_object(record_file(run));
  end.cost = home.code < 0 && record.contains("cost") ? cost_of(record.at("cost")) : home.cost;
  if (end.code == RunEnd::kHung)
    end.message = "no end within the time limit of " + std::to_string(home.request.time_limit) + " s";
  else if (end.code != kExitDone)
    end.message = end.status == "failed" && !text_in(end.summary, "reason").empty() ? end_text(end.summary)
                                                                                    : last_message(end.folder + ".log");
  return end;
}

}  // namespace footfall
