// mbd_solver/integrator/progress_watch.h: windows that do not end.

#include <gtest/gtest.h>

#include <string>

#include "mbd_solver/integrator/progress_watch.h"

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

}  // namespace
}  // namespace footfall
