#pragma once
// Frames for VTK: the deformed surfaces and axes of all bodies, with displacement and stress.

#include "mbd_solver/run/observe/sampler.h"
#include "mbd_solver/run/output/vtk_writer.h"

namespace footfall {

class Drawing {
 public:
  // The subject's parts must outlive this.
  explicit Drawing(const Subject& subject);
  bool empty() const { return parts_.empty(); }  // no body can be drawn
  // The reference is valid until the next call.
  const VtkFrame& frame(const Sample& sample);

 private:
  struct Part {
    int body;
    ModalBoundary shape;  // nodes in B with their modes
    int first_point;
  };

  const Model& model_;
  std::vector<Part> parts_;
  VtkFrame frame_;
};

}  // namespace footfall
