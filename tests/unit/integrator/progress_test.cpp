// mbd_solver/integrator/progress_watch.h: windows that do not end.

#include <gtest/gtest.h>

#include "coupler/base/errors.h"
#include "mbd_solver/integrator/progress_watch.h"
#include "mbd_solver/model/rotation.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

TEST(ProgressWatch, ComplainsOfStepsThatNeverEndAndBearsAHardMoment) {
  ProgressWatch never(0.0, 1.0), moment(0.0, 1.0);
  double t = 0.0;
  std::string complaint;
  for (int i = 0; i < 4000 && complaint.empty(); ++i) complaint = never.complaint(t += 1e-10);
  EXPECT_NE(complaint.find("2000 steps"), std::string::npos) << complaint;
  t = 0.0;
  for (int i = 0; i < 10000; ++i) EXPECT_TRUE(moment.complaint(t += i % 2000 < 1900 ? 1e-12 : 1e-5).empty()) << i;
}

// Four rods in a row, each 1e4 times heavier than the one above it.
Model heavier_and_heavier() {
  Model model({0.0, 0.0, -9.81});
  double mass = 1.0;
  for (int i = 0; i < 4; ++i, mass *= 1e4) {
    BodyState state;
    state.r = {i + 0.5, 0.0, 0.0};
    const Eigen::Vector3d J(3e-4, 8e-2, 8e-2);
    model.add_body(Body("rod_" + std::to_string(i), mass, mass * Eigen::Matrix3d(J.asDiagonal())), state);
    const Eigen::Vector3d point(i, 0.0, 0.0);
    const Eigen::Matrix3d across = axes_with_z(Eigen::Vector3d::UnitY());
    model.add_joint(revolute_joint("hinge_" + std::to_string(i), model.marker_at(i - 1, point, across),
                                   model.marker_at(i, point, across)));
  }
  return model;
}

TEST(ProgressWatch, MassesThatDifferByTwelveOrdersEndTheRunByName) {
  const Model model = heavier_and_heavier();
  test::Run run(model, "one_step", [] {
    IntegratorOptions options = test::usual();
    options.order = 5;
    options.rtol = 1e-6;
    options.atol = 1e-8;
    options.atol_velocity = 1e-6;
    return options;
  }());
  try {
    run.to(2.0, 2);
  } catch (const NumericalError& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.find("rod_") != std::string::npos || text.find("hinge_") != std::string::npos) << text;
  }
  // Steps that would be needed without an end of it: some 1e9.
  EXPECT_LT(run.integrator->statistics().steps, 200000);
}

}  // namespace
}  // namespace footfall
