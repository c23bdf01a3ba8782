#pragma once
// A sweep as its file says it, and the runs it stands for.
//
//   title = "..."                      scene = "../landing_mr/scene.toml" (relative to the file)
//   settings = ["key=value", ...]      for every run            until = 0.5 [s]; 0 or left out: the scene's end time
//   [[parameters]]                     every combination of their values is one run; the last one turns fastest
//     name, settings with {value}, values = [...]
//     or [[parameters.choices]]        name, settings, scene: for values that need more than one number, or a scene of their own
//     ensemble = true                  its runs are one case: figures become mean and spread (seeds of the bed)
//   [[figures]]                        columns of the table
//     name, key = "peak_acceleration_g" (of summary.json)
//     or columns = ["cabin.vz"] (of history.csv), reduce = "max" | "min" | "final" | "largest" (absolute)
//   [[limits]] figure, most            cases beyond are out of the ranking
//   minimise = "figure"                ranks the cases that are left
//   [[plots]] name, title, column, label   of history.csv over time, one curve per case

#include <string>
#include <vector>

namespace footfall {

struct SweepChoice {
  std::string name;
  std::string scene;  // instead of the sweep's; empty: that one
  std::vector<std::string> settings;
};

struct SweepParameter {
  std::string name;
  std::vector<SweepChoice> choices;
  bool ensemble = false;
};

enum class Reduction { kMax, kMin, kFinal, kLargest };

struct SweepFigure {
  std::string name;
  std::string key;                   // of summary.json; else
  std::vector<std::string> columns;  // of history.csv: the reduction of all of them
  Reduction reduction = Reduction::kMax;
};

struct SweepLimit {
  std::string figure;
  double most = 0.0;
};

struct SweepPlot {
  std::string name, title, column, label;
};

struct SweepSpec {
  std::string file;
  std::string title, scene;
  std::vector<std::string> settings;
  double until = 0.0;  // [s]
  std::vector<SweepParameter> parameters;
  std::vector<SweepFigure> figures;
  std::vector<SweepLimit> limits;
  std::string minimise;
  std::vector<SweepPlot> plots;
};

// Throws InputError "file:line: key: what is wrong, what was expected".
SweepSpec read_sweep(const std::string& file);

struct SweepRun {
  std::string name;                   // of its folder: the values, joined
  std::vector<std::string> values;    // names of the choices, one per parameter
  std::string scene;
  std::string group;                  // the values without those of ensembles
  std::vector<std::string> settings;  // of the sweep and of the choices
};
// In the order of their numbers.
std::vector<SweepRun> runs_of(const SweepSpec& sweep);

}  // namespace footfall
