// LAMMPS_NS::Variable::eval_tree: the value of a formula for one grain. Sums, products and quotients of numbers and of quantities of
// the grains, which drag on pouring grains is made of, are computed here, in the same order and to the same bits, without
// the large frame that LIGGGHTS' function has for its forty operations: it took a third of the time of making a bed.

#include <optional>

#include "liggghts_fix/replaced/next_definition.h"
#include "variable.h"

namespace {

// The numbers of operations, an enumeration in variable.cpp of LIGGGHTS 3.8.0.
enum Operation { kAdd = 1, kSubtract = 2, kMultiply = 3, kDivide = 4, kNegative = 7, kNumber = 44, kOfGrain = 45 };

// Of any other operation, and of a division by zero, which is an error: nothing. Nothing here has consequences, so that LIGGGHTS may
// begin the formula anew.
template <class Tree>
std::optional<double> value_of(const Tree& tree, int grain) {
  const auto part = [grain](const Tree* of) { return value_of(*of, grain); };
  switch (tree.type) {
    case kNumber: return tree.value;
    case kOfGrain: return tree.array[static_cast<std::ptrdiff_t>(grain) * tree.nstride];
    case kNegative:
      if (const auto a = part(tree.left)) return -*a;
      return std::nullopt;
    case kAdd:
    case kSubtract:
    case kMultiply:
    case kDivide: break;
    default: return std::nullopt;
  }
  const std::optional<double> a = part(tree.left), b = part(tree.right);
  if (!a || !b || (tree.type == kDivide && *b == 0.0)) return std::nullopt;
  switch (tree.type) {
    case kAdd: return *a + *b;
    case kSubtract: return *a - *b;
    case kMultiply: return *a * *b;
    default: return *a / *b;
  }
}

}  // namespace

double LAMMPS_NS::Variable::eval_tree(Tree* tree, int i) {
  static const auto next =
      footfall::next_definition<double (*)(Variable*, Tree*, int)>("_ZN9LAMMPS_NS8Variable9eval_treeEPNS0_4TreeEi");
  const std::optional<double> value = value_of(*tree, i);
  return value ? *value : next(this, tree, i);
}
