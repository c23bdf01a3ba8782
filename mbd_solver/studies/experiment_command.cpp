#include "mbd_solver/studies/experiment_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <sstream>
#include <thread>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/bed/bed.h"
#include "mbd_solver/bed/process.h"
#include "mbd_solver/bed/programs.h"
#include "mbd_solver/run/output/history.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/studies/experiment.h"
#include "mbd_solver/studies/fits.h"
#include "mbd_solver/studies/metrics.h"
#include "mbd_solver/studies/results.h"
#include "mbd_solver/studies/run_store.h"
#include "mbd_solver/studies/tables.h"
#include "mbd_solver/studies/window_growth.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

std::string path_of(const OutputPlace& place, const std::string& file) {
  return (fs::path(place.folder) / file).string();
}

void say(const std::string& text) { std::printf("%s\n", text.c_str()); }

// Into the folder, and where else it was asked for; and for people who look on.
void write_page(const OutputPlace& place, const std::string& text) {
  write_whole_file(path_of(place, place.name + ".md"), text);
  if (!place.table.empty()) write_whole_file(place.table, text);
  say(text + path_of(place, place.name + ".md"));
}

bool write_growth(const ExperimentSpec& spec, const Results& results, const OutputPlace& place) {
  const std::vector<GrowthPoint> points = growth_of_schemes(*spec.growth, results.runs);
  write_page(place, growth_page(spec, points));
  bool all = true;
  for (const GrowthPoint& p : points) {
    if (p.as_theory(!results.runs.empty())) continue;
    all = false;
    std::printf("NOT SO    %s, omega H %g: growth in LIGGGHTS %.6g, code alone %.6g, theory %.6g\n", p.scheme.c_str(),
                p.omega_h, p.in_liggghts, p.measured, p.theory);
  }
  return all;
}

bool write_map(const ExperimentSpec& spec, const Results& results, const OutputPlace& place) {
  const std::vector<Verdict> verdicts = verdicts_of(spec, results);
  write_page(place, verdict_page(spec, verdicts));
  const auto bad = std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return !v.as_expected; });
  std::printf("%zu cases, %td not as expected\n", verdicts.size(), bad);
  return bad == 0;
}

// True when all that must come out did.
bool write_statements(const ExperimentSpec& spec, const Results& results, const OutputPlace& place) {
  const std::vector<Outcome> outcomes = outcomes_of(spec, results.cases);
  if (outcomes.empty()) return true;
  write_whole_file(path_of(place, "statements.csv"), statement_table(spec, outcomes).csv());
  write_whole_file(path_of(place, "statements.md"), statement_page(spec, outcomes));
  say("\n" + statement_page(spec, outcomes));
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (spec.statements[i].must && !outcomes[i].came_out) return false;
  return true;
}

void write_errors(const ExperimentSpec& spec, const Results& results, const OutputPlace& place) {
  const std::string csv = path_of(place, place.name + ".csv");
  const Table table = error_table(spec, results);
  write_whole_file(csv, table.csv());
  if (!place.table.empty()) write_whole_file(place.table, error_page(spec, results, place.command));
  say(error_page(spec, results, place.command) + csv);
  try {
    say(joined(draw_errors(spec, results, place.folder, place.name, table), "\n"));
  } catch (const InputError& e) {
    std::fprintf(stderr, "footfall: warning: no picture: %s\n", e.what());
  }
}

}  // namespace

void demand_results(const ExperimentSpec& spec, const std::string& folder) {
  figures_of_run(spec.figures, folder, spec.file);
  if (spec.plots.empty()) return;
  const History history = read_history(folder + "/history.csv");
  for (const PlotSpec& plot : spec.plots)
    demand_columns({plot.column}, history, folder, spec.file, "plots." + plot.name + ".column");
}

bool write_output(const ExperimentSpec& spec, const Plan& plan, const Results& results, const OutputPlace& place) {
  if (spec.growth) return write_growth(spec, results, place);
  if (spec.is_map()) return write_map(spec, results, place);
  write_whole_file(path_of(place, "runs.csv"), run_table(spec, plan, results).csv());
  write_whole_file(path_of(place, "cases.csv"), case_table(spec, results.cases).csv());
  write_whole_file(path_of(place, "cases.md"), case_page(spec, results.cases));
  if (spec.curves.empty()) say(case_page(spec, results.cases));
  for (const CaseResult& c : results.cases)
    if (c.code != 0) std::printf("%s ended with code %d: %s\n", c.plan.name.c_str(), c.code, c.message.c_str());
  const bool expected = write_statements(spec, results, place);
  const std::vector<std::size_t> order = ranking(spec, results.cases);
  if (!order.empty())
    std::printf("best in %s within the limits: %s\n", spec.minimise.c_str(),
                results.cases[order.front()].plan.name.c_str());
  for (const std::string& file : {path_of(place, "runs.csv"), path_of(place, "cases.csv")}) say(file);
  for (const std::string& file : draw_plots(spec, results, place.folder)) say(file);
  if (!place.short_form)
    for (const std::string& file : write_fits(spec, plan, results.runs, place.folder)) say(file);
  if (!spec.curves.empty())
    write_errors(spec, results, place);
  else if (!place.table.empty())
    write_whole_file(place.table, case_page(spec, results.cases));
  // With curves, how a run ended is part of what is told.
  return expected && (!spec.curves.empty() || results.all_done());
}

namespace {

// One curve alone, with what is said about it.
ExperimentSpec with_curve(ExperimentSpec spec, const std::string& name) {
  const int k = index_of(spec.curves, name);
  if (k < 0)
    throw InputError(spec.file + ": no case \"" + name + "\"." + known_names("cases", name, names_in(spec.curves)));
  const CurveSpec curve = spec.curves[static_cast<std::size_t>(k)];
  spec.curves = {curve};
  auto& said = spec.statements;
  said.erase(std::remove_if(said.begin(), said.end(), [&](const StatementSpec& s) { return s.curve != name; }),
             said.end());
  return spec;
}

// The same command again, for one run or for all.
std::vector<std::string> words_again(const ExperimentArguments& a, const std::string& file, const std::string& out) {
  std::vector<std::string> words = {built_program("footfall")};
  words.insert(words.end(), a.again.begin(), a.again.end());
  if (a.again.empty()) words.insert(words.end(), {a.command, file});
  words.insert(words.end(), {"--out", out});
  if (a.short_form) words.push_back("--short");
  if (!a.of_case.empty()) words.insert(words.end(), {"--case", a.of_case});
  return words;
}

void list_runs(const RunStore& store, const std::vector<std::size_t>& chosen) {
  for (const std::size_t i : chosen) {
    std::printf("%zu  %s\n", i, store.request(i).name.c_str());
    for (const std::string& setting : store.request(i).settings) std::printf("     --set %s\n", setting.c_str());
  }
}

void write_slurm(const ExperimentArguments& a, const std::string& out, std::size_t runs, int ranks) {
  const std::string path = (fs::path(out) / "sweep.sbatch").string();
  const std::string line =
      shell_line({words_again(a, fs::absolute(a.file).string(), fs::absolute(out).string()), {}, "", ""});
  // A line end in a name would begin a line of the script.
  for (const char c : line)
    if (static_cast<unsigned char>(c) < 0x20)
      throw InputError("--slurm: a name on the command line holds a line end or another control character; rename it");
  std::string output = fs::absolute(out).string() + "/slurm_";
  for (std::size_t at = output.find('%'); at != std::string::npos; at = output.find('%', at + 2))
    output.insert(at, "%");  // Slurm's own mark
  std::ostringstream file;
  file << "#!/bin/bash\n#SBATCH --job-name=" << shell_word(fs::path(a.file).stem().string()) << "\n#SBATCH --array=0-"
       << runs - 1 << "\n#SBATCH --nodes=1\n#SBATCH --ntasks=" << ranks + 1
       << "\n#SBATCH --output=" << shell_word(output + "%a.txt") << "\n"
       << "# Beds first, on the machine you submit from:  " << line << " --list\n"
       << "# Tables and plots at the end:                 " << line << " --merge\n"
       << line << " --only \"$SLURM_ARRAY_TASK_ID\"\n";
  write_whole_file(path, file.str());
  std::printf("%s: %zu runs; submit with  sbatch %s\n", path.c_str(), runs, shell_word(path).c_str());
}

// Beds come first, several at once, each by a process of its own (--only RUN --list), so that runs side by side find
// them. Throws when one cannot be made, with what its process said; Interrupted at a signal.
void make_beds(const RunStore& store, const ExperimentArguments& a, const std::string& out,
               const std::vector<std::size_t>& runs, int jobs) {
  if (runs.empty()) return;
  make_folder((fs::path(out) / "runs").string());
  std::vector<Command> commands;
  for (const std::size_t run : runs) {
    std::vector<std::string> words = words_again(a, a.file, out);
    words.insert(words.end(), {"--only", std::to_string(run), "--list"});
    commands.push_back({words, {}, store.folder(run) + ".bed.log", ""});
  }
  std::printf("%zu beds to make, %d at once\n", commands.size(), jobs);
  std::fflush(stdout);
  int failed = -1, failed_with = 0;
  const bool interrupted = run_pool(commands, jobs, [&](int bed, int code, double) {
    if (code != kExitDone && failed < 0) failed = bed, failed_with = code;
  });
  if (interrupted) throw Interrupted("interrupted while making the beds; those that are done are kept");
  if (failed < 0) return;
  const std::string reason = read_whole_file(commands[static_cast<std::size_t>(failed)].output).value_or("");
  if (failed_with == kExitBadInput) throw InputError(reason);
  throw PartnerError(reason);
}

void say_end(const RunStore& store, std::size_t run) {
  const RunEnd end = store.end_of(run);
  std::printf("%s: %s\n", store.request(run).name.c_str(),
              end.code == kExitDone
                  ? "done"
                  : ("ended with code " + std::to_string(end.code) + ", see " + end.folder + ".log").c_str());
  std::fflush(stdout);
}

}  // namespace

int experiment_command(const ExperimentArguments& a) {
  ExperimentSpec spec = read_experiment(a.file);
  if (a.change) a.change(spec);
  if (!a.of_case.empty()) spec = with_curve(spec, a.of_case);
  if (a.short_form && spec.growth && !spec.growth->short_omega_h.empty())
    spec.growth->omega_h = spec.growth->short_omega_h;
  Plan plan = plan_of(spec, a.short_form);
  if (a.extend) a.extend(plan);
  const OutputPlace place = [&] {
    const std::string name = fs::path(a.file).stem().string();
    const std::string out = fs::absolute(a.out.empty() ? (fs::path(a.runs) / name).string() : a.out).string();
    const std::string words = a.again.empty() ? a.command + " " + a.file : shell_line({a.again, {}, "", ""});
    return OutputPlace{short_path(out), name, a.table, "./footfall " + words, a.short_form};
  }();
  RunStore store((fs::path(place.folder) / "runs").string(), a.resume);
  for (const RunRequest& run : plan.runs) store.add(run);
  const int count = static_cast<int>(plan.runs.size());
  if (a.only >= count)
    throw InputError("--only " + std::to_string(a.only) + ": there are runs 0 to " + std::to_string(count - 1));
  make_folder(place.folder);
  // Elements of a job array share it; each of their runs has a folder of its own.
  const FileLock lock = a.only < 0 && !a.merge ? lock_folder(place.folder) : FileLock();
  const auto write = [&] {
    const Results results = results_of(spec, plan, store);
    const bool good =
        a.write ? a.write(spec, plan, results, place.folder, place.command) : write_output(spec, plan, results, place);
    return good ? kExitDone : kExitFailed;
  };
  if (a.merge) return write();
  if (a.slurm) {
    write_slurm(a, place.folder, plan.runs.size(), store.most_ranks());
    return kExitDone;
  }

  std::vector<std::size_t> chosen(a.only < 0 ? plan.runs.size() : 1);
  std::iota(chosen.begin(), chosen.end(), static_cast<std::size_t>(std::max(0, a.only)));
  const int machine = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int jobs = a.jobs > 0 ? a.jobs : std::max(1, machine / store.most_ranks());
  if (a.only >= 0)
    store.make_bed(chosen.front(), a.list);
  else
    make_beds(store, a, place.folder, store.beds_to_make(chosen), jobs);
  if (a.list) {
    list_runs(store, chosen);
    return kExitDone;
  }

  const std::vector<std::size_t> left = store.left(chosen);
  const auto done = std::count_if(chosen.begin(), chosen.end(), [&](std::size_t run) { return store.is_done(run); });
  bool demanded = false;
  const auto demand_once = [&](std::size_t run) {
    if (demanded || !store.is_done(run)) return;
    demand_results(spec, store.folder(run));
    demanded = true;
  };
  for (const std::size_t run : chosen) demand_once(run);
  std::printf("%zu runs to do, %td done before, %d at once\n", left.size(), done, jobs);
  std::fflush(stdout);
  const auto ended = [&](std::size_t run) {
    say_end(store, run);
    demand_once(run);
  };
  if (!store.carry_out(left, jobs, ended)) {
    std::fprintf(stderr, "footfall: interrupted; the same command goes on with the runs that are left\n");
    return kExitInterrupted;
  }
  if (a.only >= 0) return store.is_done(chosen.front()) ? kExitDone : kExitFailed;
  return write();
}

}  // namespace footfall
