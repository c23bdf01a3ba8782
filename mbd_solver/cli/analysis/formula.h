#pragma once
// What a curve shows, of the columns of a history.

#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/output/history.h"

namespace footfall {

// factor (constant + sum of c_i column_i), or factor times the norm of the columns.
struct Formula {
  std::vector<std::pair<double, std::string>> columns;  // c_i and the column's name
  double constant = 0.0;
  double factor = 1.0;
  bool is_norm = false;

  std::string gnuplot() const;                               // as gnuplot computes it, in parentheses
  std::vector<double> values(const History& history) const;  // one per row; throws InputError for an unknown column
};

}  // namespace footfall
