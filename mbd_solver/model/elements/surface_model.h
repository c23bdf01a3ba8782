#pragma once
// A surface for distances to other surfaces: triangles or segments of beams, with a thickness around them. Distances by the
// library fcl (bounding volume trees of oriented boxes and swept spheres).

#include <Eigen/Dense>
#include <memory>
#include <vector>

namespace footfall {

// The pose of one frame in another: p_A = p + R p_B.
struct FramePose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  // [m]
};

struct SurfaceGap {
  double distance = 0.0;  // [m]; 0 or less: the surfaces cross or touch
  Eigen::Vector3d place =
      Eigen::Vector3d::Zero();  // between the nearest points, or in both surfaces; in the first frame
};

class SurfaceModel {
 public:
  // vertices: 3 x n in the frame of the surface [m]. A triangle with two equal vertices is a line. thickness: all points
  // within this distance belong to the surface [m] >= 0.
  SurfaceModel(const Eigen::Matrix3Xd& vertices, std::vector<Eigen::Vector3i> triangles, double thickness = 0.0);
  ~SurfaceModel();
  SurfaceModel(SurfaceModel&&) noexcept;

  void move(const Eigen::Matrix3Xd& vertices);  // new positions of the vertices
  // Bounding sphere at construction: centre in the frame of the surface, and radius [m].
  const Eigen::Vector3d& centre() const { return centre_; }
  double radius() const { return radius_; }

  // Smallest distance between a and b, with the pose of b in a.
  friend SurfaceGap gap_between(SurfaceModel& a, SurfaceModel& b, const FramePose& b_in_a);

 private:
  std::vector<Eigen::Vector3d> corners(const Eigen::Matrix3Xd& vertices) const;

  struct Tree;
  Tree& tree();  // built at its first use: surfaces that never approach each other need none
  std::vector<Eigen::Vector3i> triangles_;
  double thickness_;
  Eigen::Vector3d centre_;
  double radius_ = 0.0;
  std::vector<Eigen::Vector3d> corners_;  // of tree_, until it is built
  std::unique_ptr<Tree> tree_;
};

}  // namespace footfall
