#pragma once
// Reduced models of other finite-element codes.
//
// Modal body file: plain text, SI units, numbers separated by blanks, `#` starts a comment, line breaks
// separate records. Node numbers start at 0. Sections in this order; those in [brackets] are optional:
// clang-format off
//   footfall-modal-body 1   format and version, first line
//   nodes N                 N lines: x y z mass, or: x y z mass Jxx Jyy Jzz Jxy Jyz Jzx
//                           (position [m], lumped mass [kg], rotary inertia tensor [kg m2], in one frame D)
//   modes S                 for each mode a line `mode k` (k = 0..S-1) and N lines:
//                           phi_x phi_y phi_z, or: phi_x phi_y phi_z psi_x psi_y psi_z
//                           (displacement and rotation of the node per unit of the modal coordinate)
//   stiffness               S lines of one number (diagonal) or of S numbers (symmetric matrix K);
//                           the strain energy is 1/2 a^T K a
//   [damping]               S lines of one number: damping ratio zeta, by ascending frequency of the
//                           orthonormal modes; without this section the scene's
//   [triangles T]           T lines: three node numbers
//   [segments T]            T lines: two node numbers
//   [stress P]              6 P lines of S numbers: xx yy zz xy yz zx of P points [Pa] per unit of the modal
//                           coordinate; two points per triangle, then eight per segment, to be shown on them
//   end
// clang-format on
// The modes need be neither orthonormal nor free of rigid motion, but elastic: footfall removes rigid motion
// (mean axes), moves the origin to the mass centre and orthonormalises, so that files of fixed-interface and static modes can
// be used unchanged. The rotation columns (J and psi) are optional; joints that hold an orientation require them.

#include <string>

#include "mbd_solver/fe/modal_basis.h"

namespace footfall {

// Throws InputError with path:line on anything malformed. Options: mode_count, max_frequency, damping_ratio
// (if the file has none).
ReducedBody read_modal_body(const std::string& path, const BasisOptions& options, const std::string& name);

// Writes the body with its origin at p_DBo; reading it returns the same body to round-off.
void write_modal_body(const std::string& path, const ModalBody& body, const Eigen::Vector3d& p_DBo);

}  // namespace footfall
