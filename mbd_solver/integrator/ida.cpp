// The only file that includes SUNDIALS. IDA is called one step at a time, with our own convergence test of Newton,
// projection of its history, and passage of singular positions by OneStep.

#include "mbd_solver/integrator/ida.h"

#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_version.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/dynamics/turn_follower.h"
#include "mbd_solver/integrator/codes.h"
#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/one_step.h"
#include "mbd_solver/integrator/reduced_system.h"
#include "mbd_solver/integrator/singular_position.h"
#include "mbd_solver/integrator/step_control.h"

namespace footfall {
namespace {

// Functions with other names in releases 6 and 7. SUNDIALS prints nothing itself: check() reports an error with the body's name.
#if SUNDIALS_VERSION_MAJOR >= 7
const SUNComm kNoCommunicator = SUN_COMM_NULL;
constexpr int kConverged = SUN_SUCCESS, kOtherFailure = SUN_ERR_EXT_FAIL;
constexpr const char* kSilence = "SUNContext_ClearErrHandlers";
int silence(SUNContext context, void*) { return SUNContext_ClearErrHandlers(context); }
#else
void* const kNoCommunicator = nullptr;
constexpr int kConverged = SUN_NLS_SUCCESS, kOtherFailure = SUN_NLS_EXT_FAIL;
constexpr const char* kSilence = "IDASetErrHandlerFn";
void print_nothing(int, const char*, const char*, char*, void*) {}
int silence(SUNContext, void* memory) { return IDASetErrHandlerFn(memory, &print_nothing, nullptr); }
#endif

}  // namespace

struct Ida::Sundials {
  class View;
  // The window that is open, with the last step in it.
  struct Window {
    enum Phase { kTrying, kPassing, kInRows, kAtRow, kAtEnd };
    Phase phase = kTrying;
    State* state = nullptr;
    double t_end = 0.0;  // [s]
    const Inputs* inputs = nullptr;
    WindowStops stops;
    ProgressWatch watch{0.0, 0.0};
    bool starts = false;  // IDA must restart
    bool ended = false;   // at a row or step
    Drift drift;          // at the last time
    int steps = 0;
    double step_begin = 0.0, from = 0.0;  // of the step; until here its work is added [s]
    double change = 0.0;                  // when a mode changes in it; HUGE_VAL: none
    double row_time = 0.0;                // of the next row [s]
    IntegratorStatistics before_pass;
    double pass_goal = 0.0;  // [s]
  };
  Sundials(Equations& equations, const IntegratorOptions& options);
  ~Sundials();

  // The numbers of a vector.
  static Eigen::Map<const Eigen::VectorXd> view(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }
  static Eigen::Map<Eigen::VectorXd> writable(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }

  // Every return code of SUNDIALS goes through here.
  void check(int flag, const char* function);
  [[noreturn]] void give_up(const MessageCode& code, const std::string& what);
  void restart(const State& state, double t_end, const Inputs& inputs, IntegratorStatistics& statistics);
  double first_step(double window, const Eigen::VectorXd& later);  // [s]
  void aim();                                                      // sets the stop time of IDA and its next row
  // Moves all values of the history by the displacement of the newest to the projected `state`. False: the displacement is large,
  // a singular position is near; nothing moves, and IDA must restart.
  bool move_history(const State& state);
  const Eigen::VectorXd& y_of(N_Vector unknowns) { return actual = view(unknowns) + offset; }
  void interpolate(double time, N_Vector out);        // y at a time [s] within the last step
  N_Vector predicted();                               // unknowns at the start of Newton's iteration
  void solve_step(IntegratorStatistics& statistics);  // one step of IDA
  WindowStop read_row(IntegratorStatistics& statistics);
  void reach_end();                                    // of the step, or where a mode changes in it
  void finish_step(IntegratorStatistics& statistics);  // at its end, or at a row that ended the window
  void finish_window(IntegratorStatistics& statistics);
  void add_work_between(double begin, double end, const Inputs& inputs, State& state);
  // In the last step, between two times [s]: when a mode changes (like OneStep); infinity: it does not.
  double time_of_switch(double begin, double end, const Inputs& inputs);
  void count(IntegratorStatistics& statistics);
  double step_error();                  // of the last step, in tolerances of the scene
  double carried();                     // share of such an error that all later steps carry on
  void look_ahead(const State& state);  // after a step: sets passage_end if a singular position comes near
  // OneStep from the present time to passage_end or the end of the window.
  void begin_pass(IntegratorStatistics& statistics);
  void end_pass(IntegratorStatistics& statistics);
  void begin_passage(double end);
  void forget_passage();

  static int residual(sunrealtype t, N_Vector unknowns, N_Vector ydot, N_Vector F, void* self);
  static int jacobian(sunrealtype t, sunrealtype c, N_Vector unknowns, N_Vector ydot, N_Vector F, SUNMatrix, void* self,
                      N_Vector, N_Vector, N_Vector);
  static int factor(SUNLinearSolver solver, SUNMatrix);
  static int solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector r, sunrealtype);
  static int converged(SUNNonlinearSolver newton, N_Vector, N_Vector change, sunrealtype tolerance, N_Vector weight,
                       void* self);
  static int weights(N_Vector unknowns, N_Vector weight, void* self);
  template <typename Work>
  int guarded(Work work);

  Equations& equations;
  IntegratorOptions options;
  ErrorNorm norm;  // of the scene's tolerances
  double share;    // of them, the error limit of one step
  SUNContext context = nullptr;
  void* memory = nullptr;
  N_Vector y = nullptr, ydot = nullptr, scratch = nullptr, scratch2 = nullptr;
  // The unknowns of IDA are y - offset: a change of the offset moves all values of its history.
  Eigen::VectorXd offset;      // by which projections have moved q and v since the last restart [m, rad, m/s, rad/s]
  Eigen::VectorXd actual;      // of y_of
  ReducedSystem linear;        // Newton's
  SUNMatrix matrix = nullptr;  // without numbers: `linear` has them
  SUNLinearSolver solver = nullptr;
  SUNNonlinearSolver newton = nullptr;
  bool fresh = false;                  // the Jacobian belongs to the current step
  bool switched = false;               // a mode changed at the end of the last step
  double reaction_tolerance = 1.0;     // of multipliers in Newton's iteration [N, N m]
  double last_error = 1.0;             // of the last step [tolerances of a step]
  bool close = false;                  // Newton's last correction was within the tolerance
  double first_change = 0.0;           // of Newton's iteration in this step [tolerances]
  const Inputs* inputs_now = nullptr;  // during one call of IDASolve
  Inputs inputs_last;
  State state_last;  // as returned; empty: restart
  State row;         // projected, for the caller
  double t = 0.0;
  Eigen::VectorXd rates;
  TurnFollower turns;
  TurnFollower::Motion turning;  // at the last state that was returned
  EnergySample energy;
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  double passage_end = kNever;  // OneStep continues up to this time [s]
  Window window;
  std::unique_ptr<View> step_view;
  std::unique_ptr<OneStep> one_step;  // created when the first singular position comes near
  std::array<Nearness, 3> seen;       // the last measurements
  int looks = 0, steps_since_look = 0;
  double highest = kNever;   // largest log determinant of the run
  std::exception_ptr fatal;  // from inside a callback
  std::string reason;
  long counted[5] = {0, 0, 0, 0, 0};  // steps, residuals, factorizations, rejected, failures: since the last restart
  long jacobians = 0;
};

// Between the ends of the last step of IDA, by its own interpolation.
class Ida::Sundials::View : public StepView {
 public:
  explicit View(Sundials& ida) : ida_(ida) {}
  double begin() const override { return ida_.window.step_begin; }
  double end() const override { return ida_.window.state->time; }
  void at(double time, State& state, Eigen::VectorXd& derivative) override {
    state = *ida_.window.state;
    derivative = ida_.rates;
    if (time >= end()) return;
    ida_.interpolate(time, ida_.scratch);
    ida_.check(IDAGetDky(ida_.memory, time, 1, ida_.scratch2), "IDAGetDky");
    ida_.equations.layout().unpack(view(ida_.scratch), state);
    state.time = time;
    derivative = view(ida_.scratch2);
    derivative.tail(ida_.equations.layout().row_count) = view(ida_.scratch).tail(ida_.equations.layout().row_count);
  }

 private:
  Sundials& ida_;
};

namespace {

constexpr double kNoOffset = -0.0;  // x + -0.0 is x, even if x is a zero with a sign

// Error limit of one step as a share of the tolerances: a tenth; from an rtol of 1e-9 on, where a tenth comes near the round-off
// of multipliers, the limit falls with the root of rtol (a third at 1e-10).
constexpr double kStepShare = 0.1, kAllFrom = 1e-11;      // [-], [rtol] at which the share is 1
constexpr double kStartShare = 1e-3, kStartError = 1e-6;  // [windows], [tolerances of a step]
// Gauss-Legendre with three points, exact to fifth order like IDA.
const double kGaussNode[3] = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)};
constexpr double kGaussWeight[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
const double kTwoNodes = std::sqrt(1.0 / 3.0);  // of the embedded rule, with two points, for the error of work

// IDA raises its order only after steps of exactly equal length. At its limit H the next step is h 2 / (2 h / H), which for most
// H (1e-4 is one) alternates between two numbers one unit in the last place apart. The order then stays at one or two, and
// 50 000 errors of that order accumulate. With a power of two each division is exact.
double exact_limit(double max_step) { return std::exp2(std::floor(std::log2(max_step))); }

}  // namespace

Ida::Sundials::Sundials(Equations& e, const IntegratorOptions& o)
    : equations(e),
      options(o),
      norm(e.layout(), o),
      share(std::clamp(std::sqrt(kAllFrom / o.rtol), kStepShare, 1.0)),
      linear(e, e.jacobian().negligible_shares().cwiseMin(ThinLu::kRoundOff)),
      turns(e.model(), e.layout()) {
  const Layout& layout = equations.layout();
  const int n = layout.size();
  if (SUNContext_Create(kNoCommunicator, &context) != 0)
    throw NumericalError(code::kSundials, "SUNContext_Create failed.");
  y = N_VNew_Serial(n, context);
  ydot = N_VNew_Serial(n, context);
  scratch = N_VNew_Serial(n, context);
  scratch2 = N_VNew_Serial(n, context);
  matrix = SUNMatNewEmpty(context);
  solver = SUNLinSolNewEmpty(context);
  memory = IDACreate(context);
  FOOTFALL_DEMAND(y != nullptr && ydot != nullptr && scratch != nullptr && scratch2 != nullptr && matrix != nullptr &&
                  solver != nullptr && memory != nullptr);
  matrix->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  matrix->ops->zero = [](SUNMatrix) { return 0; };
  solver->content = this;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  solver->ops->setup = &Sundials::factor;
  solver->ops->solve = &Sundials::solve;

  writable(y).setZero();
  writable(ydot).setZero();
  check(IDAInit(memory, &Sundials::residual, 0.0, y, ydot), "IDAInit");
  check(silence(context, memory), kSilence);
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
  check(SUNNonlinSolSetConvTestFn(newton, &Sundials::converged, this), "SUNNonlinSolSetConvTestFn");
  check(IDASetMinStep(memory, options.min_step), "IDASetMinStep");
  if (options.max_step > 0.0) check(IDASetMaxStep(memory, exact_limit(options.max_step)), "IDASetMaxStep");
  step_view = std::make_unique<View>(*this);
  rates = Eigen::VectorXd::Zero(n);
  offset = Eigen::VectorXd::Constant(n, kNoOffset);
}

Ida::Sundials::~Sundials() {
  IDAFree(&memory);
  SUNNonlinSolFree(newton);
  SUNLinSolFreeEmpty(solver);
  SUNMatFreeEmpty(matrix);
  for (N_Vector x : {y, ydot, scratch, scratch2}) N_VDestroy(x);
  SUNContext_Free(&context);
}

void Ida::Sundials::check(int flag, const char* function) {
  if (fatal) std::rethrow_exception(std::exchange(fatal, nullptr));
  if (flag >= 0) return;
  char* text = IDAGetReturnFlagName(flag);
  std::string name = text;
  std::free(text);
  if (name == "NONE") name = std::to_string(flag);  // of another part of SUNDIALS
  give_up(code::kSundials, std::string(function) + " returned " + name + "; ");
}

// A reason from below ends with its own code; else the entry with the largest weighted local error is named.
void Ida::Sundials::give_up(const MessageCode& code, const std::string& what) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << "t = " << t << " s: " << what;
  if (!reason.empty()) throw NumericalError(out.str() + reason);
  int worst = 0;
  if (IDAGetEstLocalErrors(memory, scratch) == IDA_SUCCESS && IDAGetErrWeights(memory, scratch2) == IDA_SUCCESS)
    view(scratch)
        .head(equations.layout().lambda0())
        .cwiseProduct(view(scratch2).head(equations.layout().lambda0()))
        .cwiseAbs()
        .maxCoeff(&worst);
  out << "the largest error is in " << equations.entry_name(worst) << ".";
  throw NumericalError(code, out.str());
}

template <typename Work>
int Ida::Sundials::guarded(Work work) {
  try {
    work();
    return 0;
  } catch (const NumericalError& error) {  // a law without a value, which a smaller step may avoid
    reason = error.what();
    return 1;
  } catch (...) {  // exceptions must not pass through C
    fatal = std::current_exception();
    return -1;
  }
}

int Ida::Sundials::residual(sunrealtype time, N_Vector unknowns, N_Vector ydot, N_Vector F, void* self) {
  Sundials& s = *static_cast<Sundials*>(self);
  const int flag = s.guarded([&] {
    s.equations.residual(time, s.y_of(unknowns), view(ydot), *s.inputs_now, writable(F));
    const int rows = s.equations.layout().row_count;
    s.equations.saddle().expect_multipliers(view(s.predicted()).tail(rows), writable(F).tail(rows));
  });
  if (flag != 0) return flag;
  return view(F).allFinite() ? 0 : 1;
}

int Ida::Sundials::jacobian(sunrealtype time, sunrealtype c, N_Vector unknowns, N_Vector ydot, N_Vector, SUNMatrix,
                            void* self, N_Vector, N_Vector, N_Vector) {
  Sundials& s = *static_cast<Sundials*>(self);
  return s.guarded([&] {
    s.linear.evaluate(time, s.y_of(unknowns), view(ydot), c, *s.inputs_now);
    ++s.jacobians;
    s.fresh = true;
  });
}

// A singular matrix is a reason for a smaller step.
int Ida::Sundials::factor(SUNLinearSolver solver, SUNMatrix) {
  return static_cast<Sundials*>(solver->content)->linear.factor() ? 0 : 1;
}

int Ida::Sundials::solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector r, sunrealtype) {
  writable(x) = view(r);
  static_cast<Sundials*>(solver->content)->linear.solve_whole(writable(x));
  return 0;
}

void Ida::Sundials::restart(const State& state, double t_end, const Inputs& inputs, IntegratorStatistics& statistics) {
  const Layout& layout = equations.layout();
  count(statistics);
  // Consistent start by our own solve: dq, dv, dz; multipliers have no rate.
  Eigen::VectorXd later;
  if (inputs.loads.empty()) {  // with grains windows are short
    State shifted = state;
    shifted.time += kStartShare * (t_end - state.time);
    later.setZero(rates.size());
    equations.saddle().stage_rates(shifted, inputs, later);
  }
  equations.saddle().stage_rates(state, inputs, rates);
  ++statistics.factorizations;
  equations.layout().pack(state, rates.tail(layout.row_count), writable(y));
  writable(ydot) = rates;
  writable(ydot).tail(layout.row_count).setZero();
  offset.setConstant(kNoOffset);
  check(IDAReInit(memory, state.time, y, ydot), "IDAReInit");
  check(IDASetInitStep(memory, first_step(t_end - state.time, later)), "IDASetInitStep");
  std::fill(std::begin(counted), std::end(counted), 0L);
  turns.measure(state, rates, turning);
  t = state.time;
  last_error = 1.0;
}

// IDA's own choice, a thousandth of the window in which no number changes by more than half a tolerance; and the first two steps,
// of first order, lose less of given functions of time than kStartError:
//   error = h^2 y'' / 2,   y'' of time alone, from the rates of the same state `later`; empty: no such functions
double Ida::Sundials::first_step(double window, const Eigen::VectorXd& later) {
  norm.set(view(y));
  double h = std::min(kStartShare * window, 0.5 * share / std::max(norm(rates), 1e-300));
  if (later.size() > 0) {
    const double bend = norm(later - rates) / (kStartShare * window);  // [tolerances / s2]
    if (bend > 0.0) h = std::min(h, std::sqrt(2.0 * kStartError * share / bend));
  }
  return std::min(std::max(h, options.min_step), window);
}

void Ida::Sundials::aim() {
  window.row_time = window.stops.row_after(window.state->time);
  check(IDASetStopTime(memory, window.t_end), "IDASetStopTime");
}

// The newest y becomes y of `state`, to the last bit: differences of two numbers that are nearly equal are exact.
bool Ida::Sundials::move_history(const State& state) {
  const Layout& layout = equations.layout();
  double newest = 0.0;
  check(IDAGetCurrentTime(memory, &newest), "IDAGetCurrentTime");
  check(IDAGetDky(memory, newest, 0, scratch), "IDAGetDky");
  norm.set(y_of(scratch));
  const Eigen::VectorXd before = offset;
  offset.head(layout.q_size) = state.q - view(scratch).head(layout.q_size);
  offset.segment(layout.v0(), layout.v_size) = state.v - view(scratch).segment(layout.v0(), layout.v_size);
  if (norm(offset - before) <= share) return true;
  offset = before;  // in regular positions drift is a part of the error of a step
  return false;
}

void Ida::Sundials::interpolate(double time, N_Vector out) {
  check(IDAGetDky(memory, time, 0, out), "IDAGetDky");
  writable(out) += offset;
}

N_Vector Ida::Sundials::predicted() {
  double time = 0.0, factor = 0.0;
  N_Vector y_predicted = nullptr, unused = nullptr;
  void* self = nullptr;
  check(IDAGetNonlinearSystemData(memory, &time, &y_predicted, &unused, &unused, &unused, &unused, &factor, &self),
        "IDAGetNonlinearSystemData");
  return y_predicted;
}

void Ida::Sundials::solve_step(IntegratorStatistics& statistics) {
  window.step_begin = window.from = t;
  reason.clear();
  check(IDASolve(memory, window.t_end, &t, y, ydot, IDA_ONE_STEP), "IDASolve");
  writable(y) += offset;
  const double error = step_error();
  statistics.reported_error += error;
  statistics.summed_error += error * carried();
  last_error = error / share;
  window.change = equations.has_modes() ? time_of_switch(window.from, t, *window.inputs) : HUGE_VAL;
}

WindowStop Ida::Sundials::read_row(IntegratorStatistics& statistics) {
  State& state = *window.state;
  const double time = window.row_time;
  add_work_between(window.from, time, *window.inputs, state);
  window.from = time;
  interpolate(time, scratch);
  check(IDAGetDky(memory, time, 1, scratch2), "IDAGetDky");
  equations.layout().unpack(view(scratch), state);
  state.time = time;
  rates = view(scratch2);
  rates.tail(equations.layout().row_count) = view(scratch).tail(equations.layout().row_count);
  row = state;
  statistics.count(options.projection ? equations.saddle().project(row) : equations.saddle().check_closed(row));
  equations.saddle().smallest_multipliers(row, rates.tail(equations.layout().row_count));
  turns.follow(turning, rates, row, &turning);
  state.angles = row.angles;
  state.uncertain_angle = row.uncertain_angle;
  return {WindowStop::kRow, &row, &rates, nullptr};
}

void Ida::Sundials::reach_end() {
  State& state = *window.state;
  const double end = std::min(t, window.change);
  add_work_between(window.from, end, *window.inputs, state);
  switched = window.change < HUGE_VAL;
  if (switched) {
    check(IDAGetDky(memory, end, 1, ydot), "IDAGetDky");
    interpolate(end, y);
  }
  equations.layout().unpack(view(y), state);
  state.time = t = end;
  rates = view(ydot);
  rates.tail(equations.layout().row_count) = view(y).tail(equations.layout().row_count);
  turns.follow(turning, rates, state, &turning);
}

double Ida::Sundials::time_of_switch(double begin, double end, const Inputs& inputs) {
  const auto fits = [&](double time) {
    interpolate(time, scratch);
    equations.layout().unpack(view(scratch), row);
    row.time = time;
    return equations.mode_value(row, inputs) >= 0.0;
  };
  if (fits(end)) return HUGE_VAL;
  for (double middle = 0.5 * (begin + end); middle > begin && middle < end; middle = 0.5 * (begin + end))
    (fits(middle) ? begin : end) = middle;
  return end;
}

// Root mean square over q, v and z.
double Ida::Sundials::step_error() {
  const int count = equations.layout().lambda0();
  if (count == 0) return 0.0;
  check(IDAGetEstLocalErrors(memory, scratch), "IDAGetEstLocalErrors");
  check(IDAGetErrWeights(memory, scratch2), "IDAGetErrWeights");
  return share * std::sqrt(view(scratch).head(count).cwiseProduct(view(scratch2).head(count)).squaredNorm() / count);
}

// y(n) is made of several values before it, so that an error e of one of them moves those that follow by e / beta,
// 1 / beta = 1 + 1/2 + ... + 1/k for order k:  e = 1, rho(x) = (x - 1) rho'(1) + ..., rho'(1) = beta  [BDF with leading 1]
double Ida::Sundials::carried() {
  int order = 1;
  check(IDAGetLastOrder(memory, &order), "IDAGetLastOrder");
  double sum = 0.0;
  for (int j = 1; j <= order; ++j) sum += 1.0 / j;
  return sum;
}

// Work integrals on IDA's own interpolant, within its last step.
void Ida::Sundials::add_work_between(double begin, double end, const Inputs& inputs, State& state) {
  const double half = 0.5 * (end - begin);
  WorkError error;
  error.load_work.setZero(state.load_work.size());
  const auto sample = [&](double place) -> const EnergySample& {
    const double node = begin + half * (1.0 + place);
    interpolate(node, scratch);
    equations.powers(node, view(scratch), inputs, energy);
    return energy;
  };
  for (int i = 0; i < 3; ++i) {
    const EnergySample& at = sample(kGaussNode[i]);
    add_work(at, half * kGaussWeight[i], state);
    add_work_error(at, half * kGaussWeight[i], error);
    error.scale += half * kGaussWeight[i] * size_of_powers(at);
  }
  for (const double place : {-kTwoNodes, kTwoNodes}) add_work_error(sample(place), -half, error);
  add_step_error(error, state.work_error);
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

namespace {

constexpr double kProjectAbove = 1e-9;       // drift that remains between continued windows [m or rad]
constexpr double kProjectSpeedAbove = 5e-9;  // [m/s or rad/s]
// Drift that remains within a window [in absolute tolerances of a step], at least round-off. At a distance s from a position
// where conditions become dependent, loops open by d cause multipliers of d / s^2: larger drift changes the motion there, and no
// step is short enough for these multipliers.
constexpr double kRemainingDrift = 0.1;
constexpr double kLeastDrift = 1e-12, kLeastSpeedDrift = 1e-11;  // [m or rad], [m/s or rad/s]
// Sum of the errors of all steps [tolerances] beyond which a run warns; the motion may amplify them ten times.
constexpr double kReported = 10.0;
constexpr int kRestInterval = 10;  // steps between checks of resting rows
// Windows between corners that are nearly one are too short for IDA to start in: OneStep passes them.
constexpr double kShortest = 10.0, kTimeRoundOff = 1e-15;  // [smallest steps], of the time

bool same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a.size() == b.size() && a == b; }

bool same(const ExternalLoad& a, const ExternalLoad& b) {
  if (a.F_W != b.F_W || a.T_B != b.T_B || !same(a.Q_a, b.Q_a) || a.tangent.has_value() != b.tangent.has_value())
    return false;
  return !a.tangent ||
         (a.tangent->K == b.tangent->K && a.tangent->C == b.tangent->C && a.tangent->r_mean == b.tangent->r_mean &&
          a.tangent->L_mean == b.tangent->L_mean && a.tangent->v_mean == b.tangent->v_mean);
}

bool same(const Inputs& a, const Inputs& b) {
  return same(a.values, b.values) && a.loads.size() == b.loads.size() &&
         std::equal(a.loads.begin(), a.loads.end(), b.loads.begin(),
                    [](const ExternalLoad& x, const ExternalLoad& y) { return same(x, y); });
}

}  // namespace

Ida::Ida(Equations& equations, const IntegratorOptions& options)
    : ida_(std::make_unique<Sundials>(equations, options)) {}

Ida::~Ida() = default;

std::string Ida::warning() const {
  if (statistics_.reported_error <= kReported) return {};
  return with_code(
      code::kErrorsAccumulated,
      "the errors of " + std::to_string(statistics_.steps) + " steps of solver.integrator = \"ida\" add up to " +
          number_text(statistics_.reported_error, 2) +
          " times solver.rtol and solver.atol, and so may the error at the end. Compare with \"one_step\", "
          "which takes longer steps for stiff parts, or reduce solver.rtol");
}

const Eigen::VectorXd& Ida::end_rates() const { return ida_->rates; }

void Ida::forget() {
  ida_->state_last = {};
  ida_->forget_passage();
  ida_->equations.saddle().forget();
  ida_->linear.forget();
}

void Ida::resume(const IntegratorStatistics& so_far) {
  IntegratorStatistics abandoned;  // of a window that has not been finished
  ida_->count(abandoned);
  forget();
  statistics_ = so_far;
  ida_->jacobians = so_far.jacobians;
}

void Ida::begin(State& state, double t_end, const Inputs& inputs, const WindowStops& stops) {
  Sundials& s = *ida_;
  FOOTFALL_DEMAND(t_end > state.time);
  s.equations.recall(state);
  s.equations.switch_modes(inputs, state);
  s.inputs_now = &inputs;
  const bool continues = state.time == s.state_last.time && same(state.q, s.state_last.q) &&
                         same(state.v, s.state_last.v) && same(state.z, s.state_last.z) && same(inputs, s.inputs_last);
  s.window = {};
  s.window.state = &state;
  s.window.t_end = t_end;
  s.window.inputs = &inputs;
  s.window.stops = stops;
  s.window.watch = ProgressWatch(state.time, t_end);
  s.window.starts = !continues;
  if (continues) s.aim();
  if (t_end - state.time < kShortest * std::max(s.options.min_step, kTimeRoundOff * t_end)) s.begin_passage(t_end);
}

void Ida::end_window() {
  Sundials& s = *ida_;
  if (s.window.phase == Sundials::Window::kPassing) {
    s.one_step->end_window();
  } else {
    s.window.ended = true;
  }
}

WindowStop Ida::next() {
  using Window = Sundials::Window;
  Sundials& s = *ida_;
  Window& w = s.window;
  FOOTFALL_DEMAND(w.state != nullptr);
  for (;;) switch (w.phase) {
      case Window::kTrying:
        if (w.ended || !(w.state->time < w.t_end)) {
          s.finish_window(statistics_);
          return {};
        }
        if (w.state->time < s.passage_end) {
          s.begin_pass(statistics_);
          w.phase = Window::kPassing;
          break;
        }
        if (w.starts) {
          s.restart(*w.state, w.t_end, *w.inputs, statistics_);
          s.aim();
          w.starts = false;
        }
        s.solve_step(statistics_);
        w.phase = Window::kInRows;
        break;
      case Window::kPassing: {
        const WindowStop stop = s.one_step->next();
        if (stop.kind != WindowStop::kEnd) return stop;
        s.end_pass(statistics_);
        w.phase = Window::kTrying;
        break;
      }
      case Window::kInRows:
        if (w.row_time < std::min(s.t, w.change)) {
          w.phase = Window::kAtRow;
          return s.read_row(statistics_);
        }
        s.reach_end();
        w.phase = Window::kAtEnd;
        if (w.stops.steps) return {WindowStop::kStep, nullptr, nullptr, s.step_view.get()};
        break;
      case Window::kAtRow:
        if (w.ended) {
          *w.state = s.row;
          s.finish_step(statistics_);
        } else {
          w.row_time = w.stops.row_after(w.row_time);
          w.phase = Window::kInRows;
        }
        break;
      case Window::kAtEnd:
        if (s.switched) s.equations.switch_modes(*w.inputs, *w.state);
        s.finish_step(statistics_);
        break;
    }
}

void Ida::Sundials::finish_step(IntegratorStatistics& statistics) {
  State& state = *window.state;
  const double largest_position = std::max(kLeastDrift, kRemainingDrift * share * options.atol);
  const double largest_velocity = std::max(kLeastSpeedDrift, kRemainingDrift * share * options.atol_velocity);
  window.phase = Window::kTrying;
  equations.remember(*window.inputs, state);
  if (++window.steps % kRestInterval == 0) equations.saddle().update_resting_rows(state);
  if (const std::string slow = window.watch.check(state.time); !slow.empty()) give_up(code::kNoProgress, slow);
  const bool last = window.ended || state.time >= window.t_end;
  if (std::exchange(switched, false)) {  // a new initial value problem
    statistics.count(options.projection ? equations.saddle().project(state, SaddleSystem::Close::kFully)
                                        : equations.saddle().check_closed(state));
    window.drift = {};
    window.starts = true;
    if (last) equations.saddle().stage_rates(state, *window.inputs, rates);
    return;
  }
  window.drift = options.projection ? equations.saddle().drift(state) : equations.saddle().check_closed(state);
  if (!window.ended) look_ahead(state);
  if (last || !options.projection ||
      (window.drift.position < largest_position && window.drift.velocity < largest_velocity))
    return;
  statistics.count(equations.saddle().project(state, SaddleSystem::Close::kFully));
  if (move_history(state)) return;
  equations.saddle().forget();  // the motion must not depend on pivots of other positions
  equations.saddle().project(state, SaddleSystem::Close::kFully);
  window.starts = true;
}

void Ida::Sundials::finish_window(IntegratorStatistics& statistics) {
  State& state = *window.state;
  Drift& drift = window.drift;
  count(statistics);
  ++statistics.windows;
  bool continues_next = !window.ended && !window.starts;
  if (options.projection && (drift.position > kProjectAbove || drift.velocity > kProjectSpeedAbove)) {
    drift = equations.saddle().project(state);
    continues_next = continues_next && move_history(state);
  }
  state_last = continues_next ? state : State{};
  inputs_last = *window.inputs;
  statistics.count(drift);
  if (!window.ended) equations.saddle().smallest_multipliers(state, rates.tail(equations.layout().row_count));
  window.state = nullptr;
}

std::string sundials_version() {
  char version[64] = "unknown";
  SUNDIALSGetVersion(version, sizeof version);
  return version;
}

// --- Convergence of Newton's iteration in a step: by its remaining error relative to the error of the step, and by multipliers.

namespace {

constexpr double kIgnored = 1e-30;  // weight of multipliers, which have no error test
// Multipliers must converge nevertheless: each step extrapolates multipliers of earlier steps, which amplifies
// errors, and a small step does not detect them in v. Relative to the largest multiplier.
constexpr double kReactions = 100.0, kLeastReactions = 1e-9;  // [rtol]; [-], round-off
constexpr double kNoReaction = 1e-3;                          // lower bound of the largest multiplier [N, N m]
constexpr int kMostForReactions = 3;                          // iterations before multipliers require a new Jacobian
// IDA reuses a Jacobian while its c is within a factor 5/3, and scales corrections by 2 / (1 + ratio of c): a quarter of a
// multiplier's error may remain after a first correction. Newton fails if more than kSlowest remains (as in IDA).
constexpr double kFirstRate = 0.25, kSlowest = 0.9;
constexpr double kShareOfError = 0.1;                   // of a step's error, limit of Newton's remaining error
constexpr double kStalled = 0.5, kNewtonNoise = 3e-13;  // slower convergence below the second limit is round-off
constexpr int kMostForError = 2;                        // iterations that only this limit requires

}  // namespace

// The remaining error after a correction is correction x rate / (1 - rate). IDA's own test uses the rate of an earlier step for
// the first correction, however small it was: after multipliers converged with a second correction of 1e-13, it accepted any
// first correction of later steps. IDA also allows Newton a third of the error limit of a step, even if steps have far smaller
// errors (short max_step): their differences then contain Newton's errors, IDA lowers its order, and errors of many steps of low
// order accumulate. Here Newton's remaining error is at most a tenth of the last step's error, or round-off.
int Ida::Sundials::converged(SUNNonlinearSolver newton, N_Vector, N_Vector change, sunrealtype tolerance,
                             N_Vector weight, void* self) {
  Sundials& s = *static_cast<Sundials*>(self);
  const double size = N_VWrmsNorm(change, weight);
  const int rows = s.equations.layout().row_count;
  const double reactions = rows == 0 ? 0.0 : view(change).tail(rows).lpNorm<Eigen::Infinity>() / s.reaction_tolerance;
  int iteration = 0;
  if (SUNNonlinSolGetCurIter(newton, &iteration) != kConverged) return kOtherFailure;
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
  const double limit = std::max(kShareOfError * s.last_error, noise) * tolerance;
  if (size > 0.0 && !(left <= limit)) {
    if (iteration < kMostForError && !stalls) return SUN_NLS_CONTINUE;
    if (!s.fresh) return SUN_NLS_CONV_RECVR;
  }
  // Near a singular position multipliers do not converge even with the Jacobian of this step: then the motion alone counts.
  if (reactions > 1.0 && iteration + 1 < kMostForReactions) return SUN_NLS_CONTINUE;
  if (reactions > 1.0 && !s.fresh) return SUN_NLS_CONV_RECVR;
  s.fresh = false;
  return kConverged;
}

int Ida::Sundials::weights(N_Vector unknowns, N_Vector weight, void* self) {
  Sundials& s = *static_cast<Sundials*>(self);
  const int head = s.equations.layout().lambda0(), rows = s.equations.layout().row_count;
  const Eigen::VectorXd& now = s.y_of(unknowns);
  writable(weight).head(head) =
      (s.share * (s.options.rtol * now.head(head).cwiseAbs() + s.norm.absolute())).cwiseInverse();
  if (rows == 0) return 0;
  s.reaction_tolerance = std::max(kReactions * s.options.rtol, kLeastReactions) *
                         std::max(now.tail(rows).lpNorm<Eigen::Infinity>(), kNoReaction);
  writable(weight).tail(rows).setConstant(kIgnored);
  return now.allFinite() ? 0 : -1;
}

// --- Singular positions (singular_position.h, theory 2.4). A multistep method cannot skip a position: its steps shrink before
// it, each with an amplified error, and later steps depend on them. Therefore OneStep passes over it, and IDA restarts as far
// behind it as it stopped before.

namespace {

constexpr int kEvery = 4;       // steps between two measurements
constexpr double kFaded = 3.0;  // required fall of the log determinant: a fifth of a singular value is left
constexpr int kOrder = 5;

}  // namespace

// The determinant depends on positions alone: measurements may belong to different windows.
void Ida::Sundials::look_ahead(const State& state) {
  if (equations.layout().row_count == 0 || !options.projection || ++steps_since_look < kEvery) return;
  steps_since_look = 0;
  if (looks > 0 && !(state.time > seen.back().time)) looks = 0;
  seen = {seen[1], seen[2], Nearness{state.time, equations.saddle().log_determinant(state)}};
  highest = std::max(highest, seen.back().log_determinant);
  if (++looks < static_cast<int>(seen.size()) || seen.back().log_determinant > highest - kFaded) return;
  const double there = singular_time(seen);
  if (!std::isfinite(there)) return;
  begin_passage(there + (there - state.time));
}

void Ida::Sundials::begin_passage(double end) {
  passage_end = end;
  if (!one_step) {
    IntegratorOptions like = options;
    like.order = kOrder;
    one_step = std::make_unique<OneStep>(equations, like);
  }
  one_step->resume({});
}

void Ida::Sundials::begin_pass(IntegratorStatistics& statistics) {
  State& state = *window.state;
  count(statistics);
  window.before_pass = one_step->statistics();
  window.pass_goal = std::min(window.t_end, passage_end);
  if (!(state.step > 0.0)) check(IDAGetLastStep(memory, &state.step), "IDAGetLastStep");
  one_step->begin(state, window.pass_goal, *window.inputs, window.stops);
}

void Ida::Sundials::end_pass(IntegratorStatistics& statistics) {
  State& state = *window.state;
  statistics.add(window.before_pass, one_step->statistics());
  jacobians = statistics.jacobians;
  rates = one_step->end_rates();
  t = state.time;
  window.ended = t != window.pass_goal;
  window.drift = {};
  window.starts = true;
  if (t < passage_end) return;
  passage_end = kNever;
  state.step = 0.0;
  looks = steps_since_look = 0;
}

void Ida::Sundials::forget_passage() {
  passage_end = kNever;
  highest = kNever;
  looks = steps_since_look = 0;
}

}  // namespace footfall
