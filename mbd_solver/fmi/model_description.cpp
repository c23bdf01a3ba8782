// pugixml reads modelDescription.xml of FMI 3.0 and 2.0: attributes of the model, and its variables in one form.

#include <cstdlib>
#include <limits>
#include <pugixml.hpp>
#include <set>

#include "coupler/base/number.h"
#include "mbd_solver/base/budget.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/fmi/fmu_file.h"

namespace footfall {
namespace {

bool is_true(const pugi::xml_node& node, const char* attribute) {
  const std::string value = node.attribute(attribute).value();
  return value == "true" || value == "1";
}

[[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) {
  throw FmuProblem("file", std::string("the variable \"") + node.attribute("name").value() +
                               "\" of its modelDescription.xml " + what + "; export it again");
}

unsigned reference_of(const pugi::xml_node& node, const char* attribute) {
  const std::string text = node.attribute(attribute).value();
  constexpr std::size_t kMostDigits = 10;
  const bool digits = !text.empty() && text.size() <= kMostDigits && text.find_first_not_of("0123456789") == text.npos;
  const unsigned long value = digits ? std::strtoul(text.c_str(), nullptr, 10) : 0;
  if (!digits || value > std::numeric_limits<unsigned>::max())
    fail(node,
         std::string("has the ") + attribute + " \"" + text.substr(0, 40) + "\", expected a whole number of 32 bits");
  return static_cast<unsigned>(value);
}

// Names are given once; start values of numbers are numbers (or true and false).
void check_variables(const pugi::xml_node& variables, const FmuDescription& d) {
  std::set<std::string> names;
  auto node = variables.children().begin();
  for (const FmuVariable& v : d.variables) {
    while (node->type() != pugi::node_element) ++node;
    if (v.name.empty() || !names.insert(v.name).second)
      fail(*node, v.name.empty() ? "has no name" : "is there twice, expected each name once");
    ReadBudget values(limit::kFmuStart, "");
    std::size_t at = 0;
    for (std::string_view word; v.is_number() && !(word = next_word(v.start, at)).empty();) {
      if (!values.takes()) throw FmuProblem("limit", values.excess());
      double value = 0.0;
      if (word != "true" && word != "false" && !read_number(word, value))
        fail(*node, "has the start value " + in_quotes(word) + ", expected a number");
    }
    ++node;
  }
}

const std::string& or_default(const std::string& value, const std::string& otherwise) {
  return value.empty() ? otherwise : value;
}

// <Float64 name="h" valueReference="1" causality="output" start="1"><Dimension start="2"/></Float64>
FmuVariable variable_3(const pugi::xml_node& node) {
  FmuVariable v;
  v.name = node.attribute("name").value();
  v.type = node.name();
  v.causality = or_default(node.attribute("causality").value(), "local");
  const bool real = v.type == "Float64" || v.type == "Float32";
  const bool fixed =
      v.causality == "parameter" || v.causality == "structuralParameter" || v.causality == "calculatedParameter";
  v.variability = or_default(node.attribute("variability").value(), fixed ? "fixed" : real ? "continuous" : "discrete");
  v.unit = node.attribute("unit").value();
  v.start = node.attribute("start").value();
  if (v.start.empty()) v.start = node.child("Start").attribute("value").value();
  v.reference = reference_of(node, "valueReference");
  for (const pugi::xml_node& dimension : node.children("Dimension")) {
    FmuVariable::Dimension d;
    d.fixed = !dimension.attribute("valueReference");
    d.size = std::strtol(dimension.attribute("start").value(), nullptr, 10);
    if (!d.fixed) d.parameter = reference_of(dimension, "valueReference");
    v.dimensions.push_back(d);
  }
  return v;
}

// <ScalarVariable name="h" valueReference="1" causality="output"><Real start="1" unit="m"/></ScalarVariable>
FmuVariable variable_2(const pugi::xml_node& node) {
  FmuVariable v;
  v.name = node.attribute("name").value();
  v.causality = or_default(node.attribute("causality").value(), "local");
  v.variability = or_default(node.attribute("variability").value(), "continuous");
  v.reference = reference_of(node, "valueReference");
  for (const char* type : {"Real", "Integer", "Boolean", "String", "Enumeration"})
    if (const pugi::xml_node of_type = node.child(type)) {
      v.type = type;
      v.start = of_type.attribute("start").value();
      v.unit = of_type.attribute("unit").value();
    }
  return v;
}

}  // namespace

FmuDescription parse_model_description(const std::string& xml) {
  ReadBudget parts(limit::kXmlParts, "");
  if (!parts.takes(xml_parts(xml))) throw FmuProblem("limit", "its modelDescription.xml " + parts.excess());
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(xml.data(), xml.size());
  if (!result)
    throw FmuProblem("file", "its modelDescription.xml is damaged: " + std::string(result.description()) + " at byte " +
                                 std::to_string(result.offset) + "; export it again");
  const pugi::xml_node root = document.child("fmiModelDescription");
  if (!root) throw FmuProblem("file", "its modelDescription.xml has no element fmiModelDescription; export it again");
  FmuDescription d;
  d.version = root.attribute("fmiVersion").value();
  const bool three = d.version.rfind("3.", 0) == 0, two = d.version.rfind("2.", 0) == 0;
  if (!three && !two)
    throw FmuProblem("version",
                     "is an FMU of FMI version \"" + d.version + "\", expected 3.0 or 2.0; export it for one of them");
  d.model = root.attribute("modelName").value();
  d.token = root.attribute(three ? "instantiationToken" : "guid").value();
  const pugi::xml_node simulation = root.child("CoSimulation");
  if (!simulation) {
    d.obstacle = "tool the FMU is not for co-simulation (it has " +
                 std::string(root.child("ModelExchange") ? "model exchange only" : "no interface that is known") +
                 "); export it for co-simulation";
  } else if (is_true(simulation, "needsExecutionTool")) {
    d.obstacle =
        "tool the FMU needs the program that exported it (needsExecutionTool); export it without that, "
        "with its solver inside";
  }
  d.identifier = simulation.attribute("modelIdentifier").value();
  const bool plain = !d.identifier.empty() && d.identifier.find('/') == std::string::npos;
  if (simulation && !plain)
    throw FmuProblem("file", "its modelDescription.xml gives no usable modelIdentifier; export it again");
  d.keeps_state = is_true(simulation, three ? "canGetAndSetFMUState" : "canGetAndSetFMUstate") &&
                  is_true(simulation, three ? "canSerializeFMUState" : "canSerializeFMUstate");
  for (const pugi::xml_node& node : root.child("ModelVariables").children())
    if (node.type() == pugi::node_element) d.variables.push_back(three ? variable_3(node) : variable_2(node));
  check_variables(root.child("ModelVariables"), d);
  return d;
}

}  // namespace footfall
