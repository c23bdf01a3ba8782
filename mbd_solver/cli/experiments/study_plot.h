#pragma once
// What a study found, as CSV and as a picture.

#include <array>
#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/study_error.h"

namespace footfall {

// One run of a study (or the mean of an ensemble).
struct StudyPoint {
  std::string curve, value;
  double x = 0.0;  // scale * value; 0 when the value is no number
  int code = 0;
  std::string message;                                                 // of the run that failed
  double wall = 0.0, dem = 0.0, mbd = 0.0, exchange = 0.0, cpu = 0.0;  // [s]
  double steps = 0.0, windows = 0.0;
  std::vector<double> errors;          // one per measure [-]; NaN: none
  std::vector<SampledFigure> sampled;  // one per measure: over the ensemble; empty without one
};

struct StudyTable {
  std::string title, x_name;
  std::vector<std::string> curves, measures;
  std::vector<std::string> defaults;   // as curves: the value that the scene has by itself; empty: none
  std::vector<StudyPoint> references;  // named "reference", or after the curve whose own it is
  std::vector<StudyPoint> points;
  int members = 1;      // of the ensemble
  bool grains = false;  // run times are told without the grains' own share

  // What errors are set over: of an ensemble, whose runs often share the machine, the processor time of all programs,
  // else cost_of [s].
  double cost(const StudyPoint& point) const;
  // (x, error) or (cost, error) of one curve and measure, where both are positive.
  std::vector<std::pair<double, double>> line(const std::string& curve, std::size_t measure, bool over_cost) const;
  // (x or cost, error) of the same points with their standard errors; empty without an ensemble.
  std::vector<std::array<double, 3>> bars(const std::string& curve, std::size_t measure, bool over_cost) const;
};

// Run time that the scheme and the mechanism answer for: everything but the grains' own steps [s].
double cost_of(const StudyPoint& point, bool grains);

// With an ensemble, rows of the references come first, and every row has mean, spread and standard error (see
// SampledFigure) of every figure.
void write_study_csv(const std::string& path, const StudyTable& table);
// Writes NAME.gp beside the CSV and draws NAME.png: one row per measure, error over x on the left (slopes: observed
// orders), over cost on the right, all axes logarithmic; bars go up by the standard error. Returns the picture. Throws
// InputError when gnuplot is missing or fails.
std::string draw_study(const std::string& folder, const std::string& name, const StudyTable& table);

}  // namespace footfall
