#pragma once
// The times at which signals that are known beforehand have corners: they read time, the state of the scene and its
// beginning, but nothing of the motion.
//
// A switch is a part of an expression at which it can jump or bend: a comparison, abs, sign, rint, min, max, a condition, a
// point of a table. Each has a class that is constant between corners: the sign of its argument, the piece of its table. Where
// classes differ at two times, bisection finds the corner to the last digit. If all is made of lines, this finds every corner.
// Other functions (sin, exp, powers) are sampled on a grid of kCells per run; where they vary, steps also end at their turning
// points, at the feet of bumps, and at the ends of 64 blocks of the run. The zeros of sums, arguments and bases of powers
// belong to the grid, with points nearer and nearer to them: exp(-((time - 0.5) / 1e-9)^2) is found although no cell shows it.

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/model/control/expression_parts.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/model/laws/time_function.h"

namespace footfall {

// Where a name of an expression gets its value.
struct GivenSource {
  enum class Kind {
    kTime,
    kSince,   // time - values[place]
    kHeld,    // values[place], constant until an event
    kSignal,  // of the signals, if that is given
    kUnknown  // depends on the motion
  };
  Kind kind = Kind::kUnknown;
  int place = -1;
};

// A signal, or the condition of an event.
struct GivenEntry {
  std::string label;  // for messages
  std::string name;   // read by others as "signal.NAME"; empty: by none
  const SignalBlock* block = nullptr;
  std::vector<std::string> inputs;
  std::vector<int> active_in;  // places of the states in which it is active, else it is 0; empty: always
};

class GivenSignals {
 public:
  static constexpr int kBlocks = 64, kCellsOfBlock = 1024;
  static constexpr int kCells = kBlocks * kCellsOfBlock;

  // entries: in an order in which each follows those that it reads; their blocks must outlive this. t_end [s] > 0.
  GivenSignals(const std::vector<GivenEntry>& entries, const std::function<GivenSource(const std::string&)>& source,
               double t_end);
  ~GivenSignals();
  GivenSignals(GivenSignals&&) noexcept;
  GivenSignals& operator=(GivenSignals&&) noexcept;

  // The first corner after t [s] while the inputs of the run have these values; at infinity: none.
  Corner next(double t, const Eigen::VectorXd& values);
  // The first time after t and before that corner at which a step must end for the integral of curved values [s]; at infinity:
  // none. Between such times the quadrature of Radau IIA with three stages (order 5) is exact to 1e-14 of the largest
  // integral of the value over a block; the quadrature of one_step, which has larger constants, to some 1e-9 of a pulse.
  // Not for fuzzy signals, which bend at unknown places.
  double next_split(double t, const Eigen::VectorXd& values);
  // Signals that vary too fast for the grid, once each: their labels. Known up to the time that next() has reached.
  const std::vector<std::string>& too_fast() const;

 private:
  struct Scan;
  std::unique_ptr<Scan> scan_;
};

}  // namespace footfall
