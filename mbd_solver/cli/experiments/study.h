#pragma once
// A study as its file says it: what `footfall accuracy FILE` runs.
//
//   title = "..."                          scene = "scenes/lattice.toml" (relative to the file)
//   settings = ["key=value", ...]          for every run                until = 0.1      repeats = 3 (run times: the
//   shortest counts) short_until, short_settings = [...]    for --short, instead of until and besides settings
//   [reference]  settings = [...]          what the others are compared with
//   [[curves]]   name, settings with {value}, values = [...], short = [...] (for --short), scale (x = scale value),
//   scene and reference (its own)
//                beside = [...]: what {beside} stands for, one per value, where two numbers go together
//                default: the one of the values that the scene has by itself; recommendations are measured by its run
//                time
//   [ensemble]   settings with {value}, values = [...]: every point is run for each of them; figures are means, and
//   their spread is told [[measures]] name, kind = "rms" | "final" (columns of history.csv against the reference's, up
//   to the time `until`), "figure" (a number out of the run, against
//                the reference's: key of summary.json, or columns with reduce, prominence, over, as in sweep.h),
//                "own" (key of summary.json that is an error itself)
//   [[expect]]   curve, measure, order = [least, most] and/or error = most (at the smallest x)
//   [[cases]]    of a stability map: see CaseSpec. A file has curves, or cases, or
//   omega_h = [...], substeps = 20   for growth per window: see window_growth.h

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/sweep_figure.h"

namespace footfall {

struct CurveSpec {
  std::string name;
  std::string scene;                  // empty: the study's
  std::vector<std::string> settings;  // "{value}" is replaced
  std::vector<std::string>
      reference;  // settings of a reference of its own, besides those of [reference]; empty: the study's
  std::vector<std::string> values, short_values;
  std::vector<std::string> beside;  // as values; empty: none
  std::string default_value;        // empty: none of them
  double scale = 1.0;               // x = scale * value, for values that are numbers
};

enum class MeasureKind { kRms, kFinal, kFigure, kOwn };

struct MeasureSpec {
  std::string name;
  MeasureKind kind = MeasureKind::kRms;
  std::vector<std::string> columns;  // rms, final
  std::string key;                   // own
  double until = 0.0;                // rms, final: rows up to this time [s]; 0: all
  SweepFigure figure;                // figure
};

struct ExpectSpec {
  std::string curve, measure;
  double least_order = 0.0, most_order = 0.0;  // both 0: not asked
  double most_error = 0.0;                     // 0: not asked
};

// One line of a stability map, or several: one per value. The run must end in one of the ways of `expect`:
//   accurate   done, error within the tolerance, and no energy gained
//   warned     done, energy bounded, but the error is larger, and a warning said so
//   stopped    ended by itself with a message (exit code 1)
//   refused    not started (exit code 2)
struct CaseSpec {
  std::string name, group, scene;
  std::vector<std::string> settings;  // "{value}" is replaced
  std::vector<std::string> values;    // empty: one run
  std::vector<std::string> expect;    // one for all, or one per value
  std::string message;                // regular expression that warnings or the last message must match; empty: any
  std::vector<std::string>
      reference;  // settings added to those of the case for the run to compare with; empty: judged by energy
  std::vector<std::string> columns;  // of history.csv, compared
  bool at_end = false;               // compare the last row only: where it comes to rest
  double tolerance = 0.02;           // of the reference's swing [-]
  double order_beyond = 0.0;         // from this value on errors grow at most in proportion to the value; 0: not asked
  double until = 0.0;                // [s]; 0: the scene's end time
};

struct StudySpec {
  std::string file, folder;  // of the study
  std::string title, scene, x_name = "value";
  std::vector<std::string> settings, reference;
  std::string reference_scene;
  bool has_reference = false;
  double until = 0.0;                       // [s]; 0: the scene's end time
  std::vector<std::string> short_settings;  // besides settings
  double short_until = 0.0;                 // instead of until; 0: that one
  int repeats = 1;
  int time_limit = 600;  // per run [s]
  std::vector<CurveSpec> curves;
  std::vector<std::string> ensemble_settings, ensemble_values, ensemble_short;
  std::vector<MeasureSpec> measures;
  std::vector<ExpectSpec> expect;
  std::vector<CaseSpec> cases;
  std::vector<double> omega_h;  // growth per window instead of runs: see window_growth.h
  int substeps = 20;            // likewise, per window
};

// Throws InputError "file:line: key: what is wrong, what was expected".
StudySpec read_study(const std::string& file);

// "{value}" in every text replaced, or another mark.
std::vector<std::string> filled(std::vector<std::string> texts, const std::string& value,
                                const std::string& mark = "{value}");
// The settings of one value of the curve.
std::vector<std::string> settings_of(const CurveSpec& curve, const std::string& value);

}  // namespace footfall
