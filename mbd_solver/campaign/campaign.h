#pragma once
// A campaign: a sweep file with drawn runs. Every case has the same draws, so that cases differ by themselves alone. A row
// is one run: number = draw * cases + case. Finished rows are lines of rows.journal; a campaign that was ended in any way
// continues from them, and repeats rows whose program was ended from outside.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/campaign/sampling.h"
#include "mbd_solver/campaign/statistics.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/studies/plan.h"
#include "mbd_solver/studies/sweep_command.h"

namespace footfall {

struct CampaignRow {
  int code = -1;                // exit code of the run; -1: not done
  std::string message;          // of a run without result
  std::vector<double> metrics;  // as SweepSpec::metrics; empty without result
  std::vector<int> outcomes;    // as SweepSpec::outcomes; -1: unknown

  bool is_done() const { return code >= 0; }
  // Its program was ended by a signal or on request, or gave no answer: no result of the run, which the same command repeats.
  bool is_lost() const;
};

class Campaign {
 public:
  // `points`: those of the draws, for rare events.
  Campaign(const SweepSpec& spec, bool short_form, const std::vector<std::vector<double>>* points = nullptr);

  const SweepSpec& spec() const { return spec_; }
  const Draws& draws() const { return draws_; }
  std::size_t cases() const { return plan_.runs.size(); }
  std::size_t size() const { return rows_.size(); }  // rows of all draws
  std::string case_name(std::size_t c) const;        // "all" for the only one
  std::size_t draw_of(std::size_t row) const { return row / cases(); }
  std::size_t case_of(std::size_t row) const { return row % cases(); }
  // The run of a row, with more settings; throws InputError or NumericalError when formulas have no value.
  RunRequest request(std::size_t row, const std::vector<std::string>& more = {}) const;
  // The first draw of a case whose scene can be read. If none of the first fifty can be read, throws the error of the first draw.
  std::pair<RunRequest, Scene> first_valid(std::size_t c) const;
  std::string name(std::size_t row) const;  // of its folder: row_000012

  const CampaignRow& row(std::size_t k) const { return rows_[k]; }
  void set(std::size_t k, CampaignRow row);  // evaluates its outcomes
  // Outcomes of a run with these metrics.
  std::vector<int> outcomes_of(std::size_t row, const std::vector<double>& metrics) const;
  std::vector<std::string> case_values(std::size_t row) const;   // of the parameters that are not drawn
  std::vector<std::string> drawn_values(std::size_t row) const;  // as text
  // The value of a drawn parameter in formulas and tables: a draw's; of a choice that is no number its place.
  double drawn_number(std::size_t draw, std::size_t place) const;

  // Counts of an outcome over the rows with results. Rows without result, or without a number that the outcome requires,
  // are unknown.
  const Tally& tally(std::size_t which_case, std::size_t outcome) const { return tallies_[which_case][outcome]; }

  // The draws of the results: all, or as many as until_width required. Rows before them are done.
  std::size_t used() const { return used_; }
  bool stopped_early() const { return stopped_; }

  // Fingerprint of the inputs of all rows: a journal with another recipe belongs to another campaign.
  std::string recipe() const;

 private:
  std::map<std::string, double> values_of(std::size_t draw) const;  // for formulas
  void look_for_end();

  SweepSpec spec_;
  Draws draws_;
  Plan plan_;
  std::vector<CampaignRow> rows_;
  std::size_t used_ = 0;                     // draws, from the first, all of whose rows are done
  bool stopped_ = false;                     // the intervals are as narrow as required
  std::vector<std::vector<Tally>> tallies_;  // of those, by case and outcome
};

// A run of a row that was repeated with all its files, or with the settings of [check].
struct RepeatedRun {
  std::size_t row = 0;
  std::string why, folder;
  std::vector<double> metrics;  // empty: it failed
};

// With a metric and an outcome, "missed", for each of the [[requirements]] of the scenes.
SweepSpec with_requirements(SweepSpec spec, bool short_form);

// Rows of the results without a result, or with a metric that is not a number.
std::size_t rows_without_number(const Campaign& campaign);

// Rows worth looking at, at most `most`: without result, with an outcome, or with the least or largest value of a metric.
std::vector<RepeatedRun> rows_to_keep(const Campaign& campaign, std::size_t most);

// Before any run: how many runs the statements of the file need, and what the runs can show. Returns the exit code.
int check_campaign(const std::string& file);

// Runs, and writes the results into the folder. As sweep_command.
int campaign_command(const SweepArguments& arguments);

}  // namespace footfall
