#include "mbd_solver/integrator/ida.h"

#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/progress_watch.h"
#include "mbd_solver/integrator/work_integral.h"

namespace footfall {
namespace {

constexpr double kProjectAbove = 1e-9;       // drift [m or rad] that stays in a run that goes on
constexpr double kProjectSpeedAbove = 5e-9;  // [m/s or rad/s]
constexpr double kDriftKept = 100.0;         // drift that stays within a window [in absolute tolerances]
constexpr double kIgnored = 1e30;            // absolute tolerance of multipliers: they carry no error of their own
constexpr double kTold = 100.0;              // [tolerances] sum of the errors of all steps that a run warns of
constexpr int kRenewRest = 10;               // steps after which resting rows are looked at
// Gauss-Legendre with three points, exact to fifth order as IDA is.
const double kGaussNode[3] = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)};
constexpr double kGaussWeight[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

Eigen::Map<const Eigen::VectorXd> view(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }
Eigen::Map<Eigen::VectorXd> writable(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }

bool same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a.size() == b.size() && a == b; }

bool same(const ExternalLoad& a, const ExternalLoad& b) {
  if (a.F_W != b.F_W || a.T_B != b.T_B || !same(a.Q_a, b.Q_a) || a.tangent.has_value() != b.tangent.has_value())
    return false;
  return !a.tangent ||
         (a.tangent->K == b.tangent->K && a.tangent->C == b.tangent->C && a.tangent->r_mean == b.tangent->r_mean &&
          a.tangent->L_mean == b.tangent->L_mean && a.tangent->v_mean == b.tangent->v_mean);
}

bool same(const Inputs& a, const Inputs& b) {
  return same(a.voltages, b.voltages) && a.loads.size() == b.loads.size() &&
         std::equal(a.loads.begin(), a.loads.end(), b.loads.begin(),
                    [](const ExternalLoad& x, const ExternalLoad& y) { return same(x, y); });
}

}  // namespace

struct Ida::Sundials {
  Sundials(Equations& equations, const IntegratorOptions& options);
  ~Sundials();

  // Every return code of SUNDIALS goes through here.
  void check(int flag, const char* function);
  [[noreturn]] void give_up(const std::string& what);
  void restart(const State& state, const Inputs& inputs, IntegratorStatistics& statistics);
  // One step of IDA, with the rows in it; false: a row has ended the window, and state and rates are at it.
  bool step(double t_end, const Inputs& inputs, const Rows& rows, State& state, IntegratorStatistics& statistics);
  void add_work_between(double begin, double end, const Inputs& inputs, State& state);
  void count(IntegratorStatistics& statistics);
  double step_error();

  static int residual(realtype t, N_Vector y, N_Vector ydot, N_Vector F, void* self);
  static int jacobian(realtype t, realtype c, N_Vector y, N_Vector ydot, N_Vector F, SUNMatrix J, void* self, N_Vector,
                      N_Vector, N_Vector);
  static void message(int code, const char* module, const char* function, char* text, void* self);
  template <typename Work>
  int guarded(Work work);

  Equations& equations;
  IntegratorOptions options;
  SUNContext context = nullptr;
  void* memory = nullptr;
  N_Vector y = nullptr, ydot = nullptr, scratch = nullptr, scratch2 = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver solver = nullptr;
  const Inputs* inputs_now = nullptr;  // during one call of IDASolve
  Inputs inputs_last;
  State state_last;       // as returned; empty: start anew
  State row;              // projected, for the caller
  double row_time = 0.0;  // of the next row [s]
  double t = 0.0;
  Eigen::VectorXd rates;
  EnergySample energy;
  std::exception_ptr fatal;  // from inside a callback
  std::string complaint;
  long counted[5] = {0, 0, 0, 0, 0};  // steps, residuals, factorizations, rejected, failures: of the present start
  long jacobians = 0;
};

Ida::Sundials::Sundials(Equations& e, const IntegratorOptions& o) : equations(e), options(o) {
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
  writable(scratch).setConstant(kIgnored);
  writable(scratch).head(layout.lambda0()) = ErrorNorm(layout, options).absolute();
  check(IDASVtolerances(memory, options.rtol, scratch), "IDASVtolerances");
  writable(scratch).setOnes();
  writable(scratch).tail(layout.row_count).setZero();
  check(IDASetId(memory, scratch), "IDASetId");
  check(IDASetSuppressAlg(memory, SUNTRUE), "IDASetSuppressAlg");
  check(IDASetLinearSolver(memory, solver, matrix), "IDASetLinearSolver");
  check(IDASetJacFn(memory, &Sundials::jacobian), "IDASetJacFn");
  check(IDASetMinStep(memory, options.min_step), "IDASetMinStep");
  if (options.max_step > 0.0) check(IDASetMaxStep(memory, options.max_step), "IDASetMaxStep");
  rates = Eigen::VectorXd::Zero(n);
}

Ida::Sundials::~Sundials() {
  IDAFree(&memory);
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
  });
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
}

bool Ida::Sundials::step(double t_end, const Inputs& inputs, const Rows& rows, State& state,
                         IntegratorStatistics& statistics) {
  double from = t;
  complaint.clear();
  check(IDASolve(memory, t_end, &t, y, ydot, IDA_ONE_STEP), "IDASolve");
  statistics.summed_error += step_error();
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
    if (!rows.on_row(row, rates)) return false;
  }
  add_work_between(from, t, inputs, state);
  equations.unpack(view(y), state);
  state.time = t;
  rates = view(ydot);
  rates.tail(equations.layout().row_count) = view(y).tail(equations.layout().row_count);
  return true;
}

// The error of the last step, in tolerances: root mean square over q, v and z.
double Ida::Sundials::step_error() {
  const int count = equations.layout().lambda0();
  if (count == 0) return 0.0;
  check(IDAGetEstLocalErrors(memory, scratch), "IDAGetEstLocalErrors");
  check(IDAGetErrWeights(memory, scratch2), "IDAGetErrWeights");
  return std::sqrt(view(scratch).head(count).cwiseProduct(view(scratch2).head(count)).squaredNorm() / count);
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

Ida::Ida(Equations& equations, const IntegratorOptions& options)
    : ida_(std::make_unique<Sundials>(equations, options)) {}

Ida::~Ida() = default;

std::string Ida::warning() const {
  if (statistics_.summed_error <= kTold) return {};
  return "the errors of the " + std::to_string(statistics_.steps) + " steps of solver.integrator = \"ida\" add up to " +
         number_text(statistics_.summed_error, 2) +
         " times solver.rtol and solver.atol: the end may be off by as much. Compare with \"one_step\", which takes "
         "longer steps where parts are stiff, or make solver.rtol smaller";
}

const Eigen::VectorXd& Ida::end_rates() const { return ida_->rates; }

void Ida::forget() {
  ida_->state_last = {};
  ida_->equations.forget();
  ida_->check(SUNLinSol_KLUReInit(ida_->solver, ida_->matrix, SUNSparseMatrix_NNZ(ida_->matrix), SUNKLU_REINIT_PARTIAL),
              "SUNLinSol_KLUReInit");
}

void Ida::resume(const IntegratorStatistics& so_far) {
  forget();
  statistics_ = so_far;
  ida_->jacobians = so_far.jacobians;
}

void Ida::advance(State& state, double t_end, const Inputs& inputs, const Rows& rows) {
  Sundials& s = *ida_;
  FOOTFALL_DEMAND(t_end > state.time);
  s.inputs_now = &inputs;
  const bool goes_on = state.time == s.state_last.time && same(state.q, s.state_last.q) &&
                       same(state.v, s.state_last.v) && same(state.z, s.state_last.z) && same(inputs, s.inputs_last);
  if (!goes_on) s.restart(state, inputs, statistics_);
  s.row_time = rows.after(state.time);
  s.check(IDASetStopTime(s.memory, t_end), "IDASetStopTime");
  bool ended_by_row = false;
  Equations::Drift drift;
  int steps = 0;
  ProgressWatch watch(state.time, t_end);
  while (!ended_by_row && state.time < t_end) {
    ended_by_row = !s.step(t_end, inputs, rows, state, statistics_);
    if (++steps % kRenewRest == 0) s.equations.renew_rest(state);
    if (const std::string slow = watch.complaint(state.time); !slow.empty()) s.give_up(slow);
    drift = s.options.projection ? s.equations.drift(state) : s.equations.check_closed(state);
    // Each projection costs a start: IDA falls back to first order and a small step.
    if (ended_by_row || state.time >= t_end || !s.options.projection ||
        (drift.position < std::max(kProjectAbove, kDriftKept * s.options.atol) &&
         drift.velocity < std::max(kProjectSpeedAbove, kDriftKept * s.options.atol_velocity)))
      continue;
    statistics_.count(s.equations.project(state));
    s.restart(state, inputs, statistics_);
    s.check(IDASetStopTime(s.memory, t_end), "IDASetStopTime");
  }
  s.count(statistics_);
  ++statistics_.windows;

  s.state_last = ended_by_row ? State{} : state;
  s.inputs_last = inputs;
  if (s.options.projection && (drift.position > kProjectAbove || drift.velocity > kProjectSpeedAbove))
    drift = s.equations.project(state);
  statistics_.count(drift);
  if (!ended_by_row) s.equations.smallest_multipliers(state, s.rates.tail(s.equations.layout().row_count));
}

std::string sundials_version() {
  char version[64] = "unknown";
  SUNDIALSGetVersion(version, sizeof version);
  return version;
}

}  // namespace footfall
