#pragma once
// The mechanism as a picture: the deformed surfaces and axes of all bodies, with displacement and stress.

#include "mbd_solver/output/vtk_writer.h"
#include "mbd_solver/run/simulation.h"

namespace footfall {

class Drawing {
 public:
  explicit Drawing(Simulation& simulation);
  // The frame of the state that the equations hold. The reference holds until the next call.
  const VtkFrame& frame(const Sample& sample);

 private:
  struct Part {
    int body;
    ModalBoundary shape;  // nodes in B with their modes
    int first_point;
  };

  Simulation& simulation_;
  std::vector<Part> parts_;
  VtkFrame frame_;
};

}  // namespace footfall
