#pragma once
// Expressions of named values, and chains of signals evaluated in order.

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

using NamedValues = std::map<std::string, double>;  // addresses in a map do not change

// An arithmetic or logical expression of named values, "0.3 - knee.angle", by muParser: + - * / ^, < <= > >= == !=, && ||,
// c ? a : b, min, max, abs, sqrt, exp, ln, sin ... atan2, pi. True is 1, false is 0.
class Expression {
 public:
  // The names in a text, in alphabetical order. Throws InputError with the error and its place.
  static std::vector<std::string> names_in(const std::string& text);

  // Refers to `values`, which must contain all its names and outlive it. Throws like names_in.
  Expression(std::string text, NamedValues& values);
  ~Expression();
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  // At the current values. Throws NumericalError if it has none (division by zero, root of a negative number), with the
  // values of its names.
  double value() const;
  double value_or_nan() const;  // likewise; NaN if it has none
  const std::string& text() const { return text_; }

 private:
  [[noreturn]] void throw_no_value() const;

  std::string text_;
  std::unique_ptr<mu::Parser> parser_;
};

// Signals that are evaluated together, each after those that it reads, with the named values of their expressions. The
// signal NAME is the value "signal.NAME" to the others.
struct SignalNode {
  std::string name;
  std::shared_ptr<SignalBlock> block;
  std::vector<std::string> inputs;  // expressions, one per input of the block
  std::vector<std::string> states;  // states of the scene in which it is active, else it is 0; empty: always
  std::optional<double> initial;    // value of its inputs before the start; default: the inputs at the start
  double period = 0.0;              // [s]; 0: continuous
  int place = 0;                    // of its value among the inputs of a run
  // Places of the inputs, for messages: "scene.toml:40: signals.pitch.input: ". Empty: messages name the node.
  std::vector<std::string> written_at = {};
};

// A chain holds the values of its last evaluation. Each evaluation of a model has its own copy.
class SignalChain {
 public:
  // Throws InputError: an expression with a syntax error, or signals that depend on each other in a loop.
  explicit SignalChain(std::vector<SignalNode> nodes);
  SignalChain(const SignalChain& other);
  SignalChain(SignalChain&&) noexcept = default;
  SignalChain& operator=(SignalChain&&) noexcept = default;

  std::size_t size() const { return nodes_.size(); }
  const SignalNode& node(std::size_t k) const { return nodes_[k]; }
  int state_count() const { return states_; }
  int first_state(std::size_t k) const { return first_state_[k]; }

  // The quantities that the inputs of node k read.
  struct Reads {
    std::vector<std::size_t> nodes, names;  // other signals; values from outside, indices of names()
  };
  const Reads& reads(std::size_t k) const { return reads_[k]; }

  // The names of values from outside, to be set before an evaluation.
  const std::vector<std::string>& names() const { return names_; }
  void set(std::size_t name, double value) { *outside_[name] = value; }

  // Node k at the current values; preceding nodes are up to date. Throws NumericalError, naming the input.
  bool active(std::size_t k) const;                            // in the current state
  const Eigen::VectorXd& inputs(std::size_t k);                // valid until the next call
  void put(std::size_t k, double value) { *own_[k] = value; }  // for the nodes after it

  // The inner states of node k when it becomes active.
  void settle(std::size_t k, Eigen::Ref<Eigen::VectorXd> z);

 private:
  void bind();  // expressions and places to the values

  std::vector<SignalNode> nodes_;  // in order
  std::vector<Reads> reads_;
  std::vector<int> first_state_;
  int states_ = 0;
  std::unique_ptr<NamedValues> values_;  // the expressions refer to them
  std::vector<std::string> names_;
  std::vector<double*> outside_, own_;
  std::vector<std::vector<Expression>> expressions_;    // per node and input
  std::vector<std::vector<const double*>> activities_;  // per node: the values of its states
  std::vector<Eigen::VectorXd> inputs_;
};

// Indices in an order in which each follows those it depends on; reads[i]: indices. Throws InputError that shows the loop,
// "a <- b <- a".
std::vector<std::size_t> evaluation_order(const std::vector<std::string>& names,
                                          const std::vector<std::vector<std::size_t>>& reads);

}  // namespace footfall
