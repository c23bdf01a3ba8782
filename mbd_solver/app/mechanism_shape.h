#pragma once
// The mechanism as a run left it: drawn (bodies.pvd), or else its coupled surfaces alone, moved rigidly as DIR/motion
// says.

#include <string>
#include <vector>

#include "mbd_solver/app/compare_command.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/run/output/summary.h"
#include "mbd_solver/run/output/vtk_writer.h"

namespace footfall {

// The mechanism at one moment.
struct MechanismShape {
  VtkFrame frame;                   // points [m], triangles, lines
  std::vector<double> line_radius;  // of each line [m]
};

class MechanismShapes {
 public:
  // `run`: folder with this summary.json. Throws InputError for files that are damaged; a run that left neither is
  // empty.
  MechanismShapes(const std::string& run, const nlohmann::ordered_json& summary);

  bool drawn() const { return !frames_.empty(); }
  bool empty() const { return frames_.empty() && surfaces_.empty(); }
  // Of the frames as drawn [s]; of recorded surfaces, all their moments.
  const std::vector<double>& times() const { return times_; }
  // By the number of each cell ("body" of the frame's cell_numbers).
  const std::vector<std::string>& body_names() const { return names_; }
  // At the moment nearest to t [s].
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
