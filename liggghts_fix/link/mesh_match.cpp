// Finds the boundary node at each corner of a mesh by position, then the triangle that joins these nodes.

#include "liggghts_fix/link/mesh_match.h"

#include <algorithm>
#include <locale>
#include <map>
#include <numeric>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "liggghts_fix/link/codes.h"

namespace footfall {
namespace {

// Nodes sorted by x, so that few are compared with a point. Nodes at one position share the number of the first of them.
class NodeFinder {
 public:
  NodeFinder(const Eigen::Matrix3Xd& x, double tolerance) : x_(x), tolerance_(tolerance) {
    order_.resize(x.cols());
    for (std::size_t j = 0; j < order_.size(); ++j) order_[j] = static_cast<int>(j);
    std::sort(order_.begin(), order_.end(), [&x](int i, int j) { return x(0, i) < x(0, j); });
  }

  // The lowest-numbered node within the tolerance of p, -1 if there is none.
  int place(const Eigen::Vector3d& p) const {
    const auto first = std::lower_bound(order_.begin(), order_.end(), p[0] - tolerance_,
                                        [this](int j, double value) { return x_(0, j) < value; });
    int found = -1;
    for (auto it = first; it != order_.end() && x_(0, *it) <= p[0] + tolerance_; ++it)
      if ((x_.col(*it) - p).norm() <= tolerance_ && (found < 0 || *it < found)) found = *it;
    return found;
  }

 private:
  const Eigen::Matrix3Xd& x_;
  double tolerance_;
  std::vector<int> order_;
};

using Places = std::array<int, 3>;

Places sorted(Places places) {
  std::sort(places.begin(), places.end());
  return places;
}

std::string text(const Eigen::Vector3d& p) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << "(" << p[0] << ", " << p[1] << ", " << p[2] << ")";
  return out.str();
}

}  // namespace

std::vector<CornerNodes> match_mesh(const std::string& mesh, const ModalBoundary& boundary, const BodyMotion& pose,
                                    const std::vector<MeshTriangle>& triangles) {
  if (boundary.triangles().empty())
    throw InputError(code::kBodyWithoutTriangles, "mesh ", mesh, ": body \"", boundary.name(),
                     "\" of the scene has no triangles");
  Eigen::Matrix3Xd x(3, boundary.node_count());
  boundary.node_positions(pose, x);
  const Eigen::Vector3d extent = x.rowwise().maxCoeff() - x.rowwise().minCoeff();
  const double tolerance = kMeshTolerance * extent.norm();
  const NodeFinder finder(x, tolerance);

  std::map<Places, std::pair<int, Places>> by_places;  // sorted places -> triangle and its places in its own order
  for (std::size_t t = 0; t < boundary.triangles().size(); ++t) {
    const Eigen::Vector3i& nodes = boundary.triangles()[t];
    const Places places{finder.place(x.col(nodes[0])), finder.place(x.col(nodes[1])), finder.place(x.col(nodes[2]))};
    by_places[sorted(places)] = {static_cast<int>(t), places};
  }

  std::vector<CornerNodes> result;
  result.reserve(triangles.size());
  for (const MeshTriangle& triangle : triangles) {
    Places places;
    for (std::size_t k = 0; k < 3; ++k) {
      places[k] = finder.place(triangle.corners[k]);
      if (places[k] < 0)
        throw InputError(code::kMeshDiffersFromBody, "mesh ", mesh, ": corner ", text(triangle.corners[k]),
                         " of triangle ", triangle.id, " is not a node of body \"", boundary.name(),
                         "\" at its initial pose (within ", plain_text(tolerance),
                         " m). Move or scale the mesh to the body's place in the scene, or take the triangles from the "
                         "scene: fix couple/mbd/geometry");
    }
    const auto found = by_places.find(sorted(places));
    if (found == by_places.end())
      throw InputError(code::kMeshDiffersFromBody, "mesh ", mesh, ": triangle ", triangle.id, " at ",
                       text(triangle.corners[0]), " joins nodes of body \"", boundary.name(),
                       "\" that form no triangle there");
    const Eigen::Vector3i& nodes = boundary.triangles()[found->second.first];
    CornerNodes corners{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t l = 0; l < 3; ++l)
        if (found->second.second[l] == places[k]) corners[k] = nodes[static_cast<Eigen::Index>(l)];
    result.push_back(corners);
  }
  return result;
}

std::vector<int> order_after_restart(int before, int own, int after) {
  constexpr int kElsewhere = -1;
  std::vector<int> list(before + own + after, kElsewhere);
  std::iota(list.begin() + before, list.begin() + before + own, 0);
  for (std::size_t i = 0; i < list.size();) {
    if (list[i] != kElsewhere) {
      ++i;
      continue;
    }
    list[i] = list.back();
    list.pop_back();
  }
  return list;
}

}  // namespace footfall
