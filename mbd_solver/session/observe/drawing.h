#pragma once
// Frames for VTK: the deformed surfaces and axes of all bodies, with displacement and stress, and the marks of marks.h as field
// data: "mark_names" and "marks".

#include "mbd_solver/session/observe/marks.h"
#include "mbd_solver/session/observe/sampler.h"
#include "mbd_solver/session/output/vtk_writer.h"

namespace footfall {

class Drawing {
 public:
  // The subject's parts must outlive this.
  explicit Drawing(const Subject& subject);
  bool empty() const { return marks_.texts().empty(); }  // there is no body
  // The reference is valid until the next call.
  const VtkFrame& frame(const Sample& sample) { return frame(sample.kinematics, &sample); }
  // The same in the reference configuration, placed, without loads.
  const VtkFrame& reference_frame();

 private:
  const VtkFrame& frame(const Kinematics& kinematics, const Sample* sample);

  struct Part {
    int body;
    ModalBoundary shape;  // nodes in B with their modes
    int first_point;
  };

  const Model& model_;
  const Layout& layout_;
  Marks marks_;
  std::vector<Part> parts_;
  VtkFrame frame_;
};

}  // namespace footfall
