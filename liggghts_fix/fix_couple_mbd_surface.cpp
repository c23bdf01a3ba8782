// How grains touch a mesh that is curved or deforms: each grain once, on its facets or on the round surface behind them.

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "fix_mesh_surface.h"
#include "liggghts_fix/fix_couple_mbd_mesh.h"
#include "liggghts_fix/fix_wall_gran_smooth.h"
#include "modify.h"
#include "neighbor.h"

namespace LAMMPS_NS {
namespace {

// A grain that is not near a flat facet, to within the skin, may yet touch the round one [of the skin].
constexpr double kLargestBulge = 0.1;

}  // namespace

// fix multicontact/halfspace reads LIGGGHTS' own contacts of a mesh, facet by facet.
void CoupledMesh::let_grains_touch_once(const footfall::CoupleMbdArguments& arguments,
                                        const std::vector<FixWallGran*>& walls) {
  using Surface = footfall::CoupleMbdArguments::Surface;
  if (arguments.surface == Surface::kFacets || modify->n_fixes_style("multicontact/halfspace") > 0) return;
  const footfall::ModalBoundary& boundary = link_.body(body_).boundary();
  auto smooth = std::make_shared<SmoothMesh>(
      SmoothMesh{footfall::SurfacePieces(boundary.rho0(), corners(), arguments.edge_angle), nullptr});
  if (!smooth->pieces.curved() && boundary.mode_count() == 0) return;
  if (arguments.surface == Surface::kRound) {
    smooth->round = std::make_unique<footfall::RoundSurface>(smooth->pieces, boundary.rho0());
    if (smooth->round->largest_bulge() > kLargestBulge * neighbor->skin)
      throw footfall::InputError(
          where_ + "`surface round` makes a facet stand out by " +
          footfall::number_text(smooth->round->largest_bulge()) + " m, more than " +
          footfall::number_text(kLargestBulge) +
          " of the skin in which LIGGGHTS looks for grains: make the facets smaller, the skin (command "
          "`neighbor`) larger, or edges sharp (`edge DEGREES`)");
  }
  smooth_ = smooth;
  for (FixWallGran* wall : walls) {
    auto* const wall_of_ours = dynamic_cast<FixWallGranSmooth*>(wall);
    if (wall_of_ours == nullptr) return;  // a style of another name, which LIGGGHTS alone knows
    wall_of_ours->touch_once(fix_, smooth);
  }
  module_->set_touched_once();
  bend_round_surface();
}

// Turns or deforms it with the body.
void CoupledMesh::bend_round_surface() {
  if (smooth_ == nullptr || smooth_->round == nullptr) return;
  const footfall::DemBody& body = link_.body(body_);
  if (body.boundary().mode_count() == 0) {
    smooth_->round->turn(body.pose().rotation());
    return;
  }
  body.boundary().node_positions(body.pose(), x_W_);
  smooth_->round->deform(smooth_->pieces, x_W_);
}

}  // namespace LAMMPS_NS
