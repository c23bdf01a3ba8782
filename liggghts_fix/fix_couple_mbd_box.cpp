#include "liggghts_fix/fix_couple_mbd_box.h"

#include <sstream>

#include "domain.h"

namespace LAMMPS_NS {
namespace {

// Mesh files carry six or seven digits: a node is on the side of the box when it is this near [of the box's size].
constexpr double kOnTheSide = 1e-6;
constexpr int kFollows = 1;  // Domain::boundary of a side that follows the grains is larger

Eigen::Vector3d low(const Domain& domain) { return Eigen::Vector3d(domain.boxlo); }
Eigen::Vector3d high(const Domain& domain) { return Eigen::Vector3d(domain.boxhi); }

std::string text(const Eigen::Vector3d& x, const char* between) {
  std::ostringstream out;
  out << x[0] << between << x[1] << between << x[2];
  return out.str();
}

// A body that is larger than the box was most likely drawn in another unit.
std::string unit_guess(double body, double box) {
  if (body <= box) return "";
  const bool centimetres = 0.01 * body <= box;  // then it would fit
  return std::string(": that looks like ") + (centimetres ? "centimetres" : "millimetres") + " where metres are meant";
}

}  // namespace

bool is_outside(const Domain& domain, const Eigen::Vector3d& x, double margin) {
  const double inside = margin - kOnTheSide * (high(domain) - low(domain)).maxCoeff();
  for (int c = 0; c < 3; ++c) {
    if (domain.periodicity[c]) continue;
    if (domain.boundary[c][0] <= kFollows && x[c] - inside < domain.boxlo[c]) return true;
    if (domain.boundary[c][1] <= kFollows && x[c] + inside > domain.boxhi[c]) return true;
  }
  return false;
}

std::string outside_box(const Domain& domain, const Eigen::Matrix3Xd& x) {
  for (int j = 0; j < x.cols(); ++j) {
    if (!is_outside(domain, x.col(j), 0.0)) continue;
    const Eigen::Vector3d size = x.rowwise().maxCoeff() - x.rowwise().minCoeff();
    const Eigen::Vector3d box = high(domain) - low(domain);
    return "leaves the simulation box: node at (" + text(x.col(j), ", ") + "), box from (" + text(low(domain), ", ") +
           ") to (" + text(high(domain), ", ") + "). The body measures " + text(size, " x ") + " m" +
           unit_guess(size.maxCoeff(), box.maxCoeff()) +
           ". Make the region of create_box larger, or place the body inside it";
  }
  return "";
}

}  // namespace LAMMPS_NS
