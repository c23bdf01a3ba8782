#pragma once
// Nothing passes in silence: the surfaces of bodies ([[boundaries]]) and the static meshes of the script must not go
// through each other. What a contact of the scene holds may touch; what holds nothing ends the run. theory 6.6.
//
// A pair is looked at only when it can have met. Around each surface lies a sphere (centre c, radius r). Seen from the
// first of the two, no point of the second has moved by more than
//   s = |dc_2| + r_2 ||dR||_F / sqrt(2) + (modes),   dc_2, dR: change of the place of its centre and of its attitude,
// since a distance d was found that is not larger than theirs: while s < d nothing has met. Otherwise d is found anew,
// between the spheres where they stand well apart; and where the last sample and this one are farther apart than both
// distances together, the way between them is halved (conservative advancement).

#include <string>
#include <vector>

#include "coupler/messages.h"
#include "mbd_solver/model/elements/surface_model.h"
#include "mbd_solver/run/observe/sampler.h"

namespace footfall {

class CollisionWatch {
 public:
  // start: of the mechanism, as assembled. walls: of the script, empty without grains. Both must not change afterwards.
  CollisionWatch(const Scene& scene, const Mechanism& mechanism, const std::vector<StaticWall>& walls,
                 const Kinematics& start);

  bool watches_nothing() const { return pairs_.empty(); }
  // Pairs that overlap at the start are meant to, and left out: one line each, for the user.
  const std::vector<std::string>& notes() const { return notes_; }
  // Walls that are no longer there.
  void forget_walls(const std::vector<std::string>& names);
  // Where a run begins, or goes on: the way there is not looked at.
  void begin(const Kinematics& kinematics);
  // Throws NumericalError, naming both, time and place, where two have met that nothing holds apart.
  void look(const Subject& subject, const Sample& sample);

 private:
  struct Surface {
    std::string name;
    int body = kGround;               // kGround: a wall
    const ModalBoundary* boundary;    // null for a wall
    std::vector<SurfaceModel> parts;  // triangles, and beams of each radius
    Eigen::Vector3d centre;           // of the sphere around it, in its frame [m]
    double radius = 0.0;              // [m]
    double modal_reach = 0.0;         // largest |Phi| of a node [m per unit of a]
    Eigen::VectorXd bent;             // modal coordinates at which the parts stand
  };
  struct Place {
    FramePose pose;            // of the second in the frame of the first
    Eigen::VectorXd a_1, a_2;  // modes
  };
  struct Pair {
    std::size_t first = 0, second = 0;  // of surfaces_; the second is a body
    int contact = -1;                   // force element that holds them apart; -1: none
    double gap = 0.0;                   // at `seen`, not larger than the true one [m]
    Place seen, last;                   // when the gap was found; at the last sample
  };
  void add_body(const BodyBoundary& entry);
  void add_wall(const StaticWall& wall);
  static void surround(Surface& surface);
  void bend(Surface& surface, const Eigen::VectorXd& a);
  Place place(const Pair& pair, const Kinematics& kinematics) const;
  double travel(const Pair& pair, const Place& from, const Place& to) const;
  double between_spheres(const Pair& pair, const Place& at) const;
  SurfaceGap gap(const Pair& pair, const Place& at);
  bool may_have_passed(const Pair& pair, const Place& now) const;
  bool met_on_the_way(const Pair& pair, const Place& from, double gap_from, const Place& to, double gap_to,
                      SurfaceGap& met);
  [[noreturn]] void tell(const Pair& pair, const Sample& sample, const Eigen::Vector3d& place) const;

  std::vector<Surface> surfaces_;
  std::vector<Pair> pairs_;
  std::vector<std::string> notes_;
};

}  // namespace footfall
