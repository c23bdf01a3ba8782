#pragma once
// Errors of the curves of an experiment, as CSV and as a picture.

#include <array>
#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/results.h"

namespace footfall {

struct ErrorTable {
  std::string title, x_name;
  std::vector<std::string> curves, figures;
  std::vector<std::string> defaults;   // as curves: the value that the scene has by itself; empty: none
  std::vector<CaseResult> references;  // that of all, or those of single curves
  std::vector<CaseResult> points;
  std::size_t members = 1;  // of the ensemble
  bool grains = false;      // run times are told without the grains' own share

  // The curve of a point; "reference" of the reference of all.
  std::string curve_of(const CaseResult& point) const;
  // What errors are set over: of an ensemble, whose runs often share the machine, the processor time of all programs,
  // else run_time [s].
  double cost(const CaseResult& point) const;
  // Run time that the scheme and the mechanism answer for: everything but the grains' own steps [s].
  double run_time(const CaseResult& point) const;
  // (x or cost, error, standard error) of one curve and figure, where x and error are positive.
  std::vector<std::array<double, 3>> line(std::size_t curve, std::size_t figure, bool over_cost) const;
};

ErrorTable error_table_of(const ExperimentSpec& spec, const Plan& plan, const Results& results);

// With an ensemble, rows of the references come first, and every row has mean, spread and standard error (see
// SampledFigure) of every figure.
void write_error_csv(const std::string& path, const ErrorTable& table);
// Writes NAME.gp beside the CSV and draws NAME.png: one row per figure, error over x on the left (slopes: observed
// orders), over cost on the right, all axes logarithmic; bars go up by the standard error. Returns the picture. Throws
// InputError when gnuplot is missing or fails.
std::string draw_errors(const std::string& folder, const std::string& name, const ErrorTable& table);

}  // namespace footfall
