// Crossing triangles are found by a sweep over their boxes. Then the winding number of all shells, the sum of the solid angles
// of their triangles over 4 pi, is 1 just inside of a triangle and 0 just outside of it.

#include "mbd_solver/fe/solid_shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
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

}  // namespace

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

}  // namespace footfall
