#pragma once
// The boundary of one body on a soil without grains: every facet feels the stress of a SoilLaw at its place. Theory 6.7.
// The ground keeps what has touched it (SoilGround): where a facet has left its place, its print stays there, with its depth,
// for any facet that comes later. The memory changes between integration steps, in remember().
// On uneven ground the depth of a facet is its distance below the terrain along its normal, and x, y, down are axes at the foot
// that the facet remembers: the way slid since then is counted along the tangent plane there. In a step that moves a facet by s
// over ground of curvature kappa, directions err by kappa s. Prints are found by x and y of W.
// A facet whose face reaches up to the height H above it counts by the share min(1, z / H) that is in the ground: exact for a stress
// that grows with the depth, and less than H / 2 of a face short for a constant stress. H is the mean of the heights h_c > 0 of the
// other corners of its triangles, weighted by h_c^2.

#include <memory>
#include <unordered_map>
#include <vector>

#include "mbd_solver/model/elements/contact_element.h"
#include "mbd_solver/model/elements/soil_law.h"
#include "mbd_solver/model/terrain.h"

namespace footfall {

struct SoilFacet {
  Marker marker;                                      // on the body
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // out of the body, in B
  double area = 0.0;                                  // [m2]
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  // in W at the start [m]: in the ground it is in its own print then
  std::vector<Eigen::Vector3d>
      corners;  // from it to the other corners of its triangles, in B [m]; none: it counts as a whole
};

// Prints that facets have left, in the axes of the ground.
class SoilGround {
 public:
  struct Print {
    Eigen::Vector2d place;  // [m]
    double depth;           // [m]
  };
  // cell [m]: the largest distance at which a print is found.
  explicit SoilGround(double cell) : cell_(cell) {}

  void leave(const Eigen::Vector2d& place, double depth, double apart);  // joined with one nearer than `apart` [m]
  double depth_at(const Eigen::Vector2d& place, double within) const;    // of the nearest print [m]; 0: there is none
  const std::vector<Print>& prints() const { return prints_; }
  void restore(std::vector<Print> prints);

 private:
  long key(double x, double y) const;
  int nearest(const Eigen::Vector2d& place, double within) const;  // -1: none

  double cell_;
  std::vector<Print> prints_;
  std::unordered_map<long, std::vector<int>> cells_;
};

class SoilContact : public ContactElement, public Remembering {
 public:
  struct Surface {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();    // of the undisturbed ground, in W [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // out of the ground
    std::shared_ptr<const Terrain> terrain;             // uneven ground, instead of point and normal
  };
  // Facets of one body, at least one. ground: without prints, shared by the elements that meet the same soil. keeps_ground: this
  // element saves its prints, for all that share it.
  SoilContact(std::string name, std::vector<SoilFacet> facets, bool two_sided, const Surface& place,
              std::shared_ptr<const SoilLaw> law, std::shared_ptr<const SoilGround> ground, bool keeps_ground);

  std::unique_ptr<ElementScratch> scratch(SharedCopies& shared) const override;
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;

  void recall(const double*& memory, ElementScratch& scratch) const override;
  void save_memory(const ElementScratch& scratch, std::vector<double>& out) const override;
  bool remember(const ElementInput& in) const override;

  ContactKind kind() const override { return ContactKind::kSoil; }
  Eigen::Matrix<double, 6, 1> wrench(const ElementInput& in) const override;
  double largest_overlap(const ElementInput& in) const override;
  double area() const { return area_; }  // of all facets [m2]
  const std::vector<SoilFacet>& facets() const { return facets_; }
  bool two_sided() const { return two_sided_; }

 private:
  struct Scratch;
  struct Touch;
  bool far(const BodyKinematics& body, const Scratch& scratch) const;
  double size_of(const SoilFacet& facet) const;  // [m]
  // What is in the ground of the face of a facet at this depth. down: unit vector in W.
  struct Covered {
    double share = 1.0;
    double by_depth = 0.0;                              // [1/m]
    Eigen::Vector3d by_turn = Eigen::Vector3d::Zero();  // by a small turn of the body, in W
  };
  static Covered covered(const SoilFacet& facet, const BodyKinematics& body, const Eigen::Vector3d& down, double depth);
  void look_below(std::size_t facet, const Eigen::Vector3d& place, Scratch& scratch) const;
  SoilPoint point_of(const ElementInput& in, const SoilFacet& facet, const MovingPoint& p) const;
  // Of the ground where a facet is; rows: x, y and down in W, and the derivatives of the place by p.
  struct Frame {
    Eigen::Matrix3d axes, by_p;
    Eigen::Vector3d spot;  // x and y of its foot, depth [m]
  };
  SoilPoint point_on_terrain(const ElementInput& in, std::size_t facet, const MovingPoint& p, const Scratch& scratch,
                             Frame& frame) const;
  template <class Use>
  void each_touch(const ElementInput& in, SoilLaw::With with, Use use) const;

  std::vector<SoilFacet> facets_;
  bool two_sided_;
  Eigen::Vector3d point_;
  Eigen::Matrix3d axes_;  // rows: x, y and down of the ground, in W
  std::shared_ptr<const Terrain> terrain_;
  std::shared_ptr<const SoilLaw> law_;
  std::shared_ptr<const SoilGround> ground_;
  bool keeps_ground_;
  double reach_ = 0.0;           // radius about Bo that encloses all undeformed facets [m]
  double flexible_reach_ = 0.0;  // as RigidPlane
  double area_ = 0.0;
};

}  // namespace footfall
