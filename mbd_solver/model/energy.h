#pragma once
// Where energy is and where it goes, by the names of history.csv.

#include <array>
#include <string_view>

#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

// [J]. energy.<name>
struct StoredEnergy {
  double kinetic = 0.0;
  double gravity = 0.0;  // zero where r = 0
  double strain = 0.0;   // modes, springs, elastic part of honeycombs and stops
  double gas = 0.0;
  double contact = 0.0;  // elastic energy of rigid-plane contacts
  double total() const { return kinetic + gravity + strain + gas + contact; }
};

// dissipated.<name>
enum class Dissipation { kMrViscous, kMrYield, kHoneycomb, kDamper, kStop, kModal, kFriction, kContact };
inline constexpr int kDissipationCount = 8;
std::string_view dissipation_name(Dissipation kind);
Dissipation dissipation_of(EnergyKind kind);  // of a strut law; demands a kind that can dissipate

// Power [W] or work [J] by kind, each >= 0.
struct Dissipated {
  std::array<double, kDissipationCount> by_kind{};
  double& operator[](Dissipation kind) { return by_kind[static_cast<std::size_t>(kind)]; }
  double operator[](Dissipation kind) const { return by_kind[static_cast<std::size_t>(kind)]; }
  double total() const {
    double sum = 0.0;
    for (double value : by_kind) sum += value;
    return sum;
  }
};

}  // namespace footfall
