#pragma once
// Detects collisions: the surfaces of bodies ([[boundaries]]) and the static meshes of the script must not pass through
// each other. Surfaces with a contact of the scene may touch; without one the run ends. theory 6.6.
//
// Distances are computed only for pairs that can have met. Around each surface lies a sphere (centre c, radius r). Their
// distance has changed by no more than
//   s = |d(c_2 - c_1)| + r_1 phi_1 + r_2 phi_2 + (modes),   phi: angle by which a body has turned,
// since a lower bound d of it was found: while s < d they have not met. Otherwise d is found again, from the
// spheres where they are far apart; where the motion since the last sample exceeds both distances together, it is
// halved (conservative advancement). Between two samples each body moves on a straight line and turns uniformly. Bodies that
// have touched at the earlier sample are left to their contact, which bends a path that samples do not show.

#include <string>
#include <vector>

#include "coupler/messages.h"
#include "mbd_solver/model/elements/surface_model.h"
#include "mbd_solver/session/observe/sampler.h"

namespace footfall {

class CollisionWatch {
 public:
  // start: of the mechanism, as assembled. walls: of the script, empty without grains.
  CollisionWatch(const Scene& scene, const Mechanism& mechanism, const std::vector<StaticWall>& walls,
                 const Kinematics& start);

  bool empty() const { return pairs_.empty(); }
  // Pairs that overlap at the start are taken as intended and left out: one line each, for the user.
  const std::vector<std::string>& notes() const { return notes_; }
  void remove_walls(const std::vector<std::string>& names);
  // The state in which a run begins or resumes.
  void begin(const Kinematics& kinematics);
  // Throws NumericalError, naming both surfaces, time and place, where two have met without contact.
  void check(const Subject& subject, const Sample& sample);

 private:
  struct Surface {
    std::string name;
    int body = kGround;               // kGround: a wall
    const ModalBoundary* boundary;    // null for a wall
    std::vector<SurfaceModel> parts;  // triangles, and beams of each radius
    Eigen::Vector3d centre;           // of the sphere around it, in its frame [m]
    double radius = 0.0;              // [m]
    double modal_reach = 0.0;         // largest |Phi| of a node [m per unit of a]
    Eigen::VectorXd modes;            // modal coordinates of the present shape of the parts
  };
  struct PairPose {
    FramePose first, second;   // in W
    Eigen::VectorXd a_1, a_2;  // modes

    FramePose pose() const;  // of the second in the frame of the first
  };
  struct Pair {
    std::size_t first = 0, second = 0;  // of surfaces_; the second is a body
    Handle<ContactElement> contact;     // between them, if there is one
    bool touched = false;               // it acted at the last sample
    double gap = 0.0;                   // at `measured`, not larger than the true one [m]
    PairPose measured, last;            // where the gap was found; at the last sample
  };
  void add_body(const BodyBoundary& entry);
  void add_wall(const StaticWall& wall);
  static void enclose(Surface& surface);
  void deform(Surface& surface, const Eigen::VectorXd& a);
  PairPose place(const Pair& pair, const Kinematics& kinematics) const;
  double travel(const Pair& pair, const PairPose& from, const PairPose& to) const;
  double sphere_distance(const Pair& pair, const PairPose& at) const;
  SurfaceGap gap(const Pair& pair, const PairPose& at);
  bool may_have_passed(const Pair& pair, const PairPose& now) const;
  bool met_between(const Pair& pair, const PairPose& from, double gap_from, const PairPose& to, double gap_to,
                   SurfaceGap& met);
  [[noreturn]] void report(const Pair& pair, const Sample& sample, const Eigen::Vector3d& place) const;

  std::vector<Surface> surfaces_;
  std::vector<Pair> pairs_;
  std::vector<std::string> notes_;
};

}  // namespace footfall
