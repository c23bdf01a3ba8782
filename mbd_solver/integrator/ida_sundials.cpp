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

// Share of the tolerances that one step may err by: a tenth, and where a tenth comes near the round-off of multipliers, from an
// rtol of 1e-9 on, what a step may err by falls as the root of rtol (a third at 1e-10).
constexpr double kStepShare = 0.1, kAllFrom = 1e-11;  // [-], [rtol] at which it is all
// Gauss-Legendre with three points, exact to fifth order as IDA is.
const double kGaussNode[3] = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)};
constexpr double kGaussWeight[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

// IDA raises its order only behind steps of one length, equal to the bit. At its limit H it takes h 2 / (2 h / H) for the
// next step: for most H (1e-4 is one) that swings between two numbers, one unit in the last place apart. The order then
// stays at one or two, and 50 000 errors of that order add up. With a power of two each division is exact.
double exact_limit(double max_step) { return std::exp2(std::floor(std::log2(max_step))); }

}  // namespace

Ida::Sundials::Sundials(Equations& e, const IntegratorOptions& o)
    : equations(e), options(o), norm(e.layout(), o), share(std::clamp(std::sqrt(kAllFrom / o.rtol), kStepShare, 1.0)) {
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
  const int flag = s.guarded([&] {
    s.equations.residual(time, view(y), view(ydot), *s.inputs_now, writable(F));
    const int rows = s.equations.layout().row_count;
    s.equations.expect_multipliers(view(static_cast<IDAMem>(s.memory)->ida_yypredict).tail(rows),
                                   writable(F).tail(rows));
  });
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

void Ida::Sundials::restart(const State& state, const Inputs& inputs, IntegratorStatistics& statistics) {
  const Layout& layout = equations.layout();
  count(statistics);
  // Consistent start by our own solve: dq, dv, dz, and multipliers without a rate.
  equations.stage_rates(state, inputs, rates);
  ++statistics.factorizations;
  equations.pack(state, rates.tail(layout.row_count), writable(y));
  writable(ydot) = rates;
  writable(ydot).tail(layout.row_count).setZero();
  check(IDAReInit(memory, state.time, y, ydot), "IDAReInit");
  std::fill(std::begin(counted), std::end(counted), 0L);
  t = state.time;
  last_error = 1.0;
}

void Ida::Sundials::aim(double t_end, const Rows& rows, const State& state) {
  row_time = rows.after(state.time);
  check(IDASetStopTime(memory, t_end), "IDASetStopTime");
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
