#pragma once
// fix ID all couple/mbd/geometry body NAME
// Gives the triangles of a body of the multibody scene, at its initial pose, to `fix mesh/surface fix ID type N`: the
// geometry is defined in the scene only.

#include <vector>

#include "fix.h"

namespace LAMMPS_NS {

class FixCoupleMbdGeometry : public Fix {
 public:
  // Throws footfall::InputError for a wrong command or an unknown body.
  FixCoupleMbdGeometry(LAMMPS* lmp, int narg, char** arg);

  int setmask() override { return 0; }
  int getCreateMeshTriCount() override { return static_cast<int>(corners_.size() / 9); }
  // Corner i in the list of all triangles' corners: three coordinates in W [m].
  double* getCreateMeshTriNode(int i) override { return &corners_[3 * i]; }

 private:
  std::vector<double> corners_;
};

}  // namespace LAMMPS_NS
