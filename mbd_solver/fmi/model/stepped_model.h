#pragma once
// The model that an exported FMU controls: the mechanism in this process, or the coupled pair with its grains (led_pair.h).

#include <string>
#include <vector>

#include "mbd_solver/embed/session.h"

namespace footfall {

class SteppedModel {
 public:
  virtual ~SteppedModel() = default;

  virtual double time() const = 0;  // [s]
  virtual bool finished() const = 0;
  // Columns of history.csv, and their values now.
  virtual const std::vector<std::string>& names() const = 0;
  virtual const std::vector<std::string>& units() const = 0;
  virtual std::vector<double> row() const = 0;
  virtual std::vector<std::string> signals() const = 0;  // of kind "host"
  virtual double signal(const std::string& name) const = 0;
  virtual void set_signal(const std::string& name, double value) = 0;
  // To this time [s]. early: at most to the next event that changes the state; true: that ended the step.
  virtual bool step(double until, bool early) = 0;
  virtual std::string save() = 0;
  virtual void restore(const std::string& state) = 0;
  virtual double energy_balance() const = 0;  // its relative error so far [-]
  virtual double summed_error() const = 0;    // estimated, of all steps [tolerances of the scene]
  virtual std::vector<std::string> warnings() const = 0;

  double value(const std::string& column) const;  // throws InputError
};

class MechanismModel : public SteppedModel {
 public:
  MechanismModel(Scene scene, bool trusted) : simulation_(std::move(scene), SessionOptions{trusted, false}) {}

  double time() const override { return simulation_.time(); }
  bool finished() const override { return simulation_.finished(); }
  const std::vector<std::string>& names() const override { return simulation_.names(); }
  const std::vector<std::string>& units() const override { return simulation_.units(); }
  std::vector<double> row() const override { return simulation_.row(); }
  std::vector<std::string> signals() const override { return simulation_.signals(); }
  double signal(const std::string& name) const override { return simulation_.signal(name); }
  void set_signal(const std::string& name, double value) override { simulation_.set(name, value); }
  bool step(double until, bool early) override;
  std::string save() override { return simulation_.save(); }
  void restore(const std::string& state) override { simulation_.restore(state); }
  double energy_balance() const override { return simulation_.energy_balance(); }
  double summed_error() const override { return simulation_.summed_error(); }
  std::vector<std::string> warnings() const override { return simulation_.warnings(); }

 private:
  Session simulation_;
};

}  // namespace footfall
