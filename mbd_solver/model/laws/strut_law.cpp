#include "mbd_solver/model/laws/strut_law.h"

#include "coupler/base/errors.h"

namespace footfall {

std::string_view energy_name(EnergyKind kind) {
  switch (kind) {
    case EnergyKind::kGas: return "gas";
    case EnergyKind::kStrain: return "strain";
    case EnergyKind::kMrViscous: return "mr_viscous";
    case EnergyKind::kMrYield: return "mr_yield";
    case EnergyKind::kHoneycomb: return "honeycomb";
    case EnergyKind::kDamper: return "damper";
    case EnergyKind::kStop: return "stop";
  }
  FOOTFALL_DEMAND(false && "unknown EnergyKind");
}

}  // namespace footfall
