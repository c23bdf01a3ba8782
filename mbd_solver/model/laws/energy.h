#pragma once
// Where energy is and where it goes. The names are those of history.csv: energy.<name>, dissipated.<name>.

#include <array>
#include <string_view>

#include "coupler/base/kinds.h"

namespace footfall {

enum class Stored {
  kKinetic,
  kGravity,  // zero where r = 0
  kStrain,   // modes, springs, elastic part of honeycombs and stops
  kGas,
  kContact  // elastic energy of rigid-plane contacts
};
constexpr std::string_view name_of(Stored kind) {
  switch (kind) {
    case Stored::kKinetic: return "kinetic";
    case Stored::kGravity: return "gravity";
    case Stored::kStrain: return "strain";
    case Stored::kGas: return "gas";
    case Stored::kContact: return "contact";
  }
  return {};
}

enum class Dissipation { kMrViscous, kMrYield, kHoneycomb, kDamper, kStop, kModal, kFriction, kContact };
constexpr std::string_view name_of(Dissipation kind) {
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
  return {};
}

// Who brings energy into a mechanism, contacts with grains apart. The names are those of history.csv: work.<name>.
enum class Supply {
  kMotion,  // prescribed motions
  kForce,   // forces and torques of the scene
  kDrive    // drives of joints
};
constexpr std::string_view name_of(Supply source) {
  switch (source) {
    case Supply::kMotion: return "motion";
    case Supply::kForce: return "force";
    case Supply::kDrive: return "drive";
  }
  return {};
}

// One number for each kind.
template <class Kind>
struct ByKind {
  std::array<double, static_cast<std::size_t>(count_of<Kind>())> by_kind{};
  double& operator[](Kind kind) { return by_kind[static_cast<std::size_t>(kind)]; }
  double operator[](Kind kind) const { return by_kind[static_cast<std::size_t>(kind)]; }
  double total() const {
    double sum = 0.0;
    for (const double value : by_kind) sum += value;
    return sum;
  }
  template <class Archive>
  void visit(Archive& archive) {
    archive("by_kind", by_kind);
  }
};

using StoredEnergy = ByKind<Stored>;     // [J]
using Dissipated = ByKind<Dissipation>;  // power [W] or work [J], each >= 0
using Supplied = ByKind<Supply>;         // power [W] or work [J]

}  // namespace footfall
