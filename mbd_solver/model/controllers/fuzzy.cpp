// What a FuzzySystem answers: FuzzyLite's own evaluation, and the same rules on a grid.
#include "mbd_solver/model/controllers/fuzzy.h"
#include "coupler/base/parameter_check.h"
#include "coupler/base/text.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/model/controllers/fll_text.h"
#include "mbd_solver/model/controllers/fuzzy_engine.h"
#include "mbd_solver/model/controllers/mamdani_grid.h"

namespace footfall {
namespace {

// The term of an input that a plain rule asks for, gathered over "and" into `terms`; false if the antecedent
// is anything else.
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
  std::vector<double> inside;  // corners closer than a thousandth of the range are one (decimals written short)
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
    if (std::isnan(x)) {  // which rules fire would be chance
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

}  // namespace footfall
