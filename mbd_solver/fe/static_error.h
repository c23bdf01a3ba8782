#pragma once
// Statics of free bodies: balanced loads for static shapes, and the static error of a basis.

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <vector>

namespace footfall {

// x with K x = load, up to motions without strain. K may be singular if load does no work on these motions. M: mass, scale:
// about the first elastic lambda [1/s2]; they do not influence the solution. Throws InputError if K has negative directions.
Eigen::MatrixXd balanced_solution(const Eigen::SparseMatrix<double>& K, const Eigen::SparseMatrix<double>& M,
                                  const Eigen::MatrixXd& load, double scale);

// A free body with its interface, on the same degrees of freedom.
struct HeldBody {
  const Eigen::SparseMatrix<double>&K, &M;
  const Eigen::MatrixXd& rigid;  // n x 6: its rigid-body motions, translations first
  const std::vector<int>& held;  // degrees of freedom of the interface; not empty
  double scale;                  // about the first elastic lambda [1/s2]
};

// Number of independent rigid-body motions that the interface holds, 0 to 6.
int held_motions(const HeldBody& body);

// The largest relative error, 0 to 1, of static deflections of a body with the elastic `shapes` (n x s, s > 0) against the
// full model:
//  - unit forces and moments at the interface, each balanced by others there: deflection at the loads;
//  - weight, held at the interface, along each axis: mean deflection, over that along the softest axis.
double static_error(const HeldBody& body, const Eigen::MatrixXd& shapes);
// The first part alone: loads at joints and struts.
double interface_error(const HeldBody& body, const Eigen::MatrixXd& shapes);

}  // namespace footfall
