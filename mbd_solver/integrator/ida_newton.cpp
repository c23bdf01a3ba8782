// When Newton's iteration in a step of IDA is done: by what it leaves of the error of the step, and of the multipliers.

#include <algorithm>
#include <cmath>

#include "mbd_solver/integrator/ida_sundials.h"

namespace footfall {
namespace {

constexpr double kIgnored = 1e-30;  // weight of multipliers: they carry no error of their own
// Multipliers have to settle all the same: each step extrapolates those of the steps before, by which errors grow many
// times, and a small step does not see them in v. Relative to the largest of them.
constexpr double kReactions = 100.0, kLeastReactions = 1e-9;  // [rtol]; [-], round-off
constexpr double kNoReaction = 1e-3;                          // the largest counts at least as this [N, N m]
constexpr int kMostForReactions = 3;                          // iterations before they need a new Jacobian
// IDA keeps a Jacobian while its c is right within 5/3, and scales corrections by 2 / (1 + ratio of c): a first correction
// may leave a quarter of a multiplier's error. Newton fails when an iteration leaves more than kSlowest (as in IDA).
constexpr double kFirstRate = 0.25, kSlowest = 0.9;
constexpr double kShareOfError = 0.1;                   // of a step's error that Newton may leave
constexpr double kStalled = 0.5, kNewtonNoise = 3e-13;  // slower than that, and below that, is round-off
constexpr int kMostForError = 2;                        // iterations that only that share asks for

}  // namespace

// What is still missing after a correction is correction x rate / (1 - rate). IDA's own test takes the rate of a step before
// for the first correction, however small it was: once multipliers settled at a second correction of 1e-13, it let pass
// whatever the next first corrections left of them.
// And IDA allows Newton a third of what a step may err by, also where steps err by far less (max_step is short): their
// differences then show what Newton left, IDA takes its order down, and many steps of a low order add up. Here Newton
// leaves at most a tenth of the last step's error, or what round-off allows.
int Ida::Sundials::settled(SUNNonlinearSolver newton, N_Vector, N_Vector change, realtype tolerance, N_Vector weight,
                           void* self) {
  Sundials& s = *static_cast<Sundials*>(self);
  const double size = N_VWrmsNorm(change, weight);
  const int rows = s.equations.layout().row_count;
  const double reactions = rows == 0 ? 0.0 : view(change).tail(rows).lpNorm<Eigen::Infinity>() / s.reaction_tolerance;
  int iteration = 0;
  if (SUNNonlinSolGetCurIter(newton, &iteration) != SUN_NLS_SUCCESS) return SUN_NLS_EXT_FAIL;
  double rate = kFirstRate;
  if (iteration == 0) {
    s.first_change = size;
    s.close = false;
  } else {
    rate = std::pow(size / s.first_change, 1.0 / iteration);
    if (!(rate <= kSlowest) && !s.close) return SUN_NLS_CONV_RECVR;
  }
  const bool stalls = s.close && rate > kStalled;
  const double left = rate / (1.0 - rate) * size;
  if (!stalls) s.close = size == 0.0 || left <= tolerance;
  if (!s.close) return SUN_NLS_CONTINUE;
  const double noise = kNewtonNoise / (s.share * s.options.rtol);
  const double wanted = std::max(kShareOfError * s.last_error, noise) * tolerance;
  if (size > 0.0 && !(left <= wanted)) {
    if (iteration < kMostForError && !stalls) return SUN_NLS_CONTINUE;
    if (!s.fresh) return SUN_NLS_CONV_RECVR;
  }
  // Near a singular position multipliers do not settle even with the Jacobian of this step: then the motion alone counts.
  if (reactions > 1.0 && iteration + 1 < kMostForReactions) return SUN_NLS_CONTINUE;
  if (reactions > 1.0 && !s.fresh) return SUN_NLS_CONV_RECVR;
  s.fresh = false;
  return SUN_NLS_SUCCESS;
}

int Ida::Sundials::weights(N_Vector y, N_Vector weight, void* self) {
  Sundials& s = *static_cast<Sundials*>(self);
  const int head = s.equations.layout().lambda0(), rows = s.equations.layout().row_count;
  const Eigen::Map<const Eigen::VectorXd> now = view(y);
  writable(weight).head(head) =
      (s.share * (s.options.rtol * now.head(head).cwiseAbs() + s.norm.absolute())).cwiseInverse();
  if (rows == 0) return 0;
  s.reaction_tolerance = std::max(kReactions * s.options.rtol, kLeastReactions) *
                         std::max(now.tail(rows).lpNorm<Eigen::Infinity>(), kNoReaction);
  writable(weight).tail(rows).setConstant(kIgnored);
  return now.allFinite() ? 0 : -1;
}

}  // namespace footfall
