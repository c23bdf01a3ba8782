#pragma once
// A surface whose distance from others is asked for: triangles or the segments of beams, with a thickness around them.
// Distances by the library fcl (bounding volume trees of oriented boxes and swept spheres).

#include <Eigen/Dense>
#include <memory>
#include <vector>

namespace footfall {

// Where one frame stands in another: p_A = p + R p_B.
struct FramePose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  // [m]
};

struct SurfaceGap {
  double distance = 0.0;                            // [m]; 0 or less: the surfaces cross or touch
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // between the nearest points, or in both, in the first one's frame
};

class SurfaceModel {
 public:
  // vertices: 3 x n in the frame of the surface [m]. Each triangle names three of them; one that names two different
  // ones only is the line between them. thickness: all points so near belong to the surface [m] >= 0.
  SurfaceModel(const Eigen::Matrix3Xd& vertices, std::vector<Eigen::Vector3i> triangles, double thickness = 0.0);
  ~SurfaceModel();
  SurfaceModel(SurfaceModel&&) noexcept;

  void move(const Eigen::Matrix3Xd& vertices);  // the same triangles with their vertices elsewhere
  // The sphere that holds all of it as it was made: centre in the frame of the surface, and radius [m].
  const Eigen::Vector3d& centre() const { return centre_; }
  double radius() const { return radius_; }

  // Smallest distance between a and b; b stands in the frame of a as b_in_a says.
  friend SurfaceGap gap_between(const SurfaceModel& a, const SurfaceModel& b, const FramePose& b_in_a);

 private:
  std::vector<Eigen::Vector3d> corners(const Eigen::Matrix3Xd& vertices) const;

  struct Tree;
  Tree& tree() const;  // made when it is first asked for: surfaces that never come near each other need none
  std::vector<Eigen::Vector3i> triangles_;
  double thickness_;
  Eigen::Vector3d centre_;
  double radius_ = 0.0;
  mutable std::vector<Eigen::Vector3d> corners_;  // of tree_, until it is made
  mutable std::unique_ptr<Tree> tree_;
};

}  // namespace footfall
