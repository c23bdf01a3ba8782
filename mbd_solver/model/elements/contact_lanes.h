#pragma once
// Many contacts of one body with curved ground at once: CurvedContact (theory 6.8) at places without a radius, side by side in the lanes of
// vector registers.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/model/elements/contact_law.h"
#include "mbd_solver/model/force_element.h"

namespace footfall {

class ContactLanes {
 public:
  void clear() { spring_.clear(); }
  int count() const { return static_cast<int>(spring_.size()); }
  // A place at d from Bo, in W [m], which moves with dp [m/s] besides the motion of the body as a rigid one. n, overlap > 0 [m]: of its foot.
  // spring: the number of its spring; contacts that share one are added one after the other. share: of the stiffness.
  void add(int spring, double share, const Eigen::Vector3d& d, const Eigen::Vector3d& dp, const Eigen::Vector3d& n,
           double overlap);
  // Forces of all contacts, from the motion of Bo in W and the springs' T^T xi [m], two numbers each. What follows is of these.
  void apply(const ContactLaw& law, const Eigen::Vector3d& dr, const Eigen::Vector3d& w,
             const Eigen::Ref<const Eigen::VectorXd>& springs);

  int spring(int contact) const { return spring_[contact]; }
  Eigen::Vector3d force(int contact) const;                 // on the body, in W [N]
  Eigen::Matrix<double, 6, 1> wrench() const;               // of all, about Bo, in W [N], [N m]
  double largest_overlap() const;                           // [m]
  void add_drive(Eigen::Ref<Eigen::VectorXd> rates) const;  // of springs: T^T clip(u), the mean over its contacts [m/s]
  void add_energy(const ContactLaw& law, StoredEnergy& stored, Dissipated& power);

 private:
  std::vector<int> spring_;
  Eigen::ArrayXXd
      of_;  // a row for each contact and room for a multiple of kMostLanes, whose columns are named in the source
};

}  // namespace footfall
