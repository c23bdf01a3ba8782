// Each pattern is built in two passes over the same list of blocks: announce them, then find their places.

#include "mbd_solver/dynamics/jacobian_pattern.h"

#include <map>
#include <set>

namespace footfall {
namespace {

struct Range {
  int begin = 0, size = 0;
};

// The blocks of a joint or an element, announced to a pattern or located in the finished matrix: visit(rows, columns, block).
// `v` are the coordinates of its bodies, `own` its multipliers or inner states, which act on each other in blocks of
// `own_block`; 0: not at all.
template <typename Ranges, typename Places, typename Visit>
void visit_blocks(const Ranges& v, Range own, int own_block, bool forces, Places& places, Visit visit) {
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (v[i].size == 0) continue;
    for (std::size_t j = 0; forces && j < v.size(); ++j) {
      if (v[j].size > 0) visit(v[i], v[j], places.v_v[i][j]);
    }
    if (own.size == 0) continue;
    visit(own, v[i], places.extra_v[i]);
    visit(v[i], own, places.v_extra[i]);
  }
  if (own_block == 0) return;
  places.extra_extra.resize(static_cast<std::size_t>(own.size / own_block));
  int begin = own.begin;
  for (SparseBlock& block : places.extra_extra) {
    visit(Range{begin, own_block}, Range{begin, own_block}, block);
    begin += own_block;
  }
}

std::array<Range, 2> velocities(const Layout& layout, const Kinematics& kinematics, int body_1, int body_2) {
  const std::array<int, 2> first = pair_v(layout, body_1, body_2);
  return {Range{first[0], kinematics.of(body_1).size()}, Range{first[1], kinematics.of(body_2).size()}};
}

// Entries that depend on continuous signals: their influences, and the forces that read a place of each.
std::vector<SignalPlaces> signal_places(const Model& model) {
  std::vector<SignalPlaces> out;
  if (!model.signals()) return out;
  std::map<int, std::vector<int>> forces;  // that read a place among the inputs
  for (int i = 0; i < model.force_count(); ++i)
    for (const int place : model.force(i).read_inputs())
      if (place >= 0) forces[place].push_back(i);
  for (ContinuousSignals::Influence& influence : model.signals()->influences()) {
    SignalPlaces places;
    std::set<int> driven;
    for (const int place : influence.places)
      if (const auto found = forces.find(place); found != forces.end())
        driven.insert(found->second.begin(), found->second.end());
    for (const int force : driven) {
      places.driven.emplace_back();
      places.driven.back().force = force;
    }
    places.rates.resize(influence.rates.size());
    places.of = std::move(influence);
    out.push_back(std::move(places));
  }
  return out;
}

// Blocks of the continuous signals, if there are any.
template <typename Visit>
void visit_signal_blocks(const Model& model, const Layout& layout, const Kinematics& kinematics,
                         std::vector<SignalPlaces>& signals, Visit visit) {
  const int z0 = layout.v_size, states0 = z0 + layout.signal_z;
  const auto visit_some = [&](Range rows, Range cols, SparseBlock& block) {
    if (rows.size > 0 && cols.size > 0) visit(rows, cols, block);
  };
  for (SignalPlaces& places : signals) {
    const ContinuousSignals::Influence& of = places.of;
    const Range columns = of.body == kGround ? Range{states0 + of.first_state, of.state_count}
                                             : Range{layout.body_v[of.body], kinematics.of(of.body).size()};
    for (SignalPlaces::Driven& driven : places.driven) {
      const ForceElement& force = model.force(driven.force);
      const std::array<Range, 2> v = velocities(layout, kinematics, force.bodies()[0], force.bodies()[1]);
      for (std::size_t i = 0; i < 2; ++i) visit_some(v[i], columns, driven.v[i]);
      visit_some({z0 + layout.force_z[driven.force], force.state_count()}, columns, driven.z);
    }
    for (std::size_t k = 0; k < of.rates.size(); ++k)
      visit_some({states0 + of.rates[k].first, of.rates[k].second}, columns, places.rates[k]);
  }
}

auto announce_to(SparsePattern& pattern) {
  return [&pattern](Range rows, Range cols, SparseBlock&) {
    pattern.add_block(rows.begin, rows.size, cols.begin, cols.size);
  };
}

auto locate_in(const Eigen::SparseMatrix<double>& matrix) {
  return [&matrix](Range rows, Range cols, SparseBlock& block) {
    block = SparseBlock(matrix, rows.begin, rows.size, cols.begin, cols.size);
  };
}

Range body_range(const Layout& layout, const Kinematics& kinematics, int body) {
  return {layout.body_v[body], kinematics.of(body).size()};
}

}  // namespace

JacobianPattern::JacobianPattern(const Model& model, const Layout& layout, const Kinematics& kinematics)
    : bodies(static_cast<std::size_t>(model.body_count())),
      joints(static_cast<std::size_t>(model.joint_count())),
      forces(static_cast<std::size_t>(model.force_count())),
      signals(signal_places(model)) {
  const int z0 = layout.v_size, lambda0 = layout.v_size + layout.z_size;
  const auto visit_all = [&](auto visit) {
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joint(j);
      const int first = layout.joint_row[j], count = static_cast<int>(joint.rows.size());
      visit_blocks(velocities(layout, kinematics, joint.m1.body, joint.m2.body), {lambda0 + first, count}, 0, true,
                   joints[j], visit);
    }
    visit_signal_blocks(model, layout, kinematics, signals, visit);
    for (int i = 0; i < model.force_count(); ++i) {
      const ForceElement& force = model.force(i);
      const std::array<Range, 2> pair = velocities(layout, kinematics, force.bodies()[0], force.bodies()[1]);
      std::vector<Range> v(pair.begin(), pair.end());
      for (const int body : force.further_bodies()) v.push_back(body_range(layout, kinematics, body));
      ElementPlaces& places = forces[i];
      places.v_v.assign(v.size(), std::vector<SparseBlock>(v.size()));
      places.extra_v.resize(v.size());
      places.v_extra.resize(v.size());
      visit_blocks(v, {z0 + layout.force_z[i], force.state_count()}, force.state_block(), true, places, visit);
    }
    for (int i = 0; i < model.body_count(); ++i) {
      const Range v = body_range(layout, kinematics, i);
      visit(v, v, bodies[i]);
    }
  };
  SparsePattern pattern(lambda0 + layout.row_count);
  visit_all(announce_to(pattern));
  pattern.add_diagonal(z0, z0, layout.z_size);
  pattern.add_diagonal(lambda0, lambda0, layout.row_count);
  lower = reduced = pattern.build();
  stiffness = Eigen::VectorXd::Zero(lower.nonZeros());
  visit_all(locate_in(lower));
  v_v = diagonal_places(lower, 0, 0, layout.v_size);
  z_z = diagonal_places(lower, z0, z0, layout.z_size);
  lambda_lambda = diagonal_places(lower, lambda0, lambda0, layout.row_count);
}

SaddlePattern::SaddlePattern(const Model& model, const Layout& layout, const Kinematics& kinematics)
    : mass(static_cast<std::size_t>(model.body_count())), joints(static_cast<std::size_t>(model.joint_count())) {
  const auto visit_all = [&](auto visit) {
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joint(j);
      const int first = layout.joint_row[j], count = static_cast<int>(joint.rows.size());
      visit_blocks(velocities(layout, kinematics, joint.m1.body, joint.m2.body), {layout.v_size + first, count}, 0,
                   false, joints[j], visit);
    }
    for (int i = 0; i < model.body_count(); ++i) {
      const Range v = body_range(layout, kinematics, i);
      visit(v, v, mass[i]);
    }
  };
  SparsePattern pattern(layout.v_size + layout.row_count);
  visit_all(announce_to(pattern));
  pattern.add_diagonal(layout.v_size, layout.v_size, layout.row_count);
  matrix = pattern.build();
  visit_all(locate_in(matrix));
  diagonal = diagonal_places(matrix, layout.v_size, layout.v_size, layout.row_count);
}

}  // namespace footfall
