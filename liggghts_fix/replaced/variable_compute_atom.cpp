// LAMMPS_NS::Variable::compute_atom, which asks eval_tree for the value of a formula grain by grain. No value lives longer than one
// call, because LIGGGHTS then frees the tree.

#include "liggghts_fix/replaced/formula_column.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "variable.h"

footfall::FormulaColumn& footfall::formula_column() {
  static FormulaColumn column;
  return column;
}

void LAMMPS_NS::Variable::compute_atom(int ivar, int igroup, double* result, int stride, int sumflag) {
  static const auto next = footfall::next_definition<void (*)(Variable*, int, int, double*, int, int)>(
      "_ZN9LAMMPS_NS8Variable12compute_atomEiiPdii");
  footfall::FormulaColumn& column = footfall::formula_column();
  column.begins = true;
  column.root = nullptr;
  next(this, ivar, igroup, result, stride, sumflag);
  column.begins = false;
  column.root = nullptr;
}
