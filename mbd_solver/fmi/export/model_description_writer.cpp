// modelDescription.xml of an exported FMU: units with their base units, variables, and the dependencies of outputs.

#include <set>
#include <sstream>

#include "mbd_solver/base/exact_number.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/fmi/export/fmu_command.h"

namespace footfall {
namespace {

using BaseUnits = std::map<std::string, int>;
using Kind = ExportedVariable::Kind;

const std::map<std::string, BaseUnits>& known_units() {
  static const std::map<std::string, BaseUnits> table = {
      {"m", {{"m", 1}}},
      {"s", {{"s", 1}}},
      {"kg", {{"kg", 1}}},
      {"A", {{"A", 1}}},
      {"rad", {{"rad", 1}}},
      {"1", {}},
      {"N", {{"kg", 1}, {"m", 1}, {"s", -2}}},
      {"J", {{"kg", 1}, {"m", 2}, {"s", -2}}},
      {"W", {{"kg", 1}, {"m", 2}, {"s", -3}}},
      {"Pa", {{"kg", 1}, {"m", -1}, {"s", -2}}},
      {"V", {{"kg", 1}, {"m", 2}, {"s", -3}, {"A", -1}}},
      {"Hz", {{"s", -1}}},
  };
  return table;
}

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + html_text(value) + "\"";
}

const char* causality_of(ExportedVariable::Kind kind) {
  switch (kind) {
    case ExportedVariable::Kind::kTime: return "independent";
    case ExportedVariable::Kind::kInput: return "input";
    case ExportedVariable::Kind::kOutput: return "output";
    case ExportedVariable::Kind::kParameter: return "parameter";
  }
  return "";
}

std::string variable_element(const ExportedVariable& v) {
  std::string text = "    <Float64" + attribute("name", v.name) +
                     attribute("valueReference", std::to_string(v.reference)) +
                     attribute("causality", causality_of(v.kind)) +
                     attribute("variability", v.kind == Kind::kParameter ? "fixed" : "continuous");
  if (!v.unit.empty()) text += attribute("unit", v.unit);
  if (v.kind == Kind::kOutput) text += attribute("initial", "calculated");
  if (v.kind == Kind::kParameter) text += attribute("initial", "exact");
  if (v.kind == Kind::kInput || v.kind == Kind::kParameter) {
    std::string start;
    for (const double value : v.start) start += (start.empty() ? "" : " ") + shortest_text(value);
    text += attribute("start", start);
  }
  if (v.start.size() == 1) return text + "/>\n";
  return text + "><Dimension" + attribute("start", std::to_string(v.start.size())) + "/></Float64>\n";
}

}  // namespace

std::map<std::string, int> base_units(const std::string& unit) {
  BaseUnits total;
  std::istringstream words(unit);
  bool below = false;
  std::string word;
  const auto add = [&](const std::string& text) {
    std::size_t digits = text.find_last_not_of("0123456789-") + 1;
    if (text == "1") digits = 1;
    const auto found = known_units().find(text.substr(0, digits));
    if (found == known_units().end()) return false;
    const int power = digits < text.size() ? std::stoi(text.substr(digits)) : 1;
    for (const auto& [base, exponent] : found->second) total[base] += (below ? -1 : 1) * power * exponent;
    return true;
  };
  while (words >> word) {
    for (std::size_t begin = 0; begin <= word.size();) {
      const std::size_t slash = word.find('/', begin);
      const std::string part = word.substr(begin, slash == std::string::npos ? slash : slash - begin);
      if (!part.empty() && !add(part)) return {};
      if (slash == std::string::npos) break;
      below = true;
      begin = slash + 1;
    }
  }
  return total;
}

std::string model_description(const ExportedScene& scene) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription" +
                     attribute("fmiVersion", "3.0") + attribute("modelName", scene.name) +
                     attribute("instantiationToken", scene.token) + attribute("description", scene.title) +
                     attribute("generationTool", std::string("footfall ") + FOOTFALL_VERSION) +
                     attribute("variableNamingConvention", "flat") + ">\n";
  const std::string state = scene.has_state ? "true" : "false";
  text += "  <CoSimulation modelIdentifier=\"footfall_fmu\"" + attribute("needsExecutionTool", "false") +
          attribute("canHandleVariableCommunicationStepSize", "true") + attribute("canGetAndSetFMUState", state) +
          attribute("canSerializeFMUState", state) + attribute("mightReturnEarlyFromDoStep", "true") +
          attribute("providesIntermediateUpdate", "false") + attribute("hasEventMode", "false") + "/>\n";
  std::set<std::string> units;
  for (const ExportedVariable& v : scene.variables)
    if (!v.unit.empty()) units.insert(v.unit);
  if (!units.empty()) text += "  <UnitDefinitions>\n";
  for (const std::string& unit : units) {
    text += "    <Unit" + attribute("name", unit) + "><BaseUnit";
    for (const auto& [base, exponent] : base_units(unit))
      if (exponent != 0) text += attribute(base, std::to_string(exponent));
    text += "/></Unit>\n";
  }
  if (!units.empty()) text += "  </UnitDefinitions>\n";
  text += "  <LogCategories><Category name=\"logStatusError\" description=\"Why a call failed\"/></LogCategories>\n";
  text += "  <DefaultExperiment" + attribute("startTime", "0") + attribute("stopTime", shortest_text(scene.end_time)) +
          attribute("stepSize", shortest_text(scene.step)) + "/>\n  <ModelVariables>\n";
  for (const ExportedVariable& v : scene.variables) text += variable_element(v);
  text += "  </ModelVariables>\n  <ModelStructure>\n";
  for (const char* element : {"Output", "InitialUnknown"})
    for (const ExportedVariable& v : scene.variables)
      if (v.kind == Kind::kOutput)
        text += std::string("    <") + element + attribute("valueReference", std::to_string(v.reference)) + "/>\n";
  return text + "  </ModelStructure>\n</fmiModelDescription>\n";
}

}  // namespace footfall
