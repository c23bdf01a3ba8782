// Makes the beds first, then carries out the runs in a pool, then writes tables and pictures.
#include "mbd_solver/studies/sweep_command.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numeric>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/difference/samples.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/live_line.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/fits.h"
#include "mbd_solver/studies/metrics.h"
#include "mbd_solver/studies/run_store.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

void print_line(const std::string& text) { std::printf("%s\n", text.c_str()); }

// Writes it into the folder and to --table, and prints it.
bool write_map(const SweepSpec& spec, const Results& results, const OutputFolder& output) {
  const std::vector<MapRow> rows = map_rows(spec, results);
  const std::string page = map_page(spec, rows), file = output.path(output.name + ".md");
  write_whole_file(file, page);
  if (!output.table.empty()) write_whole_file(output.table, page);
  const auto faults = std::count_if(rows.begin(), rows.end(), [](const MapRow& row) { return row.fault; });
  std::printf("%s%s\n%zu cases, %td wrong without a warning, or without a message at their end\n", page.c_str(),
              file.c_str(), rows.size(), faults);
  return faults == 0;
}

// True when all [[expect]] are reproduced.
bool write_checks(const SweepSpec& spec, const Results& results, const OutputFolder& output) {
  const std::vector<CheckResult> check_results = check_results_of(spec, results.cases);
  if (check_results.empty()) return true;
  write_whole_file(output.path("statements.csv"), check_table(spec, check_results).csv());
  write_whole_file(output.path("statements.md"), check_page(spec, check_results));
  print_line("\n" + check_page(spec, check_results));
  for (std::size_t i = 0; i < check_results.size(); ++i)
    if (spec.checks[i].must && !check_results[i].reproduced) return false;
  return true;
}

void write_errors(const SweepSpec& spec, const Results& results, const OutputFolder& output) {
  const std::string csv = output.path(output.name + ".csv");
  const Table table = error_table(spec, results);
  write_whole_file(csv, table.csv());
  if (!output.table.empty()) write_whole_file(output.table, error_page(spec, results, output.command));
  print_line(error_page(spec, results, output.command) + csv);
  try {
    print_line(joined(draw_errors(spec, results, output.folder, output.name, table), "\n"));
  } catch (const InputError& e) {
    warn_missing_file("picture", e);
  }
}

}  // namespace

void require_results(const SweepSpec& spec, const std::string& folder) {
  metrics_of_run(spec.metrics, folder, spec.file);
  if (spec.plots.empty()) return;
  const History history = read_history(folder + "/history.csv");
  for (const PlotSpec& plot : spec.plots)
    require_columns({plot.column}, history, folder, spec.file, "plots." + plot.name + ".column");
}

bool write_output(const SweepSpec& spec, const Plan& plan, const Results& results, const OutputFolder& output) {
  if (spec.is_map()) return write_map(spec, results, output);
  write_whole_file(output.path("runs.csv"), run_table(spec, plan, results).csv());
  write_whole_file(output.path("cases.csv"), case_table(spec, results.cases).csv());
  write_whole_file(output.path(kSamplesFile), sample_table(results, output.folder).csv());
  write_whole_file(output.path("cases.md"), case_page(spec, results.cases));
  if (spec.curves.empty()) print_line(case_page(spec, results.cases));
  for (const CaseResult& c : results.cases)
    if (c.code != 0) std::printf("%s ended with exit code %d: %s\n", c.plan.name.c_str(), c.code, c.message.c_str());
  const bool expected = write_checks(spec, results, output);
  const std::vector<std::size_t> order = ranking(spec, results.cases);
  if (!order.empty())
    std::printf("best in %s within the limits: %s\n", spec.minimise.c_str(),
                results.cases[order.front()].plan.name.c_str());
  for (const std::string& file : {output.path("runs.csv"), output.path("cases.csv")}) print_line(file);
  for (const std::string& file : draw_plots(spec, results, output.folder)) print_line(file);
  if (!output.short_form)
    for (const std::string& file : write_fits(spec, plan, results.runs, output.folder)) print_line(file);
  if (!spec.curves.empty())
    write_errors(spec, results, output);
  else if (!output.table.empty())
    write_whole_file(output.table, case_page(spec, results.cases));
  // With curves, how a run ended is a result.
  return expected && (!spec.curves.empty() || results.all_done());
}

namespace {

// One curve with its checks.
SweepSpec with_curve(SweepSpec spec, const std::string& name) {
  const int k = index_of(spec.curves, name);
  if (k < 0)
    throw InputError(code::kUnknownCurve,
                     spec.file + ": no case \"" + name + "\"." + known_names("cases", name, names_in(spec.curves)));
  const CurveSpec curve = spec.curves[k];
  spec.curves = {curve};
  const auto of_others = [&](const CheckSpec& s) { return s.curve != name; };
  spec.checks.erase(std::remove_if(spec.checks.begin(), spec.checks.end(), of_others), spec.checks.end());
  return spec;
}

// The same command again, for one run or for all.
std::vector<std::string> words_again(const SweepArguments& a, const std::string& file, const std::string& out) {
  std::vector<std::string> words = {built_program("footfall")};
  words.insert(words.end(), a.again.begin(), a.again.end());
  if (a.again.empty()) words.insert(words.end(), {a.command, file});
  words.insert(words.end(), {"--out", out});
  if (a.short_form) words.push_back("--short");
  if (a.trust_script) words.push_back("--trust-script");
  if (!a.of_case.empty()) words.insert(words.end(), {"--case", a.of_case});
  return words;
}

// Makes the beds before the runs, several at once, each in a separate process (--only RUN --beds). Throws the error of a
// process that fails; Interrupted at a signal.
void make_beds(const RunStore& store, const SweepArguments& a, const std::string& out,
               const std::vector<std::size_t>& runs, int jobs) {
  if (runs.empty()) return;
  make_folder((fs::path(out) / "runs").string());
  std::vector<Command> commands;
  for (const std::size_t run : runs) {
    std::vector<std::string> words = words_again(a, a.file, out);
    words.insert(words.end(), {"--only", std::to_string(run), "--beds"});
    commands.push_back({Rights::of_user(), words, {}, store.folder(run) + ".bed.log"});
  }
  std::printf("beds to make: %zu, at once: %d\n", commands.size(), jobs);
  std::fflush(stdout);
  int failed = -1, failed_with = 0;
  const bool interrupted = run_pool(commands, jobs, [&](int bed, int code, double) {
    if (code != kExitDone && failed < 0) failed = bed, failed_with = code;
  });
  if (interrupted)
    throw Interrupted(code::kBedInterrupted, "interrupted while making the beds; finished ones are in the cache");
  if (failed < 0) return;
  const std::string reason = read_whole_file(commands[failed].output).value_or("");
  if (failed_with == kExitBadInput) throw InputError(trimmed(reason));
  throw PartnerError(trimmed(reason));
}

void print_end(const RunStore& store, std::size_t run, const std::string& count, const std::string& left) {
  const RunEnd end = store.end_of(run);
  const std::string result =
      end.code == kExitDone ? "done" : "exit code " + std::to_string(end.code) + ", see " + end.folder + ".log";
  std::printf("%s: %s (%s)%s\n", store.request(run).name.c_str(), result.c_str(), count.c_str(),
              left.empty() ? "" : (", " + left).c_str());
  std::fflush(stdout);
}

// The program for drawn runs with the words of the user; it needs OpenTURNS, which other sweeps do not.
int start_campaign(const SweepArguments& a) {
  if (a.command != "sweep" || !a.again.empty() || !a.of_case.empty())
    throw InputError(code::kWrongSweep,
                     a.file + ": has drawn runs (key runs), expected `footfall sweep` without --case");
  std::vector<std::string> words;
  try {
    words = {built_program("footfall_campaign"), "sweep", a.file};
  } catch (const InputError&) {
    throw InputError(code::kNoCampaignProgram,
                     a.file +
                         ": has drawn runs, which need the program footfall_campaign: `./footfall sweep` in the "
                         "checkout builds it, or install the package footfall-campaign");
  }
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--out", a.out);
  add("--table", a.table);
  add("--jobs", a.jobs > 0 ? std::to_string(a.jobs) : "");
  add("--only", a.only >= 0 ? std::to_string(a.only) : "");
  add("--row", a.row >= 0 ? std::to_string(a.row) : "");
  for (const auto& [flag, given] : {std::pair{"--short", a.short_form},
                                    {"--list", a.list},
                                    {"--beds", a.beds},
                                    {"--merge", a.merge},
                                    {"--slurm", a.slurm},
                                    {"--trust-script", a.trust_script}})
    if (given) words.push_back(flag);
  become_program(words[0], words);
  throw InputError(code::kNoCampaignProgram, "the program footfall_campaign cannot be started; install it again");
}

}  // namespace

OutputFolder::OutputFolder(const SweepArguments& a)
    : name(fs::path(a.file).stem().string()),
      table(a.table),
      command("./footfall " + (a.again.empty() ? a.command + " " + a.file : shell_line(a.again))),
      short_form(a.short_form) {
  folder = short_path(fs::absolute(a.out.empty() ? (fs::path(a.runs) / name).string() : a.out).string());
}

std::string OutputFolder::path(const std::string& file) const { return (fs::path(folder) / file).string(); }

void write_job_array(const SweepArguments& a, const OutputFolder& output, const JobArray& array) {
  const std::string folder = fs::absolute(output.folder).string(), path = output.path("sweep.sbatch");
  const std::string line = shell_line(words_again(a, fs::absolute(a.file).string(), folder));
  // A line end in a name would begin a new line of the script.
  for (const char c : line)
    if (static_cast<unsigned char>(c) < 0x20)
      throw InputError(code::kSlurmName, "--slurm: a name on the command line has a control character; rename it");
  write_whole_file(path, "#!/bin/bash\n#SBATCH --job-name=" + shell_word(output.name) + "\n#SBATCH --array=0-" +
                             std::to_string(array.elements - 1) +
                             "\n#SBATCH --nodes=1\n#SBATCH --ntasks=" + std::to_string(array.tasks) +
                             "\n#SBATCH --output=" + shell_word(filled({folder}, "%%", "%").front() + "/slurm_%a.txt") +
                             "\n" +  // Slurm replaces %
                             filled({array.notes}, line, "{command}").front() + line + array.options +
                             " --only \"$SLURM_ARRAY_TASK_ID\"\n");
  std::printf("%s: %s; submit with  sbatch %s\n", path.c_str(), array.contents.c_str(), shell_word(path).c_str());
}

void write_page(const StudyPage& page, const OutputFolder& output) {
  write_whole_file(output.path(output.name + ".md"), page.markdown());
  write_whole_file(output.path("report.html"), page.html());
  if (!output.table.empty()) write_whole_file(output.table, page.markdown());
}

void print_settings(const RunRequest& run) {
  for (const std::string& setting : run.settings) std::printf("     --set %s\n", setting.c_str());
}

int study_interrupted() {
  print_error(code::kStudyInterrupted, "interrupted; the same command resumes with the remaining runs");
  return kExitInterrupted;
}

int sweep_command(const SweepArguments& a) {
  SweepSpec spec = read_sweep_file(a.file);
  if (spec.is_campaign()) return start_campaign(a);
  spec.trusted = a.trust_script;
  if (a.row >= 0)
    throw InputError(code::kWrongSweep, a.file + ": has no drawn runs, expected --only RUN instead of --row");
  if (a.change) a.change(spec);
  if (!a.of_case.empty()) spec = with_curve(spec, a.of_case);
  Plan plan = plan_of(spec, a.short_form);
  if (a.extend) a.extend(plan);
  const OutputFolder output(a);
  RunStore store(output.path("runs"), a.resume);
  for (const RunRequest& run : plan.runs) store.add(run);
  const int count = static_cast<int>(plan.runs.size());
  if (a.only >= count)
    throw InputError(code::kNoSuchRun,
                     "--only " + std::to_string(a.only) + ": expected a run from 0 to " + std::to_string(count - 1));
  std::vector<std::size_t> chosen(a.only < 0 ? plan.runs.size() : 1);
  std::iota(chosen.begin(), chosen.end(), std::max(0, a.only));
  if (a.list) {
    for (const std::size_t i : chosen) {
      std::printf("%zu  %s\n", i, store.request(i).name.c_str());
      print_settings(store.request(i));
    }
    return kExitDone;
  }
  make_folder(output.folder);
  // Elements of a job array share the folder; each of their runs has its own.
  const FileLock lock = a.only < 0 && !a.merge ? lock_folder(output.folder) : FileLock();
  const auto write = [&] {
    const Results results = results_of(spec, plan, store);
    const bool good = a.write ? a.write(spec, plan, results, output) : write_output(spec, plan, results, output);
    return good ? kExitDone : kExitFailed;
  };
  if (a.merge) return write();
  if (a.slurm) {
    write_job_array(a, output,
                    {plan.runs.size(), store.most_ranks() + 1, "",
                     "# First, on the machine from which you submit, the beds:  {command} --beds\n"
                     "# At the end tables and plots:                            {command} --merge\n",
                     std::to_string(plan.runs.size()) + " runs"});
    return kExitDone;
  }

  const int jobs = store.at_once(a.jobs);
  if (a.only >= 0) {
    store.make_bed(chosen.front(), a.beds);
  } else {
    const std::vector<std::size_t> missing = store.beds_to_make(chosen);
    make_beds(store, a, output.folder, missing, jobs);
    if (a.beds) std::printf("beds made: %zu\n", missing.size());
  }
  if (a.beds) return kExitDone;

  const std::vector<std::size_t> left = store.left(chosen);
  const auto done = std::count_if(chosen.begin(), chosen.end(), [&](std::size_t run) { return store.is_done(run); });
  bool complete = false;  // a finished run has everything that metrics and plots require
  const auto check_once = [&](std::size_t run) {
    if (complete || !store.is_done(run)) return;
    require_results(spec, store.folder(run));
    complete = true;
  };
  for (const std::size_t run : chosen) check_once(run);
  std::printf("runs to do: %zu, done before: %td, at once: %d\n", left.size(), done, jobs);
  std::fflush(stdout);
  const double started = wall_clock();
  std::size_t finished = 0;
  const auto ended = [&](std::size_t run) {
    const double share = static_cast<double>(++finished) / static_cast<double>(left.size());
    print_end(store, run, std::to_string(finished) + " of " + std::to_string(left.size()),
              time_left({share, share, wall_clock() - started}));
    check_once(run);
  };
  if (!store.carry_out(left, jobs, ended)) return study_interrupted();
  if (a.only >= 0) return store.is_done(chosen.front()) ? kExitDone : kExitFailed;
  return write();
}

}  // namespace footfall
