// The only file that includes FuzzyLite. Each line of a .fll file is checked alone, and every error names its line; FuzzyLite's
// own messages do not.

#include "mbd_solver/model/control/fuzzy.h"

#include <fl/Headers.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/control/fuzzy_table.h"

namespace footfall {
namespace {

constexpr int kMostSamples = 100000;  // of a defuzzifier's integral; FuzzyLite's default is 100

// FuzzyLite's text without its trace.
std::string first_line(const fl::Exception& error) {
  const std::string text = error.getWhat();
  return text.substr(0, text.find('\n'));
}

template <class Variables>
std::string names(const Variables& variables) {
  std::string list;
  for (const auto* v : variables) list += (list.empty() ? "" : ", ") + v->getName();
  return list;
}

std::unique_ptr<fl::Engine> import(const std::string& text) {
  return std::unique_ptr<fl::Engine>(fl::FllImporter().fromString(text));
}

// FuzzyLite accepts any number of samples; a number that overflows becomes negative.
bool sample_count_is_valid(const fl::Engine& engine) {
  for (const fl::OutputVariable* v : engine.outputVariables())
    if (const auto* integral = dynamic_cast<const fl::IntegralDefuzzifier*>(v->getDefuzzifier()))
      if (integral->getResolution() < 1 || integral->getResolution() > kMostSamples) return false;
  return true;
}

// Imports every line of a block alone, to find the line that FuzzyLite refuses. Rules require the engine: check_rule.
void check_lines(const std::string& file, const FllBlock& block) {
  if (block.head.key == "Engine") return;
  for (const FllLine& line : block.lines) {
    if (line.key == "rule") continue;
    const auto refuse = [&](const std::string& why) {
      throw InputError(code::kFllSyntax, file + ":" + std::to_string(line.number) + ": \"" + line.key + ": " +
                                             line.value + "\" of " + block.head.key + " \"" + block.head.value +
                                             "\" has a syntax error: " + why);
    };
    try {
      const auto alone = import("Engine: check\n" + block.head.key + ": " + block.head.value + "\n" + line.key + ": " +
                                line.value + "\n");
      if (!sample_count_is_valid(*alone)) refuse("expected 1 to " + std::to_string(kMostSamples) + " samples.");
    } catch (const fl::Exception& error) {
      refuse(first_line(error));
    }
  }
}

std::string without_brackets(std::string word) {
  word.erase(std::remove_if(word.begin(), word.end(), [](char c) { return c == '(' || c == ')'; }), word.end());
  return word;
}

// Checks the names in every "variable is [hedges] term" of a rule; FuzzyLite reports its other errors.
void check_rule(const std::string& where, const std::string& text, const fl::Engine& engine) {
  std::istringstream words(text);
  const std::vector<std::string> word{std::istream_iterator<std::string>(words), {}};
  const auto ends_proposition = [](const std::string& w) {
    return w == "and" || w == "or" || w == "then" || w == "with";
  };
  for (std::size_t i = 1; i + 1 < word.size(); ++i) {
    if (word[i] != "is") continue;
    const std::string name = without_brackets(word[i - 1]);
    const fl::Variable* variable = nullptr;
    for (const fl::Variable* v : engine.variables())
      if (v->getName() == name) variable = v;
    if (!variable)
      throw InputError(code::kFllSyntax, where + "the rule names an unknown variable \"" + name +
                                             "\". Known variables: " + names(engine.variables()) + ".");
    std::size_t last = i + 1;
    while (last + 1 < word.size() && !ends_proposition(word[last + 1])) ++last;
    const std::string term = without_brackets(word[last]);
    if (term != "any" && !variable->hasTerm(term))  // "is any": the rule does not use this variable
      throw InputError(code::kFllSyntax, where + "variable \"" + name + "\" has no term \"" + term +
                                             "\". Its terms: " + names(variable->terms()) + ".");
  }
  try {
    std::unique_ptr<fl::Rule> rule(fl::Rule::parse(text, &engine));
  } catch (const fl::Exception& error) {
    throw InputError(code::kFllSyntax, where + "the rule \"" + text + "\" has a syntax error: " + first_line(error));
  }
}

// The place of a key of a variable, or of the variable if the key is absent.
std::string where_is(const FllText& text, const std::string& variable, const std::string& key) {
  for (const FllBlock& block : text.blocks) {
    if (block.head.key.find("Variable") == std::string::npos || block.head.value != variable) continue;
    for (const FllLine& line : block.lines)
      if (line.key == key) return text.file + ":" + std::to_string(line.number) + ": ";
    return text.file + ":" + std::to_string(block.head.number) + ": ";
  }
  return text.file + ": ";
}

void check_range(const std::string& where, const fl::Variable& variable, bool valid, const std::string& expected) {
  if (!valid || !std::isfinite(variable.range()))
    throw InputError(code::kFllVariables, where + "range of \"" + variable.getName() + "\" is " +
                                              number_text(variable.getMinimum()) + " to " +
                                              number_text(variable.getMaximum()) + "; expected " + expected + ".");
}

// FuzzyLite's engine with the variables and rules of a file. Throws InputError "file:line: ...".
std::unique_ptr<fl::Engine> read_fuzzy_engine(const FllText& from) {
  const std::string& file = from.file;
  const std::vector<FllBlock>& blocks = from.blocks;
  fl::fuzzylite::setLogging(false);  // its errors are exceptions; it must not write to our output
  // The text in two parts, because rules are checked against variables.
  std::string variables, rules;
  for (const FllBlock& block : blocks) {
    check_lines(file, block);
    std::string& text = block.head.key == "RuleBlock" ? rules : variables;
    text += block.head.key + ": " + block.head.value + "\n";
    for (const FllLine& line : block.lines) text += line.key + ": " + line.value + "\n";
  }
  try {
    const std::unique_ptr<fl::Engine> without_rules = import(variables);
    for (const FllBlock& block : blocks)
      for (const FllLine& line : block.lines)
        if (line.key == "rule") check_rule(file + ":" + std::to_string(line.number) + ": ", line.value, *without_rules);
    return import(variables + rules);
  } catch (const fl::Exception& error) {
    throw InputError(code::kFllSyntax, file + ": is not a fuzzy controller: " + first_line(error));
  }
}

}  // namespace

struct FuzzySystem::Engine {
  std::unique_ptr<fl::Engine> engine;
  std::array<fl::InputVariable*, kFuzzyInputs> input{};  // in the order of FuzzyInput
  std::vector<fl::OutputVariable*> output;
  FuzzyInput lower{}, upper{};
  std::optional<MamdaniSystem> plain;  // the same rules for the fast grid, if they are plain

  // Throw InputError "file:line: ...".
  void take_variables(const FllText& text);
  void check_coverage(const std::string& file) const;

  // The ends of an input's range and the corners of its terms, rising. `complete` is false if a term has no corners.
  std::vector<double> corners(std::size_t input_index, bool& complete) const;
  std::optional<MamdaniSystem> plain_system() const;
  void set_inputs(const FuzzyInput& value) const {
    for (std::size_t i = 0; i < kFuzzyInputs; ++i) input[i]->setValue(std::clamp(value[i], lower[i], upper[i]));
  }
};

namespace {

// Collects the terms of a plain rule, joined by "and", into `terms`; false if the antecedent is of another form.
bool gather(const fl::Expression* node, const std::vector<fl::InputVariable*>& inputs, std::array<int, 4>& terms) {
  if (node->type() == fl::Expression::Operator) {
    const auto* op = static_cast<const fl::Operator*>(node);
    return op->name == fl::Rule::andKeyword() && gather(op->left, inputs, terms) && gather(op->right, inputs, terms);
  }
  const auto* p = static_cast<const fl::Proposition*>(node);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (p->variable != inputs[i]) continue;
    if (!p->term && p->hedges.size() == 1 && dynamic_cast<const fl::Any*>(p->hedges.front())) return true;
    const auto& of_input = inputs[i]->terms();
    const auto found = std::find(of_input.begin(), of_input.end(), p->term);
    if (!p->hedges.empty() || terms[i] >= 0 || found == of_input.end()) return false;
    terms[i] = static_cast<int>(found - of_input.begin());
    return true;
  }
  return false;
}

// The axis of a plain rule system: membership of every term of an input at its nodes.
Eigen::MatrixXd memberships(const fl::Variable& variable, const Eigen::VectorXd& x) {
  Eigen::MatrixXd result(x.size(), static_cast<Eigen::Index>(variable.numberOfTerms()));
  for (Eigen::Index t = 0; t < result.cols(); ++t)
    for (Eigen::Index i = 0; i < result.rows(); ++i)
      result(i, t) = variable.getTerm(static_cast<std::size_t>(t))->membership(x[i]);
  return result;
}

}  // namespace

std::vector<double> FuzzySystem::Engine::corners(std::size_t i, bool& complete) const {
  std::vector<double> all = {lower[i], upper[i]};
  complete = true;
  for (const fl::Term* term : input[i]->terms()) {
    if (const auto* triangle = dynamic_cast<const fl::Triangle*>(term))
      all.insert(all.end(), {triangle->getVertexA(), triangle->getVertexB(), triangle->getVertexC()});
    else if (const auto* trapezoid = dynamic_cast<const fl::Trapezoid*>(term))
      all.insert(all.end(),
                 {trapezoid->getVertexA(), trapezoid->getVertexB(), trapezoid->getVertexC(), trapezoid->getVertexD()});
    else if (const auto* ramp = dynamic_cast<const fl::Ramp*>(term))
      all.insert(all.end(), {ramp->getStart(), ramp->getEnd()});
    else if (const auto* rectangle = dynamic_cast<const fl::Rectangle*>(term))
      all.insert(all.end(), {rectangle->getStart(), rectangle->getEnd()});
    else
      complete = false;
  }
  std::sort(all.begin(), all.end());
  std::vector<double> inside;  // corners closer than a thousandth of the range are merged
  for (const double c : all)
    if (c >= lower[i] && c <= upper[i] && (inside.empty() || c - inside.back() > 1e-3 * (upper[i] - lower[i])))
      inside.push_back(c);
  inside.back() = upper[i];
  return inside;
}

std::optional<MamdaniSystem> FuzzySystem::Engine::plain_system() const {
  MamdaniSystem system;
  for (const fl::OutputVariable* v : output) {
    const auto* centroid = dynamic_cast<const fl::Centroid*>(v->getDefuzzifier());
    if (!centroid || !dynamic_cast<const fl::Maximum*>(v->fuzzyOutput()->getAggregation()) || !v->isEnabled())
      return {};
    const int samples = centroid->getResolution();
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(samples, 0.5 / samples, 1.0 - 0.5 / samples);  // range 0 to 1
    const double without = v->getDefaultValue();
    system.outputs.push_back({0.0, 1.0, std::isnan(without) ? kNoRuleVoltage : without, memberships(*v, x)});
  }
  for (const fl::RuleBlock* block : engine->ruleBlocks()) {
    if (!block->isEnabled()) continue;
    if (!dynamic_cast<const fl::Minimum*>(block->getConjunction()) ||
        !dynamic_cast<const fl::Minimum*>(block->getImplication()) ||
        !dynamic_cast<const fl::General*>(block->getActivation()))
      return {};
    for (const fl::Rule* rule : block->rules()) {
      MamdaniRule simple{{-1, -1, -1, -1}, rule->getWeight(), {}};
      if (!rule->isEnabled() ||
          !gather(rule->getAntecedent()->getExpression(), {input.begin(), input.end()}, simple.term))
        return {};
      for (const fl::Proposition* outcome : rule->getConsequent()->conclusions()) {
        const auto variable = std::find(output.begin(), output.end(), outcome->variable);
        if (!outcome->hedges.empty() || variable == output.end()) return {};
        const auto& terms = (*variable)->terms();
        simple.outcomes.push_back(
            {static_cast<int>(variable - output.begin()),
             static_cast<int>(std::find(terms.begin(), terms.end(), outcome->term) - terms.begin())});
      }
      system.rules.push_back(simple);
    }
  }
  for (const fl::InputVariable* v : input)
    if (!v->isEnabled()) return {};
  return system;
}

FuzzySystem::~FuzzySystem() = default;
FuzzySystem::FuzzySystem(FuzzySystem&&) noexcept = default;
FuzzySystem& FuzzySystem::operator=(FuzzySystem&&) noexcept = default;

int FuzzySystem::output_count() const { return static_cast<int>(engine_->output.size()); }
const FuzzyInput& FuzzySystem::lower() const { return engine_->lower; }
const FuzzyInput& FuzzySystem::upper() const { return engine_->upper; }

std::vector<double> FuzzySystem::breakpoints(int input) const {
  bool complete = true;
  return engine_->corners(static_cast<std::size_t>(input), complete);
}

void FuzzySystem::evaluate(const FuzzyInput& value, Eigen::Ref<Eigen::VectorXd> voltages) const {
  FOOTFALL_DEMAND(voltages.size() == output_count());
  for (const double x : value)
    if (std::isnan(x)) {  // else the rules that fire would be arbitrary
      voltages.setConstant(kNoRuleVoltage);
      return;
    }
  engine_->set_inputs(value);
  engine_->engine->process();
  for (std::size_t i = 0; i < engine_->output.size(); ++i) {
    const double u = engine_->output[i]->getValue();
    voltages[static_cast<Eigen::Index>(i)] = std::isnan(u) ? kNoRuleVoltage : std::clamp(u, 0.0, 1.0);
  }
}

std::vector<double> FuzzySystem::evaluate_on_grid(const std::array<Eigen::VectorXd, kFuzzyInputs>& nodes) const {
  if (engine_->plain) {
    std::array<Eigen::MatrixXd, kFuzzyInputs> axis;
    for (std::size_t i = 0; i < kFuzzyInputs; ++i)
      axis[i] = memberships(*engine_->input[i], nodes[i].cwiseMax(lower()[i]).cwiseMin(upper()[i]));
    return footfall::evaluate_on_grid(*engine_->plain, axis);
  }
  std::vector<double> values;
  Eigen::VectorXd u(output_count());
  for (const double a : nodes[0])
    for (const double da : nodes[1])
      for (const double alpha : nodes[2])
        for (const double beta : nodes[3]) {
          evaluate({a, da, alpha, beta}, u);
          values.insert(values.end(), u.begin(), u.end());
        }
  return values;
}

struct FuzzyFunction::Parts {
  std::unique_ptr<fl::Engine> engine;
  fl::OutputVariable* output = nullptr;
  Eigen::VectorXd inputs;  // of the last evaluation, and
  double value = 0.0;      // its result: a step evaluates several times
};

FuzzyFunction::FuzzyFunction(const FllText& text, std::size_t inputs, const std::string& output)
    : parts_(std::make_unique<Parts>()) {
  const std::string& file = text.file;
  parts_->engine = read_fuzzy_engine(text);
  fl::Engine& engine = *parts_->engine;
  std::vector<std::string> names, outputs;
  for (const fl::InputVariable* v : engine.inputVariables()) names.push_back(v->getName());
  for (const fl::OutputVariable* v : engine.outputVariables()) outputs.push_back(v->getName());
  if (names.size() != inputs)
    throw InputError(code::kFllVariables, file + ": has " + std::to_string(names.size()) + " input variables (" +
                                              joined(names) + "), but the signal has " + std::to_string(inputs) +
                                              " inputs; expected one for each.");
  if (output.empty() && outputs.size() != 1)
    throw InputError(code::kFllVariables, file + ": has " + std::to_string(outputs.size()) + " output variables (" +
                                              joined(outputs) + "); select one by output = \"...\" of the signal.");
  for (fl::OutputVariable* v : engine.outputVariables()) {
    if (output.empty() || v->getName() == output)
      parts_->output = v;
    else
      v->setEnabled(false);  // most of the time of an evaluation goes into an output
  }
  if (!parts_->output)
    throw InputError(code::kFllVariables, file + ": there is no OutputVariable \"" + output + "\"." +
                                              known_names("outputs", output, outputs));
  if (parts_->output->isLockPreviousValue())
    throw InputError(
        code::kFllVariables,
        file + ": \"" + parts_->output->getName() +
            "\" stores its previous value, which cannot be saved in a checkpoint; expected lock-previous: false.");
  std::string status;
  if (!engine.isReady(&status))
    throw InputError(code::kFllVariables, file + ": the fuzzy system is not complete: " + status);
}

FuzzyFunction::FuzzyFunction(const FuzzyFunction& other) : parts_(std::make_unique<Parts>()) {
  parts_->engine.reset(other.parts_->engine->clone());
  parts_->output = parts_->engine->getOutputVariable(other.parts_->output->getName());
  parts_->inputs = other.parts_->inputs;
  parts_->value = other.parts_->value;
}

FuzzyFunction::~FuzzyFunction() = default;

double FuzzyFunction::value(const Eigen::Ref<const Eigen::VectorXd>& inputs) const {
  if (inputs.size() == parts_->inputs.size() && inputs == parts_->inputs) return parts_->value;
  fl::Engine& engine = *parts_->engine;
  FOOTFALL_DEMAND(inputs.size() == static_cast<Eigen::Index>(engine.numberOfInputVariables()));
  for (std::size_t i = 0; i < engine.numberOfInputVariables(); ++i) {
    fl::InputVariable* v = engine.getInputVariable(i);
    v->setValue(std::clamp(inputs[static_cast<Eigen::Index>(i)], v->getMinimum(), v->getMaximum()));
  }
  engine.process();
  const double value = parts_->output->getValue();
  if (!std::isfinite(value))
    throw NumericalError(code::kNoRuleFires, "no rule of the fuzzy system fires for these inputs.");
  parts_->inputs = inputs;
  parts_->value = value;
  return value;
}

void FuzzySystem::Engine::take_variables(const FllText& text) {
  for (std::size_t i = 0; i < kFuzzyInputs; ++i) {
    const std::string name = kFuzzyInputNames[i];
    for (fl::InputVariable* v : engine->inputVariables())
      if (v->getName() == name) input[i] = v;
    if (!input[i])
      throw InputError(code::kFllVariables,
                       text.file + ": there is no InputVariable \"" + name +
                           "\"; expected a, da, alpha and beta. Found: " + names(engine->inputVariables()) + ".");
    lower[i] = input[i]->getMinimum();
    upper[i] = input[i]->getMaximum();
    const std::string where = where_is(text, name, "range");
    if (i == 0)
      check_range(where, *input[i], lower[i] == 0.0 && upper[i] > 0.0, "0 to a_max > 0, in g");
    else
      check_range(where, *input[i], lower[i] == -upper[i] && upper[i] > 0.0,
                  "-r to r with r > 0, the same on both sides");
  }
  for (const fl::InputVariable* v : engine->inputVariables())
    if (std::find(input.begin(), input.end(), v) == input.end())
      throw InputError(code::kFllVariables, where_is(text, v->getName(), "") + "InputVariable \"" + v->getName() +
                                                "\" is not measured; expected a, da, alpha and beta only.");
  for (std::size_t i = 0; i < engine->numberOfOutputVariables(); ++i) {
    fl::OutputVariable* v = engine->getOutputVariable(i);
    const std::string expected = "U" + std::to_string(i + 1);
    if (v->getName() != expected)
      throw InputError(code::kFllVariables, where_is(text, v->getName(), "") + "OutputVariable \"" + v->getName() +
                                                "\" is output number " + std::to_string(i + 1) +
                                                "; expected the outputs U1, U2, ... in this order.");
    check_range(where_is(text, expected, "range"), *v, v->getMinimum() == 0.0 && v->getMaximum() == 1.0, "0 to 1");
    if (v->isLockPreviousValue())
      throw InputError(
          code::kFllVariables,
          where_is(text, expected, "lock-previous") + "\"" + expected +
              "\" stores its previous value, which cannot be saved in a checkpoint; expected lock-previous: false.");
    output.push_back(v);
  }
  if (output.empty())
    throw InputError(code::kFllVariables,
                     text.file + ": there is no OutputVariable; expected U1, U2, ...: one for each controlled strut.");
}

// Each output requires a rule at every corner of the terms and half way between corners. Between corners no term begins or
// ends, so that this grid finds every gap of terms with corners; inputs with other terms get nine more even points.
void FuzzySystem::Engine::check_coverage(const std::string& file) const {
  std::array<std::vector<double>, kFuzzyInputs> nodes;
  for (std::size_t i = 0; i < kFuzzyInputs; ++i) {
    bool complete = true;
    nodes[i] = corners(i, complete);
    for (std::size_t k = nodes[i].size() - 1; k > 0; --k) nodes[i].push_back(0.5 * (nodes[i][k] + nodes[i][k - 1]));
    for (int k = 0; !complete && k <= 8; ++k) nodes[i].push_back(lower[i] + (upper[i] - lower[i]) * k / 8.0);
  }
  const auto check = [&](const FuzzyInput& x) {
    set_inputs(x);
    for (fl::OutputVariable* v : output) v->fuzzyOutput()->clear();
    for (fl::RuleBlock* rules : engine->ruleBlocks())
      if (rules->isEnabled()) rules->activate();
    for (const fl::OutputVariable* v : output)
      if (v->fuzzyOutput()->isEmpty())
        throw InputError(
            code::kNoRuleFires,
            file + ": no rule fires for " + v->getName() + " at a = " + number_text(x[0]) +
                ", da = " + number_text(x[1]) + ", alpha = " + number_text(x[2]) + ", beta = " + number_text(x[3]) +
                "; expected rules that cover the whole input box. Add the missing rule, or widen the terms.");
  };
  for (const double a : nodes[0])
    for (const double da : nodes[1])
      for (const double alpha : nodes[2])
        for (const double beta : nodes[3]) check({a, da, alpha, beta});
}

FuzzySystem::FuzzySystem(const FllText& text) : engine_(std::make_unique<Engine>()) {
  engine_->engine = read_fuzzy_engine(text);
  engine_->take_variables(text);
  std::string status;
  if (!engine_->engine->isReady(&status))
    throw InputError(code::kFllVariables, text.file + ": the controller is not complete: " + status);
  engine_->check_coverage(text.file);
  engine_->plain = engine_->plain_system();
}

}  // namespace footfall
