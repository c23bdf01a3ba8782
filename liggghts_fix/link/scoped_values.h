#pragma once
// Values of LIGGGHTS that are replaced during one call of a contact model, and restored by the destructor.

#include <cstddef>
#include <vector>

namespace footfall {

// The mass on which the damping of a contact acts. LIGGGHTS takes a wall as infinitely heavy: the effective mass is the
// mass m of the grain. While this object exists, the grain counts as
//   m_eff = m M / (m + M)
// with the mass M of the body's side: damping is then as for two bodies, and the coefficient of restitution as given
// in the script. inverse_mass: 1/M [1/kg]; 0, for a fixed or driven body, changes nothing.
class ScopedPairMass {
 public:
  ScopedPairMass(double& grain, double inverse_mass) : grain_(grain), own_(grain) {
    grain = own_ / (1.0 + own_ * inverse_mass);
  }
  ~ScopedPairMass() { grain_ = own_; }
  ScopedPairMass(const ScopedPairMass&) = delete;
  ScopedPairMass& operator=(const ScopedPairMass&) = delete;

 private:
  double& grain_;
  double own_;  // [kg]
};

// LIGGGHTS' moduli E* and G* of one pair of types, multiplied by a factor. The model's k_n and k_t are proportional to
// them and its damping coefficients to their square roots, as for a smaller contact radius.
class ScopedModuli {
 public:
  ScopedModuli(double** young, double** shear, int grain, int wall, double factor)
      : young_(factor == 1.0 ? unused_ : young[grain][wall]),
        shear_(factor == 1.0 ? unused_ : shear[grain][wall]),
        young_before_(young_),
        shear_before_(shear_) {
    young_ *= factor;
    shear_ *= factor;
  }
  ~ScopedModuli() {
    young_ = young_before_;
    shear_ = shear_before_;
  }
  ScopedModuli(const ScopedModuli&) = delete;
  ScopedModuli& operator=(const ScopedModuli&) = delete;

 private:
  double unused_ = 0.0;  // where the factor is 1: without `curvature yes` the moduli are unknown
  double& young_;
  double& shear_;
  double young_before_, shear_before_;  // [Pa]
};

// Where a grain and a wall are apart, LIGGGHTS' cohesion easo/capillary/viscous reads the velocity of an atom instead
// of the wall's: atom->v[j] with j = -type, before the start of the array. While this object exists, that element
// exists and holds the velocity of the wall. Of the atoms only grain i is there, which the contact model computes.
class ScopedWallAsAtom {
 public:
  // array: Atom::v; rows: memory reused from contact to contact; wall: 3 numbers [m/s].
  ScopedWallAsAtom(double**& array, std::vector<double*>& rows, int i, int type, double* wall)
      : array_(array), before_(array) {
    const std::size_t last = static_cast<std::size_t>(i) + static_cast<std::size_t>(type);
    if (rows.size() <= last) rows.resize(2 * last + 1);
    double** const first = rows.data() + type;
    first[i] = array[i];
    first[-type] = wall;
    array_ = first;
  }
  ~ScopedWallAsAtom() { array_ = before_; }
  ScopedWallAsAtom(const ScopedWallAsAtom&) = delete;
  ScopedWallAsAtom& operator=(const ScopedWallAsAtom&) = delete;

 private:
  double**& array_;
  double** const before_;
};

}  // namespace footfall
