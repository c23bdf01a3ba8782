#pragma once
// Which of two methods takes the steps of a window. Windows end steps: where one step of few stages fills a window, more
// stages are lost; where it takes several, one step of a higher order with one stage more is cheaper.

#include <algorithm>
#include <utility>

namespace footfall {

class MethodChoice {
 public:
  bool high() const { return high_; }

  // At the start of a window [s] with a planned step h [s] of the method so far: the step to begin with.
  double begin(double window, double h) {
    const bool known = std::exchange(begun_, true);  // else h is a guess, or of either method
    if (!high_ && h < kFills * window) {
      high_ = true;
      return known ? std::min(window, kLonger * h) : h;
    }
    if (high_ && h > kEasily * window) high_ = false;
    return h;
  }

 private:
  static constexpr double kFills = 1.0 - 1e-9;
  static constexpr double kLonger = 1.8;  // the step of the higher order over that of the lower one, about
  static constexpr double kEasily = 2.5;  // windows that a step of the higher order can fill before the lower one does
  bool high_ = false, begun_ = false;
};

}  // namespace footfall
