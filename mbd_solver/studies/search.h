#pragma once
// One stage of a search by NLopt, as a function of the misfits that are known. It begins anew whenever more are known
// and goes the same way up to there, so its way depends neither on how many runs go side by side, nor on how often it
// was killed: it needs no state but the runs themselves.
//
// Where a misfit is not known yet, the search goes on with that of the nearest set that is, to see which sets it will
// probably ask for next: these are run side by side. Only the first of them is certain; the others of a global search
// are nearly always right, because its first sets do not depend on misfits.

#include <functional>
#include <optional>
#include <vector>

#include "mbd_solver/studies/calibration.h"

namespace footfall {

struct StageWay {
  std::vector<Shares> wanted;  // not known yet, the certain one first; empty: the stage has ended
  Shares best;                 // of those on the way
  double misfit = std::numeric_limits<double>::infinity();
  std::vector<Shares> sets;  // in the order of the search, each once
  std::string end;           // why it ended
};

struct SearchQuestions {
  std::function<std::optional<double>(const Shares&)> misfit;  // none: not known yet
  std::function<bool(const Shares&)> may_go_on;                // asked before each set that is known or certain
};

// `most_wanted`: so many sets are asked for at once. `start` is the first set of a local search, and of crs2 and isres.
// Throws InputError when NLopt refuses.
StageWay walk(const StageSpec& stage, const Shares& start, const SearchQuestions& questions, std::size_t most_wanted);

// The way down a formula of the shares, one parameter at a time: steps in both directions of every parameter, as long as
// one of them is better, then shorter ones. For surfaces with kinks, whose values cost nothing.

// Each share stays between those of `least` and `most`. `steps`: from long to short. `value`: infinite where a set is not
// allowed.
struct DescentBounds {
  Shares least, most;
};
Shares down_from(Shares u, const DescentBounds& bounds, const std::vector<double>& steps,
                 const std::function<double(const Shares&)>& value);

// The stage "gauss_newton": least squares, which NLopt does not have. From a set u with residuals r, and derivatives J
// by central differences of `step` (their sets are run side by side),
//
//   (J^T J + lambda I) d = -J^T r,   u + d cut at the ranges
//
// [Levenberg, Marquardt]. A better set is taken, and lambda falls to a tenth; else it grows ten times. Ends when d is
// within the stage's precision, or lambda is at its end. A search begun anew goes the same way, as walk() does.

struct LeastSquaresQuestions {
  std::function<std::optional<std::vector<double>>(const Shares&)> residuals;  // none: not known yet; empty: failed
  std::function<bool(const Shares&)> may_go_on;
};

StageWay walk_least_squares(const StageSpec& stage, const Shares& start, double step,
                            const LeastSquaresQuestions& questions);

}  // namespace footfall
