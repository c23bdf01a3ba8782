#pragma once
// The report of a campaign: the table of all rows, the page, and pictures drawn by one gnuplot process.

#include <string>
#include <vector>

#include "mbd_solver/campaign/boundary.h"
#include "mbd_solver/campaign/campaign.h"
#include "mbd_solver/campaign/statistics.h"
#include "mbd_solver/campaign/subset_search.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

// The runs of [check], by the better model, of one case.
struct BetterModelResult {
  std::size_t which_case = 0;
  std::vector<GroupDraw> drawn;
  std::vector<RepeatedRun> runs;  // one per entry of `drawn`
  std::vector<int> better;        // their outcome; -1: without result
  std::vector<double> chance;     // of the outcome, by the fitted boundary
  TwoLevels levels;
};

// Places of the rows of a case that have a result.
std::vector<std::size_t> rows_of_case(const Campaign& campaign, std::size_t which_case);

// The boundary from the runs of a case with a known outcome.
Boundary boundary_of(const Campaign& campaign, const EnvelopeSpec& envelope, std::size_t which_case);

// The chance of an outcome for each of the rows, by a logistic curve in all drawn numbers.
std::vector<double> chances(const Campaign& campaign, std::size_t outcome, const std::vector<std::size_t>& rows);

Table campaign_table(const Campaign& campaign);
// `pictures`: of draw_campaign.
StudyPage campaign_page(const Campaign& campaign, const std::vector<RepeatedRun>& kept,
                        const std::vector<BetterModelResult>& checks, const std::string& command,
                        const std::vector<std::string>& pictures);
// The page of a rare event, with all runs of the search.
StudyPage rare_page(const Campaign& campaign, const SubsetSearch& search, const std::string& command);
// Every statement of [[outcomes]] is shown, in every case.
bool statements_shown(const Campaign& campaign);
// Histograms and envelopes; returns the pictures. Throws InputError when gnuplot is missing or fails.
std::vector<std::string> draw_campaign(const Campaign& campaign, const std::string& folder);

}  // namespace footfall
