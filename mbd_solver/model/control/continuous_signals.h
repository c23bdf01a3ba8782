#pragma once
// Continuous signals, evaluated with the equations of motion, and the sensors that they read.

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "mbd_solver/model/body.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/model/elements/cable.h"
#include "mbd_solver/model/elements/joint.h"
#include "mbd_solver/model/elements/joint_coordinate.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

// --- Named numbers of one body's motion: columns of a history, and measurements of signals.

// A column of every thing of one kind; `value` reads it from the thing's current state.
template <class Thing>
struct Entry {
  const char* pattern;
  const char* unit;
  double (*value)(const Thing&);
};

inline constexpr Entry<BodyKinematics> kBodyEntries[] = {
    {"<body>.x", "m", [](const BodyKinematics& b) { return b.r.x(); }},
    {"<body>.y", "m", [](const BodyKinematics& b) { return b.r.y(); }},
    {"<body>.z", "m", [](const BodyKinematics& b) { return b.r.z(); }},
    {"<body>.vx", "m/s", [](const BodyKinematics& b) { return b.dr.x(); }},
    {"<body>.vy", "m/s", [](const BodyKinematics& b) { return b.dr.y(); }},
    {"<body>.vz", "m/s", [](const BodyKinematics& b) { return b.dr.z(); }},
    {"<body>.ax", "m/s2", [](const BodyKinematics& b) { return b.ddr.x(); }},
    {"<body>.ay", "m/s2", [](const BodyKinematics& b) { return b.ddr.y(); }},
    {"<body>.az", "m/s2", [](const BodyKinematics& b) { return b.ddr.z(); }},
    {"<body>.roll", "rad", [](const BodyKinematics& b) { return rpy_from_rotation(b.A)(0); }},
    {"<body>.pitch", "rad", [](const BodyKinematics& b) { return rpy_from_rotation(b.A)(1); }},
    {"<body>.yaw", "rad", [](const BodyKinematics& b) { return rpy_from_rotation(b.A)(2); }}};

inline constexpr Entry<BodyKinematics> kAttitudeEntries[] = {
    {"<body>.wx", "rad/s", [](const BodyKinematics& b) { return b.w.x(); }},
    {"<body>.wy", "rad/s", [](const BodyKinematics& b) { return b.w.y(); }},
    {"<body>.wz", "rad/s", [](const BodyKinematics& b) { return b.w.z(); }},
    {"<body>.qw", "-", [](const BodyKinematics& b) { return b.L(0) / b.L.norm(); }},
    {"<body>.qx", "-", [](const BodyKinematics& b) { return b.L(1) / b.L.norm(); }},
    {"<body>.qy", "-", [](const BodyKinematics& b) { return b.L(2) / b.L.norm(); }},
    {"<body>.qz", "-", [](const BodyKinematics& b) { return b.L(3) / b.L.norm(); }}};

inline constexpr Entry<CableSample> kCableEntries[] = {
    {"<cable>.length", "m", [](const CableSample& s) { return s.length; }},
    {"<cable>.force", "N", [](const CableSample& s) { return s.force; }},
    {"<cable>.slack", "m", [](const CableSample& s) { return s.stretch < 0.0 ? -s.stretch : 0.0; }},
    {"<cable>.unstretched", "m", [](const CableSample& s) { return s.unstretched; }}};

// A measurement of a continuous signal within a step: positions, velocities and functions of them alone, never
// accelerations, because signals belong to the right-hand side of the equations of motion. A sensor may have one inner state.
class Sensor {
 public:
  virtual ~Sensor() = default;
  virtual std::array<int, 2> bodies() const = 0;  // whose motion it measures; kGround if one is enough
  virtual const std::vector<int>& further_bodies() const;
  virtual int element() const { return -1; }  // the force element of the model whose states it reads; -1: none
  virtual bool has_state() const { return false; }
  // in: its bodies and the states of its element; z: its own state, if it has one.
  virtual double value(const ElementInput& in, double z) const = 0;
  virtual double rate_of_state(const PairMotion&, double) const { return 0.0; }
};

// Its value now; z: its own state. instant: has pair(body_1, body_2), of(body) and states(force element). No allocation.
template <class Instant>
double measured_by(const Sensor& sensor, const Instant& instant, double z) {
  static const Eigen::VectorXd kNone;
  const std::array<int, 2> bodies = sensor.bodies();
  ElementInput in{instant.pair(bodies[0], bodies[1]), instant.states(sensor.element()), kNone};
  const std::vector<int>& further = sensor.further_bodies();
  for (std::size_t i = 0; i < further.size(); ++i) in.further[i] = &instant.of(further[i]);
  return sensor.value(in, z);
}

// A number of one body's motion.
class BodySensor final : public Sensor {
 public:
  BodySensor(int body, double (*reads)(const BodyKinematics&)) : body_(body), reads_(reads) {}
  std::array<int, 2> bodies() const override { return {kGround, body_}; }
  double value(const ElementInput& in, double) const override { return reads_(*in.pair.body[1]); }

 private:
  int body_;
  double (*reads_)(const BodyKinematics&);
};

// A coordinate of a joint. Angles count any number of turns, by the state, as in a JointForce.
class CoordinateSensor final : public Sensor {
 public:
  CoordinateSensor(const Joint& joint, Coordinate coordinate) : m1_(joint.m1), m2_(joint.m2), coordinate_(coordinate) {}
  std::array<int, 2> bodies() const override { return {m1_.body, m2_.body}; }
  bool has_state() const override { return coordinate_ == Coordinate::kAngle; }
  double value(const ElementInput& in, double z) const override;
  double rate_of_state(const PairMotion& pair, double z) const override;

 private:
  Marker m1_, m2_;
  Coordinate coordinate_;
};

// Its rate.
class CoordinateRateSensor final : public Sensor {
 public:
  CoordinateRateSensor(const Joint& joint, Coordinate coordinate)
      : m1_(joint.m1), m2_(joint.m2), coordinate_(coordinate) {}
  std::array<int, 2> bodies() const override { return {m1_.body, m2_.body}; }
  double value(const ElementInput& in, double) const override {
    return JointCoordinate(coordinate_, in.pair, m1_, m2_).rate();
  }

 private:
  Marker m1_, m2_;
  Coordinate coordinate_;
};

// Stroke or rate of a strut, which must outlive this.
class StrutSensor final : public Sensor {
 public:
  enum class Reads { kStroke, kRate };
  StrutSensor(const Strut& strut, Reads reads) : strut_(strut), reads_(reads) {}
  std::array<int, 2> bodies() const override { return strut_.bodies(); }
  double value(const ElementInput& in, double) const override {
    const StrutMotion at = strut_.motion(in.pair);
    return reads_ == Reads::kStroke ? at.stroke : at.rate;
  }

 private:
  const Strut& strut_;
  Reads reads_;
};

// A number of a cable, which must outlive this. Its angles at rounds are derivatives of positions; its states only count
// their whole turns.
class CableSensor final : public Sensor {
 public:
  // element: of the cable, in the model.
  CableSensor(const Cable& cable, int element, double (*reads)(const CableSample&))
      : cable_(cable), element_(element), reads_(reads) {}
  std::array<int, 2> bodies() const override { return cable_.bodies(); }
  const std::vector<int>& further_bodies() const override { return cable_.further_bodies(); }
  int element() const override { return element_; }
  double value(const ElementInput& in, double) const override { return reads_(cable_.sample(in)); }

 private:
  const Cable& cable_;
  int element_;
  double (*reads_)(const CableSample&);
};

// The source of a named value.
struct SignalSource {
  enum class Kind {
    kTime,
    kPlace,  // inputs[index]: controllers, sampled signals, states of the scene
    kSince,  // time - inputs[index]: seconds in the current state of the scene
    kSensor  // sensors[index]
  };
  Kind kind = Kind::kTime;
  std::size_t index = 0;
};

// The continuous signals of a model: evaluated at every stage of a step; their inner states are integrated with the
// states of the mechanism. Evaluation stores values: each evaluation of a model has its own copy.
class ContinuousSignals {
 public:
  // sources: one per name of the chain.
  ContinuousSignals(SignalChain chain, std::vector<SignalSource> sources, std::vector<std::unique_ptr<Sensor>> sensors);

  int state_count() const { return chain_.state_count() + sensor_states_; }
  const SignalChain& chain() const { return chain_; }

  // The part that depends on the motion of one body, or on the states of one signal or sensor.
  struct Influence {
    int body = kGround;                      // whose motion; kGround: states
    int first_state = 0, state_count = 0;    // these states
    std::vector<std::size_t> sensors;        // measured anew
    std::vector<std::size_t> nodes;          // of the chain, evaluated anew, in its order
    std::vector<int> places;                 // of their values among the inputs
    std::vector<std::pair<int, int>> rates;  // first state and number of states of those that have states
  };
  // The influences of all measured bodies, in rising order, then of all states.
  std::vector<Influence> influences() const;

  // Writes the signals into their places among the input `values`, and the rates of the states into dz. instant: as of
  // measured_by(). Throws NumericalError. No allocation.
  template <class Instant>
  void evaluate(double t, const Instant& instant, const Eigen::Ref<const Eigen::VectorXd>& z,
                Eigen::Ref<Eigen::VectorXd> values, Eigen::Ref<Eigen::VectorXd> dz) {
    for (std::size_t i = 0; i < sensors_.size(); ++i) measure(i, instant, z, dz);
    set_names(t, values);
    for (std::size_t k = 0; k < chain_.size(); ++k) set_value(k, z, values);
    for (std::size_t k = 0; k < chain_.size(); ++k) set_rates(k, z, dz);
  }
  // The same if only parts under this influence differ from the last evaluation.
  template <class Instant>
  void evaluate(const Influence& changed, const Instant& instant, const Eigen::Ref<const Eigen::VectorXd>& z,
                Eigen::Ref<Eigen::VectorXd> values, Eigen::Ref<Eigen::VectorXd> dz) {
    for (const std::size_t i : changed.sensors) {
      measure(i, instant, z, dz);
      chain_.set(name_of_sensor_[i], measured_[static_cast<Eigen::Index>(i)]);
    }
    for (const std::size_t k : changed.nodes) set_value(k, z, values);
    for (const std::size_t k : changed.nodes) set_rates(k, z, dz);
  }
  // Settles the states of every signal (before null), or of those that were inactive under the inputs `before`. Throws
  // NumericalError; at the start, with before null, InputError.
  template <class Instant>
  void settle(double t, const Instant& instant, const Eigen::VectorXd* before, Eigen::Ref<Eigen::VectorXd> z,
              Eigen::Ref<Eigen::VectorXd> values) {
    for (std::size_t i = 0; i < sensors_.size(); ++i) measure(i, instant, z, scratch_);
    start(t, before, z, values);
  }

 private:
  template <class Instant>
  void measure(std::size_t i, const Instant& instant, const Eigen::Ref<const Eigen::VectorXd>& z,
               Eigen::Ref<Eigen::VectorXd> dz) {
    const int state = sensor_state_[i];
    measured_[static_cast<Eigen::Index>(i)] = measured_by(*sensors_[i], instant, state >= 0 ? z[state] : 0.0);
    if (state < 0) return;
    const std::array<int, 2> bodies = sensors_[i]->bodies();
    dz[state] = sensors_[i]->rate_of_state(instant.pair(bodies[0], bodies[1]), z[state]);
  }
  // Adds the nodes that read its sensors or nodes, and the places and rates of all.
  void complete(Influence& influence, std::vector<bool>& visited) const;
  double output(std::size_t k, const Eigen::Ref<const Eigen::VectorXd>& states);  // value of node k
  void set_names(double t, const Eigen::Ref<const Eigen::VectorXd>& values);
  void set_value(std::size_t k, const Eigen::Ref<const Eigen::VectorXd>& z, Eigen::Ref<Eigen::VectorXd> values);
  void set_rates(std::size_t k, const Eigen::Ref<const Eigen::VectorXd>& z, Eigen::Ref<Eigen::VectorXd> dz);
  void start(double t, const Eigen::VectorXd* before, Eigen::Ref<Eigen::VectorXd> z,
             Eigen::Ref<Eigen::VectorXd> values);

  SignalChain chain_;
  std::vector<SignalSource> sources_;
  std::vector<std::shared_ptr<const Sensor>> sensors_;
  std::vector<int> sensor_state_;                                      // place of its state among all states, or -1
  std::vector<std::size_t> name_of_sensor_;                            // its place among the names of the chain
  std::vector<std::vector<std::size_t>> readers_, readers_of_sensor_;  // nodes that read a node, a sensor
  int sensor_states_ = 0;
  Eigen::VectorXd measured_, scratch_;
};

}  // namespace footfall
