#pragma once
// The memory of SUNDIALS' IDA: who owns it, what it calls, and one step of it. Only ida.cpp, ida_sundials.cpp,
// ida_newton.cpp and ida_passage.cpp look into it.

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <array>
#include <exception>
#include <limits>
#include <memory>
#include <string>

#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/ida.h"
#include "mbd_solver/integrator/one_step.h"
#include "mbd_solver/integrator/singular_position.h"

namespace footfall {

struct Ida::Sundials {
  Sundials(Equations& equations, const IntegratorOptions& options);
  ~Sundials();

  // The numbers of a vector.
  static Eigen::Map<const Eigen::VectorXd> view(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }
  static Eigen::Map<Eigen::VectorXd> writable(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength(x)}; }

  // Every return code of SUNDIALS goes through here.
  void check(int flag, const char* function);
  [[noreturn]] void give_up(const std::string& what);
  void restart(const State& state, const Inputs& inputs, IntegratorStatistics& statistics);
  void aim(double t_end, const Rows& rows, const State& state);  // where IDA has to stop, and its next row
  // All values of the history, the newest and those before, move by what projection has moved the newest to `state`. False:
  // that is far, a singular position is near; nothing moves, and IDA has to start again.
  bool move_history(const State& state);
  // One step of IDA, with the rows in it; false: a row has ended the window, and state and rates are at it.
  bool step(double t_end, const Inputs& inputs, const Rows& rows, State& state, IntegratorStatistics& statistics);
  void add_work_between(double begin, double end, const Inputs& inputs, State& state);
  void count(IntegratorStatistics& statistics);
  double step_error();                  // of the last step, in tolerances of the scene
  void look_ahead(const State& state);  // after a step: sets passage_end where a singular position comes near
  // One_step from state.time to passage_end or t_end, with the rows on the way; false: a row has ended the window.
  bool pass(double t_end, const Inputs& inputs, const Rows& rows, State& state, IntegratorStatistics& statistics);
  void forget_passage();

  static int residual(realtype t, N_Vector y, N_Vector ydot, N_Vector F, void* self);
  static int jacobian(realtype t, realtype c, N_Vector y, N_Vector ydot, N_Vector F, SUNMatrix J, void* self, N_Vector,
                      N_Vector, N_Vector);
  static int settled(SUNNonlinearSolver newton, N_Vector, N_Vector change, realtype tolerance, N_Vector weight,
                     void* self);
  static int weights(N_Vector y, N_Vector weight, void* self);
  static void message(int code, const char* module, const char* function, char* text, void* self);
  template <typename Work>
  int guarded(Work work);

  Equations& equations;
  IntegratorOptions options;
  ErrorNorm norm;  // of the scene's tolerances
  double share;    // of them, that one step may err by
  SUNContext context = nullptr;
  void* memory = nullptr;
  N_Vector y = nullptr, ydot = nullptr, scratch = nullptr, scratch2 = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver solver = nullptr;
  SUNNonlinearSolver newton = nullptr;
  bool fresh = false;                  // the Jacobian is of the step that Newton is in
  double reaction_tolerance = 1.0;     // of multipliers in Newton's iteration [N, N m]
  double last_error = 1.0;             // of the last step [tolerances of a step]
  bool close = false;                  // Newton's last correction was within the tolerance
  double first_change = 0.0;           // of Newton's iteration in this step [tolerances]
  const Inputs* inputs_now = nullptr;  // during one call of IDASolve
  Inputs inputs_last;
  State state_last;       // as returned; empty: start anew
  State row;              // projected, for the caller
  double row_time = 0.0;  // of the next row [s]
  double t = 0.0;
  Eigen::VectorXd rates;
  EnergySample energy;
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  double passage_end = kNever;        // up to there one_step goes on [s]
  std::unique_ptr<OneStep> one_step;  // made when the first singular position comes near
  std::array<Nearness, 3> seen;       // the last looks
  int looks = 0, steps_since_look = 0;
  double highest = kNever;   // determinant of the run, its logarithm
  std::exception_ptr fatal;  // from inside a callback
  std::string complaint;
  long counted[5] = {0, 0, 0, 0, 0};  // steps, residuals, factorizations, rejected, failures: of the present start
  long jacobians = 0;
};

}  // namespace footfall
