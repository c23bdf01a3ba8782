#pragma once
// `digits fast` of fix couple/mbd: pair forces may differ from those of LIGGGHTS in their last digits.

#include <set>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace footfall {

// Every LIGGGHTS whose pair forces may differ.
inline std::set<const LAMMPS_NS::LAMMPS*>& all_with_fast_digits() {
  static std::set<const LAMMPS_NS::LAMMPS*> all;
  return all;
}
inline bool has_fast_digits(const LAMMPS_NS::LAMMPS* lmp) { return all_with_fast_digits().count(lmp) > 0; }

}  // namespace footfall
