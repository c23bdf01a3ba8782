#pragma once
// Smooth functions through scattered numbers with noise: cubic radial basis functions and a plane,
//
//   s(x) = sum over j of w_j |x - x_j|^3 + c_0 + c . x,   [K + lambda I, P; P^T, 0] [w; c] = [y; 0]
//
// with K_ij = |x_i - x_j|^3 and P = [1, x^T]; with too few points for a plane, P = [1]. lambda, of kSmoothings, is the
// one that tells each point best from the others: least sum of e_j^2, e_j = w_j / (M^-1)_jj of the matrix M above
// [Rippa 1999, for lambda = 0]. Several numbers at the same points share M; each has its own lambda.

#include <Eigen/Dense>
#include <array>
#include <random>

#include "mbd_solver/studies/search.h"

namespace footfall {

class ResponseSurfaces {
 public:
  static constexpr std::array<double, 6> kSmoothings = {1e-5, 1e-3, 1e-2, 1e-1, 1.0, 10.0};

  // `points`: one per column; `values`: a row for each point, a column for each number.
  ResponseSurfaces(const Eigen::MatrixXd& points, const Eigen::MatrixXd& values);

  Eigen::VectorXd at(const Eigen::VectorXd& x) const;  // all numbers
  // What is wrong, root mean square, where a point is told from the others alone; per number.
  const Eigen::VectorXd& left_out_errors() const { return left_out_errors_; }

 private:
  Eigen::MatrixXd points_;
  Eigen::MatrixXd weights_;  // w above c, a column for each number
  Eigen::VectorXd left_out_errors_;
};

// The stage "surrogate": for runs that are dear, many parameters and targets that feel only some of them each. Of every
// number that a target asks for it keeps a response surface (response_surface.h) over the parameters that can move that
// number, and so a model of the whole misfit,
//
//   Phi(u) = sum over numbers k of part_k(s_k(u)),
//
// which knows bounds and caps exactly. The surfaces are made anew after every set. In turn, three kinds of sets come
// next: where the model is least; and among random ones, half of them about the best set, that of the least
// a Phi + (1 - a) (1 - d), Phi and the distance d to the next known set scaled to 0..1, for a = 0.8 and 0.5 [Regis,
// Shoemaker 2007]. Before there are as many sets as parameters and two, it takes those of a Latin hypercube.

struct SurrogateQuestions {
  // The numbers k of a set; none: not known yet; empty: a run failed.
  std::function<std::optional<std::vector<double>>(const Shares&)> numbers;
  std::function<double(std::size_t, double)> part;  // of number k in Phi, where it has this value
  std::vector<std::vector<std::size_t>> moved_by;   // the parameters that can move number k
  std::vector<Shares> earlier;                      // sets that are known before
  std::function<bool(const Shares&)> allowed = [](const Shares&) { return true; };  // constraints kept
  std::function<bool(const Shares&)> may_go_on;
};

// Goes on from where it stood, whenever more sets are known. Its way depends on the numbers alone.
class SurrogateSearch {
 public:
  // The first set of the way is `start`.
  SurrogateSearch(const StageSpec& stage, const Shares& start, SurrogateQuestions questions);

  const StageWay& go();

 private:
  Shares next();
  Shares latin(std::size_t row);
  double uniform();
  double normal();
  double misfit_of(const std::vector<double>& numbers) const;  // Phi
  void learn(const Shares& set, const std::vector<double>& numbers);

  const StageSpec stage_;
  const SurrogateQuestions questions_;
  const Shares start_;
  std::mt19937_64 random_;
  std::vector<std::vector<double>> hypercube_;      // one row per parameter
  std::vector<Shares> tried_;                       // all sets, failed ones too
  std::vector<Shares> known_;                       // sets with numbers
  std::vector<std::vector<double>> known_numbers_;  // of known_
  Shares best_;                                     // of known_
  double best_misfit_ = std::numeric_limits<double>::infinity();
  std::size_t designed_ = 0, modelled_ = 0;  // sets of either kind so far
  StageWay way_;
};

}  // namespace footfall
