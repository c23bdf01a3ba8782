// Faces that belong to one solid only; nodes on edges are found by the corners of the edge.

#include "mbd_solver/fe/mesh_skin.h"

#include <algorithm>
#include <array>
#include <map>

namespace footfall {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

using Edges = std::vector<std::array<int, 2>>;

// Corners of the nodes on edges, in the order of the code.
const Edges& edges_of(int dimension, int corners, EdgeOrder order) {
  static const Edges kTri = {{0, 1}, {1, 2}, {2, 0}}, kQuad = {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, kLine = {{0, 1}};
  static const Edges kTet = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  static const Edges kTetGmsh = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {2, 3}, {1, 3}};
  static const Edges kPyramid = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
  static const Edges kPyramidGmsh = {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}};
  static const Edges kWedge = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
  static const Edges kWedgeNastran = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 4}, {2, 5}, {3, 4}, {4, 5}, {5, 3}};
  static const Edges kWedgeGmsh = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}};
  static const Edges kBrick = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                               {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  static const Edges kBrickNastran = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5},
                                      {2, 6}, {3, 7}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  static const Edges kBrickGmsh = {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3},
                                   {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
  if (dimension == 1) return kLine;
  if (dimension == 2) return corners == 3 ? kTri : kQuad;
  switch (corners) {
    case 4: return order == kGmsh ? kTetGmsh : kTet;
    case 5: return order == kGmsh ? kPyramidGmsh : kPyramid;
    case 6: return order == kGmsh ? kWedgeGmsh : order == kNastran ? kWedgeNastran : kWedge;
    default: return order == kGmsh ? kBrickGmsh : order == kNastran ? kBrickNastran : kBrick;
  }
}

using Faces = std::vector<std::vector<int>>;

const Faces& faces_of(int corners) {
  static const Faces kTet = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  static const Faces kPyramid = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  static const Faces kWedge = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  static const Faces kBrick = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  switch (corners) {
    case 4: return kTet;
    case 5: return kPyramid;
    case 6: return kWedge;
    default: return kBrick;
  }
}

}  // namespace

std::vector<Vector3i> skin_of(const FeMesh& mesh) {
  const bool solid =
      std::any_of(mesh.elements.begin(), mesh.elements.end(), [](const MeshElement& e) { return e.dimension == 3; });
  struct Face {
    const MeshElement* element;
    std::vector<int> corners;  // local numbers
    int uses = 0;
  };
  std::map<std::vector<int>, std::size_t> seen;
  std::vector<Face> faces;
  const auto add = [&](const MeshElement& element, std::vector<int> corners) {
    std::vector<int> key;
    for (const int c : corners) key.push_back(element.nodes[c]);
    std::sort(key.begin(), key.end());
    key.erase(std::unique(key.begin(), key.end()), key.end());
    if (key.size() < 3) return;  // of a collapsed element
    const auto [entry, fresh] = seen.try_emplace(key, faces.size());
    if (fresh) faces.push_back({&element, std::move(corners), 0});
    ++faces[entry->second].uses;
  };
  const auto at = [&](const MeshElement& e, int local) -> const Vector3d& { return mesh.points[e.nodes[local]]; };
  for (const MeshElement& element : mesh.elements) {
    if (element.dimension == 2 && !solid)
      add(element, element.corners == 3 ? std::vector<int>{0, 1, 2} : std::vector<int>{0, 1, 2, 3});
    if (element.dimension != 3) continue;
    double volume = 0.0;  // six times; negative: nodes in the other order
    const Vector3d& o = at(element, 0);
    for (const std::vector<int>& f : faces_of(element.corners))
      for (std::size_t k = 2; k < f.size(); ++k)
        volume += (at(element, f[0]) - o).dot((at(element, f[k - 1]) - o).cross(at(element, f[k]) - o));
    for (std::vector<int> f : faces_of(element.corners)) {
      if (volume < 0.0) std::reverse(f.begin(), f.end());
      add(element, f);
    }
  }
  std::vector<Vector3i> triangles;
  for (const Face& face : faces) {
    if (solid && face.uses != 1) continue;
    const MeshElement& e = *face.element;
    std::vector<int> ring;  // corners and nodes on edges in turn; -1 where there is none
    bool all = true;
    const Edges& edges = edges_of(e.dimension, e.corners, e.order);
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const int a = face.corners[i], b = face.corners[(i + 1) % face.corners.size()];
      const auto edge = std::find_if(edges.begin(), edges.end(), [&](const auto& ab) {
        return (ab[0] == a && ab[1] == b) || (ab[0] == b && ab[1] == a);
      });
      const auto local = static_cast<std::size_t>(e.corners + (edge - edges.begin()));
      const int middle = local < e.nodes.size() ? e.nodes[local] : -1;
      all = all && middle >= 0;
      ring.push_back(e.nodes[a]);
      ring.push_back(middle);
    }
    const auto triangle = [&](int a, int b, int c) {
      if (a != b && b != c && c != a) triangles.emplace_back(a, b, c);
    };
    if (all && ring.size() == 6) {
      triangle(ring[0], ring[1], ring[5]);
      triangle(ring[1], ring[2], ring[3]);
      triangle(ring[3], ring[4], ring[5]);
      triangle(ring[1], ring[3], ring[5]);
    } else if (all) {
      triangle(ring[7], ring[0], ring[1]);
      triangle(ring[1], ring[2], ring[3]);
      triangle(ring[3], ring[4], ring[5]);
      triangle(ring[5], ring[6], ring[7]);
      triangle(ring[1], ring[3], ring[7]);
      triangle(ring[3], ring[5], ring[7]);
    } else {
      for (std::size_t k = 4; k < ring.size(); k += 2) triangle(ring[0], ring[k - 2], ring[k]);
    }
  }
  return triangles;
}

}  // namespace footfall
