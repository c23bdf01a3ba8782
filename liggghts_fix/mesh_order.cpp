#include "liggghts_fix/mesh_order.h"

#include <algorithm>
#include <numeric>

namespace footfall {

std::vector<int> order_after_restart(int before, int own, int after) {
  constexpr int kForeign = -1;
  std::vector<int> list(static_cast<std::size_t>(before + own + after), kForeign);
  std::iota(list.begin() + before, list.begin() + before + own, 0);
  for (std::size_t i = 0; i < list.size();) {
    if (list[i] != kForeign) {
      ++i;
      continue;
    }
    list[i] = list.back();
    list.pop_back();
  }
  return list;
}

}  // namespace footfall
