#include "mbd_solver/cli/analysis/surface_plots.h"

#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"

namespace footfall {

std::string write_surface_script(const std::string& folder, const SurfacePicture& picture) {
  FOOTFALL_DEMAND(picture.z.rows() == picture.x.size() && picture.z.cols() == picture.y.size());
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  const std::filesystem::path base = std::filesystem::path(folder) / picture.name;

  std::ofstream data(base.string() + ".dat");
  data << "# " << picture.x_axis << ", " << picture.y_axis << ", " << picture.z_axis << "\n";
  for (Eigen::Index i = 0; i < picture.x.size(); ++i) {
    for (Eigen::Index j = 0; j < picture.y.size(); ++j)
      data << picture.x[i] << ' ' << picture.y[j] << ' ' << picture.z(i, j) << '\n';
    data << '\n';
  }
  std::ofstream script(base.string() + ".gp");
  script << "# gnuplot " << picture.name << ".gp draws " << picture.name << ".png and " << picture.name << ".svg from "
         << picture.name << ".dat\n"
         << "set encoding utf8\nunset key\nset hidden3d\nset pm3d depthorder border lc rgb \"#404040\" lw 0.3\nset "
            "view 60, 230\nset ticslevel 0\n"
         << "set palette defined (0 \"#2c4c8c\", 0.5 \"#7fc8b0\", 1 \"#f4e04d\")\nset zrange [0:1]\nset cbrange [0:1]\n"
         << "set title \"" << picture.title << "\" noenhanced\nset xlabel \"" << picture.x_axis
         << "\" noenhanced\nset ylabel \"" << picture.y_axis << "\" noenhanced\nset zlabel \"" << picture.z_axis
         << "\" noenhanced rotate\n";
  for (const auto& [terminal, ending] :
       {std::pair("pngcairo size 900,680 font \"DejaVu Sans,11\"", ".png"),
        std::pair("svg size 900,680 font \"DejaVu Sans,11\" background rgb \"white\"", ".svg")}) {
    script << "set terminal " << terminal << "\nset output \"" << picture.name << ending << "\"\nsplot '"
           << picture.name << ".dat' with pm3d\n";
  }
  data.flush();
  script.flush();
  if (!data || !script) throw InputError(base.string() + ".gp: cannot be written; choose another folder with --out");
  return picture.name + ".gp";
}

}  // namespace footfall
