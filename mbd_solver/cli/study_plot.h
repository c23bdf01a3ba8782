#pragma once
// The table of a study as CSV, and its picture.

#include <string>
#include <vector>

namespace footfall {

// One run of a study (or the mean of an ensemble).
struct StudyPoint {
  std::string curve, value;
  double x = 0.0;                                   // scale * value; 0 when the value is no number
  int code = 0;
  double wall = 0.0, dem = 0.0, mbd = 0.0, exchange = 0.0;  // [s]
  double steps = 0.0, windows = 0.0;
  std::vector<double> errors;                       // one per measure [-]; NaN: none
  std::vector<double> spreads;                      // over the ensemble, of the figure's mean [-]; empty without one
};

struct StudyTable {
  std::string title, x_name;
  std::vector<std::string> curves, measures;
  std::vector<StudyPoint> points;
  bool grains = false;                              // run times are told without the grains' own share

  // (x, error) or (cost, error) of one curve and measure, where both are positive.
  std::vector<std::pair<double, double>> line(const std::string& curve, std::size_t measure, bool over_cost) const;
};

// Run time that the scheme and the mechanism answer for: everything but the grains' own steps [s].
double cost_of(const StudyPoint& point, bool grains);

void write_study_csv(const std::string& path, const StudyTable& table);
// The same as a Markdown table for the pages.
void write_study_table(const std::string& path, const StudyTable& table);
// Writes NAME.gp beside the CSV and draws NAME.png: one row per measure, error over x on the left (slopes: observed orders), over run time
// on the right, all axes logarithmic. Returns the picture. Throws InputError when gnuplot is missing or fails.
std::string draw_study(const std::string& folder, const std::string& name, const StudyTable& table);

}  // namespace footfall
