#pragma once
// A surface for contact with points and balls: planes, capsules and triangles in one frame; triangles as connected pieces.
// Theory 6.5.

#include <Eigen/Dense>
#include <array>
#include <memory>
#include <vector>

namespace footfall {

// --- Triangles as connected pieces: corners welded, orientations made consistent, with the normals of faces, edges and
// corners.

struct PieceTriangle {
  Eigen::Vector3i corners;
  int piece = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit vector
  // Sum of the face normals at each edge (from corner k to k + 1) and at each corner, weighted by angle: they decide whether a
  // point is outside (Baerentzen and Aanaes 2005).
  std::array<Eigen::Vector3d, 3> edge_normal, corner_normal;
  std::array<bool, 3> edge_is_border{}, corner_is_border{};
};

struct TrianglePieces {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<PieceTriangle> triangles;
  std::vector<bool> open;  // of each piece: it has a border, or no consistent orientation
};

// Throws InputError for a triangle without area.
TrianglePieces triangle_pieces(const Eigen::Matrix3Xd& vertices, const std::vector<Eigen::Vector3i>& triangles);

// The point of a triangle that is nearest to p.
struct NearestPoint {
  Eigen::Vector3d point;
  int edge = -1;    // it lies on this edge; -1: on none
  int corner = -1;  // on this corner; -1: on none
};
NearestPoint nearest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& c);

// --- The surface. Near a point p it has the distance phi(p) (negative within), n = grad phi, and H = dn/dp:
//   plane      phi = n.(p - p0),                      H = 0
//   capsule    phi = |p - c| - r, c on its axis,      H = (I - n n^T [- t t^T]) / |p - c|
//   triangles  phi = +-|p - c|, c the nearest point;  H = 0 on a face, (I - n n^T - t t^T) / phi on an edge along t,
//                                                     (I - n n^T) / phi on a corner
// Outside of triangles every local minimum of the distance is a contact: one on each face of a groove, one on the edge of a
// ridge, and one on coplanar faces. Of minima whose normals differ by less than 20 degrees the nearest counts. Within, the
// nearest point counts alone. Triangles are found by the box tree of the library fcl.

struct SurfaceTouch {
  double distance = 0.0;                             // phi [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // n, unit vector
  Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();    // H [1/m]
};

// A triangle near a point: scratch of ContactSurface::touches().
struct NearTriangle {
  std::size_t triangle = 0;
  NearestPoint at;
  double distance = 0.0;  // of the point [m] >= 0
};

// The side that counts as outside, for each piece of a ContactSurface: +1 along the normals, -1 opposite. (Closed
// triangle surfaces have an outside; the sides of an open surface are equivalent.)
using SurfaceSides = std::vector<double>;

class ContactSurface {
 public:
  ContactSurface();
  ~ContactSurface();
  ContactSurface(ContactSurface&&) noexcept;

  void add_plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);  // normal: unit vector
  void add_capsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius);
  // Corners that coincide (to 1e-9 of the size) are welded. Connected triangles get a consistent orientation, closed pieces
  // outward.
  void add_triangles(const Eigen::Matrix3Xd& vertices, const std::vector<Eigen::Vector3i>& triangles);
  bool empty() const;
  // False if nothing within this distance of the point can touch: a few comparisons.
  bool may_touch(const Eigen::Vector3d& p, double distance, const SurfaceSides& sides) const;

  // The side of each piece where most of the points are. across: largest distance of points on the other side [m].
  SurfaceSides sides_of(const std::vector<Eigen::Vector3d>& points, double& across) const;
  // Contacts of a ball of radius >= 0 about p: distance < radius, and -distance < depth. Overwrites near and out.
  void touches(const Eigen::Vector3d& p, double radius, double depth, const SurfaceSides& sides,
               std::vector<NearTriangle>& near, std::vector<SurfaceTouch>& out) const;

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
