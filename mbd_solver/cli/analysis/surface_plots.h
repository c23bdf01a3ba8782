#pragma once
// gnuplot scripts of surfaces z(x, y), as [Lin25 Figure 4] shows its control surfaces.

#include <Eigen/Dense>
#include <string>

namespace footfall {

struct SurfacePicture {
  std::string name;  // file name without ending
  std::string title;
  std::string x_axis, y_axis, z_axis;
  Eigen::VectorXd x, y;
  Eigen::MatrixXd z;  // x by y
};

// NAME.dat and NAME.gp in `folder`; the script draws NAME.png and NAME.svg. Returns the script's file name. Throws
// InputError when the folder cannot be written.
std::string write_surface_script(const std::string& folder, const SurfacePicture& picture);

}  // namespace footfall
