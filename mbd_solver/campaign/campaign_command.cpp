// Rows without grains go to workers, rows on grains are runs of their own; each result is a line of the journal at once.
// Then rows worth looking at are repeated with all their files, the check is run, and tables and pictures are written.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <thread>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/app/view_page.h"
#include "mbd_solver/base/live_line.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/campaign/campaign.h"
#include "mbd_solver/campaign/campaign_page.h"
#include "mbd_solver/campaign/worker_pool.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/run_store.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kElements = 100;  // of a Slurm job array
constexpr const char* kJournal = "footfall campaign ";

// Results as they come: a line "row TAB code TAB metrics ... TAB message" each. An incomplete last line is dropped.
class Journal {
 public:
  Journal(const std::string& path, const std::string& recipe) {
    const std::string head = kJournal + recipe + "\n";
    const std::string text = read_whole_file(path).value_or("");
    const std::size_t whole = text.rfind('\n') + 1;  // 0: no line
    const bool mine = text.compare(0, head.size(), head) == 0;
    if (!mine && whole > 0) keep_others(path);
    file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | (mine ? 0 : O_TRUNC), 0644);
    if (file_ < 0 || (mine && ::ftruncate(file_, static_cast<off_t>(whole)) != 0) || ::lseek(file_, 0, SEEK_END) < 0)
      throw FileError(path + ": cannot be written; choose another folder with --out");
    if (!mine) put(head);
  }
  ~Journal() { ::close(file_); }
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  void write(std::size_t row, const CampaignRow& r) {
    std::string line = std::to_string(row) + '\t' + std::to_string(r.code);
    for (const double metric : r.metrics) {
      line += '\t';
      append_number(line, metric, 17);
    }
    std::string message = r.message;
    std::replace_if(
        message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    put(line + '\t' + message + '\n');
  }

 private:
  // Rows of other numbers, or of files that have changed since.
  static void keep_others(const std::string& path) {
    const std::string kept = fs::path(path).replace_extension(".before").string();
    std::error_code error;
    fs::rename(path, kept, error);
    if (error) return;
    std::fprintf(stderr, "footfall: the rows of %s are of other inputs and are made again; the old ones are in %s\n",
                 path.c_str(), kept.c_str());
  }
  void put(const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t sent = ::write(file_, text.data() + at, text.size() - at);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) throw FileError("the journal of the campaign cannot be written: is the disk full?");
      at += static_cast<std::size_t>(sent);
    }
  }
  int file_ = -1;
};

// The rows of all journals in the folder that are of this campaign. Returns those that are lost and not repeated yet.
std::set<std::size_t> read_journals(const std::string& folder, const std::string& recipe, Campaign& campaign) {
  std::set<std::size_t> lost;
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".journal") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  const std::size_t metrics = campaign.spec().metrics.size();
  for (const std::string& file : files) {
    const std::string text = read_whole_file(file).value_or("");
    const std::vector<std::string> lines = split(text.substr(0, text.rfind('\n') + 1), '\n');
    if (lines.empty() || lines[0] != kJournal + recipe) continue;
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const std::vector<std::string> cells = split(lines[i] + '\t', '\t');  // an empty message is a cell as well
      if (cells.size() < 2) continue;
      const std::size_t row = std::strtoul(cells[0].c_str(), nullptr, 10);
      CampaignRow r;
      r.code = std::atoi(cells[1].c_str());
      const std::size_t numbers = r.code == kExitDone ? metrics : 0;
      if (row >= campaign.size() || cells.size() < 2 + numbers) continue;
      for (std::size_t k = 0; k < numbers; ++k) r.metrics.push_back(read_number(cells[2 + k].c_str(), nullptr));
      if (cells.size() > 2 + numbers) r.message = cells[2 + numbers];
      if (r.is_lost()) {
        if (!campaign.row(row).is_done()) lost.insert(row);
        continue;
      }
      lost.erase(row);
      campaign.set(row, std::move(r));
    }
  }
  return lost;
}

// The line of progress: the first outcome in the first cases.
std::string progress_text(const Campaign& campaign, std::size_t done, std::size_t all, double started,
                          std::size_t before) {
  std::string text = std::to_string(done) + " of " + std::to_string(all) + " runs";
  std::size_t without = 0;
  for (std::size_t row = 0; row < campaign.used() * campaign.cases(); ++row) without += campaign.row(row).code > 0;
  if (without > 0) text += ", " + std::to_string(without) + " without result";
  const SweepSpec& spec = campaign.spec();
  for (std::size_t c = 0; c < std::min<std::size_t>(3, campaign.cases()) && !spec.outcomes.empty(); ++c) {
    const Tally& tally = campaign.tally(c, 0);
    const Probability p = tally.probability();
    text += ", " + (campaign.cases() > 1 ? campaign.case_name(c) + ": " : "") + spec.outcomes[0].name + " " +
            std::to_string(tally.hits) + " times" +
            (tally.unknown > 0 ? ", unknown " + std::to_string(tally.unknown) + " times" : "") + ": " +
            number_text(100.0 * p.low, 3) + " to " + number_text(100.0 * p.high, 3) + " %";
  }
  const double share = static_cast<double>(done) / static_cast<double>(all);
  const std::string left =
      time_left({share, static_cast<double>(done - before) / static_cast<double>(all), wall_clock() - started});
  return text + (left.empty() ? "" : ", " + left);
}

class CampaignRun {
 public:
  CampaignRun(Campaign& campaign, std::string folder, int jobs)
      : campaign_(campaign), folder_(std::move(folder)), jobs_(jobs) {}

  // Rows from `first` to before `last`; false when interrupted.
  bool run(std::size_t first, std::size_t last, const std::string& part, const std::string& recipe) {
    const std::set<std::size_t> lost = read_journals(folder_, recipe, campaign_);
    Journal journal((fs::path(folder_) / ("rows" + part + ".journal")).string(), recipe);
    std::vector<std::size_t> left;
    for (std::size_t row = first; row < last; ++row)
      if (!campaign_.row(row).is_done()) left.push_back(row);
    before_ = done_ = last - first - left.size();
    all_ = last - first;
    started_ = wall_clock();
    std::printf("runs to do: %zu, done before: %zu, at once: %d\n", ended() ? 0 : left.size(), before_, jobs_);
    const auto repeated = std::distance(lost.lower_bound(first), lost.lower_bound(last));
    if (repeated > 0 && !ended())
      std::printf("runs to repeat, whose programs were ended from outside: %ld\n", static_cast<long>(repeated));
    std::fflush(stdout);
    std::size_t lost_now = 0;
    const auto record = [&](std::size_t row, CampaignRow r) {
      journal.write(row, r);
      lost_now += r.is_lost() ? 1 : 0;
      campaign_.set(row, std::move(r));
      ++done_;
      const double share = static_cast<double>(done_) / static_cast<double>(all_);
      if (line_.due(share)) line_.show(progress_text(campaign_, done_, all_, started_, before_));
    };
    const bool whole = on_grains() ? by_runs(left, record) : by_workers(left, part, record);
    if (done_ > before_) line_.show(progress_text(campaign_, done_, all_, started_, before_));
    line_.finish();
    const double spent = wall_clock() - started_;
    if (done_ > before_ && whole)
      std::printf("%zu runs in %s s: %s runs per second, %d at once\n", done_ - before_, number_text(spent, 4).c_str(),
                  number_text(static_cast<double>(done_ - before_) / spent, 3).c_str(), jobs_);
    if (lost_now > 0)
      print_error(code::kRunEndedFromOutside,
                  std::to_string(lost_now) +
                      " of the runs have no result, because their programs were ended from outside (by a signal, or "
                      "for lack of memory); start the same command again, which repeats them");
    return whole;
  }

  // Repeats rows with all their files; the metrics must equal the table. False when interrupted.
  bool repeat(std::vector<RepeatedRun>& runs, const std::string& where) {
    RunStore store((fs::path(folder_) / where).string(), true);
    std::vector<std::size_t> numbers;
    for (RepeatedRun& run : runs) {
      try {
        numbers.push_back(store.add(campaign_.request(run.row, {"output.vtk=true"})));  // to be played
        run.folder = store.folder(numbers.back());
      } catch (const std::exception& e) {  // a row that cannot be run has only its message
        run.folder.clear();
      }
    }
    runs.erase(std::remove_if(runs.begin(), runs.end(), [](const RepeatedRun& r) { return r.folder.empty(); }),
               runs.end());
    const std::vector<std::size_t> left = store.left(numbers);
    if (!left.empty()) std::printf("runs to repeat with all their files: %zu\n", left.size());
    std::fflush(stdout);
    if (!store.carry_out(left, jobs_, [](std::size_t) {})) return false;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      if (store.end_of(numbers[k]).code == kExitDone)
        runs[k].metrics = metrics_of_run(campaign_.spec().metrics, runs[k].folder, campaign_.spec().file);
      if (same(runs[k])) continue;
      ++differing_;
      print_error(code::kRowDiffers, runs[k].folder + " has other figures than row " + std::to_string(runs[k].row) +
                                         " of runs.csv, expected the same digits: programs or files have changed "
                                         "meanwhile; start again in another folder (--out)");
    }
    return true;
  }
  int differing() const { return differing_; }

 private:
  bool ended() const { return campaign_.stopped_early(); }

  bool same(const RepeatedRun& run) const {
    const CampaignRow& row = campaign_.row(run.row);
    if (row.metrics.size() != run.metrics.size()) return false;
    for (std::size_t k = 0; k < row.metrics.size(); ++k)
      if (!(row.metrics[k] == run.metrics[k]) && !(std::isnan(row.metrics[k]) && std::isnan(run.metrics[k])))
        return false;
    return true;
  }

  bool on_grains() const {
    for (std::size_t c = 0; c < campaign_.cases(); ++c)
      if (campaign_.first_valid(c).second.touches_particles()) return true;
    return false;
  }

  template <class Record>
  bool by_workers(const std::vector<std::size_t>& left, const std::string& part, const Record& record) {
    if (left.empty() || ended()) return true;
    WorkerPool pool((fs::path(folder_) / ("work" + part)).string(), std::min(jobs_, static_cast<int>(left.size())),
                    campaign_.spec().time_limit);
    std::size_t next = 0;
    while ((next < left.size() && !ended()) || (pool.busy() && !ended())) {
      while (pool.idle() && next < left.size() && !ended()) {
        const std::size_t row = left[next++];
        RunRequest r;
        try {
          r = campaign_.request(row);
        } catch (const CodedError& e) {
          record(row, {kExitBadInput, e.what(), {}, {}});
          continue;
        }
        pool.start({row, r.scene, r.settings, r.until, r.trusted});
      }
      const std::optional<WorkerAnswer> answer = pool.wait();
      if (pool.interrupted()) return false;
      if (!answer) continue;
      CampaignRow r;
      r.code = answer->code;
      r.message = answer->message;
      if (r.code == kExitDone)
        r.metrics = metrics_of_run(campaign_.spec().metrics, answer->folder, campaign_.spec().file);
      record(answer->run, std::move(r));
    }
    return true;
  }

  // Runs with grains have folders, which are kept.
  template <class Record>
  bool by_runs(const std::vector<std::size_t>& left, const Record& record) {
    constexpr std::size_t kAtOnce = 60;  // between looks at the intervals
    RunStore store((fs::path(folder_) / "runs").string(), true);
    for (std::size_t first = 0; first < left.size() && !ended(); first += kAtOnce) {
      std::vector<std::size_t> rows, numbers;
      for (std::size_t k = first; k < std::min(left.size(), first + kAtOnce); ++k) {
        try {
          numbers.push_back(store.add(campaign_.request(left[k])));
          rows.push_back(left[k]);
        } catch (const std::exception& e) {
          record(left[k], {kExitBadInput, e.what(), {}, {}});
        }
      }
      for (const std::size_t n : numbers) store.try_bed(n);
      if (!store.carry_out(store.left(numbers), jobs_, [](std::size_t) {})) return false;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const RunEnd end = store.end_of(numbers[k]);
        CampaignRow r{end.code, end.message, {}, {}};
        // The time limit kills a run that does not end on request.
        if (r.code == 128 + SIGKILL && campaign_.spec().time_limit > 0) r.code = RunEnd::kHung;
        if (end.code == kExitDone)
          r.metrics = metrics_of_run(campaign_.spec().metrics, end.folder, campaign_.spec().file);
        record(rows[k], std::move(r));
      }
    }
    return true;
  }

  Campaign& campaign_;
  std::string folder_;
  int jobs_, differing_ = 0;
  std::size_t before_ = 0, done_ = 0, all_ = 0;
  double started_ = 0.0;
  LiveLine line_{false, ::isatty(STDOUT_FILENO) == 1};
};

// The runs of [check] of one case: most where the outcome is uncertain. False when interrupted.
bool run_better_model(const Campaign& campaign, const std::string& folder, int jobs, BetterModelResult& result) {
  const SweepSpec& spec = campaign.spec();
  const BetterModelSpec& check = *spec.better_model;
  const std::size_t outcome =
      check.outcome.empty() ? 0 : static_cast<std::size_t>(index_of(spec.outcomes, check.outcome));
  std::vector<std::size_t> rows;
  std::vector<int> cheap;
  for (const std::size_t row : rows_of_case(campaign, result.which_case))
    if (campaign.row(row).outcomes[outcome] >= 0) {
      rows.push_back(row);
      cheap.push_back(campaign.row(row).outcomes[outcome]);
    }
  if (rows.size() < 2) return true;
  // Weights fall off about the boundary as (p (1 - p))^1/4, more slowly than the scatter of the outcome, as wrong calls reach
  // further than that; and a share that all have.
  const std::vector<double> p = chances(campaign, outcome, rows);
  std::vector<double> weights;
  for (const double chance : p) weights.push_back(std::pow(chance * (1.0 - chance), 0.25));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& w : weights)
    w = (sum > 0.0 ? (1.0 - check.far) * w / sum : 0.0) + std::max(check.far, 0.01) / static_cast<double>(rows.size());
  result.drawn = draw_by_groups(weights, check.runs, static_cast<std::uint64_t>(spec.seed) + 1);
  RunStore store((fs::path(folder) / "check").string(), true);
  std::vector<std::size_t> numbers;
  for (const GroupDraw& drawn : result.drawn) {
    RunRequest r = campaign.request(rows[drawn.run], check.settings);
    if (!check.scene.empty()) r.scene = check.scene;
    if (check.until > 0.0) r.until = check.until;
    numbers.push_back(store.add(r));
    result.runs.push_back({rows[drawn.run], "check", store.folder(numbers.back()), {}});
    result.chance.push_back(p[drawn.run]);
  }
  std::printf("%s: runs of the check: %zu\n", campaign.case_name(result.which_case).c_str(), numbers.size());
  std::fflush(stdout);
  for (const std::size_t n : numbers) store.try_bed(n);
  const int at_once = std::max(1, jobs / store.most_ranks());
  if (!store.carry_out(store.left(numbers), at_once, [](std::size_t) {})) return false;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    RepeatedRun& run = result.runs[k];
    if (const RunEnd& end = store.end_of(numbers[k]); end.code == kExitDone)
      run.metrics = metrics_of_run(spec.metrics, run.folder, spec.file);
    else
      std::printf("row %zu in the check ended with exit code %d: %s\n", run.row, end.code, end.message.c_str());
    result.better.push_back(campaign.outcomes_of(run.row, run.metrics)[outcome]);
  }
  result.levels = two_levels(cheap, result.drawn, result.better);
  return true;
}

// The beds of rows first ... last - 1, one after the other. A bed that cannot be made is reported, and the others are made.
int make_beds(const Campaign& campaign, const std::string& folder, std::size_t first, std::size_t last) {
  RunStore store((fs::path(folder) / "runs").string(), true);
  std::vector<std::size_t> runs;
  int code = kExitDone;
  const auto report = [&](const std::string& row, const char* why) {
    std::fprintf(stderr, "footfall: %s: %s\n", row.c_str(), why);
    code = kExitFailed;
  };
  for (std::size_t row = first; row < last; ++row) {
    try {
      runs.push_back(store.add(campaign.request(row)));
    } catch (const std::exception& e) {
      report("row " + std::to_string(row), e.what());
    }
  }
  const std::vector<std::size_t> missing = store.beds_to_make(runs);
  std::printf("beds to make: %zu\n", missing.size());
  std::fflush(stdout);
  for (const std::size_t run : missing) {
    try {
      store.make_bed(run, true);
    } catch (const InputError& e) {
      report(store.request(run).name, e.what());
    }
  }
  return code;
}

// What the runs can show; false when they cannot show a statement of the file, also if nothing happens.
bool report_statements(const SweepSpec& spec) {
  const auto percent = [](double share) { return number_text(100.0 * share, 3) + " %"; };
  bool all = true;
  for (const OutcomeSpec& o : spec.outcomes) {
    const auto runs = static_cast<double>(spec.runs);
    std::string text = "\"" + o.name + "\": ";
    if (!o.at_most) {
      text += std::to_string(spec.runs) + " runs in which it does not happen show a probability of at most " +
              percent(upper_bound(0.0, runs)) + " with 95 % confidence";
    } else {
      text += "below " + percent(*o.at_most) + " with 95 % confidence takes";
      for (const long hits : {0, 1, 2, 5})
        text += (hits > 0 ? ", " : " ") + std::to_string(runs_for(*o.at_most, hits)) + " runs if it happens " +
                (hits > 0 ? std::to_string(hits) + " times" : "never");
      const long allowed = hits_allowed(*o.at_most, spec.runs);
      if (allowed >= 0) {
        text += "; in " + std::to_string(spec.runs) + " runs it may happen " + std::to_string(allowed) + " times";
      } else {
        all = false;
        print_error(code::kTooFewRuns,
                    text + "; expected runs = " + std::to_string(runs_for(*o.at_most, 0)) + " or more in " + spec.file);
        continue;
      }
    }
    std::printf("%s.\n", text.c_str());
  }
  const std::size_t count = spec.runs;
  if (tolerance_place(count, kToleranceShare) >= count)
    std::printf("Limits of figures that 95 %% of runs keep, with 95 %% confidence, take 59 runs.\n");
  return all;
}

void publish(const StudyPage& page, const OutputFolder& output) {
  write_page(page, output);
  std::printf("%s%s\n%s\n%s\n", page.markdown().c_str(), output.path("runs.csv").c_str(),
              output.path(output.name + ".md").c_str(), output.path("report.html").c_str());
}

// Each batch of runs depends on the results before it, which the journal has after an interruption.
int search_rare(const SweepSpec& spec, const SweepArguments& a, const OutputFolder& output, int jobs) {
  if (a.only >= 0 || a.row >= 0 || a.list || a.slurm || a.merge || a.beds)
    throw InputError(code::kWrongSweep, spec.file +
                                            ": has [rare], whose runs depend on those before; remove --only, "
                                            "--row, --list, --slurm, --merge and --beds");
  const RareSpec& rare = *spec.rare;
  const double sign = rare.above ? 1.0 : -1.0;
  const std::size_t metric = index_of(spec.metrics, rare.metric);
  const std::size_t inputs = std::count_if(spec.parameters.begin(), spec.parameters.end(),
                                           [](const ParameterSpec& p) { return p.is_drawn(); });
  SubsetSearch search(inputs, spec.runs, sign * (rare.above ? *rare.above : *rare.below),
                      static_cast<std::uint64_t>(spec.seed));
  make_folder(output.folder);
  const FileLock lock = lock_folder(output.folder);
  std::vector<std::vector<double>> points, batch = search.next({});
  std::optional<Campaign> campaign;
  while (!batch.empty()) {
    points.insert(points.end(), batch.begin(), batch.end());
    campaign.emplace(spec, false, &points);
    CampaignRun run(*campaign, output.folder, jobs);
    if (!run.run(0, campaign->size(), "", campaign->recipe())) return study_interrupted();
    std::vector<double> values;
    for (std::size_t row = points.size() - batch.size(); row < points.size(); ++row) {
      if (campaign->row(row).is_lost()) return kExitFailed;  // its result decides about the points that follow
      const std::vector<double>& metrics = campaign->row(row).metrics;
      values.push_back(metrics.empty() ? NAN : sign * metrics[metric]);
    }
    batch = search.next(values);
  }
  write_whole_file(output.path("runs.csv"), campaign_table(*campaign).csv());
  publish(rare_page(*campaign, search, output.command), output);
  return rows_without_number(*campaign) == 0 ? kExitDone : kExitFailed;
}

// The page of a kept run, unless it failed before there was anything to see.
void write_view_of(const RepeatedRun& run) {
  try {
    if (!run.metrics.empty() && has_frames(run.folder)) write_view({run.folder, "", 0, "", true});
  } catch (const InputError& e) {
    warn_missing_file("page", e);
  }
}

}  // namespace

int check_campaign(const std::string& file) {
  const SweepSpec spec = with_requirements(read_sweep_file(file), false);
  const Campaign campaign(spec, false);
  campaign.recipe();  // reads the scene of every case
  std::printf("%s: no faults. %zu draws of %zu parameters, %zu cases.\n", file.c_str(), campaign.draws().count(),
              campaign.draws().parameters().size(), campaign.cases());
  return report_statements(spec) ? kExitDone : kExitFailed;
}

int campaign_command(const SweepArguments& a) {
  SweepSpec spec = read_sweep_file(a.file);
  spec.trusted = a.trust_script;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int jobs = a.jobs > 0 ? a.jobs : cores;
  if (spec.rare && !a.short_form) return search_rare(spec, a, OutputFolder(a), jobs);
  Campaign campaign(with_requirements(spec, a.short_form), a.short_form);
  const OutputFolder output(a);
  const std::string& folder = output.folder;
  const std::string recipe = campaign.recipe();  // reads the scene of every case: its faults are found before all runs
  const std::size_t elements = std::min(kElements, campaign.size());
  if (a.only >= static_cast<int>(elements))
    throw InputError(code::kNoSuchRun, "--only " + std::to_string(a.only) +
                                           ": expected an element of the job array, 0 to " +
                                           std::to_string(elements - 1));
  if (a.row >= static_cast<long>(campaign.size()))
    throw InputError(code::kNoSuchRun, "--row " + std::to_string(a.row) + ": expected a row from 0 to " +
                                           std::to_string(campaign.size() - 1));
  if (a.list) {
    for (std::size_t row = 0; row < campaign.size(); ++row) {
      try {
        const RunRequest r = campaign.request(row);
        std::printf("%zu  %s\n", row, r.scene.c_str());
        print_settings(r);
      } catch (const CodedError& e) {
        std::printf("%zu  %s\n", row, e.what());
      }
    }
    return kExitDone;
  }
  make_folder(folder);
  const FileLock lock = a.only < 0 && !a.merge ? lock_folder(folder) : FileLock();
  if (a.slurm) {
    write_job_array(
        a, output,
        {elements, 1, " --jobs 1",
         "# Each element carries out a share of the rows. At the end tables and pictures:  {command} --merge\n",
         std::to_string(campaign.size()) + " runs in " + std::to_string(elements) + " elements"});
    return kExitDone;
  }
  if (a.beds) {
    const std::size_t element = a.only < 0 ? 0 : static_cast<std::size_t>(a.only), parts = a.only < 0 ? 1 : elements;
    return make_beds(campaign, folder, element * campaign.size() / parts, (element + 1) * campaign.size() / parts);
  }
  CampaignRun run(campaign, folder, jobs);
  if (a.row < 0 && a.only < 0 && !a.short_form &&
      std::any_of(spec.outcomes.begin(), spec.outcomes.end(),
                  [](const OutcomeSpec& o) { return o.at_most.has_value(); }))
    report_statements(spec);
  if (a.row >= 0) {
    read_journals(folder, recipe, campaign);
    std::vector<RepeatedRun> one = {{static_cast<std::size_t>(a.row), "", "", {}}};
    const bool known = campaign.row(one[0].row).is_done();
    if (!run.repeat(one, "kept")) return study_interrupted();
    if (one.empty()) throw NumericalError(code::kRunWithoutRows, "row " + std::to_string(a.row) + " cannot be run");
    std::printf("%s%s\n", one[0].folder.c_str(), known ? "" : " (the row is not in the table yet)");
    return !known || run.differing() == 0 ? kExitDone : kExitFailed;
  }
  if (a.only >= 0) {
    const std::size_t element = a.only;
    const std::size_t first = element * campaign.size() / elements, last = (element + 1) * campaign.size() / elements;
    return run.run(first, last, "_" + std::to_string(a.only), recipe) ? kExitDone : study_interrupted();
  }
  if (a.merge) {
    read_journals(folder, recipe, campaign);
    if (campaign.used() < campaign.draws().count() && !campaign.stopped_early())
      print_error(code::kRowsMissing, "the first row that is not done is of draw " + std::to_string(campaign.used()) +
                                          " of " + std::to_string(campaign.draws().count()) +
                                          "; tables have the draws before it");
  } else if (!run.run(0, campaign.size(), "", recipe)) {
    return study_interrupted();
  }
  // The table first: the next steps take time, and need no repetition of runs when they are interrupted.
  write_whole_file(output.path("runs.csv"), campaign_table(campaign).csv());
  std::vector<RepeatedRun> kept = rows_to_keep(campaign, campaign.spec().keep);
  if (!kept.empty() && !run.repeat(kept, "kept")) return study_interrupted();
  for (const RepeatedRun& one : kept) write_view_of(one);
  std::vector<BetterModelResult> checks;
  for (std::size_t c = 0; c < campaign.cases() && campaign.spec().better_model && campaign.used() > 1; ++c) {
    checks.emplace_back();
    checks.back().which_case = c;
    if (!run_better_model(campaign, folder, jobs, checks.back())) return study_interrupted();
  }
  std::vector<std::string> pictures;
  try {
    pictures = draw_campaign(campaign, folder);
  } catch (const InputError& e) {
    warn_missing_file("picture", e);
  }
  if (const std::size_t unknown = rows_without_number(campaign); unknown > 0)
    print_error(code::kRowsUnknown,
                std::to_string(unknown) + " of " + std::to_string(campaign.used() * campaign.cases()) +
                    " rows have no result, or a figure without a number; probabilities and percentiles are bounded as "
                    "if these had any value, and the page lists the causes");
  publish(campaign_page(campaign, kept, checks, output.command, pictures), output);
  if (run.differing() > 0 || rows_without_number(campaign) > 0) return kExitFailed;
  return statements_shown(campaign) ? kExitDone : kExitRequirements;
}

}  // namespace footfall
