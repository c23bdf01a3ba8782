#pragma once
// [[requirements]] of a scene: one number of a run each, from an expression of figures and columns, and whether it keeps its
// bounds.
//
// An expression reads
//   KEY             a number of summary.json, also KEY.NAME of a table in it
//   COLUMN.max      of a column of history.csv over all steps; likewise .min, .largest (of the absolute values), .final
//   ledger.COLUMN.max, ledger.KEY   of ledger.csv over its rows, and of the table `ledger` of summary.json, when both are written
//   COLUMN          the column itself, where `reduce` says how its expression becomes one number
//   g0, deg, pi     9.80665 m/s2, one degree [rad]

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

// Of requirements whose value is one column or figure in another unit than they state: nothing is converted. names, units: of the
// columns.
std::vector<std::string> requirement_unit_warnings(const Scene& scene, const std::vector<std::string>& names,
                                                   const std::vector<std::string>& units);

class Requirements {
 public:
  // columns: of history.csv, the first is time. The scene must outlive this. Throws InputError with a line "FILE:LINE: ..."
  // for each name that no run of this scene has.
  Requirements(const Scene& scene, std::vector<std::string> columns);

  void see(const std::vector<double>& row);  // at every step
  // Adds `requirements`, a list with name, value, unit, least, most, margin, verdict and why, and requirements_missed, the
  // number of those that are not met. Without entries: nothing.
  void judge(nlohmann::ordered_json& summary) const;
  void visit(Archive& archive);

 private:
  struct Range {  // of a column, or of an expression at each step
    double least = 0.0, largest = 0.0, last = 0.0;
    bool seen = false;
    void see(double value);
    double reduced(Reduce reduce) const;
    void visit(Archive& archive);
  };
  struct Entry {
    std::unique_ptr<NamedValues> values;  // of the names in its expression
    Expression expression;
    std::vector<std::pair<double*, std::size_t>> columns;                        // read at each step
    std::vector<std::tuple<double*, std::string, Reduce, std::size_t>> reduced;  // place, name, how, column
    std::vector<std::pair<double*, std::string>> keys;                           // of the summary
    Range range;                                                                 // with `reduce`
    double undefined_at = -1.0;  // first time at which the expression had no value [s]
  };
  Entry entry_of(const RequirementSpec& spec, std::string& faults) const;
  double value_of(Entry& entry, const RequirementSpec& spec, const nlohmann::ordered_json& summary) const;

  const Scene& scene_;
  std::vector<std::string> names_;
  mutable std::vector<Entry> entries_;
  std::vector<std::size_t> watched_;  // columns of which ranges are kept
  std::vector<Range> ranges_;         // of these
};

// Judges again the requirements of summary.json that read the ledger; other columns are reduced over their rows. The table
// `ledger` is in the summary already.
void judge_ledger(nlohmann::ordered_json& summary, const History& history, const History& ledger);

// The keys of summary.json with one number each that an expression may read.
const std::vector<std::string>& summary_figures();

}  // namespace footfall
