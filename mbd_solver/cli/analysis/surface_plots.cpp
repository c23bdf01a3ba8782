#include "mbd_solver/cli/analysis/surface_plots.h"

#include <filesystem>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"
#include "coupler/base/quote.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/gnuplot.h"

namespace footfall {

std::string write_surface_script(const std::string& folder, const SurfacePicture& picture) {
  FOOTFALL_DEMAND(picture.z.rows() == picture.x.size() && picture.z.cols() == picture.y.size());
  make_folder(folder);
  const std::filesystem::path base = std::filesystem::path(folder) / picture.name;

  std::ostringstream data;
  data << "# " << picture.x_axis << ", " << picture.y_axis << ", " << picture.z_axis << "\n";
  for (Eigen::Index i = 0; i < picture.x.size(); ++i) {
    for (Eigen::Index j = 0; j < picture.y.size(); ++j)
      data << picture.x[i] << ' ' << picture.y[j] << ' ' << picture.z(i, j) << '\n';
    data << '\n';
  }
  write_whole_file(base.string() + ".dat", data.str());
  const std::string setup =
      "set encoding utf8\nunset key\nset hidden3d\nset pm3d depthorder border lc rgb \"#404040\" lw 0.3\n"
      "set view 60, 230\nset ticslevel 0\n"
      "set palette defined (0 \"#2c4c8c\", 0.5 \"#7fc8b0\", 1 \"#f4e04d\")\nset zrange [0:1]\nset cbrange [0:1]\n";
  return write_drawing(folder, picture.name, {900, 680}, setup,
                       "set title " + gnuplot_text(picture.title) + " noenhanced\nset xlabel " +
                           gnuplot_text(picture.x_axis) + " noenhanced\nset ylabel " + gnuplot_text(picture.y_axis) +
                           " noenhanced\nset zlabel " + gnuplot_text(picture.z_axis) + " noenhanced rotate\nsplot " +
                           gnuplot_text(picture.name + ".dat") + " with pm3d\n");
}

}  // namespace footfall
