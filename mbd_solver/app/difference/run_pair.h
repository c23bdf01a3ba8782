#pragma once
// In what two runs differ: keys of their scenes, figures of their summaries, curves of their histories.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/session/output/history.h"

namespace footfall {

// The folder's name, as users call the run.
std::string name_of_run(const std::string& folder);

// A folder with the results of a run. Throws InputError where it is none.
struct FinishedRun {
  explicit FinishedRun(const std::string& folder);

  std::string folder, name;        // name_of_run
  nlohmann::ordered_json summary;  // summary.json
  nlohmann::ordered_json scene;    // of it; empty if unknown
  History history;
};
// Two runs; of equal names each gets its folder in front.
struct RunPair {
  RunPair(const std::string& first, const std::string& second);
  FinishedRun a, b;
};

// A key of scenes, as --set names it, with both values; "-" where a scene does not have it.
struct KeyDifference {
  std::string key, a, b;
};
std::vector<KeyDifference> scene_differences(const nlohmann::ordered_json& a, const nlohmann::ordered_json& b);

// Peaks, margins, errors: numbers that both summaries have and that differ, with the unit in their name; without costs.
struct FigureDifference {
  std::string name, unit;
  double a, b;
  std::string key = "";  // of the summary
};
std::vector<FigureDifference> figure_differences(const nlohmann::ordered_json& a, const nlohmann::ordered_json& b);

// Of a column that both histories have, over the time that both cover; the largest share first.
struct CurveDifference {
  std::string name, unit;
  double largest = 0.0, at = 0.0;  // |b - a|, and when [s]
  double share = 0.0;              // root mean square of b - a over the range of both
};
// Columns of both that differ by more than kVisible of the largest value with their unit; the largest share first.
inline constexpr double kVisible = 1e-6;
std::vector<CurveDifference> curve_differences(const History& a, const History& b);

// The column of a history at time t [s], straight between rows; nan outside.
double value_at(const History& history, const std::vector<double>& column, double t);

// Both histories on one clock, of these columns: NAME (first), NAME (second). Rows are the first run's
// in the time that both cover. Throws InputError where there are fewer than two.
inline constexpr const char *kFirstRun = " (first)", *kSecondRun = " (second)";
History on_one_clock(const RunPair& pair, const std::vector<std::string>& columns);

}  // namespace footfall
