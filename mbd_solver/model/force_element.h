#pragma once
// A force element acts on one or two bodies (or a body and the ground), may own inner states z, and reports its energy and
// power. Generalized forces and derivatives are local to its pair of bodies: velocities [v1; v2], increments [dx1; dx2] as in
// kinematic_vector.h; the assembler scatters them. A cable acts on further bodies, whose coordinates follow the coordinates
// of the pair. Gravity is a constant of the model and external loads are constants of a window; neither is a force element.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/model/kinematic_vector.h"
#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

class ForceElement;

inline constexpr std::size_t kMostBodies = 8;  // on which one element acts

// Scratch data of an element during evaluation: buffers, and results for the last state or step. Elements themselves
// are constant, so that several evaluations may share a model, each with its own scratch.
struct ElementScratch {
  explicit ElementScratch(const ForceElement& element) : owner(&element) {}
  virtual ~ElementScratch() = default;
  const ForceElement* owner;  // whose scratch this is
};

// Data that several elements share and an evaluation changes, such as tracks in a soil: one copy for each evaluation.
class SharedCopies {
 public:
  template <class T>
  std::shared_ptr<T> of(const std::shared_ptr<const T>& original) {
    if (original == nullptr) return nullptr;
    std::shared_ptr<void>& copy = copies_[original.get()];
    if (copy == nullptr) copy = std::make_shared<T>(*original);
    return std::static_pointer_cast<T>(copy);
  }

 private:
  std::map<const void*, std::shared_ptr<void>> copies_;  // by the original
};

struct ElementInput {
  PairMotion pair;
  Eigen::Ref<const Eigen::VectorXd> z;  // inner states of this element
  // Inputs of the model: controller outputs, then signals; only continuous signals change within a step.
  Eigen::Ref<const Eigen::VectorXd> inputs;
  double time = 0.0;                                             // [s]
  std::array<const BodyKinematics*, kMostBodies - 2> further{};  // of ForceElement::further_bodies()
  ElementScratch* scratch = nullptr;                             // from ForceElement::scratch()

  int size() const {  // of the generalized force
    int n = pair.size();
    for (std::size_t i = 0; i < further.size() && further[i] != nullptr; ++i) n += further[i]->size();
    return n;
  }
};

// Sized once by the assembler, zeroed before each call. n = ElementInput::size(), m = state_count().
struct ElementDerivatives {
  Eigen::MatrixXd dQ_dx, dQ_dv;    // n x n: of the generalized force
  Eigen::MatrixXd dQ_dz;           // n x m
  Eigen::MatrixXd ddz_dx, ddz_dv;  // m x n: of the rate of z
  Eigen::MatrixXd ddz_dz;          // m x state_block(): of each block of z by itself, one below the other
};

class ForceElement {
 public:
  ForceElement(std::string name, int body_1, int body_2) : name_(std::move(name)), bodies_{body_1, body_2} {}
  virtual ~ForceElement() = default;

  const std::string& name() const { return name_; }
  const std::array<int, 2>& bodies() const { return bodies_; }         // body indices or kGround
  const std::vector<int>& further_bodies() const { return further_; }  // body indices

  virtual int state_count() const { return 0; }
  // Inner states act on each other only within blocks of this size, which divides state_count().
  virtual int state_block() const { return state_count(); }
  virtual std::array<int, 2> read_inputs() const { return {-1, -1}; }  // places in ElementInput::inputs; -1: none
  // Required size of ElementInput::inputs.
  int input_count() const { return 1 + std::max(read_inputs()[0], read_inputs()[1]); }
  virtual Eigen::VectorXd initial_state() const { return {}; }
  // For one evaluation, to be passed with every input; null: this element needs none.
  virtual std::unique_ptr<ElementScratch> scratch(SharedCopies&) const { return nullptr; }
  // Q += generalized force (n); dz = rate of the inner states (m, overwritten).
  virtual void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q,
                         Eigen::Ref<Eigen::VectorXd> dz) const = 0;
  // Adds all derivatives; false if all are zero (no contact), and nothing is to be scattered.
  virtual bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const = 0;
  // Adds stored energy and dissipated power. Identity: supplied power - Q.v = d(stored)/dt + sum of dissipated power.
  virtual void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const = 0;
  // Adds the power supplied from outside.
  virtual void add_supply(const ElementInput&, Supplied&) const {}

 protected:
  // The scratch of an input, as the type that scratch() of this element makes.
  template <class Scratch>
  Scratch& scratch_of(const ElementInput& in) const {
    FOOTFALL_DEMAND(in.scratch != nullptr);
    return own_scratch<Scratch>(*in.scratch);
  }
  template <class Scratch, class Any>
  Scratch& own_scratch(Any& scratch) const {
    FOOTFALL_DEMAND(scratch.owner == this);
    return static_cast<Scratch&>(scratch);
  }
  // For an element on any number of bodies, at most kMostBodies.
  void set_bodies(const std::vector<int>& bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) (i < 2 ? bodies_[i] : further_.emplace_back()) = bodies[i];
  }

 private:
  std::string name_;
  std::array<int, 2> bodies_;
  std::vector<int> further_;
};

// Interface of an element with inner states that may be modes (StrutLaw::switches): they change between integration steps alone.
class Switching {
 public:
  virtual ~Switching() = default;
  virtual bool switches() const = 0;                              // false: this element has no modes
  virtual double switch_value(const ElementInput& in) const = 0;  // below 0 where a mode no longer fits
  // Sets the modes that no longer fit; true if there were any.
  virtual bool switch_states(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> z) const = 0;
};

// Null for elements without modes.
inline const Switching* switching(const ForceElement& element) {
  const auto* const found = dynamic_cast<const Switching*>(&element);
  return found != nullptr && found->switches() ? found : nullptr;
}

// Interface of an element with a memory of the past that changes between integration steps alone. Forces must not
// jump there while the state remains. The memory is part of the state (State::memory); the scratch holds it unpacked.
class Remembering {
 public:
  virtual ~Remembering() = default;
  // Takes the memory from these numbers and moves on behind them; null: the memory of the start.
  virtual void recall(const double*& numbers, ElementScratch& scratch) const = 0;
  virtual void save_memory(const ElementScratch& scratch, std::vector<double>& out) const = 0;  // appends its numbers
  virtual bool remember(const ElementInput& in) const = 0;  // at the end of a step; true if anything changed
};

}  // namespace footfall
