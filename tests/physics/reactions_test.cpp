// Reactions of mechanisms with more conditions than they need: of all multipliers that give the same forces on the bodies,
// both integrators hand out those of the smallest sum (s_i lambda_i)^2 (theory 2.2).

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/physics/famous_mechanisms.h"
#include "tests/physics/mechanisms.h"
#include "tests/physics/motion_of.h"

namespace footfall {
namespace {

struct RedundantMechanism {
  std::string name;
  std::function<Model()> make;
  double t_end;  // [s], a regular position
  int too_many;  // conditions
  double rtol = 1e-8;
};

void PrintTo(const RedundantMechanism& mechanism, std::ostream* out) { *out << mechanism.name; }

const std::vector<RedundantMechanism>& redundant_mechanisms() {
  static const std::vector<RedundantMechanism> all = {
      {"Bennett", [] { return test::bennett(); }, 0.8, 3},
      {"Bricard",
       [] {
         return test::bricard(
             0.01, [] { return 0.0; }, [] { return false; });
       },
       0.8, 1},
      {"FourBars", [] { return test::n_four_bar(2); }, 0.4, 6},
      {"CrankRocker", [] { return test::crank_rocker(3, false); }, 0.5, 3},
      {"Squeezer", [] { return test::squeezer(); }, 0.01, 9}};
  return all;
}

class Reactions : public ::testing::TestWithParam<RedundantMechanism> {};
INSTANTIATE_TEST_SUITE_P(Of, Reactions, ::testing::ValuesIn(redundant_mechanisms()),
                         [](const auto& mechanism) { return mechanism.param.name; });

// What the page says of them, written down anew with dense matrices: nothing of it is taken from the solver but M and Phi_v.
struct Page {
  Eigen::MatrixXd M, Phi_v;
  Eigen::VectorXd s;  // of every row, at the start

  // Of the same reactions as `lambda`, those of the smallest sum (s_i lambda_i)^2: lambda = S^-1 (Phi_v^T S^-1)^+ Phi_v^T lambda.
  Eigen::VectorXd smallest(const Eigen::VectorXd& lambda, int rank) const {
    const Eigen::VectorXd inverse = s.cwiseInverse();
    const Eigen::MatrixXd A = Phi_v.transpose() * inverse.asDiagonal();
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd f = Phi_v.transpose() * lambda;
    const Eigen::VectorXd part = svd.matrixU().leftCols(rank).transpose() * f;
    return inverse.cwiseProduct(svd.matrixV().leftCols(rank) * part.cwiseQuotient(svd.singularValues().head(rank)));
  }
  double size(const Eigen::VectorXd& lambda) const { return s.cwiseProduct(lambda).norm(); }
};

Page page_at(test::Run& run) {
  const Layout& layout = run.equations.layout();
  const int n = layout.v_size, rows = layout.row_count;
  Eigen::VectorXd rates(layout.size()), y(layout.size()), x = Eigen::VectorXd::Zero(layout.size()), Mx = x;
  run.equations.accelerations(run.state, run.inputs, rates);
  run.equations.pack(run.state, rates.tail(rows), y);
  Page page;
  page.M = Eigen::MatrixXd(n, n);
  page.Phi_v = Eigen::MatrixXd(rows, n);
  for (int k = 0; k < n; ++k) {
    x.setZero();
    x[layout.v0() + k] = 1.0;
    run.equations.apply_mass(y, x, run.state.time, Mx);  // dF/dydot x
    page.M.col(k) = Mx.segment(layout.v0(), n);
    page.Phi_v.col(k) = Mx.tail(rows);
  }
  return page;
}

// s_i^2: mean of (Phi_v M^-1 Phi_v^T)_kk over the joint's lengths, or angles.
Eigen::VectorXd sizes_of_rows(const Page& page, const Model& model, const Layout& layout) {
  const Eigen::VectorXd each = (page.Phi_v * page.M.ldlt().solve(page.Phi_v.transpose())).diagonal();
  Eigen::VectorXd s(each.size());
  for (int j = 0; j < model.joint_count(); ++j) {
    const std::vector<ConstraintRow>& rows = model.joint(j).rows;
    const int first = layout.joint_row[static_cast<std::size_t>(j)];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      double sum = 0.0, count = 0.0;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        if (rows[k].unit != rows[i].unit) continue;
        sum += each[first + static_cast<int>(k)];
        count += 1.0;
      }
      s[first + static_cast<int>(i)] = std::sqrt(sum / count);
    }
  }
  return s;
}

struct Found {
  State state;
  Eigen::VectorXd lambda;
};

// At a row on the way and at the end.
std::vector<Found> reactions_of(const Model& model, const std::string& kind, const RedundantMechanism& mechanism) {
  test::Run run(model, kind, test::as_a_scene(mechanism.rtol));
  const int rows_of_joints = run.equations.layout().row_count;
  std::vector<Found> out;
  Rows rows;
  const double middle = 0.5 * mechanism.t_end;
  rows.next = [=](double time) { return time < middle ? middle : HUGE_VAL; };
  rows.on_row = [&](const State& state, const Eigen::VectorXd& rates) {
    out.push_back({state, rates.tail(rows_of_joints)});
    return true;
  };
  run.integrator->advance(run.state, mechanism.t_end, run.inputs, rows);
  out.push_back({run.state, run.integrator->end_rates().tail(rows_of_joints)});
  return out;
}

TEST_P(Reactions, AreTheSmallestByBothIntegrators) {
  const RedundantMechanism& mechanism = GetParam();
  const Model model = mechanism.make();
  test::Run here(model, "one_step", test::as_a_scene(mechanism.rtol));
  const Layout& layout = here.equations.layout();
  ASSERT_EQ(layout.row_count - here.assembly.rank, mechanism.too_many);
  const Eigen::VectorXd s = sizes_of_rows(page_at(here), model, layout);

  const std::vector<Found> one_step = reactions_of(model, "one_step", mechanism),
                           ida = reactions_of(model, "ida", mechanism);
  ASSERT_EQ(one_step.size(), 2u);
  ASSERT_EQ(ida.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const std::vector<Found>* by : {&one_step, &ida}) {
      const Found& found = (*by)[i];
      const std::string where = (by == &ida ? "ida" : "one_step") + std::string(i == 0 ? ", in a row" : ", at the end");
      here.state = found.state;
      Page page = page_at(here);
      page.s = s;
      const Eigen::VectorXd smallest = page.smallest(found.lambda, here.assembly.rank);
      // kSoft of make_smallest(), three times refined, leaves far less; drift of 1e-10 tilts Phi_v by as much.
      EXPECT_LT(page.size(found.lambda - smallest), 1e-7 * page.size(smallest)) << where;
      // As a direct solve at the same state has them: the multipliers of a step err by what Newton leaves.
      Eigen::VectorXd rates(layout.size());
      here.equations.accelerations(found.state, here.inputs, rates);
      EXPECT_LT(page.size(found.lambda - rates.tail(layout.row_count)), 1e-4 * page.size(smallest)) << where;
    }
    // A thousand tolerances: the motions differ by up to a hundred, and reactions follow the accelerations.
    EXPECT_LT(s.cwiseProduct(one_step[i].lambda - ida[i].lambda).norm(),
              1e3 * mechanism.rtol * s.cwiseProduct(one_step[i].lambda).norm());
  }
}

}  // namespace
}  // namespace footfall
