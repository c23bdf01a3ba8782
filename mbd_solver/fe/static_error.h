#pragma once
// Statics of bodies that are not held: what static shapes are made with, and how far a basis errs in statics.

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <vector>

namespace footfall {

// x with K x = load, up to motions without strain. K may be singular: load does no work on these motions. M: mass,
// scale: about the first elastic lambda [1/s2]; they only steer the way to x. Throws InputError when K has negative
// directions.
Eigen::MatrixXd balanced_solution(const Eigen::SparseMatrix<double>& K, const Eigen::SparseMatrix<double>& M,
                                  const Eigen::MatrixXd& load, double scale);

// A free body with the places where something is attached to it. All on the same degrees of freedom.
struct HeldBody {
  const Eigen::SparseMatrix<double>&K, &M;
  const Eigen::MatrixXd& rigid;  // n x 6: its rigid-body motions, translations first
  const std::vector<int>& held;  // degrees of freedom of the interface; not empty
  double scale;                  // about the first elastic lambda [1/s2]
};

// How many independent rigid-body motions the interface holds, 0 to 6.
int held_motions(const HeldBody& body);

// The largest relative error of the deflection under a static load, of a body of the elastic `shapes` (n x s, s > 0) against
// the model itself; 0 to 1:
//  - unit forces and moments at the interface, each balanced by others there: deflection at the loads;
//  - weight, held at the interface, along each axis: mean deflection, over that along the softest axis.
double static_error(const HeldBody& body, const Eigen::MatrixXd& shapes);
// Of that the first part alone: what joints and struts will see.
double interface_error(const HeldBody& body, const Eigen::MatrixXd& shapes);

}  // namespace footfall
