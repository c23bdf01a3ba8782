// From a .fll file to a checked FuzzySystem: every complaint names its line.
#include <cmath>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/controllers/fuzzy_engine.h"

namespace footfall {
namespace {

constexpr int kMostSamples = 100000;  // of a defuzzifier's integral; FuzzyLite takes 100 if the file says nothing

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

// FuzzyLite takes any number of samples, and one that overflows becomes negative.
bool takes_possible_samples(const fl::Engine& engine) {
  for (const fl::OutputVariable* v : engine.outputVariables())
    if (const auto* integral = dynamic_cast<const fl::IntegralDefuzzifier*>(v->getDefuzzifier()))
      if (integral->getResolution() < 1 || integral->getResolution() > kMostSamples) return false;
  return true;
}

// Imports every line of a block alone, so that the one FuzzyLite refuses is known. Rules need the whole
// engine: check_rule.
void check_lines(const std::string& file, const FllBlock& block) {
  if (block.head.key == "Engine") return;
  for (const FllLine& line : block.lines) {
    if (line.key == "rule") continue;
    const auto refuse = [&](const std::string& why) {
      throw InputError(file + ":" + std::to_string(line.number) + ": \"" + line.key + ": " + line.value + "\" of " +
                       block.head.key + " \"" + block.head.value + "\" is not understood: " + why);
    };
    try {
      const auto alone = import("Engine: check\n" + block.head.key + ": " + block.head.value + "\n" + line.key + ": " +
                                line.value + "\n");
      if (!takes_possible_samples(*alone)) refuse("expected 1 to " + std::to_string(kMostSamples) + " samples.");
    } catch (const fl::Exception& error) {
      refuse(first_line(error));
    }
  }
}

std::string without_brackets(std::string word) {
  word.erase(std::remove_if(word.begin(), word.end(), [](char c) { return c == '(' || c == ')'; }), word.end());
  return word;
}

// Every "variable is [hedges] term" of a rule must name what exists; what else is wrong with it, FuzzyLite
// says.
void check_rule(const std::string& where, const std::string& text, const fl::Engine& engine) {
  std::istringstream in(text);
  std::vector<std::string> word;
  for (std::string w; in >> w;) word.push_back(w);
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
      throw InputError(where + "the rule names an unknown variable \"" + name +
                       "\". Known variables: " + names(engine.variables()) + ".");
    std::size_t last = i + 1;
    while (last + 1 < word.size() && !ends_proposition(word[last + 1])) ++last;
    const std::string term = without_brackets(word[last]);
    if (term != "any" && !variable->hasTerm(term))  // "is any": the rule does not ask for this variable
      throw InputError(where + "variable \"" + name + "\" has no term \"" + term +
                       "\". Its terms: " + names(variable->terms()) + ".");
  }
  try {
    std::unique_ptr<fl::Rule> rule(fl::Rule::parse(text, &engine));
  } catch (const fl::Exception& error) {
    throw InputError(where + "the rule \"" + text + "\" is not understood: " + first_line(error));
  }
}

// Where a key of a variable stands, or the variable if the key is not given.
std::string where_is(const std::string& file, const std::vector<FllBlock>& blocks, const std::string& variable,
                     const std::string& key) {
  for (const FllBlock& block : blocks) {
    if (block.head.key.find("Variable") == std::string::npos || block.head.value != variable) continue;
    for (const FllLine& line : block.lines)
      if (line.key == key) return file + ":" + std::to_string(line.number) + ": ";
    return file + ":" + std::to_string(block.head.number) + ": ";
  }
  return file + ": ";
}

void check_range(const std::string& where, const fl::Variable& variable, bool valid, const std::string& expected) {
  if (!valid || !std::isfinite(variable.range()))
    throw InputError(where + "range of \"" + variable.getName() + "\" is " + number_text(variable.getMinimum()) +
                     " to " + number_text(variable.getMaximum()) + "; expected " + expected + ".");
}

}  // namespace

void FuzzySystem::Engine::take_variables(const std::string& file, const std::vector<FllBlock>& blocks) {
  for (std::size_t i = 0; i < kFuzzyInputs; ++i) {
    const std::string name = kFuzzyInputNames[i];
    for (fl::InputVariable* v : engine->inputVariables())
      if (v->getName() == name) input[i] = v;
    if (!input[i])
      throw InputError(file + ": there is no InputVariable \"" + name +
                       "\"; expected a, da, alpha and beta. Found: " + names(engine->inputVariables()) + ".");
    lower[i] = input[i]->getMinimum();
    upper[i] = input[i]->getMaximum();
    const std::string where = where_is(file, blocks, name, "range");
    if (i == 0)
      check_range(where, *input[i], lower[i] == 0.0 && upper[i] > 0.0, "0 to a_max > 0, in g");
    else
      check_range(where, *input[i], lower[i] == -upper[i] && upper[i] > 0.0,
                  "-r to r with r > 0, the same on both sides");
  }
  for (const fl::InputVariable* v : engine->inputVariables())
    if (std::find(input.begin(), input.end(), v) == input.end())
      throw InputError(where_is(file, blocks, v->getName(), "") + "InputVariable \"" + v->getName() +
                       "\" is not measured. Expected a, da, alpha and beta only.");
  for (std::size_t i = 0; i < engine->numberOfOutputVariables(); ++i) {
    fl::OutputVariable* v = engine->getOutputVariable(i);
    const std::string expected = "U" + std::to_string(i + 1);
    if (v->getName() != expected)
      throw InputError(where_is(file, blocks, v->getName(), "") + "OutputVariable \"" + v->getName() +
                       "\" is output number " + std::to_string(i + 1) +
                       "; expected the outputs U1, U2, ... in this order.");
    check_range(where_is(file, blocks, expected, "range"), *v, v->getMinimum() == 0.0 && v->getMaximum() == 1.0,
                "0 to 1");
    if (v->isLockPreviousValue())
      throw InputError(where_is(file, blocks, expected, "lock-previous") + "\"" + expected +
                       "\" keeps its previous value; expected lock-previous: false, because a hidden memory "
                       "could not be resumed.");
    output.push_back(v);
  }
  if (output.empty())
    throw InputError(file + ": there is no OutputVariable; expected U1, U2, ...: one for each controlled strut.");
}

// Each output must get a rule at every corner of the terms and half way between corners. Between corners no
// term begins or ends, so that this grid finds every gap of terms with corners; inputs with other terms get
// nine even points more.
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
        throw InputError(file + ": no rule fires for " + v->getName() + " at a = " + number_text(x[0]) + ", da = " +
                         number_text(x[1]) + ", alpha = " + number_text(x[2]) + ", beta = " + number_text(x[3]) +
                         "; expected rules that cover the whole input box. Add the missing rule, or widen the terms.");
  };
  for (const double a : nodes[0])
    for (const double da : nodes[1])
      for (const double alpha : nodes[2])
        for (const double beta : nodes[3]) check({a, da, alpha, beta});
}

std::unique_ptr<fl::Engine> read_fuzzy_engine(const std::string& file, const std::vector<FllBlock>& blocks) {
  fl::fuzzylite::setLogging(false);  // its complaints come as exceptions; it must not write into our output
  // the file's text in two parts, because rules can be checked only against variables
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
    throw InputError(file + ": is not a fuzzy controller: " + first_line(error));
  }
}

FuzzySystem::FuzzySystem(const std::filesystem::path& path) : engine_(std::make_unique<Engine>()) {
  const std::string file = path.string();
  const std::vector<FllBlock> blocks = read_fll_text(path);
  engine_->engine = read_fuzzy_engine(file, blocks);
  engine_->take_variables(file, blocks);
  std::string status;
  if (!engine_->engine->isReady(&status)) throw InputError(file + ": the controller is not complete: " + status);
  engine_->check_coverage(file);
  engine_->plain = engine_->plain_system();
}

}  // namespace footfall
