#pragma once
// peaks.csv: the least and the largest value of each column of history.csv, with their times, over all steps of a run.

#include <string>
#include <vector>

#include "coupler/archive.h"

namespace footfall {

struct ColumnPeaks {
  std::string name, unit;
  double least = 0.0, least_time = 0.0, largest = 0.0, largest_time = 0.0;  // [unit], [s]

  void visit(Archive& archive);
};

class Peaks {
 public:
  // Names and units of history.csv; the first column is time.
  Peaks(const std::vector<std::string>& names, const std::vector<std::string>& units);

  void see(const std::vector<double>& row);
  void write(const std::string& path) const;  // throws InputError when it cannot be written
  void visit(Archive& archive);

 private:
  std::vector<ColumnPeaks> columns_;
  bool empty_ = true;
};

// Empty where there is no such file. Throws InputError "file:line: ...".
std::vector<ColumnPeaks> read_peaks(const std::string& path);

}  // namespace footfall
