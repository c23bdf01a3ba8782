// Products with the Jacobian X and its derivatives, term by term; sums over modes take most of the time of flexible
// bodies.

#include "mbd_solver/model/kinematic_vector.h"

namespace footfall {
namespace {

// U a, U da and U dda (U: 3 x s) in one pass. Nine sums stay in registers; three Eigen vectors would take twice as long.
struct ModeSums {
  ModeSums(const Eigen::Matrix3Xd& U, const BodyKinematics& b) {
    double s0 = 0.0, s1 = 0.0, s2 = 0.0, d0 = 0.0, d1 = 0.0, d2 = 0.0, e0 = 0.0, e1 = 0.0, e2 = 0.0;
    const double* column = U.data();
    const double *at_a = b.a.data(), *at_da = b.da.data(), *at_dda = b.dda.data();
    for (int k = 0; k < b.modes; ++k, column += 3) {
      const double a_k = at_a[k], da_k = at_da[k], dda_k = at_dda[k];
      s0 += column[0] * a_k, s1 += column[1] * a_k, s2 += column[2] * a_k;
      d0 += column[0] * da_k, d1 += column[1] * da_k, d2 += column[2] * da_k;
      e0 += column[0] * dda_k, e1 += column[1] * dda_k, e2 += column[2] * dda_k;
    }
    a << s0, s1, s2;
    da << d0, d1, d2;
    dda << e0, e1, e2;
  }
  Eigen::Vector3d a, da, dda;
};

// out += U^T f by rows of three; Eigen's product with so short an inner size takes twice as long.
inline void add_to_modes(const Eigen::Matrix3Xd& U, const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) {
  const double* column = U.data();
  for (Eigen::Index k = 0; k < out.size(); ++k, column += 3)
    out[k] += column[0] * f[0] + column[1] * f[1] + column[2] * f[2];
}

}  // namespace

KinematicVector KinematicVector::constant(const Eigen::Vector3d& value_W) {
  KinematicVector out;
  out.value_ = value_W;
  return out;
}

KinematicVector KinematicVector::axis(const PairMotion& pair, int slot, const Marker& marker, int k) {
  KinematicVector out;
  out.add_term(pair, slot, 1.0, false, marker.axes.col(k), marker.U[k]);
  return out;
}

KinematicVector::KinematicVector(const PairMotion& pair, int slot, const Marker& marker, int k, const NodeTurn& turn) {
  const Eigen::Vector3d u = marker.axes.col(k);
  if (pair.body[slot]->modes == 0) {
    add_term(pair, slot, 1.0, false, u, marker.U[k]);
  } else {
    add_term(pair, slot, 1.0, false, Local{u + turn.a.cross(u), turn.da.cross(u), turn.dda.cross(u)}, marker.U[k]);
  }
}

KinematicVector KinematicVector::point(const PairMotion& pair, int slot, const Marker& marker) {
  KinematicVector out;
  out.add_term(pair, slot, 1.0, true, marker.s0, marker.S);
  return out;
}

KinematicVector::KinematicVector(const PairMotion& pair, const Marker& m1, const Marker& m2) {
  add_term(pair, 0, -1.0, true, m1.s0, m1.S);
  add_term(pair, 1, 1.0, true, m2.s0, m2.S);
}

void KinematicVector::add_term(const PairMotion& pair, int slot, double sign, bool point, const Eigen::Vector3d& u0,
                               const Eigen::Matrix3Xd& U) {
  const BodyKinematics& b = *pair.body[slot];
  if (b.ground) {
    value_ += sign * u0;
    return;
  }
  if (b.modes == 0) {
    add_term(pair, slot, sign, point, Local{u0, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}, U);
  } else {
    const ModeSums sums(U, b);
    add_term(pair, slot, sign, point, Local{u0 + sums.a, sums.da, sums.dda}, U);
  }
}

void KinematicVector::add_term(const PairMotion& pair, int slot, double sign, bool point, const Local& local,
                               const Eigen::Matrix3Xd& U) {
  const BodyKinematics& b = *pair.body[slot];
  Term& t = terms_[count_++];
  t.body = &b;
  t.U = &U;
  t.offset = pair.offset(slot);
  t.sign = sign;
  t.point = point;
  const Eigen::Vector3d x = b.A.lazyProduct(local.u), turning = b.w.cross(x);
  Eigen::Vector3d rate = turning, acc = b.dw.cross(x);
  t.x = x;
  if (b.modes == 0) {
    t.y.setZero();
    t.z.setZero();
    acc += b.w.cross(turning);
  } else {
    const Eigen::Vector3d y = b.A.lazyProduct(local.U_da), z = b.A.lazyProduct(local.U_dda);
    t.y = y;
    t.z = z;
    rate += y;
    acc = acc + z + b.w.cross(turning + 2.0 * y);
  }
  if (point) {
    value_ += sign * b.r;
    rate += b.dr;
    acc += b.ddr;
  }
  value_ += sign * x;
  rate_ += sign * rate;
  acc_ += sign * acc;
}

void KinematicVector::add_transposed(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const {
  for (int i = 0; i < count_; ++i) {
    const Term& t = terms_[i];
    const Eigen::Vector3d g = t.sign * f;
    if (t.point) out.segment<3>(t.offset) += g;
    out.segment<3>(t.offset + 3) += t.x.cross(g);
    if (t.body->modes > 0) {
      const Eigen::Vector3d local = t.body->A.transpose() * g;
      add_to_modes(*t.U, local, out.segment(t.offset + 6, t.body->modes));
    }
  }
}

void KinematicVector::add_rate_by_position(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const {
  // alpha' = w x x + y: by theta -(w~ x~ + y~), by a w~ A U
  for (int i = 0; i < count_; ++i) {
    const Term& t = terms_[i];
    const Eigen::Vector3d g = t.sign * f;
    const Eigen::Vector3d wg = t.body->w.cross(g);
    out.segment<3>(t.offset + 3) += t.y.cross(g) - t.x.cross(wg);
    if (t.body->modes > 0) {
      const Eigen::Vector3d local = -(t.body->A.transpose() * wg);
      add_to_modes(*t.U, local, out.segment(t.offset + 6, t.body->modes));
    }
  }
}

void KinematicVector::add_acc_by_position(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const {
  // by theta -(dw~ x~ + z~ + w~ w~ x~ + 2 w~ y~), by a (dw~ + w~ w~) A U
  for (int i = 0; i < count_; ++i) {
    const Term& t = terms_[i];
    const Eigen::Vector3d g = t.sign * f;
    const Eigen::Vector3d wg = t.body->w.cross(g);
    const Eigen::Vector3d h = t.body->w.cross(wg) - t.body->dw.cross(g);
    out.segment<3>(t.offset + 3) += t.x.cross(h) + t.z.cross(g) - 2.0 * t.y.cross(wg);
    if (t.body->modes > 0) {
      const Eigen::Vector3d local = t.body->A.transpose() * h;
      add_to_modes(*t.U, local, out.segment(t.offset + 6, t.body->modes));
    }
  }
}

void KinematicVector::add_acc_by_velocity(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const {
  // by w -((w x x)~ + w~ x~ + 2 y~), by da 2 w~ A U
  for (int i = 0; i < count_; ++i) {
    const Term& t = terms_[i];
    const Eigen::Vector3d g = t.sign * f;
    const Eigen::Vector3d wg = t.body->w.cross(g);
    out.segment<3>(t.offset + 3) += (t.body->w.cross(t.x) + 2.0 * t.y).cross(g) - t.x.cross(wg);
    if (t.body->modes > 0) {
      const Eigen::Vector3d local = -2.0 * (t.body->A.transpose() * wg);
      add_to_modes(*t.U, local, out.segment(t.offset + 6, t.body->modes));
    }
  }
}

void KinematicVector::add_product(const Eigen::Matrix3d& C, const KinematicVector& other,
                                  Eigen::Ref<Eigen::MatrixXd> K) const {
  for (int i = 0; i < count_; ++i) {
    const Term& t = terms_[i];
    const Eigen::Matrix3d turn = skew(t.x);  // (-x~)^T
    for (int j = 0; j < other.count_; ++j) {
      const Term& o = other.terms_[j];
      const Eigen::Matrix3d D = (t.sign * o.sign) * C;
      const Eigen::Matrix3d turn_D = turn * D;
      const Eigen::Matrix3d back = skew(o.x);
      if (t.point && o.point) K.block<3, 3>(t.offset, o.offset) += D;
      if (t.point) K.block<3, 3>(t.offset, o.offset + 3).noalias() -= D * back;
      if (o.point) K.block<3, 3>(t.offset + 3, o.offset) += turn_D;
      K.block<3, 3>(t.offset + 3, o.offset + 3).noalias() -= turn_D * back;
      if (o.body->modes > 0) {  // columns of a: A_o U_o
        for (int k = 0; k < o.body->modes; ++k) {
          const Eigen::Vector3d column = o.body->A * o.U->col(k);
          const Eigen::Vector3d D_column = D * column;
          if (t.point) K.block<3, 1>(t.offset, o.offset + 6 + k) += D_column;
          K.block<3, 1>(t.offset + 3, o.offset + 6 + k) += t.x.cross(D_column);
          if (t.body->modes > 0) {
            const Eigen::Vector3d local = t.body->A.transpose() * D_column;
            K.block(t.offset + 6, o.offset + 6 + k, t.body->modes, 1).noalias() += t.U->transpose() * local;
          }
        }
      }
      if (t.body->modes > 0) {  // rows of a: U^T A^T
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d local_r = t.body->A.transpose() * D.col(k);
          const Eigen::Vector3d local_theta = -(t.body->A.transpose() * (D * back.col(k)));
          if (o.point) K.block(t.offset + 6, o.offset + k, t.body->modes, 1).noalias() += t.U->transpose() * local_r;
          K.block(t.offset + 6, o.offset + 3 + k, t.body->modes, 1).noalias() += t.U->transpose() * local_theta;
        }
      }
    }
  }
}

void KinematicVector::add_jacobian(Eigen::Ref<Eigen::Matrix3Xd> out) const {
  for (int i = 0; i < count_; ++i) {
    const Term& t = terms_[i];
    if (t.point) out.block<3, 3>(0, t.offset).diagonal().array() += t.sign;
    out.block<3, 3>(0, t.offset + 3) -= t.sign * skew(t.x);
    for (int k = 0; k < t.body->modes; ++k) {
      const Eigen::Vector3d column = t.body->A * t.U->col(k);
      out.col(t.offset + 6 + k) += t.sign * column;
    }
  }
}

void KinematicVector::add_rate_jacobian(Eigen::Ref<Eigen::Matrix3Xd> out) const {
  for (int i = 0; i < count_; ++i) {
    const Term& t = terms_[i];
    out.block<3, 3>(0, t.offset + 3) -= t.sign * (skew(t.body->w) * skew(t.x) + skew(t.y));
    for (int k = 0; k < t.body->modes; ++k) {
      const Eigen::Vector3d column = t.body->A * t.U->col(k);
      out.col(t.offset + 6 + k) += t.sign * t.body->w.cross(column);
    }
  }
}

void KinematicVector::add_second(const Eigen::Vector3d& f, Eigen::Ref<Eigen::MatrixXd> K) const {
  // X^T f = [f; x x f; U^T A^T f]: by theta [0; f~ x~; U^T A^T f~], by a [0; -f~ A U; 0]
  for (int i = 0; i < count_; ++i) {
    const Term& t = terms_[i];
    const Eigen::Vector3d g = t.sign * f;
    const Eigen::Matrix3d g_skew = skew(g);
    K.block<3, 3>(t.offset + 3, t.offset + 3).noalias() += g_skew * skew(t.x);
    for (int k = 0; k < t.body->modes; ++k) {
      const Eigen::Vector3d column = t.body->A * t.U->col(k);
      const Eigen::Vector3d turned = column.cross(g);  // -f~ A U_k = (f~)^T A U_k
      K.block<3, 1>(t.offset + 3, t.offset + 6 + k) += turned;
      K.block<1, 3>(t.offset + 6 + k, t.offset + 3) += turned.transpose();
    }
  }
}

NodeTurn::NodeTurn(const BodyKinematics& body, const Marker& marker) {
  if (body.modes == 0) return;
  const ModeSums sums(marker.Psi, body);
  a = sums.a;
  da = sums.da;
  dda = sums.dda;
}

void MarkerVectors::find_axis(int slot, int k) {
  const Marker& at = marker(slot);
  if (!turn_[slot]) turn_[slot].emplace(*pair_.body[slot], at);
  vectors_[3 * slot + k].emplace(pair_, slot, at, k, *turn_[slot]);
}

// The axes of one marker act on the modes together: Psi^T sum u_k x (A^T f_k).
void MarkerVectors::add_pushed(Eigen::Ref<Eigen::VectorXd> out) const {
  for (int slot = 0; slot < 2; ++slot) {
    const BodyKinematics& body = *pair_.body[slot];
    const bool* pushed = pushed_ + 3 * slot;
    if (body.ground || !(pushed[0] || pushed[1] || pushed[2])) continue;
    const Marker& at = marker(slot);
    const int first = pair_.offset(slot);
    Eigen::Vector3d of_modes = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      if (!pushed[k]) continue;
      const Eigen::Vector3d& f = forces_[3 * slot + k];
      out.segment<3>(first + 3) += vectors_[3 * slot + k]->value().cross(f);
      if (body.modes == 0) continue;
      const Eigen::Vector3d local = body.A.transpose() * f;
      of_modes += Eigen::Vector3d(at.axes.col(k)).cross(local);
    }
    if (body.modes > 0) add_to_modes(at.Psi, of_modes, out.segment(first + 6, body.modes));
  }
  if (pushed_[kDifference]) vectors_[kDifference]->add_transposed(forces_[kDifference], out);
}

MovingPoint::MovingPoint(const BodyKinematics& body, const Marker& marker) : body_(&body), marker_(&marker) {
  Eigen::Vector3d s = marker.s0;
  rate_ = body.dr;
  if (body.modes > 0) {
    Eigen::Vector3d ds = Eigen::Vector3d::Zero();
    for (int k = 0; k < body.modes; ++k) {
      s += body.a[k] * marker.S.col(k);
      ds += body.da[k] * marker.S.col(k);
    }
    rate_ += body.A.lazyProduct(ds);
  }
  x_ = body.A.lazyProduct(s);
  value_ = body.r + x_;
  rate_ += body.w.cross(x_);
}

void MovingPoint::add_transposed(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const {
  out.head<3>() += f;
  out.segment<3>(3) += x_.cross(f);
  if (body_->modes == 0) return;
  const Eigen::Vector3d local = body_->A.transpose() * f;
  add_to_modes(marker_->S, local, out.segment(6, body_->modes));
}

}  // namespace footfall
