// muParser reads the expressions; a depth-first search orders the signals and finds loops.

#include "mbd_solver/model/control/signal_chain.h"

#include <muParser.h>
#include <algorithm>
#include <cmath>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

constexpr const char* kNameCharacters = "0123456789_.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

double opposite(double value) { return value == 0.0 ? 1.0 : 0.0; }

[[noreturn]] void refuse(const std::string& text, const std::string& what) {
  throw InputError(code::kExpressionSyntax, "\"" + text + "\": " + what);
}

[[noreturn]] void refuse_syntax(const std::string& text, const mu::Parser::exception_type& error) {
  std::string what = error.GetMsg();
  while (!what.empty() && (what.back() == '.' || what.back() == '\n')) what.pop_back();
  refuse(text, what + "; expected an expression such as \"0.3 - 2 * knee.angle\"");
}

// muParser accepts assignments and lists as well.
void demand_one_value(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const char before = i > 0 ? text[i - 1] : ' ', after = i + 1 < text.size() ? text[i + 1] : ' ';
    if (before == '<' || before == '>' || before == '!' || before == '=' || after == '=') continue;
    refuse(text, "assigns a value; write == to compare");
  }
}

std::unique_ptr<mu::Parser> parser_of(const std::string& text) {
  demand_one_value(text);
  auto parser = std::make_unique<mu::Parser>();
  parser->DefineNameChars(kNameCharacters);
  parser->DefineConst("pi", kPi);
  parser->DefineInfixOprt("!", opposite);
  parser->SetExpr(text);
  return parser;
}

}  // namespace

namespace {

// Reads the text; place(name) is the place of a variable.
template <typename WhereOf>
std::unique_ptr<mu::Parser> read_expression(const std::string& text, const WhereOf& place) {
  try {
    std::unique_ptr<mu::Parser> parser = parser_of(text);
    std::vector<std::string> names;
    for (const auto& [name, unused] : parser->GetUsedVar()) names.push_back(name);
    for (const std::string& name : names) parser->DefineVar(name, place(name));
    parser->Eval();  // compiles it
    if (parser->GetNumResults() != 1) refuse(text, "has several values; expected one");
    return parser;
  } catch (const mu::Parser::exception_type& error) {
    refuse_syntax(text, error);
  }
}

}  // namespace

std::vector<std::string> Expression::names_in(const std::string& text) {
  std::vector<std::string> names;
  double any = 1.0;
  read_expression(text, [&](const std::string& name) {
    names.push_back(name);
    return &any;
  });
  return names;
}

Expression::Expression(std::string text, NamedValues& values) : text_(std::move(text)) {
  parser_ = read_expression(text_, [&](const std::string& name) {
    const auto found = values.find(name);
    FOOTFALL_DEMAND(found != values.end());
    return &found->second;
  });
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

void Expression::throw_no_value() const {
  std::vector<std::string> arguments;
  for (const auto& [name, place] : parser_->GetVar()) arguments.push_back(name + " = " + number_text(*place, 4));
  throw NumericalError(code::kNoValue,
                       "\"" + text_ + "\" has no value" + (arguments.empty() ? "" : " where " + joined(arguments)) +
                           "; guard divisions, roots and logarithms, for example \"x > 0 ? sqrt(x) : 0\"");
}

double Expression::value_or_nan() const {
  try {
    const double value = parser_->Eval();
    return std::isfinite(value) ? value : std::nan("");
  } catch (const mu::Parser::exception_type&) {
    return std::nan("");
  }
}

double Expression::value() const {
  const double value = value_or_nan();
  if (!std::isfinite(value)) throw_no_value();
  return value;
}

namespace {

const std::string kSignal = "signal.", kState = "state.";

// The names in the inputs of a node, each once.
std::vector<std::string> names_read(const SignalNode& node) {
  std::vector<std::string> names;
  std::set<std::string> listed;
  for (const std::string& input : node.inputs)
    for (std::string& name : Expression::names_in(input))
      if (listed.insert(name).second) names.push_back(std::move(name));
  return names;
}

struct Sorted {
  std::vector<SignalNode> nodes;
  std::vector<std::vector<std::string>> names;  // that each of them reads
};

Sorted in_order(std::vector<SignalNode> nodes) {
  std::vector<std::vector<std::string>> read;
  std::vector<std::string> names;
  std::map<std::string, std::size_t> node_of;
  for (const SignalNode& node : nodes) {
    node_of.emplace(kSignal + node.name, names.size());
    names.push_back(node.name);
    read.push_back(names_read(node));
  }
  std::vector<std::vector<std::size_t>> reads(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (const std::string& name : read[k])
      if (const auto other = node_of.find(name); other != node_of.end()) reads[k].push_back(other->second);
  std::vector<std::size_t> order;
  try {
    order = evaluation_order(names, reads);
  } catch (const InputError&) {
    // A block without direct feedthrough depends on its states only: it may precede its inputs.
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (!nodes[k].block->passes_through()) reads[k].clear();
    order = evaluation_order(names, reads);
  }
  Sorted sorted;
  for (const std::size_t k : order) {
    sorted.nodes.push_back(std::move(nodes[k]));
    sorted.names.push_back(std::move(read[k]));
  }
  return sorted;
}

}  // namespace

std::vector<std::size_t> evaluation_order(const std::vector<std::string>& names,
                                          const std::vector<std::vector<std::size_t>>& reads) {
  std::vector<std::size_t> order, way;
  std::vector<bool> done(names.size(), false), on_the_way = done;
  const auto visit = [&](const auto& self, std::size_t k) -> void {
    if (done[k]) return;
    if (on_the_way[k]) {
      std::vector<std::string> circle;
      for (auto at = std::find(way.begin(), way.end(), k); at != way.end(); ++at) circle.push_back(names[*at]);
      circle.push_back(names[k]);
      throw InputError(code::kSignalLoop, "they depend on each other in a loop: " + joined(circle, " <- ") +
                                              "; put a lowpass filter into the loop");
    }
    way.push_back(k);
    on_the_way[k] = true;
    for (const std::size_t other : reads[k]) self(self, other);
    way.pop_back();
    done[k] = true;
    order.push_back(k);
  };
  for (std::size_t k = 0; k < names.size(); ++k) visit(visit, k);
  return order;
}

SignalChain::SignalChain(std::vector<SignalNode> nodes) : values_(std::make_unique<NamedValues>()) {
  Sorted sorted = in_order(std::move(nodes));
  nodes_ = std::move(sorted.nodes);
  std::map<std::string, std::size_t> own, outside;  // index of the node, index in names_
  for (std::size_t k = 0; k < nodes_.size(); ++k) own.emplace(kSignal + nodes_[k].name, k);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const SignalNode& node = nodes_[k];
    FOOTFALL_DEMAND(static_cast<int>(node.inputs.size()) == node.block->input_count());
    first_state_.push_back(states_);
    states_ += node.block->state_count();
    for (const std::string& state : node.states) outside.emplace(kState + state, 0);
    for (const std::string& name : sorted.names[k])
      if (own.count(name) == 0) outside.emplace(name, 0);
  }
  for (auto& [name, index] : outside) {
    index = names_.size();
    names_.push_back(name);
  }
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    reads_.emplace_back();
    for (const std::string& name : sorted.names[k]) {
      const auto found = own.find(name);
      found != own.end() ? reads_[k].nodes.push_back(found->second) : reads_[k].names.push_back(outside.at(name));
    }
  }
  bind();
}

SignalChain::SignalChain(const SignalChain& other)
    : nodes_(other.nodes_),
      reads_(other.reads_),
      first_state_(other.first_state_),
      states_(other.states_),
      values_(std::make_unique<NamedValues>(*other.values_)),
      names_(other.names_) {
  for (SignalNode& node : nodes_)
    if (std::unique_ptr<SignalBlock> own = node.block->copy()) node.block = std::move(own);
  bind();
}

void SignalChain::bind() {
  for (const std::string& name : names_) outside_.push_back(&(*values_)[name]);
  for (const SignalNode& node : nodes_) own_.push_back(&(*values_)[kSignal + node.name]);
  for (const SignalNode& node : nodes_) {
    expressions_.emplace_back();
    for (const std::string& input : node.inputs) expressions_.back().emplace_back(input, *values_);
    activities_.emplace_back();
    for (const std::string& state : node.states) activities_.back().push_back(&values_->at(kState + state));
    inputs_.push_back(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(node.inputs.size())));
  }
}

bool SignalChain::active(std::size_t k) const {
  const std::vector<const double*>& states = activities_[k];
  return states.empty() || std::any_of(states.begin(), states.end(), [](const double* s) { return *s != 0.0; });
}

const Eigen::VectorXd& SignalChain::inputs(std::size_t k) {
  Eigen::VectorXd& u = inputs_[k];
  for (std::size_t i = 0; i < expressions_[k].size(); ++i) {
    try {
      u[static_cast<Eigen::Index>(i)] = expressions_[k][i].value();
    } catch (const NumericalError& error) {
      const std::vector<std::string>& at = nodes_[k].written_at;
      throw NumericalError((i < at.size() ? at[i] : "signal \"" + nodes_[k].name + "\": ") + error.what());
    }
  }
  return u;
}

void SignalChain::settle(std::size_t k, Eigen::Ref<Eigen::VectorXd> z) {
  const SignalNode& node = nodes_[k];
  if (node.block->state_count() == 0) return;
  if (node.initial) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(node.inputs.size()));
    u[0] = *node.initial;
    node.block->settle(u, z);
  } else {
    node.block->settle(inputs(k), z);
  }
}

}  // namespace footfall
