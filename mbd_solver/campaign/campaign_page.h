#pragma once
// What a campaign reports: the table of all rows, the page, and pictures drawn by one gnuplot process.

#include <string>
#include <vector>

#include "mbd_solver/campaign/campaign.h"
#include "mbd_solver/campaign/statistics.h"
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

// The boundary of an outcome in one or two drawn parameters, from a quadratic logistic curve.
class Boundary {
 public:
  // y empty: over x alone. Values outside the sampled range are not answered for.
  Boundary(const Campaign& campaign, const EnvelopeSpec& envelope, std::size_t which_case);

  struct Crossing {
    double x = 0.0, y = 0.0, low = 0.0, high = 0.0;  // the band is along y, or along x when `along_x`
    bool along_x = false;
  };
  std::vector<Crossing> crossings() const;
  // Of the line through the other parameter's median (for one parameter: of x).
  std::vector<Crossing> middle() const;
  bool in_band(double x, double y) const;
  double agreement() const { return agreement_; }  // share of the runs on the right side
  bool fitted() const { return fitted_; }          // both outcomes have been seen
  double low(int axis) const { return low_[axis]; }
  double high(int axis) const { return high_[axis]; }

 private:
  Eigen::VectorXd terms(double x, double y) const;
  double score(double x, double y) const;  // 0 on the boundary
  std::vector<Crossing> along(int axis, double other) const;

  bool two_;
  double level_;  // score at the boundary
  double low_[2] = {0.0, 0.0}, high_[2] = {1.0, 1.0}, median_[2] = {0.0, 0.0};
  Logistic fit_;
  double agreement_ = 0.0;
  bool fitted_ = false;
};

// The chance of an outcome for each of the rows, by a logistic curve in all drawn numbers.
std::vector<double> chances(const Campaign& campaign, std::size_t outcome, const std::vector<std::size_t>& rows);

Table campaign_table(const Campaign& campaign);
// `pictures`: of draw_campaign.
StudyPage campaign_page(const Campaign& campaign, const std::vector<RepeatedRun>& kept,
                        const std::vector<BetterModelResult>& checks, const std::string& command,
                        const std::vector<std::string>& pictures);
// Histograms and envelopes; returns the pictures. Throws InputError when gnuplot is missing or fails.
std::vector<std::string> draw_campaign(const Campaign& campaign, const std::string& folder);

}  // namespace footfall
