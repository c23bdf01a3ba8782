#include "mbd_solver/cli/experiments/sweep_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <thread>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/experiments/run_record.h"
#include "mbd_solver/cli/experiments/sweep_fit.h"
#include "mbd_solver/cli/experiments/sweep_table.h"
#include "mbd_solver/cli/launch/bed.h"
#include "mbd_solver/cli/launch/process_pool.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

struct SweepNeeds {
  int cores = 1;                  // of the largest run
  std::vector<std::size_t> beds;  // one run for each bed that is not made yet
};

// The sweep, its runs and their folders.
class Sweep {
 public:
  explicit Sweep(const SweepArguments& a)
      : spec_(read_sweep(a.file)),
        runs_(runs_of(spec_)),
        out_(short_path(
            fs::absolute(a.out.empty() ? "runs/sweeps/" + fs::path(a.file).stem().string() : a.out).string())) {
    std::set<std::string> names;
    for (const SweepRun& run : runs_)
      if (!names.insert(run.name).second)
        throw InputError(spec_.file + ": two runs are named \"" + run.name + "\"; give their choices different names");
  }

  const std::vector<SweepRun>& runs() const { return runs_; }
  const SweepSpec& spec() const { return spec_; }
  const std::string& out() const { return out_; }
  std::string folder(std::size_t run) const { return (fs::path(out_) / "runs" / runs_[run].name).string(); }

  // What the machine has to give the chosen runs. Every scene is read once before anything runs: a wrong setting stops
  // the whole sweep, not its hundredth run.
  SweepNeeds needs(const std::vector<std::size_t>& chosen) const {
    SweepNeeds needs;
    std::set<std::string> seen;
    for (const std::size_t run : chosen) {
      const Scene scene = read_scene(runs_[run].scene, runs_[run].settings);
      if (!scene.touches_particles()) continue;
      needs.cores = std::max(needs.cores, scene.particles->ranks);
      if (!scene.particles->bed) continue;
      const std::string bed = bed_folder(*scene.particles->bed);
      if (seen.insert(bed).second && !bed_is_made(bed)) needs.beds.push_back(run);
    }
    return needs;
  }

  void make_bed_of(std::size_t run, bool quiet) const {
    const Scene scene = read_scene(runs_[run].scene, runs_[run].settings);
    if (scene.touches_particles() && scene.particles->bed)
      prepare_bed(*scene.particles->bed, scene.particles->ranks, quiet);
  }

  std::vector<std::string> words(std::size_t run) const {
    std::vector<std::string> words = {
        built_program("footfall"), "run", runs_[run].scene, "--quiet", "--out", folder(run)};
    if (spec_.until > 0.0) words.insert(words.end(), {"--until", number_text(spec_.until)});
    for (const std::string& setting : runs_[run].settings) words.insert(words.end(), {"--set", setting});
    return words;
  }

  // What a run is made from: its command, its scene and the files it names (run_record.h). When one of them has
  // changed, a finished run is done again.
  std::string recipe(std::size_t run) const {
    std::ostringstream text;
    for (const std::string& word : words(run)) text << word << '\n';
    text << made_from(read_scene(runs_[run].scene, runs_[run].settings));
    return text.str();
  }
  bool is_done(std::size_t run) const {
    const std::optional<std::string> kept = read_whole_file(folder(run) + ".recipe");
    return kept && *kept == recipe(run) && result_of(spec_, folder(run)).done;
  }
  void keep_recipe(std::size_t run) const { write_whole_file(folder(run) + ".recipe", recipe(run)); }

 private:
  SweepSpec spec_;
  std::vector<SweepRun> runs_;
  std::string out_;
};

void list_runs(const Sweep& sweep, const std::vector<std::size_t>& chosen) {
  for (const std::size_t i : chosen) {
    std::printf("%zu  %s\n", i, sweep.runs()[i].name.c_str());
    for (const std::string& setting : sweep.runs()[i].settings) std::printf("     --set %s\n", setting.c_str());
  }
}

void write_slurm(const Sweep& sweep, const SweepArguments& a, int cores) {
  fs::create_directories(sweep.out());
  const std::string path = (fs::path(sweep.out()) / "sweep.sbatch").string();
  std::ofstream out = open_to_write(path);
  const std::string footfall = built_program("footfall"), file = fs::absolute(a.file).string(),
                    folder = fs::absolute(sweep.out()).string();
  out << "#!/bin/bash\n#SBATCH --job-name=" << fs::path(a.file).stem().string() << "\n#SBATCH --array=0-"
      << sweep.runs().size() - 1 << "\n#SBATCH --nodes=1\n#SBATCH --ntasks=" << cores + 1
      << "\n#SBATCH --output=" << folder << "/slurm_%a.txt\n"
      << "# Beds first, on the machine you submit from:  " << footfall << " sweep " << file << " --out " << folder
      << " --list\n"
      << "# Tables and plots at the end:                 " << footfall << " sweep " << file << " --out " << folder
      << " --merge\n"
      << footfall << " sweep " << file << " --out " << folder << " --only \"$SLURM_ARRAY_TASK_ID\"\n";
  std::printf("%s: %zu runs; submit with  sbatch %s\n", path.c_str(), sweep.runs().size(), path.c_str());
}

// Beds come first, several at once, each by a process of its own (--only RUN --list), so that runs side by side find
// them. Throws when one cannot be made, with what its process said; Interrupted at a signal.
void make_beds(const Sweep& sweep, const std::string& file, const std::vector<std::size_t>& runs, int jobs) {
  if (runs.empty()) return;
  fs::create_directories(fs::path(sweep.out()) / "runs");
  std::vector<Command> commands;
  for (const std::size_t run : runs)
    commands.push_back(
        {{built_program("footfall"), "sweep", file, "--out", sweep.out(), "--only", std::to_string(run), "--list"},
         {},
         sweep.folder(run) + ".bed.log",
         ""});
  std::printf("%zu beds to make, %d at once\n", commands.size(), jobs);
  std::fflush(stdout);
  int failed = -1, failed_with = 0;
  const bool interrupted = run_pool(commands, jobs, [&](int bed, int code) {
    if (code != kExitDone && failed < 0) failed = bed, failed_with = code;
  });
  if (interrupted) throw Interrupted{};
  if (failed < 0) return;
  const std::string reason = read_whole_file(commands[static_cast<std::size_t>(failed)].output).value_or("");
  if (failed_with == kExitBadInput) throw InputError(reason);
  throw PartnerError(reason);
}

// Tables, plots and the ranking. True when every run is done.
bool merge(const Sweep& sweep) {
  std::vector<SweepResult> results;
  std::vector<std::string> folders;
  bool complete = true;
  for (std::size_t i = 0; i < sweep.runs().size(); ++i) {
    folders.push_back(sweep.folder(i));
    results.push_back(result_of(sweep.spec(), folders.back()));
    complete = complete && results.back().done;
  }
  const std::vector<SweepCase> cases = cases_of(sweep.spec(), sweep.runs(), results);
  const std::string runs_csv = (fs::path(sweep.out()) / "runs.csv").string(),
                    cases_csv = (fs::path(sweep.out()) / "cases.csv").string();
  write_run_table(runs_csv, sweep.spec(), sweep.runs(), results);
  write_case_table(cases_csv, sweep.spec(), cases);
  write_case_page((fs::path(sweep.out()) / "cases.md").string(), sweep.spec(), cases);
  for (const SweepCase& c : cases) {
    std::printf("%s", c.name.c_str());
    for (std::size_t k = 0; k < c.mean.size(); ++k) {
      std::printf("  |  %s %.4g", sweep.spec().figures[k].name.c_str(), c.mean[k]);
      if (c.runs.size() > 1) std::printf(" +- %.2g", c.spread[k]);
    }
    std::printf("%s\n", c.within_limits ? "" : "  |  beyond the limits");
  }
  if (!sweep.spec().statements.empty()) {
    const std::vector<StatementVerdict> verdicts = verdicts_of(sweep.spec(), cases);
    write_statements(sweep.out(), sweep.spec(), verdicts);
    for (std::size_t i = 0; i < verdicts.size(); ++i)
      std::printf("%s: %s (%.4g)\n", sweep.spec().statements[i].text.c_str(),
                  std::isnan(verdicts[i].judged) ? "not run"
                  : verdicts[i].came_out         ? "came out"
                                                 : "did not come out",
                  verdicts[i].judged);
  }
  const std::vector<int> order = ranking(sweep.spec(), cases);
  if (!order.empty())
    std::printf("best in %s within the limits: %s\n", sweep.spec().minimise.c_str(),
                cases[static_cast<std::size_t>(order.front())].name.c_str());
  std::printf("%s\n%s\n", runs_csv.c_str(), cases_csv.c_str());
  for (const std::string& picture : draw_sweep(sweep.spec(), cases, folders, sweep.out()))
    std::printf("%s\n", picture.c_str());
  for (const std::string& file : write_fits(sweep.spec(), sweep.runs(), results, sweep.out()))
    std::printf("%s\n", file.c_str());
  return complete;
}

}  // namespace

int sweep_command(const SweepArguments& a) {
  const Sweep sweep(a);
  const int count = static_cast<int>(sweep.runs().size());
  if (a.only >= count)
    throw InputError("--only " + std::to_string(a.only) + ": the sweep has runs 0 to " + std::to_string(count - 1));
  if (a.merge) return merge(sweep) ? kExitDone : kExitFailed;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < sweep.runs().size(); ++i)
    if (a.only < 0 || static_cast<int>(i) == a.only) chosen.push_back(i);
  const SweepNeeds needs = sweep.needs(chosen);
  if (a.slurm) {
    write_slurm(sweep, a, needs.cores);
    return kExitDone;
  }
  const int machine = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int jobs = a.jobs > 0 ? a.jobs : std::max(1, machine / needs.cores);
  if (a.only >= 0)
    sweep.make_bed_of(chosen.front(), a.list);
  else
    make_beds(sweep, a.file, needs.beds, jobs);
  if (a.list) {
    list_runs(sweep, chosen);
    return kExitDone;
  }

  fs::create_directories(fs::path(sweep.out()) / "runs");
  std::vector<Command> commands;
  std::vector<std::size_t> numbers;
  for (const std::size_t i : chosen) {
    if (sweep.is_done(i)) continue;
    commands.push_back({sweep.words(i), {}, sweep.folder(i) + ".log", ""});
    numbers.push_back(i);
  }
  std::printf("%zu runs to do, %zu done before, %d at once\n", commands.size(), chosen.size() - commands.size(), jobs);
  std::fflush(stdout);
  const bool interrupted = run_pool(commands, jobs, [&](int task, int code) {
    const std::size_t run = numbers[static_cast<std::size_t>(task)];
    if (code == kExitDone) sweep.keep_recipe(run);
    std::printf("%s: %s\n", sweep.runs()[run].name.c_str(),
                code == kExitDone ? "done"
                                  : ("ended with code " + std::to_string(code) + ", see " +
                                     commands[static_cast<std::size_t>(task)].output)
                                        .c_str());
    std::fflush(stdout);
  });
  if (interrupted) {
    std::fprintf(stderr, "footfall: interrupted; the same command goes on with the runs that are left\n");
    return kExitInterrupted;
  }
  if (a.only >= 0) return sweep.is_done(static_cast<std::size_t>(a.only)) ? kExitDone : kExitFailed;
  return merge(sweep) ? kExitDone : kExitFailed;
}

}  // namespace footfall
