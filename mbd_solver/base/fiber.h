#pragma once
// A function with a stack of its own that can pause: a loop that calls back becomes one that is called step by step. It runs on the
// thread of its caller, and neither thread nor signal is involved.

#include <exception>
#include <functional>
#include <memory>

namespace footfall {

class Fiber {
 public:
  // The work does not begin before the first resume().
  explicit Fiber(std::function<void()> work);
  ~Fiber();  // the work has ended, or has not begun: what stands on its stack is not destroyed here
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  void resume();  // until the work pauses or ends; throws what the work threw
  void pause();   // from within the work, not from within a catch clause
  bool ended() const { return ended_; }
  bool begun() const { return begun_; }

 private:
  struct Contexts;
  static void enter(unsigned high, unsigned low);  // of the address of a Fiber
  std::function<void()> work_;
  std::unique_ptr<Contexts> contexts_;
  std::exception_ptr error_;
  bool begun_ = false, ended_ = false;
};

}  // namespace footfall
