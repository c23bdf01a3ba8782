// clang-format off
// Wall of grains against one beam of a coupled body: a chain of capsules that fix couple/mbd moves and bends.
//
//   fix ID group wall/gran/beam model ... [tangential ...] [cohesion ...] [rolling_friction ...] type T body NAME [chain C] [keywords]
//
// model ... and keywords (store_force, store_force_contact, temperature, contact_area, limitForce ...): as in stock fix wall/gran.
// T: material of the beam. NAME: a body of the scene with beams. C: which of its beams; needed when there are several.
// One beam per fix: a grain has one contact and one history with it, which goes on from segment to segment. Two beams are two fixes.
// The body is coupled by this fix, before or after fix couple/mbd, and the forces go where those of its meshes go.
// Beams have no periodic images; they may stick out of the box.
// Output, of the last step: f_ID[1-3] force on the beam in W [N], f_ID[4-6] moment about the body's origin in W [N m], f_ID[7] grains in
// contact, f_ID[8] largest overlap over grain radius.

#ifdef FIX_CLASS
FixStyle(wall/gran/beam,FixWallGranBeam)
#else
// clang-format on

#ifndef LMP_FIX_WALL_GRAN_BEAM_H
#define LMP_FIX_WALL_GRAN_BEAM_H

#include "fix_wall_gran.h"
#include "liggghts_fix/beam_arguments.h"
#include "liggghts_fix/beam_contact.h"
#include "liggghts_fix/beam_motion.h"
#include "liggghts_fix/beam_neighbours.h"

namespace footfall {
class DemBody;
class DemLink;
}  // namespace footfall

namespace LAMMPS_NS {

class FixWallGranBeam : public FixWallGran {
 public:
  FixWallGranBeam(LAMMPS* lmp_, int narg, char** arg);

  void init() override;
  void setup(int vflag) override;
  double compute_vector(int n) override;

 protected:
  void pre_neighbor() override;
  void pre_force(int vflag) override;
  void post_force_primitive(int vflag) override;

 private:
  FixWallGranBeam(LAMMPS* lmp_, footfall::BeamArguments arguments);
  void check_segment_lengths() const;
  footfall::GrainView grains() const;
  double touch(int i, const footfall::BeamTouch& touch, double* history);

  footfall::DemLink& link_;
  const footfall::BeamArguments arguments_;
  const footfall::ModalBoundary& boundary_;
  const int body_index_;
  footfall::BeamChain chain_;
  footfall::BeamMotion motion_;
  footfall::BeamNeighbours neighbours_;
  bool renumbered_ = true;
  double stiffness_per_kn_ = 1.0;

  // Of this rank, in the last step.
  footfall::GeneralizedForce load_;  // on the body
  int contacts_ = 0;
  double overlap_ = 0.0;  // largest over radius [-]
};

}  // namespace LAMMPS_NS

#endif
#endif
