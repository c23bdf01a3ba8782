// Measurements in the units of the rules; evaluation exact or by table.

#include "mbd_solver/model/control/fuzzy_controller.h"

#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

std::size_t input_index(std::string_view name) {
  for (std::size_t i = 0; i < kFuzzyInputs; ++i)
    if (name == kFuzzyInputNames[i]) return i;
  throw InputError(code::kFllVariables,
                   "control surface: unknown input \"" + std::string(name) + "\". Known inputs: a, da, alpha, beta.");
}

}  // namespace

ControlSurface control_surface(const FuzzySystem& system, int output, std::string_view first, std::string_view second,
                               int points, const FuzzyInput& held) {
  const std::size_t i = input_index(first), j = input_index(second);
  if (i == j)
    throw InputError(code::kParametersDisagree,
                     "control surface: both axes are \"" + std::string(first) + "\"; expected two different inputs.");
  if (output < 0 || output >= system.output_count())
    throw InputError(code::kFllVariables, "control surface: there is no output U" + std::to_string(output + 1) +
                                              "; expected U1 to U" + std::to_string(system.output_count()) + ".");
  if (points < 2)
    throw InputError(code::kFuzzyGrid,
                     "control surface: " + std::to_string(points) + " points along an axis; expected at least 2.");
  ControlSurface surface{Eigen::VectorXd::LinSpaced(points, system.lower()[i], system.upper()[i]),
                         Eigen::VectorXd::LinSpaced(points, system.lower()[j], system.upper()[j]),
                         Eigen::MatrixXd(points, points)};
  Eigen::VectorXd voltages(system.output_count());
  FuzzyInput input = held;
  for (int row = 0; row < points; ++row)
    for (int column = 0; column < points; ++column) {
      input[i] = surface.first[row];
      input[j] = surface.second[column];
      system.evaluate(input, voltages);
      surface.voltage(row, column) = voltages[output];
    }
  return surface;
}

FuzzyController::FuzzyController(const FuzzyControllerParameters& parameters)
    : parameters_(parameters),
      system_(parameters.rules),
      filter_("controller fuzzy", parameters.filter_frequency, parameters.period) {
  if (!parameters.tabulated) return;
  table_.emplace(system_, parameters.grid);
  table_difference_ = table_->largest_difference(system_);
}

void FuzzyController::sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) {
  constexpr double kDegree = 180.0 / kPi;
  filter_.sample(m.acceleration);
  const FuzzyInput input = {filter_.acceleration() / kStandardGravity, filter_.jerk() * kJerkTime / kStandardGravity,
                            m.pitch * kDegree, m.roll * kDegree};
  if (table_)
    table_->evaluate(input, voltages);
  else
    system_.evaluate(input, voltages);
}

Eigen::VectorXd FuzzyController::memory() const {
  Eigen::VectorXd memory(AccelerationFilter::kMemory);
  filter_.save(memory);
  return memory;
}

void FuzzyController::restore(const Eigen::Ref<const Eigen::VectorXd>& memory) { filter_.restore(memory); }

}  // namespace footfall
