#pragma once
// The mechanism as a run recorded it: as drawn (bodies.pvd), or only its coupled surfaces, moved rigidly (DIR/motion).

#include <string>
#include <vector>

#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/session/output/vtk_writer.h"

namespace footfall {

// One coupled mesh: position and rotation since the start, at the ends of windows.
struct RecordedMotion {
  std::string body;
  std::vector<double> time;                // [s]
  std::vector<std::vector<double>> pose;   // x y z of the nodes' mean [m], rotation vector [rad]
  std::vector<std::vector<double>> force;  // mean force of the grains in the window before [N]
  std::vector<double> bend;                // largest distance of a node from the rigid motion [m]
};
// Reads FOLDER/BODY.csv. Throws InputError.
RecordedMotion read_motion(const std::string& folder, const std::string& body);
// Names of all bodies recorded in the folder.
std::vector<std::string> recorded_bodies(const std::string& folder);
// Rotation matrix of a pose.
Eigen::Matrix3d rotation_of(const std::vector<double>& pose);

// The mechanism at one time.
struct MechanismShape {
  VtkFrame frame;                   // points [m], triangles, lines
  std::vector<double> line_radius;  // of each line [m]
};

class MechanismShapes {
 public:
  // `run`: folder with this summary.json. Throws InputError for damaged files. Empty for a run that recorded neither.
  MechanismShapes(const std::string& run, const nlohmann::ordered_json& summary);

  bool drawn() const { return !frames_.empty(); }
  bool empty() const { return frames_.empty() && surfaces_.empty(); }
  // Of the frames as drawn, or of recorded surfaces [s].
  const std::vector<double>& times() const { return times_; }
  // By the number of each cell ("body" of the frame's cell_numbers).
  const std::vector<std::string>& body_names() const { return names_; }
  // At the time nearest to t [s].
  MechanismShape near(double t) const;

 private:
  struct Surface {
    RecordedMotion record;
    TriangleMesh mesh;
  };
  MechanismShape drawn_near(double t) const;
  MechanismShape recorded_near(double t) const;

  std::string folder_;
  std::vector<std::pair<double, std::string>> frames_;  // time [s], file
  std::vector<Surface> surfaces_;
  std::vector<double> times_;
  std::vector<double> radii_;  // of tubes and rods, by the number of the body [m]
  std::vector<std::string> names_;
};

// Index of the time nearest to t; `times` must not be empty.
std::size_t nearest(const std::vector<double>& times, double t);

}  // namespace footfall
