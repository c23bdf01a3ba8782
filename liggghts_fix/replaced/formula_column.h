#pragma once
// The values of one formula for all grains of this rank, of which LIGGGHTS asks for one after the other.

#include <vector>

namespace footfall {

struct FormulaColumn {
  bool begins = false;         // the next formula that is asked for is that of compute_atom
  const void* root = nullptr;  // its tree, where `values` are of it
  std::vector<double> values;
};
FormulaColumn& formula_column();

}  // namespace footfall
