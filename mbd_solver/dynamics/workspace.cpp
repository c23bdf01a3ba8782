#include "mbd_solver/dynamics/workspace.h"

#include <algorithm>

namespace footfall {
namespace {

struct Range {
  int begin = 0, size = 0;
};

// Rows or columns of a pair's bodies and of the element's own unknowns in y.
struct PairRanges {
  Range q[2], v[2], own;
};

PairRanges ranges(const Layout& layout, const Kinematics& kinematics, int body_1, int body_2, int v0, Range own) {
  PairRanges out;
  out.own = own;
  const int bodies[2] = {body_1, body_2};
  const std::array<int, 2> q = pair_q(layout, body_1, body_2), v = pair_v(layout, body_1, body_2);
  for (std::size_t i = 0; i < 2; ++i) {
    const int n = kinematics.of(bodies[i]).size();
    if (n == 0) continue;
    out.q[i] = {q[i], n + 1};
    out.v[i] = {v0 + v[i], n};
  }
  return out;
}

enum class Use { kJointInJacobian, kForceInJacobian, kJointInSaddle };

// The blocks a joint or an element needs, announced to the pattern or located in the finished matrix.
template <typename Visit>
void visit_blocks(const PairRanges& r, Use use, PairPlaces& places, Visit visit) {
  for (int i = 0; i < 2; ++i) {
    if (r.v[i].size == 0) continue;
    if (use != Use::kJointInSaddle) {
      for (int j = 0; j < 2; ++j) {
        if (r.v[j].size == 0) continue;
        visit(r.v[i], r.q[j], places.v_q[i][j]);
        if (use == Use::kForceInJacobian) visit(r.v[i], r.v[j], places.v_v[i][j]);
      }
    }
    if (r.own.size == 0) continue;
    if (use != Use::kJointInSaddle) visit(r.own, r.q[i], places.extra_q[i]);
    visit(r.own, r.v[i], places.extra_v[i]);
    visit(r.v[i], r.own, places.v_extra[i]);
  }
  if (use == Use::kForceInJacobian && r.own.size > 0) visit(r.own, r.own, places.extra_extra);
}

int kept_count(const Layout& layout, const Joint& joint, int joint_index, int& first) {
  int count = 0;
  first = 0;
  for (std::size_t k = 0; k < joint.rows.size(); ++k) {
    const int row = layout.kept[static_cast<std::size_t>(layout.joint_row[static_cast<std::size_t>(joint_index)]) + k];
    if (row < 0) continue;
    if (count == 0) first = row;
    ++count;
  }
  return count;
}

}  // namespace

Equations::Workspace::Workspace(const Model& model, const Layout& layout) : kinematics(model) {
  int largest = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    inertia.emplace_back(model.body(i).mode_count());
    largest = std::max(largest, 6 + model.body(i).mode_count());
  }
  const int n = 2 * largest;
  row = row2 = row3 = row4 = local = Eigen::VectorXd::Zero(n);
  K = D = M = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < model.force_count(); ++i) {
    const ForceElement& force = model.force(i);
    const int size = force_pair(force).size(), m = force.state_count();
    ElementDerivatives d;
    d.dQ_dx = d.dQ_dv = Eigen::MatrixXd::Zero(size, size);
    d.dQ_dz = Eigen::MatrixXd::Zero(size, m);
    d.ddz_dx = d.ddz_dv = Eigen::MatrixXd::Zero(m, size);
    d.ddz_dz = Eigen::MatrixXd::Zero(m, m);
    elements.push_back(d);
  }
  dtheta_dL.resize(static_cast<std::size_t>(model.body_count()));
  body_places.resize(static_cast<std::size_t>(model.body_count()));
  joint_places.resize(static_cast<std::size_t>(model.joint_count()));
  saddle_joint.resize(static_cast<std::size_t>(model.joint_count()));
  force_places.resize(static_cast<std::size_t>(model.force_count()));

  // Two passes over the same list of blocks: announce them, then find their places.
  SparsePattern pattern(layout.size());
  SparsePattern saddle_pattern(layout.v_size + layout.row_count);
  const auto visit_pairs = [&](auto jacobian_visit, auto saddle_visit) {
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joint(j);
      int first = 0;
      const int count = kept_count(layout, joint, j, first);
      const std::size_t at = static_cast<std::size_t>(j);
      visit_blocks(ranges(layout, kinematics, joint.m1.body, joint.m2.body, layout.v0(), {layout.lambda0() + first, count}),
                   Use::kJointInJacobian, joint_places[at], jacobian_visit);
      visit_blocks(ranges(layout, kinematics, joint.m1.body, joint.m2.body, 0, {layout.v_size + first, count}),
                   Use::kJointInSaddle, saddle_joint[at], saddle_visit);
    }
    for (int i = 0; i < model.force_count(); ++i) {
      const ForceElement& force = model.force(i);
      const std::size_t at = static_cast<std::size_t>(i);
      visit_blocks(ranges(layout, kinematics, force.bodies()[0], force.bodies()[1], layout.v0(),
                          {layout.z0() + layout.force_z[at], force.state_count()}),
                   Use::kForceInJacobian, force_places[at], jacobian_visit);
    }
  };
  visit_pairs([&](Range rows, Range cols, SparseBlock&) { pattern.add_block(rows.begin, rows.size, cols.begin, cols.size); },
              [&](Range rows, Range cols, SparseBlock&) { saddle_pattern.add_block(rows.begin, rows.size, cols.begin, cols.size); });
  for (int i = 0; i < model.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const int s = model.body(i).mode_count(), q = layout.body_q[at], v = layout.v0() + layout.body_v[at];
    pattern.add_diagonal(q, q, 3);
    pattern.add_diagonal(q, v, 3);
    pattern.add_block(q + 3, 4, q + 3, 4);
    pattern.add_block(q + 3, 4, v + 3, 3);
    pattern.add_diagonal(q + 7, q + 7, s);
    pattern.add_diagonal(q + 7, v + 6, s);
    pattern.add_block(v, 6 + s, q, 7 + s);
    pattern.add_block(v, 6 + s, v, 6 + s);
    saddle_pattern.add_block(layout.body_v[at], 6 + s, layout.body_v[at], 6 + s);
  }
  pattern.add_diagonal(layout.z0(), layout.z0(), layout.z_size);
  pattern.add_diagonal(layout.lambda0(), layout.lambda0(), layout.row_count);
  saddle_pattern.add_diagonal(layout.v_size, layout.v_size, layout.row_count);

  jacobian = pattern.build();
  saddle = saddle_pattern.build();
  const auto locate_in = [](const Eigen::SparseMatrix<double>& matrix) {
    return [&matrix](Range rows, Range cols, SparseBlock& block) {
      block = SparseBlock(matrix, rows.begin, rows.size, cols.begin, cols.size);
    };
  };
  visit_pairs(locate_in(jacobian), locate_in(saddle));
  for (int i = 0; i < model.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const int s = model.body(i).mode_count(), q = layout.body_q[at], v = layout.v0() + layout.body_v[at];
    BodyPlaces& places = body_places[at];
    places.r_r = diagonal_places(jacobian, q, q, 3);
    places.r_dr = diagonal_places(jacobian, q, v, 3);
    places.L_L = SparseBlock(jacobian, q + 3, 4, q + 3, 4);
    places.L_w = SparseBlock(jacobian, q + 3, 4, v + 3, 3);
    places.a_a = diagonal_places(jacobian, q + 7, q + 7, s);
    places.a_da = diagonal_places(jacobian, q + 7, v + 6, s);
    places.v_q = SparseBlock(jacobian, v, 6 + s, q, 7 + s);
    places.v_v = SparseBlock(jacobian, v, 6 + s, v, 6 + s);
    saddle_mass.emplace_back(saddle, layout.body_v[at], 6 + s, layout.body_v[at], 6 + s);
  }
  z_z = diagonal_places(jacobian, layout.z0(), layout.z0(), layout.z_size);
  lambda_lambda = diagonal_places(jacobian, layout.lambda0(), layout.lambda0(), layout.row_count);
  saddle_diagonal = diagonal_places(saddle, layout.v_size, layout.v_size, layout.row_count);
  saddle_lu = std::make_unique<SparseLu>(saddle);
  saddle_x = Eigen::VectorXd::Zero(layout.v_size + layout.row_count);
  phi_rate = Eigen::VectorXd::Zero(layout.row_count);
  y = rhs = Eigen::VectorXd::Zero(layout.size());
  last_q = Eigen::VectorXd::Zero(layout.q_size);
  last_v = Eigen::VectorXd::Zero(layout.v_size);
  regularisation = Eigen::VectorXd::Zero(layout.row_count);
}

}  // namespace footfall
