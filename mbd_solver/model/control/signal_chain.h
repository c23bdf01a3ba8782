#pragma once
// An arithmetic or logical expression of named values, "0.3 - knee.angle", by muParser: + - * / ^, < <= > >= == !=, && ||,
// c ? a : b, min, max, abs, sqrt, exp, ln, sin ... atan2, pi. True is 1, false is 0.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/model/control/signal_blocks.h"

namespace mu {
class Parser;
}

namespace footfall {

using NamedValues = std::map<std::string, double>;  // a map keeps its places

class Expression {
 public:
  // The names that a text reads, in alphabetical order. Throws InputError: what is wrong with it, and where.
  static std::vector<std::string> names_in(const std::string& text);

  // Reads the values where they stand; all its names are among them, and stay there. Throws as names_in.
  Expression(std::string text, NamedValues& values);
  ~Expression();
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  // Of the values now. Throws NumericalError where it has none (a division by zero, the root of a negative number), with
  // the values of its names.
  double value() const;
  const std::string& text() const { return text_; }

 private:
  [[noreturn]] void complain_of_no_value() const;

  std::string text_;
  std::unique_ptr<mu::Parser> parser_;
};

// Signals that are evaluated together, in an order in which each reads what stands before it, and the named values that
// their expressions read. A signal NAME is the value "signal.NAME" to the others.

struct SignalNode {
  std::string name;
  std::unique_ptr<SignalBlock> block;
  std::vector<std::string> inputs;  // expressions, one per input of the block
  std::vector<std::string> states;  // it works in these states of the scene only, else it is 0; empty: always
  std::optional<double> initial;    // value of its inputs before the start; not given: those of the start
  double period = 0.0;              // [s]; 0: continuous
  int place = 0;                    // of its value among the inputs of a run
  // Where the inputs stand, for messages: "scene.toml:40: signals.pitch.input: ". Empty: they go by the node's name.
  std::vector<std::string> written_at = {};
};

class SignalChain {
 public:
  // Throws InputError: an expression that cannot be read, or signals that depend on each other in a circle.
  explicit SignalChain(std::vector<SignalNode> nodes);

  std::size_t size() const { return nodes_.size(); }
  const SignalNode& node(std::size_t k) const { return nodes_[k]; }
  int state_count() const { return states_; }
  int first_state(std::size_t k) const { return first_state_[k]; }

  // The names that come from elsewhere, and their values, to be set before an evaluation.
  const std::vector<std::string>& names() const { return names_; }
  void set(std::size_t name, double value) const { *outside_[name] = value; }

  // Node k at the present values; nodes before it are up to date. Throws NumericalError, naming the input.
  bool works(std::size_t k) const;                                   // in the present state
  const Eigen::VectorXd& inputs(std::size_t k) const;                // good until the next call
  void put(std::size_t k, double value) const { *own_[k] = value; }  // what those behind it read

  // The inner states of node k at the start, or where it begins to work.
  void settle(std::size_t k, Eigen::Ref<Eigen::VectorXd> z) const;

 private:
  std::vector<SignalNode> nodes_;  // in order
  std::vector<int> first_state_;
  int states_ = 0;
  std::unique_ptr<NamedValues> values_;  // which the expressions view
  std::vector<std::string> names_;
  std::vector<double*> outside_, own_;
  std::vector<std::vector<Expression>> expressions_;    // per node and input
  std::vector<std::vector<const double*>> activities_;  // per node: the values of its states
  mutable std::vector<Eigen::VectorXd> inputs_;
};

// Names in an order in which each stands behind those it depends on; reads(i): indices. A circle is an InputError that
// names it: "a -> b -> a".
std::vector<std::size_t> evaluation_order(const std::vector<std::string>& names,
                                          const std::vector<std::vector<std::size_t>>& reads);

}  // namespace footfall
