#include "mbd_solver/model/energy.h"

#include <string>

#include "coupler/base/errors.h"

namespace footfall {

std::string_view dissipation_name(Dissipation kind) {
  switch (kind) {
    case Dissipation::kMrViscous: return "mr_viscous";
    case Dissipation::kMrYield: return "mr_yield";
    case Dissipation::kHoneycomb: return "honeycomb";
    case Dissipation::kDamper: return "damper";
    case Dissipation::kStop: return "stop";
    case Dissipation::kModal: return "modal";
    case Dissipation::kFriction: return "friction";
    case Dissipation::kContact: return "contact";
  }
  FOOTFALL_DEMAND(false);
  return {};
}

Dissipation dissipation_of(EnergyKind kind) {
  switch (kind) {
    case EnergyKind::kMrViscous: return Dissipation::kMrViscous;
    case EnergyKind::kMrYield: return Dissipation::kMrYield;
    case EnergyKind::kHoneycomb: return Dissipation::kHoneycomb;
    case EnergyKind::kDamper: return Dissipation::kDamper;
    case EnergyKind::kStop: return Dissipation::kStop;
    case EnergyKind::kGas:
    case EnergyKind::kStrain: break;
  }
  FOOTFALL_DEMAND(false);
  return Dissipation::kDamper;
}

}  // namespace footfall
