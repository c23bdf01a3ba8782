#pragma once
// Contact of one body with a rigid plane, at points (spheres of radius >= 0) and circular edges of the body. Theory 6.4.
//   overlap   delta = radius - n.(p - p0), contact while delta > 0 at c = p - radius n, moving with p and w
//   normal    f_n = k delta^1.5 g(d delta'),  g(u) = 1 + u for u >= 0, exp(u) for u < 0:
//             Hunt-Crossley damping while closing, never tensile
//   friction  f_t = -mu f_n u / sqrt(u^2 + v_s^2),  u = v_t + xi / tau,
//             xi' = clip(u) - xi / tau,  clip(u) = u where |u| <= 10 v_s, else 10 v_s u / |u|;  xi' = -xi / tau in the air
// Each place has a spring xi [m] (two inner states). During stick xi' = v_t: the spring replaces creep, and v_t decays to
// zero within tau. The spring bears up to 99.5 % of mu f_n; sliding friction is mu f_n. tau = 0: no springs, u = v_t, and
// stick becomes creep.
// A circular edge (radius R about c, axis a; rigid bodies) touches at m places, counted from the lowest:
//   p_k = c + R e_k,  e_k = cos(2 pi k/m) e_0 + sin(2 pi k/m) a x e_0,  e_0 = -(n - (n.a) a)/s,  s = |n x a|.
// The places remain at the plane while the body rolls, so that a cylinder rolls smoothly. delta_k depends on height and
// tilt s alone and is the same for k and -k: the motion of p_k along the edge does no work.
// Restitution e of an impact at speed v depends on d v alone:
//   d v - ln(1 + d v) = (e d v - 1) exp(e d v) + 1.
// Power: damping k delta^1.5 (g - 1) delta' >= 0; friction -f_t.v_t - d(stored)/dt, where the springs store
//   mu k delta^1.5 tau v_s (sqrt(1 + (xi / (tau v_s))^2) - 1),
// so that it is >= 0 except while the normal force grows on a deflected spring: at least -10 tau v_s mu d(f_n)/dt.

#include <algorithm>
#include <vector>

#include "mbd_solver/model/elements/contact_element.h"
#include "mbd_solver/model/elements/contact_law.h"

namespace footfall {

struct ContactPoint {
  Marker marker;        // on the body; its axes are not used
  double radius = 0.0;  // [m] >= 0
};

struct ContactRim {
  Marker marker;        // centre; its z axis is the circle's. On a rigid body
  double radius = 0.0;  // [m] > 0
};

class RigidPlane : public ContactElement {
 public:
  struct Parameters : ContactLaw {                      // of each point
    Eigen::Vector3d point = Eigen::Vector3d::Zero();    // p0, any point of the plane, in W [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // n, out of the ground
  };
  // All points and rims on one body, at least one. Throws InputError on values outside their range.
  RigidPlane(std::string name, std::vector<ContactPoint> points, const Parameters& parameters,
             std::vector<ContactRim> rims = {});

  int state_count() const override { return parameters_.stick_time > 0.0 ? 2 * place_count() : 0; }
  int state_block() const override { return std::min(state_count(), 2); }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(state_count()); }
  std::unique_ptr<ElementScratch> scratch(SharedCopies& shared) const override;
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;
  ContactKind kind() const override { return ContactKind::kPlane; }
  Eigen::Matrix<double, 6, 1> wrench(const ElementInput& in) const override;
  double largest_overlap(const ElementInput& in) const override;

 private:
  struct Scratch;
  struct Frame;
  struct Contact;
  bool far(const BodyKinematics& body) const;  // bounding sphere clear of the plane
  int place_count() const;
  void apply_law(const ElementInput& in, const Frame& frame, const Eigen::Vector3d& ds, Contact& at) const;
  template <class Use>
  void each_contact(const ElementInput& in, Use use) const;  // use(contact, frame) for every contact
  template <class Use>
  void each_contact_of_rim(const ElementInput& in, const Frame& frame, const ContactRim& rim, int first_place,
                           Use use) const;

  std::vector<ContactPoint> points_;
  std::vector<ContactRim> rims_;
  Parameters parameters_;
  Eigen::VectorXd s_;                     // of all points from Bo in B, undeformed [m]
  Eigen::MatrixXd S_;                     // modes there
  Eigen::Matrix<double, 3, 2> tangents_;  // columns span the plane; xi is in these
  double reach_ = 0.0;                    // radius about Bo that encloses all undeformed spheres [m]
  double flexible_reach_ = 0.0;           // largest |S| of a point: reach grows by this times |a| [m per unit of a]
};

}  // namespace footfall
