#pragma once
// Geometry over time, for ParaView and `footfall view`: one VTU file per frame, and a .pvd that lists them with times.

#include <Eigen/Dense>
#include <string>
#include <utility>
#include <vector>

namespace footfall {

struct VtkFrame {
  Eigen::Matrix3Xd points;                 // 3 x N [m]
  std::vector<Eigen::Vector3i> triangles;  // indices of points
  std::vector<Eigen::Vector2i> lines;      // indices of points
  // Arrays by name: vectors of points, 3 x N; numbers of cells, triangles first, then lines.
  std::vector<std::pair<std::string, Eigen::Matrix3Xd>> point_vectors;
  std::vector<std::pair<std::string, Eigen::VectorXd>> cell_numbers;
  // Texts and vectors of the whole frame, by name: field data in ParaView.
  std::vector<std::pair<std::string, std::vector<std::string>>> texts;
  std::vector<std::pair<std::string, Eigen::Matrix3Xd>> field_vectors;
};

class VtkSeries {
 public:
  // Files FOLDER/NAME_0000.vtu ... and FOLDER/NAME.pvd.
  VtkSeries(std::string folder, std::string name);
  // Writes the frame, and the list again, so that a running or interrupted run can be opened. Throws InputError when a
  // file cannot be written, NumericalError when a number is not finite.
  void write(double time, const VtkFrame& frame);

  // Times of the frames so far [s]; a resumed run continues after them.
  std::vector<double> times() const;
  void resume_after(const std::vector<double>& times);

 private:
  struct Cells {  // of the last frame, with their text: the next frame mostly has the same
    bool written = false;
    std::vector<Eigen::Vector3i> triangles;
    std::vector<Eigen::Vector2i> lines;
    std::string connectivity, offsets, types;
  };
  void add_to_list(double time);
  const Cells& cells_of(const VtkFrame& frame);

  std::string folder_, name_;
  std::vector<std::pair<double, std::string>> frames_;
  Cells cells_;
};

// A .pvd: times [s] and names of files in its folder. Throws InputError when it cannot be written.
void write_vtk_list(const std::string& pvd, const std::vector<std::pair<double, std::string>>& frames);

// Read what VtkSeries wrote: times and file names of a .pvd; one frame, without vectors of points. Throw InputError naming
// the file.
std::vector<std::pair<double, std::string>> read_vtk_series(const std::string& pvd);
VtkFrame read_vtk_frame(const std::string& vtu);

}  // namespace footfall
