#pragma once
// The constant description of a mechanism: bodies, joints, force elements, gravity. Built once, then only read.

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "mbd_solver/model/body.h"
#include "mbd_solver/model/elements/joint.h"
#include "mbd_solver/model/force_element.h"
#include "mbd_solver/model/marker.h"

namespace footfall {

class ContinuousSignals;  // control/continuous_signals.h, which includes joints and elements
class Model;

// A force element of a model with its type, from Model::add_force().
template <class T>
class Handle {
 public:
  Handle() = default;  // of no element
  template <class Derived, class = std::enable_if_t<std::is_base_of_v<T, Derived>>>
  Handle(const Handle<Derived>& other) : index_(other.index()) {}

  explicit operator bool() const { return index_ >= 0; }
  int index() const { return index_; }  // in the model; -1: no element
  const T& of(const Model& model) const;

 private:
  friend class Model;
  explicit Handle(int index) : index_(index) {}

  int index_ = -1;
};

class Model {
 public:
  // `gravity` [m/s2] in W.
  explicit Model(const Eigen::Vector3d& gravity = Eigen::Vector3d::Zero()) : gravity_(gravity) {}

  // Each returns the index of the new part, or its handle. Names must be unique among their kind (InputError).
  int add_body(Body body, const BodyState& initial);
  int add_joint(Joint joint);
  template <class T>
  Handle<T> add_force(std::unique_ptr<T> element) {
    return Handle<T>(add_element(std::move(element)));
  }
  // Once, after the parts that the signals measure.
  void set_signals(std::shared_ptr<const ContinuousSignals> signals) { signals_ = std::move(signals); }

  const Eigen::Vector3d& gravity() const { return gravity_; }
  int body_count() const { return static_cast<int>(bodies_.size()); }
  int joint_count() const { return static_cast<int>(joints_.size()); }
  int force_count() const { return static_cast<int>(forces_.size()); }
  const Body& body(int index) const { return bodies_[index]; }
  const Joint& joint(int index) const { return joints_[index]; }
  const ForceElement& force(int index) const { return *forces_[index]; }
  const ContinuousSignals* signals() const { return signals_.get(); }  // null if there are none
  const BodyState& initial(int index) const { return initial_[index]; }
  // Index by name; InputError with a list of the known names.
  int body_index(const std::string& name) const;
  std::optional<int> find_body(const std::string& name) const;

  // Marker on a body (or kGround) from a point and axes given in W at the initial state.
  Marker marker_at(int body, const Eigen::Vector3d& p_W,
                   const Eigen::Matrix3d& axes_W = Eigen::Matrix3d::Identity()) const;
  // Position of a marker at the initial state, in W [m].
  Eigen::Vector3d initial_position(const Marker& marker) const;

 private:
  int add_element(std::unique_ptr<ForceElement> element);

  Eigen::Vector3d gravity_;
  std::vector<Body> bodies_;
  std::vector<BodyState> initial_;
  std::vector<Joint> joints_;
  std::vector<std::unique_ptr<ForceElement>> forces_;
  std::unordered_map<std::string, int> body_names_, joint_names_, force_names_;  // indices
  std::shared_ptr<const ContinuousSignals> signals_;
};

// The scratch of all force elements of a model, for one evaluation at a time.
class ElementScratches {
 public:
  explicit ElementScratches(const Model& model);
  ElementScratch* of(int force) { return scratches_[force].get(); }  // null for an element that needs none

 private:
  std::vector<std::unique_ptr<ElementScratch>> scratches_;
};

template <class T>
const T& Handle<T>::of(const Model& model) const {
  return static_cast<const T&>(model.force(index_));
}

}  // namespace footfall
