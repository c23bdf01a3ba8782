#pragma once
// What a run writes down: the columns of history.csv and the figures of summary.json, taken from samples.
// Names as docs give them: `<body>.x`, `<strut>.stroke`, `energy.kinetic`, `coupling.omega_h.<body>`, ...

#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/observe/flexible_figures.h"
#include "mbd_solver/run/simulation.h"

namespace footfall {

// The columns of history.csv. Only what the scene has gets a column.
class Observation {
 public:
  explicit Observation(Simulation& simulation);

  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& units() const { return units_; }
  // One row, in the order of the names. The reference holds until the next call.
  const std::vector<double>& row(const Sample& sample);
  // Of all flexible bodies, over the rows so far.
  const FlexibleBodies& flexible() const { return flexible_; }

 private:
  // Writes the values of one group of columns.
  using Group = std::function<void(const Sample&, std::vector<double>&)>;
  void add_body(int body);
  void add_flexible(int k);
  void add_contact(int body, const std::string& name);
  void add_strut(const StrutEntry& strut);
  void add_controller(const ControllerEntry& controller);
  void add_energies();
  void add_coupling();
  void column(const std::string& name, const std::string& unit);

  Simulation& simulation_;
  FlexibleBodies flexible_;
  std::vector<std::string> names_, units_;
  std::vector<Group> groups_;
  std::vector<double> row_;
};

// of the reference energy: more than time integration with usual tolerances leaves open
inline constexpr double kGoodBalance = 0.01;

// Largest values over every window of a run, not only over the rows that are written.
struct Figures {
  double peak_acceleration = 0.0;  // of the heaviest body [m/s2]
  double max_descent = 0.0;        // of the heaviest body against gravity's direction, from the start [m]
  double max_penetration = 0.0;    // of the lowest boundary point below the ground at the start [m]
  double max_contact_force = 0.0;  // on one body [N]
  double reference_energy = 0.0;   // initial mechanical energy without gravity; else the largest kinetic energy [J]
  double energy_balance = 0.0;     // largest |E - E0 + dissipated - work of contact and motion| [J]
  double contact_work = 0.0;       // done by the ground's grains on the mechanism so far [J]
  double contact_force = 0.0;      // on all bodies now [N]

  double energy_balance_relative() const { return reference_energy > 0.0 ? energy_balance / reference_energy : 0.0; }
};

class FigureTaker {
 public:
  explicit FigureTaker(Simulation& simulation);
  void take(const Sample& sample);
  const Figures& figures() const { return figures_; }
  // What to tell when the mechanism's energy did not close to kGoodBalance; empty otherwise.
  std::string balance_warning() const;
  const std::string& body_name() const;  // the heaviest body, whose acceleration and descent are reported

 private:
  double lowest_boundary_point(const Sample& sample);

  Simulation& simulation_;
  Figures figures_;
  Eigen::Vector3d up_;
  int body_ = 0;
  double start_height_ = 0.0;  // [m]
  double start_energy_ = 0.0;  // [J]
  bool started_ = false;
};

}  // namespace footfall
