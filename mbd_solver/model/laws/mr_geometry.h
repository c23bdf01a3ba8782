#pragma once
// From the drawing and the fluid of a bypass MR damper to the parameters of its law [Lin25 14, 15, Figure 2]:
//   F_y(U) = 3 pi L1 tau_y(U) (D1 + d1) / 2
//   c      = (12 eta L1 / d^2 + 32 eta (L2/D2^2 + L3/D3^2 + L4/D4^2)) pi D3^2 / 4

#include <optional>
#include <vector>

#include "mbd_solver/model/laws/mr_damper.h"

namespace footfall {

struct YieldStress {
  double voltage;  // U in [0, 1] [-]
  double stress;   // tau_y, shear yield strength of the fluid in the field of this U [Pa]
};

// No defaults: [Lin25] does not print these values. Everything > 0 except L2, L4 >= 0.
struct MrGeometry {
  double D1 = 0.0;                 // inner diameter of the bypass cylinder [m]
  double d1 = 0.0;                 // diameter of the magnetic core, < D1 [m]
  double D2 = 0.0;                 // inner diameter of the first connecting cylinder [m]
  double D3 = 0.0;                 // inner diameter of the main cylinder [m]
  std::optional<double> D4;        // inner diameter of the second connecting cylinder; not given: D2 [m]
  std::optional<double> d;         // gap between core and bypass cylinder; not given: (D1 - d1) / 2 [m]
  double L1 = 0.0;                 // length of the wound section of the core [m]
  double L2 = 0.0;                 // length of the first connecting cylinder [m]
  double L3 = 0.0;                 // length of the main cylinder [m]
  double L4 = 0.0;                 // length of the second connecting cylinder [m]
  double eta = 0.0;                // viscosity of the fluid without field [Pa s]
  std::vector<YieldStress> tau_y;  // U rising strictly from 0 to 1, tau_y >= 0 and never falling
};

// `law` carries what geometry does not decide (v_s, coil lag, initial voltage); its forces are replaced:
// yield_table, yield_force (at U = 1) and viscous_coefficient. Throws InputError for a value out of its
// range.
MrDamperParameters mr_damper_from_geometry(const MrGeometry& geometry, MrDamperParameters law = {});

}  // namespace footfall
