// Searches by response surfaces: mbd_solver/cli/calibrate/surrogate.h and response_surface.h.
#include "mbd_solver/cli/calibrate/surrogate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "mbd_solver/cli/calibrate/response_surface.h"
#include "tests/unit/cli/search_stage.h"

namespace footfall {
namespace {

// Points of a lattice in the unit square, moved a little so that no three are in line.
Eigen::MatrixXd scattered_points(int side) {
  Eigen::MatrixXd points(2, side * side);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      points.col(i * side + j) = Eigen::Vector2d(i + 0.3 * std::sin(7.0 * j + i), j + 0.3 * std::cos(5.0 * i)) / side;
  return points;
}

TEST(ResponseSurfaces, IsExactOnAPlane) {
  const Eigen::MatrixXd points = scattered_points(4);
  const Eigen::VectorXd values = (3.0 + 2.0 * points.row(0).array() - 5.0 * points.row(1).array()).matrix().transpose();
  const ResponseSurfaces surface(points, values);
  for (const Eigen::Vector2d& x : {Eigen::Vector2d(0.1, 0.9), Eigen::Vector2d(2.0, -1.0)})
    EXPECT_NEAR(surface.at(x)[0], 3.0 + 2.0 * x.x() - 5.0 * x.y(), 1e-8);
  EXPECT_LT(surface.left_out_errors()[0], 1e-8);
}

// The cubic spline's error falls with at least the square of the distance of points.
TEST(ResponseSurfaces, ComesNearerWithMorePoints) {
  const auto f = [](double x, double y) { return std::sin(3.0 * x) * std::exp(-y); };
  double before = 0.0;
  for (const int side : {5, 10}) {
    const Eigen::MatrixXd points = scattered_points(side);
    Eigen::VectorXd values(points.cols());
    for (Eigen::Index j = 0; j < points.cols(); ++j) values[j] = f(points(0, j), points(1, j));
    const ResponseSurfaces surface(points, values);
    double error = 0.0;
    for (double x = 0.2; x < 0.75; x += 0.1)
      for (double y = 0.2; y < 0.75; y += 0.1)
        error = std::max(error, std::abs(surface.at(Eigen::Vector2d(x, y))[0] - f(x, y)));
    if (side == 10) {
      EXPECT_LT(error, before / 4.0);
    }
    before = error;
  }
}

// Noise about a plane is not followed: between points the surface stays nearer to the plane than the points do.
TEST(ResponseSurfaces, SmoothsNoise) {
  const Eigen::MatrixXd points = scattered_points(7);
  Eigen::VectorXd values(points.cols());
  double noise = 0.0;
  for (Eigen::Index j = 0; j < points.cols(); ++j) {
    const double e = std::sin(12345.678 * static_cast<double>(j * j + 1));
    noise += e * e / static_cast<double>(points.cols());
    values[j] = 4.0 * points(0, j) + e;
  }
  const ResponseSurfaces surface(points, values);
  double error = 0.0;
  int places = 0;
  for (double x = 0.1; x < 0.85; x += 0.1, ++places)
    error += std::pow(surface.at(Eigen::Vector2d(x, 0.45))[0] - 4.0 * x, 2);
  EXPECT_LT(error / places, 0.25 * noise);
}

TEST(ResponseSurfaces, OfOnePointIsItsValue) {
  const ResponseSurfaces surface(Eigen::MatrixXd::Constant(3, 1, 0.5), Eigen::VectorXd::Constant(1, 7.0));
  EXPECT_DOUBLE_EQ(surface.at(Eigen::Vector3d(0.1, 0.2, 0.9))[0], 7.0);
}

// Ten parameters; each of eight numbers feels three of them, bends, and is wanted within bounds.
constexpr std::size_t kManyParameters = 10, kManyNumbers = 8;
Shares bent_middle() { return Shares(kManyParameters, 0.5); }
double bent_number(std::size_t k, const Shares& u) {
  return std::sin(2.0 * u[k]) + u[k + 1] * u[k + 1] - u[(k + 5) % kManyParameters];
}
double bent_part(std::size_t k, double y) {  // met at a hidden set
  static const Shares kHidden = {0.3, 0.7, 0.2, 0.6, 0.45, 0.8, 0.35, 0.25, 0.65, 0.55};
  const double off = (y - bent_number(k, kHidden)) / 0.1;
  return std::min(9.0, off * off);
}
double bent_misfit(const Shares& u) {
  double sum = 0.0;
  for (std::size_t k = 0; k < kManyNumbers; ++k) sum += bent_part(k, bent_number(k, u));
  return sum;
}

SurrogateQuestions questions_of(std::map<Shares, bool>* known) {
  SurrogateQuestions questions;
  for (std::size_t k = 0; k < kManyNumbers; ++k) questions.moved_by.push_back({k, k + 1, (k + 5) % kManyParameters});
  questions.part = bent_part;
  questions.may_go_on = [](const Shares&) { return true; };
  questions.numbers = [known](const Shares& u) -> std::optional<std::vector<double>> {
    if (known && !known->count(u)) return {};
    std::vector<double> all;
    for (std::size_t k = 0; k < kManyNumbers; ++k) all.push_back(bent_number(k, u));
    return all;
  };
  return questions;
}

StageWay surrogate_way(const SurrogateQuestions& questions, int evaluations) {
  SurrogateSearch search(stage_of(SearchMethod::kSurrogate, evaluations), bent_middle(), questions);
  return search.go();
}

TEST(SurrogateSearch, IsBetterThanSimplicesInAsManySets) {
  const StageWay way = surrogate_way(questions_of(nullptr), 40);
  SearchQuestions blind;
  blind.may_go_on = [](const Shares&) { return true; };
  blind.misfit = bent_misfit;
  const StageWay simplices = walk(stage_of(SearchMethod::kSbplx, 40), bent_middle(), blind, 1);
  EXPECT_EQ(way.sets.size(), 40u);
  EXPECT_DOUBLE_EQ(way.misfit, bent_misfit(way.best));
  EXPECT_LT(way.misfit, 0.2 * simplices.misfit) << simplices.misfit;
  for (const Shares& u : way.sets)
    for (const double share : u) EXPECT_TRUE(share >= 0.0 && share <= 1.0);
}

TEST(SurrogateSearch, GoesTheSameWayHoweverOftenItBegins) {
  const StageWay straight = surrogate_way(questions_of(nullptr), 30);
  std::map<Shares, bool> known;
  StageWay way;
  for (int round = 0; round < 100; ++round) {  // as a calibration that is killed after every set
    way = surrogate_way(questions_of(&known), 30);
    if (way.wanted.empty()) break;
    ASSERT_EQ(way.wanted.size(), 1u);
    known[way.wanted.front()] = true;
  }
  EXPECT_EQ(way.sets, straight.sets);
  EXPECT_EQ(way.best, straight.best);
  EXPECT_EQ(way.end, "all evaluations done");
}

TEST(SurrogateSearch, UsesWhatIsKnownAndDoesNotAskForItAgain) {
  SurrogateQuestions questions = questions_of(nullptr);
  questions.earlier = surrogate_way(questions, 30).sets;
  const StageWay way = surrogate_way(questions, 10);
  for (std::size_t k = 1; k < way.sets.size(); ++k)
    EXPECT_EQ(std::count(questions.earlier.begin(), questions.earlier.end(), way.sets[k]), 0);
  EXPECT_LT(way.misfit, 0.5 * bent_misfit(bent_middle()));
}

TEST(SurrogateSearch, GoesAroundSetsWhoseRunsFail) {
  SurrogateQuestions questions = questions_of(nullptr);
  const auto all = questions.numbers;
  questions.numbers = [all](const Shares& u) { return u[0] > 0.6 ? std::vector<double>() : all(u); };
  const StageWay way = surrogate_way(questions, 40);
  EXPECT_LE(way.best[0], 0.6);
  EXPECT_LT(way.misfit, bent_misfit(bent_middle()));
}

TEST(SurrogateSearch, KeepsConstraints) {
  SurrogateQuestions questions = questions_of(nullptr);
  questions.allowed = [](const Shares& u) { return u[0] + u[1] <= 1.0; };
  const StageWay way = surrogate_way(questions, 40);
  for (std::size_t k = 1 + bent_middle().size() + 1; k < way.sets.size(); ++k)  // behind the hypercube
    EXPECT_LE(way.sets[k][0] + way.sets[k][1], 1.0);
}

TEST(SurrogateSearch, EndsAtALimit) {
  SurrogateQuestions questions = questions_of(nullptr);
  int asked = 0;
  questions.may_go_on = [&](const Shares&) { return ++asked <= 7; };
  const StageWay way = surrogate_way(questions, 40);
  EXPECT_EQ(way.sets.size(), 7u);
  EXPECT_EQ(way.end, "limit reached");
}

}  // namespace
}  // namespace footfall
