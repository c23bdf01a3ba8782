#pragma once
// One body: its inertia (rigid or modal), and its position and velocity.

#include <Eigen/Dense>
#include <memory>
#include <string>

#include "mbd_solver/model/modal_body.h"
#include "mbd_solver/model/modal_inertia.h"

namespace footfall {

inline constexpr int kGround = -1;  // body index of the inertial frame W

// Position and velocity of one body. q = [r; L; a], v = [dr; w; da] (theory 1).
struct BodyState {
  Eigen::Vector3d r = Eigen::Vector3d::Zero();   // p_WBo [m]; Bo = centre of mass (undeformed)
  Eigen::Vector4d L = Eigen::Vector4d::UnitX();  // unit quaternion, scalar first
  Eigen::Vector3d dr = Eigen::Vector3d::Zero();  // velocity of Bo in W [m/s]
  Eigen::Vector3d w = Eigen::Vector3d::Zero();   // angular velocity in W [rad/s]
  Eigen::VectorXd a, da;                         // modal coordinates and rates; empty means zero
};

// Constant after construction. A rigid body has mode_count() == 0 and enters no modal loop.
class Body {
 public:
  // Rigid: mass [kg] > 0, inertia about the centre of mass in B [kg m2], symmetric positive definite; else InputError.
  Body(std::string name, double mass, const Eigen::Matrix3d& inertia);
  // Flexible (or rigid when the modal body holds no modes).
  Body(std::string name, std::shared_ptr<const ModalBody> modal);

  const std::string& name() const { return name_; }
  double mass() const { return inertia_.mass(); }
  int mode_count() const { return inertia_.mode_count(); }
  const ModalInertia& inertia() const { return inertia_; }
  // Rotary inertia of the undeformed body about Bo, in B [kg m2].
  const Eigen::Matrix3d& rigid_inertia() const { return rigid_inertia_; }
  const ModalBody* modal() const { return modal_.get(); }  // null for a body given as rigid

 private:
  std::string name_;
  std::shared_ptr<const ModalBody> modal_;
  ModalInertia inertia_;
  Eigen::Matrix3d rigid_inertia_;
};

}  // namespace footfall
