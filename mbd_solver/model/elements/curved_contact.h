#pragma once
// One contact of a place with a curved surface: what surface_contact.h and terrain_contact.h share of theory 6.5.
//   u = P g + P xi / tau,  P = 1 - n n^T,   f = f_n (n - mu u / sqrt(u^2 + v_s^2))

#include "mbd_solver/model/elements/contact_law.h"
#include "mbd_solver/model/force_element.h"

namespace footfall {

struct CurvedContact {
  double radius = 0.0;                               // of the place [m]
  double overlap = 0.0;                              // delta [m]
  double closing = 0.0;                              // delta' [m/s]
  Eigen::Vector3d n = Eigen::Vector3d::Zero();       // in W
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();       // dn/dp as seen from the surface, in W [1/m]
  Eigen::Vector3d g = Eigen::Vector3d::Zero();       // velocity of the contact over the surface [m/s]
  Eigen::Vector3d spring = Eigen::Vector3d::Zero();  // xi / tau in W [m/s]
  Eigen::Vector3d held = Eigen::Vector3d::Zero();    // P xi / tau [m/s]
  Eigen::Vector3d u = Eigen::Vector3d::Zero();       // [m/s]
  double inverse_speed = 0.0;                        // 1 / sqrt(u^2 + v_s^2)
  ContactLaw::Normal normal;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // on the body of the place [N]

  // held and all below it, from the values above.
  void apply(const ContactLaw& law);
  // rate: of P xi at the present normal [m/s].
  void add_energy(const ContactLaw& law, const Eigen::Vector3d& rate, StoredEnergy& stored, Dissipated& power) const;

  // Of the force, 3 x n each: by increments of positions (f_x) and by g (by_g, by_u: by u), from the derivatives of the place D, of the
  // normal N, of g (g_x) and of u (u_x) at a fixed force.
  struct Slopes {
    Eigen::Matrix3d by_u, by_g;
  };
  Slopes differentiate(const ContactLaw& law, const Eigen::Matrix3Xd& D, const Eigen::Matrix3Xd& N,
                       const Eigen::Matrix3Xd& g_x, const Eigen::Matrix3Xd& u_x, Eigen::Matrix3Xd& f_x) const;
};

}  // namespace footfall
