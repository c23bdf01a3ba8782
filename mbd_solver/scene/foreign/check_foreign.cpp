// Checks of signals that another program computes: names of outputs, and of an FMU what its modelDescription.xml says. The host
// of FMUs reads that file in a process of its own; where the host is not built, the run refuses instead.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>

#include "coupler/base/files.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/helper_process.h"
#include "mbd_solver/scene/foreign/foreign_code.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {
using namespace code;

namespace {

constexpr double kTimeToDescribe = 60.0;  // [s]

// A variable of an FMU as the end of a name in expressions: "y[1]" -> "y_1", "der(x)" -> "der_x".
std::string name_in_expressions(const std::string& variable) {
  std::string name;
  bool gap = false;
  for (const char c : variable) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    if (plain && gap && !name.empty()) name += '_';
    if (plain) name += c;
    gap = !plain;
  }
  return name;
}

const MessageCode& code_of_problem(const std::string& kind) {
  if (kind == "version") return kFmuVersion;
  if (kind == "platform") return kFmuPlatform;
  if (kind == "tool") return kFmuTool;
  if (kind == "limit") return kReadLimit;
  return kFmuFile;
}

// Names of the variables that a scene can use so, for a message.
std::vector<std::string> usable_names(const FmuDescription& fmu, const std::set<std::string>& causalities) {
  std::vector<std::string> names;
  for (const FmuVariable& v : fmu.variables)
    if (causalities.count(v.causality) > 0) names.push_back(v.name);
  return names;
}

struct FmuUse {
  const FmuDescription& fmu;
  const SignalSpec& signal;
  const EntryFindings& at;

  // The variable of this name, if it can be used; else a finding.
  const FmuVariable* use(const std::string& key, const std::string& name, const std::set<std::string>& causalities,
                         bool whole_arrays) const {
    const FmuElement found = find_element(fmu, name, signal.start);
    if (!found.variable) {
      at.error(kFmuVariable, key, "names \"", name, "\", which the FMU does not have.",
               known_names("variables for this", name, usable_names(fmu, causalities)));
      return nullptr;
    }
    const FmuVariable& v = *found.variable;
    if (!found.problem.empty() && !(whole_arrays && v.name == name)) {
      at.error(kFmuArray, key, "names \"", name, "\", which ", found.problem);
      return nullptr;
    }
    if (causalities.count(v.causality) == 0) {
      at.error(kFmuCausality, key, "names \"", name, "\", whose causality is \"", v.causality, "\", expected ",
               joined({causalities.begin(), causalities.end()}, " or "), ".",
               known_names("variables for this", name, usable_names(fmu, causalities)));
      return nullptr;
    }
    return &v;
  }
  bool require_number(const std::string& key, const FmuVariable& v) const {
    at.error_if(!v.is_number(), kFmuType, key, "names \"", v.name, "\", which is of the type ", v.type,
                ", expected a number or a Boolean");
    return v.is_number();
  }
};

bool reads_as_number(const std::string& text) {
  char* end = nullptr;
  const double value = read_number(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(value);
}

void check_start(const FmuUse& use, const std::string& name, const std::string& value) {
  const FmuVariable* const v =
      use.use("start", name, {"parameter", "structuralParameter", "input", "output", "local"}, true);
  if (!v) return;
  use.at.error_if(v->variability == "constant", kFmuCausality, "start", "names \"", name,
                  "\", which is constant; remove it");
  use.at.error_if(v->type == "Binary" || v->type == "Clock", kFmuType, "start", "names \"", name, "\" of the type ",
                  v->type, ", which a scene cannot set; remove it");
  if (!v->is_number()) return;
  const bool word = v->type == "Boolean" && (value == "true" || value == "false");
  for (const std::string& each : split(value, ' '))
    use.at.error_if(!word && !each.empty() && !reads_as_number(each), kWrongType, "start", "gives \"", name,
                    "\" the value \"", each, "\", expected a number");
}

void check_fmu(const SignalSpec& s, const EntryFindings& at) {
  FmuDescription fmu;
  try {
    fmu = describe_fmu(s.file);
  } catch (const InputError& error) {
    at.all().coded_error(at.source(), "file", error.what());
    return;
  }
  const FmuUse use{fmu, s, at};
  for (const std::string& name : s.input_names)
    if (const FmuVariable* const v = use.use("inputs", name, {"input"}, false)) use.require_number("inputs", *v);
  for (const std::string& name : s.outputs)
    if (const FmuVariable* const v = use.use("outputs", name, {"output", "local", "independent"}, false))
      use.require_number("outputs", *v);
  for (const auto& [name, value] : s.start) check_start(use, name, value);
}

// A Python file without these functions keeps nothing, or cannot say what.
bool keeps_its_state(const SignalSpec& s) {
  if (s.stateless) return true;
  const std::string text = read_whole_file(s.file).value_or("");
  const auto defines = [&](const std::string& what) {
    return text.find("\ndef " + what + "(") != std::string::npos || text.rfind("def " + what + "(", 0) == 0 ||
           text.find("\n" + what + " = ") != std::string::npos;
  };
  return defines("save") && defines("restore");
}

}  // namespace

std::vector<std::string> SignalSpec::output_signals() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < outputs.size(); ++i)
    names.push_back(name + "." + (i < output_names.size() ? output_names[i] : name_in_expressions(outputs[i])));
  return names;
}

FmuDescription describe_fmu(const std::string& file) {
  const std::string host = fmu_host();
  if (host.empty())
    throw InputError(kFmuHost, "the program footfall_fmu_host is not built, which reads FMUs; ", kBuildFmuHost);
  std::string answer;
  try {
    answer = HelperProcess({Rights::starting({host}), {host, "describe"}}, kTimeToDescribe).ask("D" + file);
  } catch (const NoAnswer& error) {
    throw InputError(kFmuFile, file, ": the program that reads it ", error.what());
  }
  if (!answer.empty() && answer[0] == 'V') return fmu_description_of(answer.substr(1));
  const std::size_t tab = answer.find('\t');
  if (answer.empty() || tab == std::string::npos) throw InputError(kFmuFile, file, ": cannot be read as an FMU");
  throw InputError(code_of_problem(answer.substr(1, tab - 1)), file, ": ", answer.substr(tab + 1));
}

// Whether a Python file may define a name; a file that imports all names of another may.
static bool may_define(const std::string& text, const std::string& name) {
  if (text.find("import *") != std::string::npos || text.find("globals()") != std::string::npos) return true;
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t i = text.find(name); i != std::string::npos; i = text.find(name, i + 1)) {
    const std::size_t end = i + name.size();
    if (i > 0 && is_part(text[i - 1])) continue;
    if (end < text.size() && is_part(text[end])) continue;
    std::size_t line = text.find_last_of('\n', i);
    line = line == std::string::npos ? 0 : line + 1;
    const std::size_t comment = text.find('#', line);
    if (comment == std::string::npos || comment > i) return true;
  }
  return false;
}

void check_foreign(const Scene& scene, const SignalSpec& s, const EntryFindings& at) {
  const auto refused = [&](const char* key) { return s.source.refused.count(key) > 0; };
  if (s.kind == SignalKind::kPython) {
    at.missing_if(s.file.empty() && !refused("file"), "file",
                  "a python signal is computed by a function of a .py file");
    at.missing_if(s.function.empty() && !refused("function"), "function",
                  "name the function of the file, f(time, *inputs)");
    at.missing_if(s.period == 0.0 && !refused("period"), "period", "it is sampled, for example period_ms = 1");
    at.error_if(!s.input_names.empty(), kWrongType, "inputs", "is a table, expected a list of expressions");
    if (s.file.empty() || s.function.empty()) return;
    if (const std::optional<std::string> text = read_whole_file(s.file); text && !may_define(*text, s.function))
      at.warning(kNoFunction, "function", "is \"", s.function, "\", which ", s.file, " does not define; write  def ",
                 s.function, "(time, ...)  there, or name a function of the file");
    return;
  }
  at.missing_if(s.file.empty() && !refused("file"), "file", "an fmu signal is computed by an .fmu file");
  at.missing_if(s.outputs.empty() && !refused("outputs"), "outputs",
                "list the variables that are read, for example outputs = [\"y\"]");
  at.missing_if(s.period == 0.0 && !refused("period"), "period", "it is sampled, for example period_ms = 1");
  at.error_if(!s.inputs.empty() && s.input_names.empty(), kWrongType, "inputs",
              "is a list, expected a table { variable = \"expression\", ... }");
  std::set<std::string> names;
  const std::vector<std::string> signals = s.output_signals();
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const std::string& name = signals[i];
    at.error_if(name.size() <= s.name.size() + 1, kBadName, "outputs", "has \"", s.outputs[i],
                "\", of which no name can be made; write { name = \"", s.outputs[i], "\" }");
    at.error_if(!is_plain_name(name) || name.find('-') != std::string::npos, kBadName, "outputs", "makes the signal \"",
                name, "\", expected letters, digits, _ and .");
    at.error_if(!names.insert(name).second, kDuplicateName, "outputs", "makes the signal \"", name,
                "\" twice; write { name = \"variable\", ... }");
    for (const SignalSpec& other : scene.signals)
      at.error_if(other.name == name, kDuplicateName, "outputs", "makes the signal \"", name,
                  "\", which is another signal as well; rename one of them");
  }
  std::error_code none;
  const bool there = std::filesystem::is_regular_file(s.file, none);  // another check reports a file that is not
  if (s.kind == SignalKind::kFmu && there && !refused("file") && !fmu_host().empty()) check_fmu(s, at);
}

bool runs_foreign_code(const Scene& scene) {
  return std::any_of(scene.signals.begin(), scene.signals.end(), [](const SignalSpec& s) { return s.is_foreign(); });
}

void require_trust(const Scene& scene, bool trusted) {
  if (trusted) return;
  for (const SignalSpec& s : scene.signals)
    if (s.is_foreign())
      throw InputError(kForeignCode, place_of(scene.file, s.source, "file"), s.file,
                       " is a program, which may do whatever you may; if you trust it, add --trust-script");
}

void require_foreign_code(const Scene& scene) {
  for (const SignalSpec& s : scene.signals) {
    if (s.kind == SignalKind::kPython && scene.output.checkpoint_interval > 0.0 && !keeps_its_state(s))
      throw InputError(kScriptState, place_of(scene.file, scene.output.source, "checkpoint_interval"),
                       "asks for checkpoints, but ", s.file, " of signal \"", s.name,
                       "\" has no functions save() and restore(saved); add them, give the signal stateless = true if "
                       "it keeps nothing between calls, or remove checkpoint_interval");
    if (s.kind != SignalKind::kFmu) continue;
    const std::string where = place_of(scene.file, s.source, "file");
    FmuDescription fmu;
    try {
      fmu = describe_fmu(s.file);
    } catch (const InputError& error) {
      throw InputError(where + error.what());
    }
    if (!fmu.obstacle.empty()) {
      const std::size_t tab = fmu.obstacle.find(' ');
      throw InputError(code_of_problem(fmu.obstacle.substr(0, tab)), where, s.file, ": ", fmu.obstacle.substr(tab + 1));
    }
    if (!fmu.keeps_state && scene.output.checkpoint_interval > 0.0)
      throw InputError(kFmuState, place_of(scene.file, scene.output.source, "checkpoint_interval"),
                       "asks for checkpoints, but the FMU of signal \"", s.name,
                       "\" cannot tell its state (canSerializeFMUState); remove checkpoint_interval, or export the FMU "
                       "with that ability");
  }
}

std::vector<std::string> foreign_code_without_state(const Scene& scene) {
  std::vector<std::string> names;
  for (const SignalSpec& s : scene.signals)
    if ((s.kind == SignalKind::kFmu && !describe_fmu(s.file).keeps_state) ||
        (s.kind == SignalKind::kPython && !keeps_its_state(s)))
      names.push_back(s.name);
  return names;
}

}  // namespace footfall
