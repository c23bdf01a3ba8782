// Reads fix property/global: kn and its companions, or Young's modulus, Poisson's ratio and restitution.

#include "liggghts_fix/contact/wall_materials.h"

#include "fix_property_global.h"
#include "modify.h"

namespace LAMMPS_NS {

std::vector<footfall::WallContact> wall_contacts(Modify& modify, int types, int wall_type, const char* style) {
  if (wall_type < 1 || wall_type > types) return {};
  const auto by_type = [&](const char* name) {
    return dynamic_cast<FixPropertyGlobal*>(
        modify.find_fix_property(name, "property/global", "peratomtype", types, 0, style, false));
  };
  const auto by_pair = [&](const char* name) {
    return dynamic_cast<FixPropertyGlobal*>(
        modify.find_fix_property(name, "property/global", "peratomtypepair", types, types, style, false));
  };
  // For the pair of a grain type and the wall; 0 where the script gives none.
  const auto constant = [&](FixPropertyGlobal* pairs, int type) {
    return pairs == nullptr ? 0.0 : pairs->compute_array(type - 1, wall_type - 1);
  };

  std::vector<footfall::WallContact> contacts(static_cast<std::size_t>(types) + 1);
  FixPropertyGlobal* friction = by_pair("coefficientFriction");
  if (FixPropertyGlobal* kn = by_pair("kn")) {
    for (int type = 1; type <= types; ++type) {
      footfall::WallContact& contact = contacts[type];
      contact.linear = constant(kn, type);
      contact.linear_shear = constant(by_pair("kt"), type);
      contact.linear_damping = constant(by_pair("gamman"), type);
      contact.linear_shear_damping = constant(by_pair("gammat"), type);
      contact.friction = constant(friction, type);
    }
    return contacts;
  }

  FixPropertyGlobal* young = by_type("youngsModulus");
  FixPropertyGlobal* poisson = by_type("poissonsRatio");
  FixPropertyGlobal* restitution = by_pair("coefficientRestitution");
  if (young == nullptr || poisson == nullptr) return {};
  const auto elastic = [&](int type) {
    return footfall::ElasticConstants{young->compute_vector(type - 1), poisson->compute_vector(type - 1)};
  };
  for (int type = 1; type <= types; ++type) {
    footfall::WallContact& contact = contacts[type];
    contact = footfall::hertz_mindlin(elastic(type), elastic(wall_type));
    contact.friction = constant(friction, type);
    if (restitution != nullptr) contact.damping = footfall::damping_of_restitution(constant(restitution, type));
  }
  return contacts;
}

}  // namespace LAMMPS_NS
