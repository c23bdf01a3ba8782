#include "mbd_solver/integrator/ida_sundials.h"

#include <ida/ida.h>
#include <ida/ida_impl.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "coupler/base/errors.h"
#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/work_integral.h"

namespace footfall {
namespace {

constexpr double kIgnored = 1e-30;  // weight of multipliers: they carry no error of their own
// Share of the tolerances that one step may err by; all of them from kAllFrom on, where a tenth comes near the round-off
// of multipliers.
constexpr double kStepShare = 0.1, kAllFrom = 1e-9;  // [-], [rtol]
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
// Gauss-Legendre with three points, exact to fifth order as IDA is.
const double kGaussNode[3] = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)};
constexpr double kGaussWeight[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

Eigen::Map<const Eigen::VectorXd> view(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }
Eigen::Map<Eigen::VectorXd> writable(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }

// IDA raises its order only behind steps of one length, equal to the bit. At its limit H it takes h 2 / (2 h / H) for the
// next step: for most H (1e-4 is one) that swings between two numbers, one unit in the last place apart. The order then
// stays at one or two, and 50 000 errors of that order add up. With a power of two each division is exact.
double exact_limit(double max_step) { return std::exp2(std::floor(std::log2(max_step))); }

}  // namespace

Ida::Sundials::Sundials(Equations& e, const IntegratorOptions& o)
    : equations(e),
      options(o),
      norm(e.layout(), o),
      share(std::clamp(kAllFrom / o.rtol, kStepShare, 1.0)),
      least_left(kNewtonNoise / (share * o.rtol)) {
  const Layout& layout = equations.layout();
  const int n = layout.size();
  if (SUNContext_Create(nullptr, &context) != 0) throw NumericalError("SUNContext_Create failed.");
  y = N_VNew_Serial(n, context);
  ydot = N_VNew_Serial(n, context);
  scratch = N_VNew_Serial(n, context);
  scratch2 = N_VNew_Serial(n, context);
  const Eigen::SparseMatrix<double>& pattern = equations.jacobian_pattern();
  matrix = SUNSparseMatrix(n, n, pattern.nonZeros(), CSC_MAT, context);
  memory = IDACreate(context);
  FOOTFALL_DEMAND(y != nullptr && ydot != nullptr && scratch != nullptr && scratch2 != nullptr && matrix != nullptr &&
                  memory != nullptr);
  std::copy_n(pattern.outerIndexPtr(), n + 1, SUNSparseMatrix_IndexPointers(matrix));
  std::copy_n(pattern.innerIndexPtr(), pattern.nonZeros(), SUNSparseMatrix_IndexValues(matrix));
  solver = SUNLinSol_KLU(y, matrix, context);
  FOOTFALL_DEMAND(solver != nullptr);

  writable(y).setZero();
  writable(ydot).setZero();
  check(IDAInit(memory, &Sundials::residual, 0.0, y, ydot), "IDAInit");
  check(IDASetErrHandlerFn(memory, &Sundials::message, this), "IDASetErrHandlerFn");
  check(IDASetUserData(memory, this), "IDASetUserData");
  check(IDAWFtolerances(memory, &Sundials::weights), "IDAWFtolerances");
  writable(scratch).setOnes();
  writable(scratch).tail(layout.row_count).setZero();
  check(IDASetId(memory, scratch), "IDASetId");
  check(IDASetSuppressAlg(memory, SUNTRUE), "IDASetSuppressAlg");
  check(IDASetLinearSolver(memory, solver, matrix), "IDASetLinearSolver");
  check(IDASetJacFn(memory, &Sundials::jacobian), "IDASetJacFn");
  newton = SUNNonlinSol_Newton(y, context);
  FOOTFALL_DEMAND(newton != nullptr);
  check(IDASetNonlinearSolver(memory, newton), "IDASetNonlinearSolver");
  check(SUNNonlinSolSetConvTestFn(newton, &Sundials::settled, this), "SUNNonlinSolSetConvTestFn");
  check(IDASetMinStep(memory, options.min_step), "IDASetMinStep");
  if (options.max_step > 0.0) check(IDASetMaxStep(memory, exact_limit(options.max_step)), "IDASetMaxStep");
  rates = Eigen::VectorXd::Zero(n);
}

Ida::Sundials::~Sundials() {
  IDAFree(&memory);
  SUNNonlinSolFree(newton);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  for (N_Vector x : {y, ydot, scratch, scratch2}) N_VDestroy(x);
  SUNContext_Free(&context);
}

void Ida::Sundials::check(int flag, const char* function) {
  if (fatal) std::rethrow_exception(std::exchange(fatal, nullptr));
  if (flag >= 0) return;
  char* name = IDAGetReturnFlagName(flag);
  const std::string what = std::string(function) + " returned " + name + "; ";
  std::free(name);
  give_up(what);
}

void Ida::Sundials::give_up(const std::string& what) {
  std::ostringstream out;
  out << "t = " << t << " s: " << what;
  if (!complaint.empty()) {
    out << complaint;
  } else {
    // The entry with the largest weighted local error is where it hurts.
    int worst = 0;
    if (IDAGetEstLocalErrors(memory, scratch) == IDA_SUCCESS && IDAGetErrWeights(memory, scratch2) == IDA_SUCCESS)
      view(scratch)
          .head(equations.layout().lambda0())
          .cwiseProduct(view(scratch2).head(equations.layout().lambda0()))
          .cwiseAbs()
          .maxCoeff(&worst);
    out << "what does not settle is " << equations.entry_name(worst) << ".";
  }
  throw NumericalError(out.str());
}

// SUNDIALS prints nothing itself: check() says it with the name of the body.
void Ida::Sundials::message(int, const char*, const char*, char*, void*) {}

template <typename Work>
int Ida::Sundials::guarded(Work work) {
  try {
    work();
    return 0;
  } catch (const NumericalError& error) {  // a law without a value: a smaller step may stay clear of it
    complaint = error.what();
    return 1;
  } catch (...) {  // no exception may pass through C
    fatal = std::current_exception();
    return -1;
  }
}

int Ida::Sundials::residual(realtype time, N_Vector y, N_Vector ydot, N_Vector F, void* self) {
  Sundials& s = *static_cast<Sundials*>(self);
  const int flag = s.guarded([&] { s.equations.residual(time, view(y), view(ydot), *s.inputs_now, writable(F)); });
  if (flag != 0) return flag;
  return view(F).allFinite() ? 0 : 1;
}

int Ida::Sundials::jacobian(realtype time, realtype c, N_Vector y, N_Vector ydot, N_Vector, SUNMatrix J, void* self,
                            N_Vector, N_Vector, N_Vector) {
  Sundials& s = *static_cast<Sundials*>(self);
  return s.guarded([&] {
    const Eigen::SparseMatrix<double>& values = s.equations.jacobian(time, view(y), view(ydot), c, *s.inputs_now);
    // The matrix is zeroed before each call, pattern included.
    std::copy_n(values.outerIndexPtr(), values.cols() + 1, SUNSparseMatrix_IndexPointers(J));
    std::copy_n(values.innerIndexPtr(), values.nonZeros(), SUNSparseMatrix_IndexValues(J));
    std::copy_n(values.valuePtr(), values.nonZeros(), SUNSparseMatrix_Data(J));
    ++s.jacobians;
    s.fresh = true;
  });
}

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
  const double wanted = std::max(kShareOfError * s.last_error, s.least_left) * tolerance;
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

void Ida::Sundials::restart(const State& state, const Inputs& inputs, IntegratorStatistics& statistics) {
  const Layout& layout = equations.layout();
  count(statistics);
  // Consistent start by our own solve: dq, dv, dz, and multipliers without a rate.
  equations.accelerations(state, inputs, rates);
  ++statistics.factorizations;
  equations.pack(state, rates.tail(layout.row_count), writable(y));
  writable(ydot) = rates;
  writable(ydot).tail(layout.row_count).setZero();
  check(IDAReInit(memory, state.time, y, ydot), "IDAReInit");
  std::fill(std::begin(counted), std::end(counted), 0L);
  t = state.time;
  last_error = 1.0;
}

// phi[0] is y_n, phi[j] are differences of y_n, y_(n-1), ...: with phi[0] alone all of them move.
bool Ida::Sundials::move_history(const State& state) {
  const Layout& layout = equations.layout();
  Eigen::Map<Eigen::VectorXd> newest = writable(static_cast<IDAMem>(memory)->ida_phi[0]);
  norm.set(newest);
  Eigen::Map<Eigen::VectorXd> moved = writable(scratch);
  moved.setZero();
  moved.head(layout.q_size) = state.q - newest.head(layout.q_size);
  moved.segment(layout.v0(), layout.v_size) = state.v - newest.segment(layout.v0(), layout.v_size);
  if (!(norm(moved) <= share)) return false;  // drift of a regular position is a part of the error of a step
  newest.head(layout.q_size) = state.q;
  newest.segment(layout.v0(), layout.v_size) = state.v;
  return true;
}

bool Ida::Sundials::step(double t_end, const Inputs& inputs, const Rows& rows, State& state,
                         IntegratorStatistics& statistics) {
  double from = t;
  complaint.clear();
  check(IDASolve(memory, t_end, &t, y, ydot, IDA_ONE_STEP), "IDASolve");
  const double error = step_error();
  statistics.told_error += error;
  last_error = error / share;
  for (; row_time < t; row_time = rows.after(row_time)) {
    add_work_between(from, row_time, inputs, state);
    from = row_time;
    check(IDAGetDky(memory, row_time, 0, scratch), "IDAGetDky");
    check(IDAGetDky(memory, row_time, 1, scratch2), "IDAGetDky");
    equations.unpack(view(scratch), state);
    state.time = row_time;
    rates = view(scratch2);
    rates.tail(equations.layout().row_count) = view(scratch).tail(equations.layout().row_count);
    row = state;
    statistics.count(options.projection ? equations.project(row) : equations.check_closed(row));
    equations.smallest_multipliers(row, rates.tail(equations.layout().row_count));
    if (rows.on_row(row, rates)) continue;
    state = row;
    return false;
  }
  add_work_between(from, t, inputs, state);
  equations.unpack(view(y), state);
  state.time = t;
  rates = view(ydot);
  rates.tail(equations.layout().row_count) = view(y).tail(equations.layout().row_count);
  return true;
}

// Root mean square over q, v and z.
double Ida::Sundials::step_error() {
  const int count = equations.layout().lambda0();
  if (count == 0) return 0.0;
  check(IDAGetEstLocalErrors(memory, scratch), "IDAGetEstLocalErrors");
  check(IDAGetErrWeights(memory, scratch2), "IDAGetErrWeights");
  return share * std::sqrt(view(scratch).head(count).cwiseProduct(view(scratch2).head(count)).squaredNorm() / count);
}

// Work integrals on IDA's own interpolant, within its last step.
void Ida::Sundials::add_work_between(double begin, double end, const Inputs& inputs, State& state) {
  const double half = 0.5 * (end - begin);
  for (int i = 0; i < 3; ++i) {
    const double node = begin + half * (1.0 + kGaussNode[i]);
    check(IDAGetDky(memory, node, 0, scratch), "IDAGetDky");
    equations.energy(node, view(scratch), inputs, energy);
    add_work(energy, half * kGaussWeight[i], state);
  }
}

void Ida::Sundials::count(IntegratorStatistics& statistics) {
  long now[5] = {0, 0, 0, 0, 0};
  check(IDAGetNumSteps(memory, &now[0]), "IDAGetNumSteps");
  check(IDAGetNumResEvals(memory, &now[1]), "IDAGetNumResEvals");
  check(IDAGetNumLinSolvSetups(memory, &now[2]), "IDAGetNumLinSolvSetups");
  check(IDAGetNumErrTestFails(memory, &now[3]), "IDAGetNumErrTestFails");
  check(IDAGetNumNonlinSolvConvFails(memory, &now[4]), "IDAGetNumNonlinSolvConvFails");
  statistics.steps += now[0] - counted[0];
  statistics.residuals += now[1] - counted[1];
  statistics.factorizations += now[2] - counted[2];
  statistics.rejected += now[3] - counted[3];
  statistics.newton_failures += now[4] - counted[4];
  statistics.jacobians = jacobians;
  std::copy(std::begin(now), std::end(now), std::begin(counted));
}

}  // namespace footfall
