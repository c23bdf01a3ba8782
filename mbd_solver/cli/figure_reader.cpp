#include "mbd_solver/cli/figure_reader.h"

#include <map>

namespace footfall {

void take_figure(TableReader& table, SweepFigure& figure) {
  static const std::map<std::string, Reduction> known = {
      {"max", Reduction::kMax},         {"min", Reduction::kMin},     {"final", Reduction::kFinal},
      {"largest", Reduction::kLargest}, {"peaks", Reduction::kPeaks}, {"variation", Reduction::kVariation}};
  std::string reduce = "max";
  table.take("key", figure.key);
  table.take("columns", figure.columns);
  table.take("reduce", reduce);
  table.take("prominence", figure.prominence);
  table.take("over", figure.over);
  if (figure.key.empty() == figure.columns.empty()) table.fail("key", "expected either key (of summary.json) or columns (of history.csv)");
  const auto found = known.find(reduce);
  if (found == known.end()) table.fail(*table.next("reduce"), "reduce", "is \"" + reduce + "\", expected max, min, final, largest, peaks or variation");
  figure.reduction = found->second;
}

}  // namespace footfall
