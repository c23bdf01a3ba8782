#pragma once
// Triangles as connected pieces: corners welded, turned alike, with the normals of faces, edges and corners.

#include <Eigen/Dense>
#include <array>
#include <memory>
#include <vector>

namespace footfall {

struct PieceTriangle {
  Eigen::Vector3i corners;
  int piece = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit vector
  // Sum of the normals of what meets at each edge (from corner k to k + 1) and at each corner, by their angles there:
  // a point is outside when it stands on their side (Baerentzen and Aanaes 2005).
  std::array<Eigen::Vector3d, 3> edge_normal, corner_normal;
  std::array<bool, 3> edge_is_border{}, corner_is_border{};
};

struct TrianglePieces {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<PieceTriangle> triangles;
  std::vector<bool> open;  // of each piece: it has a border, or cannot be turned alike
};

// Throws InputError for a triangle without area.
TrianglePieces triangle_pieces(const Eigen::Matrix3Xd& vertices, const std::vector<Eigen::Vector3i>& triangles);

// The point of a triangle that is nearest to p.
struct NearestPoint {
  Eigen::Vector3d point;
  int edge = -1;    // it stands on this edge; -1: not
  int corner = -1;  // on this corner; -1: not
};
NearestPoint nearest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& c);

// A surface that balls and points touch: planes, capsules (balls too) and triangles, in one frame. theory 6.5.
//
// Near a point p the surface tells its distance phi(p) (negative within), n = grad phi, and H = dn/dp:
//   plane      phi = n.(p - p0),                      H = 0
//   capsule    phi = |p - c| - r, c on its axis,      H = (I - n n^T [- t t^T]) / |p - c|
//   triangles  phi = +-|p - c|, c the nearest point;  H = 0 on a face, (I - n n^T - t t^T) / phi on an edge along t,
//                                                     (I - n n^T) / phi on a corner
// Outside of triangles every local minimum of the distance is a place of contact: one on each face of a groove, one on
// the edge of a ridge, and one where faces are parts of one plane. Minima whose normals differ by less than 20 degrees
// count as one, the nearest. Within, the nearest counts alone. Triangles are found by the library fcl's tree of boxes.

struct SurfaceTouch {
  double distance = 0.0;                             // phi [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // n, unit vector
  Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();    // H [1/m]
};

// Closed triangle surfaces have an outside; of an open one both sides are alike. Which side counts as outside for
// somebody: +1 that of the normals, -1 the other one, for each piece of a ContactSurface.
using SurfaceSides = std::vector<double>;

class ContactSurface {
 public:
  ContactSurface();
  ~ContactSurface();
  ContactSurface(ContactSurface&&) noexcept;

  void add_plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);  // normal: unit vector
  void add_capsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius);
  // Corners that coincide (to 1e-9 of the size) are one. Connected triangles are turned alike, closed pieces outward.
  void add_triangles(const Eigen::Matrix3Xd& vertices, const std::vector<Eigen::Vector3i>& triangles);
  bool empty() const;
  // False when nothing within this distance of the point can touch: a few comparisons.
  bool may_touch(const Eigen::Vector3d& p, double distance, const SurfaceSides& sides) const;

  // On which side of each piece the points stand: the sign of most of them. across: how far the others stand on the other
  // side, the largest distance [m]; 0 without.
  SurfaceSides sides_of(const std::vector<Eigen::Vector3d>& points, double& across) const;
  // Where a ball of radius >= 0 about p touches: distance < radius, and -distance < depth. Overwrites out.
  void touches(const Eigen::Vector3d& p, double radius, double depth, const SurfaceSides& sides,
               std::vector<SurfaceTouch>& out) const;

 private:
  struct Plane {
    Eigen::Vector3d point, normal;
  };
  struct Capsule {
    Eigen::Vector3d from, to;
    double radius;
  };
  struct Triangles;
  std::vector<Plane> planes_;
  std::vector<Capsule> capsules_;
  std::vector<std::unique_ptr<Triangles>> meshes_;
};

}  // namespace footfall
