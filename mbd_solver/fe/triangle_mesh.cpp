// Welding by cells, defects from the uses of each directed edge, volume integrals as sums over tetrahedra.

#include "mbd_solver/fe/triangle_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

using Eigen::Vector3d;
using Box = Eigen::AlignedBox3d;

constexpr double kTouching = 1e-6;   // of the mesh's size
constexpr double kNoVolume = 1e-12;  // of its cube
constexpr double kMostAngles = 2e7;  // solid angles to be computed; more triangles are sampled
constexpr std::size_t kNamed = 10;   // numbers in one message

// The mesh about its middle, so that a place far from the origin costs no digits.
struct Solid {
  std::vector<std::array<Vector3d, 3>> triangles;
  std::vector<Box> boxes;
  double size = 0.0;  // [m]
};

struct Shell {
  std::vector<int> triangles;
  double volume = 0.0;  // negative: faces inward
  Box box;
};

std::string numbers_in(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::string text = numbers.size() == 1 ? "triangle " : "triangles ";
  for (std::size_t i = 0; i < std::min(numbers.size(), kNamed); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  if (numbers.size() > kNamed) text += " and " + std::to_string(numbers.size() - kNamed) + " more";
  return text;
}

int set_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    int& above = parent[i];
    above = parent[above];
    i = above;
  }
  return i;
}

// Triangles connected by edges; shells that only share a corner are two.
std::vector<Shell> shells_of(const TriangleMesh& mesh, const Solid& solid) {
  std::vector<int> parent(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::map<std::pair<int, int>, int> users;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = mesh.triangles[t](i), b = mesh.triangles[t]((i + 1) % 3);
      const auto [user, fresh] = users.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(t));
      if (!fresh) parent[set_of(parent, static_cast<int>(t))] = set_of(parent, user->second);
    }
  std::map<int, Shell> shells;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Shell& shell = shells[set_of(parent, static_cast<int>(t))];
    const std::array<Vector3d, 3>& p = solid.triangles[t];
    shell.triangles.push_back(static_cast<int>(t));
    shell.volume += p[0].dot(p[1].cross(p[2])) / 6.0;
    shell.box.extend(solid.boxes[t]);
  }
  std::vector<Shell> result;
  for (auto& shell : shells) result.push_back(std::move(shell.second));
  return result;
}

// --- Crossing triangles.

// The edge from p to q passes through the triangle, with more than `gap` [m] on both sides of its plane and inside of its
// edges.
bool pierces(const Vector3d& p, const Vector3d& q, const std::array<Vector3d, 3>& t, double gap) {
  const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  const double above = normal.dot(p - t[0]), below = normal.dot(q - t[0]);
  if (!((above > gap && below < -gap) || (above < -gap && below > gap))) return false;
  const Vector3d x = p + above / (above - below) * (q - p);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d edge = t[(i + 1) % 3] - t[i];
    if (!(normal.dot(edge.cross(x - t[i])) > gap * edge.norm())) return false;
  }
  return true;
}

bool cross(const TriangleMesh& mesh, const Solid& solid, int a, int b, double gap) {
  for (const auto& [one, other] : {std::pair{a, b}, std::pair{b, a}}) {
    const Eigen::Vector3i &mine = mesh.triangles[one], &its = mesh.triangles[other];
    const auto shared = [&](int n) { return n == its(0) || n == its(1) || n == its(2); };
    const std::array<Vector3d, 3>& p = solid.triangles[one];
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3;
      if (shared(mine(i)) || shared(mine(next))) continue;
      if (pierces(p[i], p[next], solid.triangles[other], gap)) return true;
    }
  }
  return false;
}

// Numbers of triangles that pass through each other, along the axis on which their boxes overlap least.
std::vector<int> crossing(const TriangleMesh& mesh, const Solid& solid) {
  Vector3d sum = Vector3d::Zero();
  Box all;
  for (const Box& box : solid.boxes) {
    sum += box.sizes();
    all.extend(box);
  }
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (sum(i) * all.sizes()[axis] < sum(axis) * all.sizes()[i]) axis = i;
  std::vector<int> order(solid.boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto box_of = [&](int t) -> const Box& { return solid.boxes[t]; };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::pair(box_of(a).min()[axis], a) < std::pair(box_of(b).min()[axis], b); });
  std::vector<int> found, open;
  for (const int t : order) {
    const Box& box = box_of(t);
    open.erase(std::remove_if(open.begin(), open.end(),
                              [&](int other) { return box_of(other).max()[axis] < box.min()[axis]; }),
               open.end());
    for (const int other : open)
      if (box.intersects(box_of(other)) && cross(mesh, solid, t, other, kTouching * solid.size))
        found.insert(found.end(), {t, other});
    open.push_back(t);
  }
  return found;
}

// --- Winding numbers.

// Solid angle of a triangle seen from x over 4 pi (van Oosterom and Strackee 1983), positive from inside.
double angle_of(const std::array<Vector3d, 3>& t, const Vector3d& x) {
  const Vector3d a = t[0] - x, b = t[1] - x, c = t[2] - x;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb) / (2.0 * kPi);
}

// How often the other shell winds about x; far outside of its box not at all.
int winding(const Solid& solid, const Shell& shell, const Vector3d& x) {
  if (!shell.box.contains(x)) return 0;
  double sum = 0.0;
  for (const int t : shell.triangles) sum += angle_of(solid.triangles[t], x);
  return static_cast<int>(std::lround(sum));
}

// Points a little inside and outside of a triangle: under its middle and near its corners.
std::vector<Vector3d> samples(const std::array<Vector3d, 3>& t) {
  std::vector<Vector3d> points = {(t[0] + t[1] + t[2]) / 3.0};
  for (std::size_t i = 0; i < 3; ++i) points.push_back(0.98 * t[i] + 0.01 * (t[(i + 1) % 3] + t[(i + 2) % 3]));
  return points;
}

struct Misplaced {
  std::size_t sampled = 0;
  std::vector<int> twice, inward;  // triangles next to points within the solid twice, or less than zero times
};

// The misplaced triangles of shell `own` among the triangles near other shells.
Misplaced misplaced(const Solid& solid, const std::vector<Shell>& shells, std::size_t own) {
  const Shell& shell = shells[own];
  std::vector<const Shell*> others;
  double size = 0.0;
  for (std::size_t i = 0; i < shells.size(); ++i)
    if (i != own && shells[i].box.intersects(shell.box)) {
      others.push_back(&shells[i]);
      size += static_cast<double>(shells[i].triangles.size());
    }
  const double angles = 8.0 * size * static_cast<double>(shell.triangles.size()) * static_cast<double>(shells.size());
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(angles / kMostAngles)));
  const double beside = 3.0 * kTouching * solid.size;
  Misplaced result;
  for (std::size_t k = 0; k < shell.triangles.size(); k += stride) {
    const int n = shell.triangles[k];
    const std::array<Vector3d, 3>& t = solid.triangles[n];
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    bool twice = false, inward = false;
    for (const Vector3d& x : samples(t))
      for (const double side : {-1.0, 1.0}) {
        int w = (side < 0.0) == (shell.volume > 0.0) ? (side < 0.0 ? 1 : -1) : 0;  // of the own shell
        for (const Shell* other : others) w += winding(solid, *other, x + side * beside * normal);
        twice = twice || w > 1;
        inward = inward || w < 0;
      }
    ++result.sampled;
    if (twice) result.twice.push_back(n);
    if (inward) result.inward.push_back(n);
  }
  return result;
}

// Whether the closed shells of a mesh bound a solid: none crosses another or itself, and every point is within it once
// or not at all. Crossing triangles are found by a sweep over their boxes. Then the winding number of all shells, the
// sum of the solid angles of their triangles over 4 pi, is 1 just inside of a triangle and 0 just outside of it.
// mesh: closed and oriented (mesh_findings). A shell within another that faces inward is a cavity, one within a cavity a
// solid; shells may touch. Surfaces nearer than a millionth of the mesh's size count as touching.
// Throws InputError beginning with `where`, with numbers of triangles: a shell encloses nothing, faces inward, lies within
// another and faces outward as well, or triangles of shells that overlap.
void require_solid(const TriangleMesh& mesh, const std::string& where) {
  const auto refuse = [&](const std::string& what) { throw InputError(code::kMeshDefect, where + ": " + what); };
  Box all;
  for (const Eigen::Vector3i& t : mesh.triangles)
    for (const int n : t) all.extend(mesh.vertices[n]);
  Solid solid;
  solid.size = all.diagonal().norm();
  for (const Eigen::Vector3i& t : mesh.triangles) {
    std::array<Vector3d, 3>& p = solid.triangles.emplace_back();
    Box& box = solid.boxes.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = mesh.vertices[t(static_cast<Eigen::Index>(i))] - all.center();
      box.extend(p[i]);
    }
  }
  const std::vector<Shell> shells = shells_of(mesh, solid);
  for (const Shell& shell : shells)
    if (!(std::abs(shell.volume) > kNoVolume * std::pow(solid.size, 3)))
      refuse("the surface encloses no volume at " + numbers_in(shell.triangles) + "; expected a solid body");
  const std::vector<int> crosses = crossing(mesh, solid);
  if (!crosses.empty())
    refuse(numbers_in(crosses) +
           " pass through each other, so that a part of the volume counts twice; expected shells that do not overlap. "
           "Unite the solids in the program that made them");
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const Shell& shell = shells[i];
    const Misplaced wrong = misplaced(solid, shells, i);
    if (!wrong.inward.empty())
      refuse(
          "the surface faces inward at " + numbers_in(wrong.inward) + " (volume " + number_text(shell.volume) +
          " m3); expected corners counter-clockwise seen from outside, and inward only around a cavity within another "
          "shell. Flip its normals");
    if (!wrong.twice.empty() && wrong.twice.size() == wrong.sampled)
      refuse(
          "the shell of " + numbers_in(shell.triangles) +
          " lies within another one and faces outward as well, so that its volume counts twice; flip its normals if it "
          "is a cavity, else remove it");
    if (!wrong.twice.empty())
      refuse(
          numbers_in(wrong.twice) +
          " lie within another shell, so that a part of the volume counts twice; expected shells that do not overlap. "
          "Unite the solids in the program that made them");
  }
}

}  // namespace

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
