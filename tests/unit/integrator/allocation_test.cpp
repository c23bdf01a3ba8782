// A step takes no memory: twice as many steps ask malloc as often as half of them. mbd_solver/integrator/one_step.h.

#include "tests/support/heap_requests.h"
#include "tests/unit/dynamics/run.h"
#include "tests/unit/integrator/smooth_mechanisms.h"

namespace footfall {
namespace {

TEST(OneStep, TakesNoMemoryInAStep) {
  SKIP_WHERE_MEMORY_IS_NOT_COUNTED();
  const Model model = test::smooth_loop(3);
  for (int order : {2, 3, 5}) {
    IntegratorOptions options = test::usual();
    options.order = order;
    options.max_step = 1e-3;
    test::Run run(model, "one_step", options);
    run.to(0.01);  // what is sized at its first use
    const auto count = [&](double t_end) {
      const long before = test::heap_requests;
      run.integrator->advance(run.state, t_end, run.inputs);
      return test::heap_requests - before;
    };
    const long few = count(0.02), many = count(0.12);
    EXPECT_GT(test::heap_requests, 0);
    EXPECT_LE(many, few) << order;
  }
}

}  // namespace
}  // namespace footfall
