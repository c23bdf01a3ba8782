#pragma once
// Contact of two bodies, or of a body and fixed walls: points and balls of one against the surface of the other
// (contact_surface.h), by the law of contact_law.h. Theory 6.5.
//   overlap   delta = R - phi(p),  p the point in the frame of the surface B,  n = grad phi
//   place     c = p - R n, with the relative velocity  g = v_A(c) - v_B(c) = p' - v_B(p) - R (w_A - w_B) x n
//   force     f(delta, -n.g, g - (n.g) n) on A at c, -f on B at the same c: momentum is conserved to round-off
// Every point has one spring xi (three inner states, in the frame of B) for all its contacts:
//   u_i = P_i (g_i + xi / tau),  P_i = I - n_i n_i^T,
//   xi' = mean over its contacts of clip(u_i) - P_i xi / tau, turning with B;  xi' = -xi / tau in the air.
// With one contact on a flat surface this is the law of the plane. The body with the surface is rigid.

#include <memory>
#include <vector>

#include "mbd_solver/model/elements/contact_law.h"
#include "mbd_solver/model/elements/contact_surface.h"
#include "mbd_solver/model/elements/rigid_plane.h"

namespace footfall {

// The surface that points meet, and their side of each piece. Walls become known when a run begins.
struct SurfaceSeen {
  std::shared_ptr<const ContactSurface> surface;  // null: no contact yet
  SurfaceSides sides;
};

class SurfaceContact : public ContactElement {
 public:
  struct Side {
    int slot = 0;  // of the body with the points: 0 or 1
    std::vector<ContactPoint> points;
    std::shared_ptr<const SurfaceSeen> seen;  // of the other body, in its frame
    double depth = 0.0;                       // points deeper than this within triangles do not touch [m] > 0
  };
  // body_2 may be kGround, for walls. At least one point. Throws InputError on values of the law outside their range.
  SurfaceContact(std::string name, int body_1, int body_2, std::vector<Side> sides, const ContactLaw& law);

  int state_count() const override { return law_.stick_time > 0.0 ? 3 * places_ : 0; }
  int state_block() const override { return std::min(state_count(), 3); }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(state_count()); }
  std::unique_ptr<ElementScratch> scratch(SharedCopies& shared) const override;
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;
  ContactKind kind() const override { return ContactKind::kSurface; }
  Eigen::Matrix<double, 6, 1> wrench(const ElementInput& in) const override;
  double largest_overlap(const ElementInput& in) const override;

 private:
  struct Scratch;
  struct Contact;
  bool far(const Side& side, double reach, double flexible_reach, const ElementInput& in) const;
  // use(place, contacts, count) for every point with contacts.
  template <class Use>
  void each_place(const ElementInput& in, Use use) const;
  void add_derivatives(const ElementInput& in, const Contact& at, int place, double share,
                       ElementDerivatives& out) const;
  Eigen::Vector3d spring_rate(const Contact* contacts, int count) const;  // xi' in W [m/s]

  std::vector<Side> sides_;
  std::vector<double> reach_, flexible_reach_;  // of each side's points [m], [m per unit of a]
  ContactLaw law_;
  int places_ = 0;
};

}  // namespace footfall
