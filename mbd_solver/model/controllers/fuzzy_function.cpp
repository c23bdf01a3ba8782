#include "mbd_solver/model/controllers/fuzzy_function.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/controllers/fuzzy_engine.h"

namespace footfall {

struct FuzzyFunction::Parts {
  std::unique_ptr<fl::Engine> engine;
  fl::OutputVariable* output = nullptr;
};

FuzzyFunction::FuzzyFunction(const std::filesystem::path& path, std::size_t inputs, const std::string& output)
    : parts_(std::make_unique<Parts>()) {
  const std::string file = path.string();
  parts_->engine = read_fuzzy_engine(file, read_fll_text(path));
  fl::Engine& engine = *parts_->engine;
  std::vector<std::string> names, outputs;
  for (const fl::InputVariable* v : engine.inputVariables()) names.push_back(v->getName());
  for (const fl::OutputVariable* v : engine.outputVariables()) outputs.push_back(v->getName());
  if (names.size() != inputs)
    throw InputError(file + ": has " + std::to_string(names.size()) + " input variables (" + joined(names) +
                     "), but the signal gives " + std::to_string(inputs) + " inputs; expected one for each.");
  if (output.empty() && outputs.size() != 1)
    throw InputError(file + ": has " + std::to_string(outputs.size()) + " output variables (" + joined(outputs) +
                     "); the signal must say which by output = \"...\".");
  for (fl::OutputVariable* v : engine.outputVariables())
    if (output.empty() || v->getName() == output) parts_->output = v;
  if (!parts_->output)
    throw InputError(file + ": there is no OutputVariable \"" + output + "\"." +
                     known_names("outputs", output, outputs));
  if (parts_->output->isLockPreviousValue())
    throw InputError(file + ": \"" + parts_->output->getName() +
                     "\" keeps its previous value; expected lock-previous: false, a hidden memory is not resumed.");
  std::string status;
  if (!engine.isReady(&status)) throw InputError(file + ": the fuzzy system is not complete: " + status);
}

FuzzyFunction::~FuzzyFunction() = default;

double FuzzyFunction::value(const Eigen::Ref<const Eigen::VectorXd>& inputs) const {
  fl::Engine& engine = *parts_->engine;
  FOOTFALL_DEMAND(inputs.size() == static_cast<Eigen::Index>(engine.numberOfInputVariables()));
  for (std::size_t i = 0; i < engine.numberOfInputVariables(); ++i) {
    fl::InputVariable* v = engine.getInputVariable(i);
    v->setValue(std::clamp(inputs[static_cast<Eigen::Index>(i)], v->getMinimum(), v->getMaximum()));
  }
  engine.process();
  const double value = parts_->output->getValue();
  if (!std::isfinite(value)) throw NumericalError("no rule of the fuzzy system fires here.");
  return value;
}

}  // namespace footfall
