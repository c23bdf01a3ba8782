#pragma once
// The force law of a strut along its line, and the kinds of energy that laws and elements report.

#include <Eigen/Dense>
#include <array>
#include <string_view>
#include <vector>

#include "mbd_solver/base/kinds.h"

namespace footfall {

// Kinds of stored energy: energy.<name> of history.csv.
enum class Stored {
  kKinetic,
  kGravity,  // zero where r = 0
  kStrain,   // modes, springs, elastic part of honeycombs and stops
  kGas,
  kContact  // elastic energy of rigid-plane contacts
};
constexpr std::string_view name_of(Stored kind) {
  return name_in(kind, "kinetic", "gravity", "strain", "gas", "contact");
}

// Kinds of dissipation: dissipated.<name> of history.csv.
enum class Dissipation {
  kMrViscous,
  kMrYield,
  kHoneycomb,
  kDamper,
  kStop,
  kModal,
  kFriction,
  kContact,
  kSoil,
  kSoilInertia
};
constexpr std::string_view name_of(Dissipation kind) {
  return name_in(kind, "mr_viscous", "mr_yield", "honeycomb", "damper", "stop", "modal", "friction", "contact", "soil",
                 "soil_inertia");
}

// Sources of energy other than contacts with grains: work.<name> of history.csv.
enum class Supply {
  kMotion,  // prescribed motions
  kForce,   // forces and torques of the scene
  kDrive    // drives of joints
};
constexpr std::string_view name_of(Supply source) { return name_in(source, "motion", "force", "drive"); }

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

// Arguments of a law. Stroke x = undeformed length - length [m] (compression positive), rate = dx/dt [m/s].
struct StrutInput {
  double stroke = 0.0;   // [m]
  double rate = 0.0;     // [m/s]
  double voltage = 0.0;  // U commanded by a controller or constant, in [0, 1] [-]; constant within a step
  Eigen::Ref<const Eigen::VectorXd> z;  // inner states of this law
  double time = 0.0;                    // [s]
  double command = 0.0;                 // a signal added to its function of time, in the same unit
};

// Results of a law. Force positive in compression (it pushes the ends apart) [N].
struct StrutOutput {
  explicit StrutOutput(int states)
      : dforce_dz(states), dz(states), ddz_dstroke(states), ddz_drate(states), ddz_dz(states, states) {
    set_zero();
  }
  void set_zero() {
    force = dforce_dstroke = dforce_drate = 0.0;
    dforce_dz.setZero();
    dz.setZero();
    ddz_dstroke.setZero();
    ddz_drate.setZero();
    ddz_dz.setZero();
  }
  double force = 0.0;           // [N]
  double dforce_dstroke = 0.0;  // [N/m]
  double dforce_drate = 0.0;    // [N s/m]
  Eigen::VectorXd dforce_dz;    // states
  Eigen::VectorXd dz;           // rate of the inner states
  Eigen::VectorXd ddz_dstroke;
  Eigen::VectorXd ddz_drate;
  Eigen::MatrixXd ddz_dz;  // states x states
};

struct StrutPower {
  Dissipation kind;
  double power;  // >= 0 [W]
};

// Force as a function of stroke, rate and inner state. A strut of a scene is a list of laws between two points; each law
// is tested alone, in closed form.
class StrutLaw {
 public:
  virtual ~StrutLaw() = default;
  virtual std::string_view kind() const = 0;  // "gas_spring", "mr_damper", "honeycomb", ...
  virtual int state_count() const { return 0; }
  virtual Eigen::VectorXd initial_state() const { return {}; }
  // Force, inner rates and all derivatives. `out` is sized to state_count(); every field is overwritten. No allocation.
  // Throws NumericalError where the law has no value (gas volume exhausted), naming stroke and limit.
  virtual void evaluate(const StrutInput& in, StrutOutput& out) const = 0;
  // Energy stored and recoverable at this stroke and state [J], and its kind.
  virtual double stored_energy(const StrutInput& in) const = 0;
  virtual Stored stored_kind() const { return Stored::kStrain; }
  // Dissipated power, appended by kind.
  // Identity: force * rate + supplied power = d(stored)/dt + sum of dissipated power.
  virtual void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const = 0;
  // Inner states that are modes: their rates are 0, and they change between integration steps, where switch_value() falls
  // below 0; switch_state() then sets those that fit.
  virtual bool switches() const { return false; }
  virtual double switch_value(const StrutInput&) const { return 1.0; }
  virtual void switch_state(const StrutInput&, Eigen::Ref<Eigen::VectorXd>) const {}
  // Power that a drive supplies [W].
  virtual double supplied_power(const StrutInput&) const { return 0.0; }
};

}  // namespace footfall
