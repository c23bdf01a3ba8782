// Welding by cells, defects from the uses of each directed edge, volume integrals as sums over tetrahedra.

#include "mbd_solver/fe/triangle_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/fe/solid_shells.h"
#include "mbd_solver/model/codes.h"

namespace footfall {

TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
  TriangleMesh result = mesh;
  for (Eigen::Vector3d& x : result.vertices) x = R * x + p;
  return result;
}

// Vertices are sorted into cells of the size of the tolerance; a partner is in the same or a neighbouring cell.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance) {
  FOOTFALL_DEMAND(tolerance > 0.0);
  using Cell = std::array<long, 3>;
  TriangleMesh result;
  result.notes = mesh.notes;
  std::map<Cell, std::vector<int>> cells;
  std::vector<int> number(mesh.vertices.size(), -1);
  const auto find_or_add = [&](const Eigen::Vector3d& x) {
    Cell home{};
    for (int i = 0; i < 3; ++i) home[i] = std::lround(x(i) / tolerance);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto cell = cells.find({home[0] + i, home[1] + j, home[2] + k});
          if (cell == cells.end()) continue;
          for (int candidate : cell->second)
            if ((result.vertices[candidate] - x).norm() <= tolerance) return candidate;
        }
    const int added = static_cast<int>(result.vertices.size());
    result.vertices.push_back(x);
    cells[home].push_back(added);
    return added;
  };
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Eigen::Vector3i corners;
    for (int i = 0; i < 3; ++i) {
      FOOTFALL_DEMAND(triangle(i) >= 0 && triangle(i) < static_cast<int>(mesh.vertices.size()));
      int& n = number[triangle(i)];
      if (n < 0) n = find_or_add(mesh.vertices[triangle(i)]);
      corners(i) = n;
    }
    result.triangles.push_back(corners);
  }
  return result;
}

namespace {

constexpr double kDegenerate = 1e-6;  // height over longest edge
constexpr std::size_t kListed = 10;   // numbers in one message

using Edge = std::pair<int, int>;

std::string list(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), kListed); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  if (numbers.size() > kListed) text += " and " + std::to_string(numbers.size() - kListed) + " more";
  return text;
}

std::string triangles(const std::vector<int>& numbers) {
  return (numbers.size() == 1 ? "triangle " : "triangles ") + list(numbers);
}

int root(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

// Triangles that share a vertex are one piece; returns one list of triangles per piece, largest first.
std::vector<std::vector<int>> pieces(const TriangleMesh& mesh) {
  std::vector<int> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const Eigen::Vector3i& t : mesh.triangles)
    for (int i = 1; i < 3; ++i) parent[root(parent, t(i))] = root(parent, t(0));
  std::map<int, std::vector<int>> groups;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    groups[root(parent, mesh.triangles[t](0))].push_back(static_cast<int>(t));
  std::vector<std::vector<int>> result;
  for (auto& group : groups) result.push_back(std::move(group.second));
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return result;
}

}  // namespace

std::vector<std::string> mesh_findings(const TriangleMesh& mesh, const MeshDemands& demands) {
  std::vector<std::string> findings;
  if (mesh.triangles.empty()) return {"the mesh has no triangles, expected at least one."};

  std::vector<int> invalid, degenerate, duplicate;
  std::map<std::array<int, 3>, int> seen;
  std::map<Edge, std::vector<int>> forward;  // directed edges: which triangles run along them
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3i& corner = mesh.triangles[t];
    const int number = static_cast<int>(t);
    bool valid = corner.minCoeff() >= 0 && corner.maxCoeff() < static_cast<int>(mesh.vertices.size());
    for (int i = 0; valid && i < 3; ++i) valid = mesh.vertices[corner(i)].allFinite();
    if (!valid) {
      invalid.push_back(number);
      continue;
    }
    double longest = 0.0;
    std::array<Eigen::Vector3d, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = mesh.vertices[corner(i)];
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, (p[(i + 1) % 3] - p[i]).norm());
    if (!((p[1] - p[0]).cross(p[2] - p[0]).norm() > kDegenerate * longest * longest)) {
      degenerate.push_back(number);
      continue;
    }
    std::array<int, 3> key = {corner(0), corner(1), corner(2)};
    std::sort(key.begin(), key.end());
    if (!seen.emplace(key, number).second) {
      duplicate.push_back(number);
      continue;
    }
    for (int i = 0; i < 3; ++i) forward[{corner(i), corner((i + 1) % 3)}].push_back(number);
  }
  if (!invalid.empty())
    return {triangles(invalid) + ": corner numbers or coordinates are not valid, expected numbers below " +
            std::to_string(mesh.vertices.size()) + " and finite coordinates."};
  if (!degenerate.empty())
    findings.push_back(triangles(degenerate) +
                       ": no area (a degenerate triangle), expected three corners apart. Remove it or "
                       "repair the mesh.");
  if (!duplicate.empty())
    findings.push_back(triangles(duplicate) +
                       ": the same corners as an earlier triangle (a duplicate), expected each "
                       "triangle once.");
  if (demands.connected) {
    const std::vector<std::vector<int>> found = pieces(mesh);
    if (found.size() > 1)
      findings.push_back("the mesh falls into " + std::to_string(found.size()) +
                         " disconnected pieces; expected one. The largest has " + std::to_string(found[0].size()) +
                         " triangles; the next consists of " + triangles(found[1]) +
                         ". If they should touch, weld their common vertices.");
  }
  // An edge is open if only one triangle has it, and crowded if more than two have, unless as many run one way as the other.
  std::vector<int> open, crowded, turned;
  for (const auto& [edge, users] : forward) {
    const auto opposite = forward.find({edge.second, edge.first});
    const std::size_t others = opposite == forward.end() ? 0 : opposite->second.size();
    if (users.size() == 1 && others == 0) open.push_back(users[0]);
    if (users.size() == others) continue;  // also where two shells touch
    if (users.size() + others > 2) crowded.insert(crowded.end(), users.begin(), users.end());
    if (users.size() > 1) turned.insert(turned.end(), users.begin(), users.end());
  }
  for (std::vector<int>* numbers : {&open, &crowded, &turned}) {
    std::sort(numbers->begin(), numbers->end());
    numbers->erase(std::unique(numbers->begin(), numbers->end()), numbers->end());
  }
  if (demands.closed && !open.empty())
    findings.push_back("the surface is not closed: " + triangles(open) +
                       " border on a hole, expected every edge to belong to two triangles. Close the hole or "
                       "weld vertices.");
  if (demands.closed && !crowded.empty())
    findings.push_back("the surface is not closed: " + triangles(crowded) +
                       " meet at an edge of more than two triangles, expected every edge to belong to two.");
  if (demands.oriented && !turned.empty())
    findings.push_back(triangles(turned) +
                       ": inconsistent orientation with neighbours; expected all corners counter-clockwise seen from "
                       "outside. Flip one of them.");
  return findings;
}

void check_mesh(const TriangleMesh& mesh, const MeshDemands& demands, const std::string& where) {
  std::string message;
  for (const std::string& finding : mesh_findings(mesh, demands))
    message += (message.empty() ? "" : "\n") + where + ": " + finding;
  if (!message.empty()) throw InputError(code::kMeshDefect, message);
}

namespace {

using Eigen::Vector3d;

struct Corners {
  Vector3d a, b, c;
  double volume() const { return a.dot(b.cross(c)) / 6.0; }
};

Corners corners_of(const TriangleMesh& mesh, const Eigen::Vector3i& t, const Vector3d& o) {
  const auto at = [&](int i) { return Vector3d(mesh.vertices[t(i)] - o); };
  return {at(0), at(1), at(2)};
}

Vector3d middle_of(const TriangleMesh& mesh) {
  Vector3d sum = Vector3d::Zero();  // about the first one: far from the origin a sum loses digits
  for (const Vector3d& x : mesh.vertices) sum += x - mesh.vertices[0];
  return mesh.vertices[0] + sum / static_cast<double>(mesh.vertices.size());
}

}  // namespace

MassProperties polyhedron_properties(const TriangleMesh& mesh, double density, const std::string& where) {
  if (!(density > 0.0))
    throw InputError(code::kParameterOutOfRange,
                     where + ": the density is " + number_text(density) + ", expected more than 0");
  MeshDemands demands;
  demands.closed = demands.oriented = true;
  check_mesh(mesh, demands, where);
  require_solid(mesh, where);
  const Vector3d o = middle_of(mesh);

  double volume = 0.0;
  Vector3d moment = Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Corners k = corners_of(mesh, t, o);
    const double v = k.volume();
    const Vector3d s = k.a + k.b + k.c;
    volume += v;
    moment += v / 4.0 * s;
    second += v / 20.0 * (k.a * k.a.transpose() + k.b * k.b.transpose() + k.c * k.c.transpose() + s * s.transpose());
  }
  const Vector3d p = moment / volume;
  const Eigen::Matrix3d about_centre = second - volume * p * p.transpose();
  MassProperties out;
  out.mass = density * volume;
  out.centre = o + p;
  out.inertia = density * (about_centre.trace() * Eigen::Matrix3d::Identity() - about_centre);
  return out;
}

}  // namespace footfall
