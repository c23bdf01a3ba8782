#include <gtest/gtest.h>

#include "tests/physics/famous_mechanisms.h"
#include "tests/physics/mechanisms.h"
#include "tests/physics/motion_of.h"

// What IDA says of its own errors: a run that ends off by tens of tolerances does not pass in silence.
namespace footfall {
namespace {

std::string warning_after(const Model& model, double t_end, double rtol, double* error = nullptr) {
  test::Run run(model, "ida", test::as_a_scene(rtol));
  const test::Motion start = test::motion_of(run);
  run.to(t_end);
  if (error != nullptr) {
    test::Run reference(model, "one_step", test::as_a_scene(1e-3 * rtol));
    reference.to(t_end);
    const test::Motion end = test::motion_of(reference);
    *error = test::difference(test::motion_of(run), end, test::size_of(start, end)) / rtol;
  }
  return run.integrator->warning();
}

TEST(IdaWarning, ComesWhereTheEndIsOffByTensOfTolerances) {
  double error = 0.0;
  const std::string warning = warning_after(test::bennett(), 10.0, 1e-6, &error);
  EXPECT_GT(error, 30.0);
  EXPECT_NE(warning.find("add up to"), std::string::npos) << "error " << error << " tolerances; " << warning;
}

TEST(IdaWarning, ComesWhereStiffPartsVibrateAtItsTolerance) {
  // Thousands of steps in the first seconds of a spin-up: their errors add up.
  EXPECT_NE(warning_after(test::spin_up_beam(8), 1.5, 1e-6).find("add up to"), std::string::npos);
}

TEST(IdaWarning, StaysAwayWhereTheErrorsAreFew) { EXPECT_EQ(warning_after(test::flyball_governor(), 1e-3, 1e-6), ""); }

}  // namespace
}  // namespace footfall
