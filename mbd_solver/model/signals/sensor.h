#pragma once
// What a continuous signal can measure within a step: positions and velocities, never accelerations or forces, so that
// what follows from it stands on the right side of the equations of motion. A sensor may have one inner state.

#include <array>
#include <memory>

#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/joints/joint.h"
#include "mbd_solver/model/joints/joint_coordinate.h"

namespace footfall {

class Sensor {
 public:
  virtual ~Sensor() = default;
  virtual std::array<int, 2> bodies() const = 0;  // whose motion it sees; kGround where one is enough
  virtual bool has_state() const { return false; }
  // z: its state, or anything. rate_of_state is asked for where there is one.
  virtual double value(const PairMotion& pair, double z) const = 0;
  virtual double rate_of_state(const PairMotion&, double) const { return 0.0; }
};

// A number of one body's motion.
class BodySensor final : public Sensor {
 public:
  BodySensor(int body, double (*reads)(const BodyKinematics&)) : body_(body), reads_(reads) {}
  std::array<int, 2> bodies() const override { return {kGround, body_}; }
  double value(const PairMotion& pair, double) const override { return reads_(*pair.body[1]); }

 private:
  int body_;
  double (*reads_)(const BodyKinematics&);
};

// A coordinate of a joint. An angle goes on over any number of turns; its state counts them, as that of a JointForce.
class CoordinateSensor final : public Sensor {
 public:
  CoordinateSensor(const Joint& joint, Coordinate coordinate) : m1_(joint.m1), m2_(joint.m2), coordinate_(coordinate) {}
  std::array<int, 2> bodies() const override { return {m1_.body, m2_.body}; }
  bool has_state() const override { return coordinate_ == Coordinate::kAngle; }
  double value(const PairMotion& pair, double z) const override;
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
  double value(const PairMotion& pair, double) const override {
    return JointCoordinate(coordinate_, pair, m1_, m2_).rate();
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
  double value(const PairMotion& pair, double) const override {
    const StrutMotion at = strut_.motion(pair);
    return reads_ == Reads::kStroke ? at.stroke : at.rate;
  }

 private:
  const Strut& strut_;
  Reads reads_;
};

}  // namespace footfall
