#pragma once
// A mesh to which a parser of finite-element files adds its parts (fe_mesh.cpp, gmsh_mesh.cpp).

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/base/budget.h"
#include "mbd_solver/fe/fe_mesh.h"

namespace footfall {

constexpr long kLargestId = 2000000000;  // of nodes and elements

// Corners of an element with this many nodes; 0: there is none.
inline int corners_of(int dimension, int nodes) {
  if (dimension == 1) return nodes == 2 || nodes == 3 ? 2 : 0;
  if (dimension == 2) return nodes == 3 || nodes == 6 ? 3 : nodes == 4 || nodes == 8 || nodes == 9 ? 4 : 0;
  switch (nodes) {
    case 4:
    case 10: return 4;
    case 5:
    case 13:
    case 14: return 5;
    case 6:
    case 15:
    case 18: return 6;
    case 8:
    case 20:
    case 27: return 8;
    default: return 0;
  }
}

// Names of sets keep the order of their nodes. Entries of sets are counted: sets that name sets can have any number of them.
class MeshBuilder {
 public:
  explicit MeshBuilder(const std::string& file) : entries(limit::kSetEntries, file) {}

  template <class Fail>
  void add_node(long id, const Eigen::Vector3d& x, const Fail& fail) {
    if (!mesh_.index.emplace(id, static_cast<int>(mesh_.ids.size())).second) {
      const Eigen::Vector3d& before = mesh_.points[mesh_.index.at(id)];
      if (before == x) return;
      fail("node " + std::to_string(id) + " has two places, expected each number once.");
    }
    mesh_.ids.push_back(id);
    mesh_.points.push_back(x);
  }
  // Numbers of nodes; 0 is a node on an edge that is left out. Returns the index of the element, -1 without one.
  template <class Fail>
  int add_element(int dimension, const std::vector<long>& ids, EdgeOrder order, const Fail& fail) {
    MeshElement element;
    element.dimension = dimension;
    element.corners = corners_of(dimension, static_cast<int>(ids.size()));
    element.order = order;
    if (element.corners == 0)
      fail("an element of " + std::to_string(ids.size()) + " nodes in " + std::to_string(dimension) +
           " dimensions, expected a linear or quadratic one.");
    for (std::size_t i = 0; i < ids.size(); ++i)
      element.nodes.push_back(ids[i] == 0 && i >= static_cast<std::size_t>(element.corners) ? -1 : node(ids[i], fail));
    mesh_.elements.push_back(std::move(element));
    return static_cast<int>(mesh_.elements.size()) - 1;
  }
  template <class Fail>
  int node(long id, const Fail& fail) const {
    const auto found = mesh_.index.find(id);
    if (found == mesh_.index.end()) fail("unknown node " + std::to_string(id) + ", expected a node in the file.");
    return found->second;
  }
  void add_to_set(const std::string& name, int node) {
    entries.take();
    if (node >= 0 && seen_[name].insert(node).second) mesh_.sets[name].push_back(node);
  }
  void add_element_to_set(const std::string& name, int element) {
    if (element < 0) return;
    for (const int n : mesh_.elements[element].nodes) add_to_set(name, n);
  }
  FeMesh& mesh() { return mesh_; }

  ReadBudget entries;

 private:
  FeMesh mesh_;
  std::map<std::string, std::set<int>> seen_;
};

FeMesh gmsh_mesh(const std::string& bytes, const std::string& file);

}  // namespace footfall
