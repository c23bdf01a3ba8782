#pragma once
// Wall of grains against the beams of coupled bodies: chains of capsules that fix couple/mbd moves and bends.
//
//   fix ID group wall/gran/beam model ... [tangential ...] [cohesion ...] [rolling_friction ...]
//     type T body NAME [chain C] [body ...] [curvature yes] [keywords]
//
// model ... and keywords (store_force, store_force_contact, temperature, contact_area, limitForce ...): as in stock fix
// wall/gran.
// T: material of the beams. NAME: a body of the scene with beams; all of its beams, or beam number C.
// curvature yes: Hertz' contact on a cylinder, and on a sphere at the ends of a beam; otherwise as stiff as on a plane.
// A grain has one contact and one history with each beam, which continues from segment to segment. Two beams are two
// contacts.
// This fix couples the bodies, before or after fix couple/mbd; its forces are added to the forces on the bodies' meshes. Beams
// may extend out of the box.
// Output, of the last step: f_ID[1-3] force on all beams in W [N], f_ID[4-6] its moment about the origin of W [N m],
// f_ID[7] contacts, f_ID[8] largest overlap over grain radius; f_ID[i][1-8] the same of the i-th beam, its moment about
// its body's origin (in W).

#include <memory>
#include <vector>

#include "fix_wall_gran.h"
#include "liggghts_fix/link/beam_arguments.h"
#include "liggghts_fix/link/beam_chain.h"
#include "liggghts_fix/link/beam_neighbours.h"
#include "liggghts_fix/link/dem_body.h"
#include "liggghts_fix/link/grain_paths.h"

namespace footfall {
class DemLink;
}  // namespace footfall

namespace LAMMPS_NS {

class FixWallGranBeam : public FixWallGran {
 public:
  FixWallGranBeam(LAMMPS* lmp_, int narg, char** arg);

  void post_create() override;
  void pre_delete(bool unfixed) override;
  void init() override;
  void setup(int vflag) override;
  double compute_vector(int n) override;
  double compute_array(int beam, int n) override;

 protected:
  void pre_neighbor() override;
  void pre_force(int vflag) override;
  void post_force_primitive(int vflag) override;

 private:
  struct Beam {
    Beam(const footfall::ModalBoundary& boundary_, int body_, int number);

    const footfall::ModalBoundary& boundary;
    const int body;  // index in the link
    footfall::BeamChain chain;
    footfall::BeamMotion motion;
    footfall::BeamNeighbours neighbours;
    footfall::GrainPassages passages;    // through the axis
    footfall::BodyMotion at_list;        // motion at which the neighbour list was built
    FixPropertyAtom* history = nullptr;  // of each grain with this beam; null: the model has none
    // Values of this rank, in the last step.
    footfall::GeneralizedForce load;  // on the body
    int contacts = 0;
    double overlap = 0.0;  // largest over radius [-]
  };

  FixWallGranBeam(LAMMPS* lmp_, footfall::BeamArguments arguments);
  void check_segment_lengths() const;
  footfall::GrainView grains() const;
  double over_ranks(double mine, bool largest) const;
  void touch_grains(Beam& beam);
  double touch(Beam& beam, int i, const footfall::BeamTouch& touch, double* history);
  void watch_passage(Beam& beam, int i, const footfall::BeamTouch& touch);
  double softness(const Beam& beam, const footfall::BeamTouch& touch, double r) const;

  footfall::DemLink& link_;
  const footfall::BeamArguments arguments_;
  std::vector<std::unique_ptr<Beam> > beams_;  // the parts of a beam refer to each other: it must not be moved
  bool renumbered_ = true;
  bool reads_wall_as_atom_ = false;  // the contact model does so (ScopedWallAsAtom)
  std::vector<double*> velocities_;
  footfall::ContactSlope slope_;  // of the contact just computed; sliding grains are taken as sticking
  double stiffness_per_kn_ = 1.0;
  double** young_ = nullptr;  // E* and G* of LIGGGHTS by pairs of types, with `curvature yes` [Pa]
  double** shear_ = nullptr;
};

}  // namespace LAMMPS_NS
