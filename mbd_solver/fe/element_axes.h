#pragma once
// From the axes of an element to those of the drawing, three rows and columns at a time: every degree of freedom belongs to a vector.

#include <Eigen/Dense>

namespace footfall {

// T K T^T, T = diag(R_DE, R_DE, ...): columns of R_DE are the axes of the element in the drawing.
template <class Matrix>
Matrix turned_stiffness(Matrix K, const Eigen::Matrix3d& R_DE) {
  for (Eigen::Index j = 0; j < K.cols(); j += 3)
    for (Eigen::Index i = 0; i < K.rows(); i += 3) {
      const Eigen::Matrix3d block = R_DE * K.template block<3, 3>(i, j);
      K.template block<3, 3>(i, j).noalias() = block * R_DE.transpose();
    }
  return K;
}

// S T^T.
template <class Matrix>
Matrix turned_stress(Matrix S, const Eigen::Matrix3d& R_DE) {
  for (Eigen::Index j = 0; j < S.cols(); j += 3)
    for (Eigen::Index i = 0; i < S.rows(); i += 3) {
      const Eigen::Matrix3d block = S.template block<3, 3>(i, j);
      S.template block<3, 3>(i, j).noalias() = block * R_DE.transpose();
    }
  return S;
}

}  // namespace footfall
