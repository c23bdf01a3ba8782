// A step takes no memory: twice as many steps ask malloc as often as half of them. mbd_solver/integrator/one_step.h.

#include <atomic>
#include <cstddef>

#include "tests/unit/dynamics/run.h"
#include "tests/unit/integrator/smooth_mechanisms.h"

namespace {
std::atomic<long> asked{0};
}

extern "C" void* __libc_malloc(std::size_t);
extern "C" void* malloc(std::size_t size) {
  ++asked;
  return __libc_malloc(size);
}

namespace footfall {
namespace {

TEST(OneStep, TakesNoMemoryInAStep) {
  const Model model = test::smooth_loop(3);
  for (int order : {2, 5}) {
    IntegratorOptions options = test::usual();
    options.order = order;
    options.max_step = 1e-3;
    test::Run run(model, "one_step", options);
    run.to(0.01);  // what is sized at its first use
    const auto count = [&](double t_end) {
      const long before = asked;
      run.integrator->advance(run.state, t_end, run.inputs);
      return asked - before;
    };
    const long few = count(0.02), many = count(0.12);
    EXPECT_GT(asked, 0);
    EXPECT_LE(many, few) << order;
  }
}

}  // namespace
}  // namespace footfall
