// LAMMPS_NS::Variable::eval_tree: the value of a formula for one grain. LIGGGHTS follows the tree of the formula for every grain, which
// took a third of the time of making a bed, whose grains have drag while they fall. Sums, products and quotients of numbers
// and of quantities of the grains are computed here for all grains at once, operation by operation: the same operations in
// the same order for each grain, so the same bits.

#include <algorithm>

#include "atom.h"
#include "liggghts_fix/replaced/formula_column.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "variable.h"

namespace {

// The numbers of operations, an enumeration in variable.cpp of LIGGGHTS 3.8.0.
enum Operation { kAdd = 1, kSubtract = 2, kMultiply = 3, kDivide = 4, kNegative = 7, kNumber = 44, kOfGrain = 45 };

template <class Operator>
void combine(std::vector<double>& a, const std::vector<double>& b, Operator combined) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] = combined(a[k], b[k]);
}

// Values for the first `count` grains. False where the tree has another operation, or divides by zero, which is an error: nothing
// here has consequences, so that LIGGGHTS may begin anew.
template <class Tree>
bool values_of(const Tree& tree, int count, std::vector<double>& values) {
  values.resize(static_cast<std::size_t>(count));
  switch (tree.type) {
    case kNumber: std::fill(values.begin(), values.end(), tree.value); return true;
    case kOfGrain:
      for (int k = 0; k < count; ++k) values[k] = tree.array[static_cast<std::ptrdiff_t>(k) * tree.nstride];
      return true;
    case kNegative:
      if (!values_of(*tree.left, count, values)) return false;
      for (double& value : values) value = -value;
      return true;
    case kAdd:
    case kSubtract:
    case kMultiply:
    case kDivide: break;
    default: return false;
  }
  std::vector<double> right;
  if (!values_of(*tree.left, count, values) || !values_of(*tree.right, count, right)) return false;
  if (tree.type == kAdd) combine(values, right, [](double a, double b) { return a + b; });
  if (tree.type == kSubtract) combine(values, right, [](double a, double b) { return a - b; });
  if (tree.type == kMultiply) combine(values, right, [](double a, double b) { return a * b; });
  if (tree.type != kDivide) return true;
  if (std::find(right.begin(), right.end(), 0.0) != right.end()) return false;
  combine(values, right, [](double a, double b) { return a / b; });
  return true;
}

}  // namespace

double LAMMPS_NS::Variable::eval_tree(Tree* tree, int i) {
  static const auto next =
      footfall::next_definition<double (*)(Variable*, Tree*, int)>("_ZN9LAMMPS_NS8Variable9eval_treeEPNS0_4TreeEi");
  footfall::FormulaColumn& column = footfall::formula_column();
  if (column.begins) {
    column.begins = false;
    column.root = values_of(*tree, atom->nlocal, column.values) ? tree : nullptr;
  }
  return tree == column.root ? column.values[i] : next(this, tree, i);
}
