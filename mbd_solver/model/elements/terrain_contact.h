#pragma once
// Contact of one body with uneven ground, at points (spheres of radius >= 0) and circular edges of the body. Theory 6.8.
// The law is the same as in RigidPlane, with the distance phi, the normal n and its derivative H = dn/dp of the terrain at the foot of
// each place: delta = radius - phi(p), the contact moves with the body at p - radius n, and slip is along the tangent plane:
//   u = P v + T s / tau, P = I - n n^T,  s' = T^T clip(u) - s / tau: the spring s [m] of a place has two inner states, along the x and y
//   axes of W turned with z to n, T = R(z -> n) [e_x e_y]; |T s| = |s|, so that its energy does not change as n turns
// A ball has one contact for each local minimum of its distance, and one with each rock; they share a spring.
// A circular edge (radius R about c, axis a) that is raised from the ground touches where its distance from the ground has its
// minimum, n.t = 0 with the tangent t = a x e: it rolls without facets, also over a step. As the body turns by dtheta and moves
// by dr the place moves along the edge by R t dpsi, (R t.H t - n.e) dpsi = -t.H dp - (t x n).dtheta; this does no work.
// Where the ground bends so much that there may be several, these are counted in the plane of the edge (edge_on_terrain.h).
// An edge that lies within 30 degrees of the ground touches at 12 places of its own. Points on its face share their springs, and on the
// field their stiffness: m points and 12 places have 12 / (12 + m) of k each, as stiff as on a plane. Where the ground is a plane within
// the reach of the body the 12 places touch alone, as in RigidPlane; rocks meet each point with k.

#include <array>
#include <memory>
#include <vector>

#include "mbd_solver/model/elements/rigid_plane.h"
#include "mbd_solver/model/terrain.h"

namespace footfall {

class TerrainContact : public ContactElement {
 public:
  // kRocks: these alone touch, not the field between them.
  enum class Touches { kAll, kRocks };
  // All points and rims on one body, at least one. Throws InputError on values outside their range.
  TerrainContact(std::string name, std::vector<ContactPoint> points, const ContactLaw& law,
                 std::shared_ptr<const Terrain> terrain, std::vector<ContactRim> rims = {},
                 Touches touches = Touches::kAll);

  int state_count() const override { return law_.stick_time > 0.0 ? 2 * place_count() : 0; }
  int state_block() const override { return std::min(state_count(), 2); }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(state_count()); }
  std::unique_ptr<ElementScratch> scratch(SharedCopies& shared) const override;
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;
  ContactKind kind() const override { return ContactKind::kTerrain; }
  Eigen::Matrix<double, 6, 1> wrench(const ElementInput& in) const override;
  double largest_overlap(const ElementInput& in) const override;
  bool touches_rock(const ElementInput& in) const;

 private:
  struct Contact;
  struct Scratch;
  struct Face {                               // of an edge
    std::array<std::vector<int>, 12> points;  // on the face, by the nearest place
    double share = 1.0;                       // of the stiffness, of each place and point
  };
  struct
      Way {  // p moves along its edge by wander [dr; dtheta] as the body moves; on a ridge n turns by turn [dr; dtheta], not by H dp
    Eigen::Matrix<double, 3, 6> wander, turn;
    bool turns = false;
    bool drags = false;  // the energy changes by drag besides n.dp, and the stiffness by growth, per [dr; dtheta]
    Eigen::Matrix<double, 1, 6> drag, growth, stretch;  // stretch: of the overlap besides -n.dp, in parts of it
    int rim = 0;
  };
  struct Candidate {   // a point that may touch
    int place, point;  // of points_; kOnRim
    double radius, share;
    bool field;            // it may touch the field
    Eigen::Vector3d s, d;  // from Bo to it, in B and in W [m]
  };
  static constexpr int kOnRim = -1;
  bool sort_onto_face(int point);
  int place_count() const;
  const Terrain::Lid& lid_over(const Eigen::Vector3d& r, double reach, Scratch& scratch) const;
  // The scratch with the contacts of this state, by places.
  Scratch& find_contacts(const ElementInput& in, Terrain::With with) const;
  void touch_all(const ElementInput& in, Terrain::With with, Scratch& scratch) const;
  bool is_known(const ElementInput& in, Terrain::With with, Scratch& scratch) const;
  void offer_own_points(const ElementInput& in, const Terrain::Lid& lid, Scratch& scratch) const;
  void offer_rim(const ElementInput& in, std::size_t index, int first_place, const Terrain::Lid& lid,
                 Scratch& scratch) const;
  void offer_face(const ElementInput& in, const Face& face, int part, int place, const Terrain::Lid& lid,
                  Scratch& scratch) const;
  void touch(const ElementInput& in, const Terrain::Lid& lid, Terrain::With with, Scratch& scratch) const;
  void touch_in_lanes(const ElementInput& in, Scratch& scratch) const;
  void touch_standing_rim(const ElementInput& in, std::size_t index, int first_place, const Terrain::Lid& lid,
                          const Eigen::Vector3d& a, const Eigen::Vector3d& centre, const Eigen::Vector3d& n, bool bends,
                          Scratch& scratch) const;
  Terrain::Foot foot_on_plane(const Terrain::Lid& lid, const Eigen::Vector3d& from_body, double above) const;
  Contact* add_contact(const ElementInput& in, const Candidate& at, const Terrain::Foot& foot, bool with_bend,
                       Scratch& scratch) const;
  void add_derivatives(const ElementInput& in, const Contact& at, double share, Scratch& scratch,
                       ElementDerivatives& out) const;
  Eigen::Vector2d spring_drive(const Contact* contacts, int count) const;

  std::vector<ContactPoint> points_;
  std::vector<ContactRim> rims_;
  std::vector<int> own_;     // points with springs of their own
  std::vector<Face> faces_;  // of each rim
  ContactLaw law_;
  std::shared_ptr<const Terrain> terrain_;
  bool field_;                   // the field touches
  double reach_ = 0.0;           // radius about Bo that encloses all undeformed spheres [m]
  double flexible_reach_ = 0.0;  // largest |S| of a point [m per unit of a]
  Eigen::VectorXd own_s_;        // of own points, one below the other: from Bo, undeformed, in B [m]
  Eigen::MatrixXd own_S_;        // and their shapes; no columns on a rigid body [m per unit of a]
};

}  // namespace footfall
