#include "mbd_solver/cli/experiments/figure_reader.h"

#include <map>

namespace footfall {

void take_figure(TableReader& table, SweepFigure& figure) {
  static const std::map<std::string, Reduction> known = {{"max", Reduction::kMax},
                                                         {"min", Reduction::kMin},
                                                         {"final", Reduction::kFinal},
                                                         {"largest", Reduction::kLargest},
                                                         {"drop", Reduction::kDrop},
                                                         {"peaks", Reduction::kPeaks},
                                                         {"variation", Reduction::kVariation}};
  std::string reduce = "max";
  table.take("key", figure.key);
  table.take("columns", figure.columns);
  table.take("reduce", reduce);
  table.take("average", figure.average);
  table.take("prominence", figure.prominence);
  table.take("over", figure.over);
  if (figure.key.empty() == figure.columns.empty())
    table.fail("key", "expected either key (of summary.json) or columns (of history.csv)");
  if (figure.average && figure.columns.size() < 2)
    table.fail(*table.next("average"), "average", "is true, expected at least two columns to take the mean of");
  const auto found = known.find(reduce);
  if (found == known.end())
    table.fail(*table.next("reduce"), "reduce",
               "is \"" + reduce + "\", expected max, min, final, largest, drop, peaks or variation");
  figure.reduction = found->second;
}

}  // namespace footfall
