#include "mbd_solver/cli/calibrate/descent.h"

#include <algorithm>

namespace footfall {

namespace {

constexpr double kBetter = 1e-9;  // less than this is rounding

}  // namespace

Shares down_from(Shares u, const DescentBounds& bounds, const std::vector<double>& steps,
                 const std::function<double(const Shares&)>& value) {
  double least = value(u);
  for (const double step : steps)
    for (bool better = true; better;) {
      better = false;
      for (std::size_t i = 0; i < u.size(); ++i)
        for (const double move : {step, -step}) {
          const double from = u[i];
          u[i] = std::clamp(from + move, bounds.least[i], bounds.most[i]);
          const double tried = value(u);
          if (tried < least - kBetter)
            least = tried, better = true;
          else
            u[i] = from;
        }
    }
  return u;
}

}  // namespace footfall
