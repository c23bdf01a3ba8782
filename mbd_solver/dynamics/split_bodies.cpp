// Joints of one part of the mechanism, as it falls apart without the bodies that are split, share copies. Closed loops
// through such a body therefore remain short.

#include "mbd_solver/dynamics/split_bodies.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace footfall {
namespace {

constexpr std::size_t kMostJoints = 32;    // of a body that is not split
constexpr std::size_t kJointsOfACopy = 8;  // few entries in the factor of a copy, and few links

// Lowest body of the part that body i belongs to, paths shortened.
int lowest(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

}  // namespace

SplitBodies::SplitBodies(const Model& model, const Layout& layout) {
  const std::size_t count = static_cast<std::size_t>(model.body_count());
  std::vector<std::vector<int>> joints(count);  // on each body
  for (int j = 0; j < model.joint_count(); ++j)
    for (const int body : {model.joint(j).m1.body, model.joint(j).m2.body})
      if (body != kGround) joints[body].push_back(j);
  const auto is_split = [&](int body) { return joints[body].size() > kMostJoints; };

  std::vector<int> parent(count);
  std::iota(parent.begin(), parent.end(), 0);
  for (int j = 0; j < model.joint_count(); ++j) {
    const int a = model.joint(j).m1.body, b = model.joint(j).m2.body;
    if (a == kGround || b == kGround || is_split(a) || is_split(b)) continue;
    const auto [low, high] = std::minmax({lowest(parent, a), lowest(parent, b)});  // a list: its values, not references
    parent[high] = low;
  }

  for (std::size_t i = 0; i < count; ++i) {
    const int u = layout.body_v[i], end = i + 1 < count ? layout.body_v[i + 1] : layout.v_size;
    if (!is_split(static_cast<int>(i))) {
      for (int k = u; k < end; ++k) place_.push_back(size_++);
      continue;
    }
    std::vector<std::pair<int, int>> order;  // part of the other body, joint
    for (const int j : joints[i]) {
      const Joint& joint = model.joint(j);
      const int other = joint.m1.body == static_cast<int>(i) ? joint.m2.body : joint.m1.body;
      const bool alone = other == kGround || is_split(other);
      order.emplace_back(alone ? model.body_count() : lowest(parent, other), j);
    }
    std::sort(order.begin(), order.end());
    const std::size_t copies = (order.size() + kJointsOfACopy - 1) / kJointsOfACopy;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const int j = order[k].second, row = layout.joint_row[j];
      for (std::size_t r = 0; r < model.joint(j).rows.size(); ++r)  // of a gear: the copy of its first member
        copy_of_.emplace(std::pair(row + static_cast<int>(r), copied_.size()), static_cast<int>(k / kJointsOfACopy));
    }
    place_.insert(place_.end(), static_cast<std::size_t>(end - u), -1 - static_cast<int>(copied_.size()));
    copied_.push_back({u, end - u, size_, static_cast<int>(copies)});
    size_ += (end - u) * static_cast<int>(copies);
  }
}

Eigen::SparseMatrix<double> SplitBodies::split(const Eigen::SparseMatrix<double>& transposed) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < transposed.cols(); ++row) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(transposed, row); entry; ++entry) {
      const int place = place_[entry.row()];
      if (place >= 0) {
        entries.emplace_back(place, row, entry.value());
        continue;
      }
      const std::size_t index = static_cast<std::size_t>(-1 - place);
      const Copied& body = copied_[index];
      entries.emplace_back(body.first + copy_of_.at({row, index}) * body.size + static_cast<int>(entry.row()) - body.u,
                           row, std::sqrt(body.count) * entry.value());
    }
  }
  int links = static_cast<int>(transposed.cols());
  for (const Copied& body : copied_) {
    for (int k = body.size; k < body.count * body.size; ++k, ++links) {
      entries.emplace_back(body.first + k - body.size, links, std::sqrt(0.5));
      entries.emplace_back(body.first + k, links, -std::sqrt(0.5));
    }
  }
  Eigen::SparseMatrix<double> out(size_, links);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

Eigen::VectorXd SplitBodies::joined(const Eigen::VectorXd& u) const {
  Eigen::VectorXd out(static_cast<Eigen::Index>(place_.size()));
  for (Eigen::Index i = 0; i < out.size(); ++i)
    if (const int place = place_[i]; place >= 0) out[i] = u[place];
  for (const Copied& body : copied_) {
    out.segment(body.u, body.size).setZero();
    for (int k = 0; k < body.count; ++k)
      out.segment(body.u, body.size) += u.segment(body.first + k * body.size, body.size) / std::sqrt(body.count);
  }
  return out;
}

}  // namespace footfall
