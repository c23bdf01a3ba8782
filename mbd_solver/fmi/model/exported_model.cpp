// A line per variable: kind, reference, name, unit, start values.

#include "mbd_solver/fmi/model/exported_model.h"

#include <charconv>

#include "coupler/base/text.h"
#include "mbd_solver/base/exact_number.h"

namespace footfall {

std::string text_of_variables(const std::vector<ExportedVariable>& variables) {
  std::string text;
  for (const ExportedVariable& v : variables) {
    text += "TIOP"[static_cast<int>(v.kind)];
    text += "\t" + std::to_string(v.reference) + "\t" + v.name + "\t" + v.unit + "\t";
    for (const double value : v.start) text += shortest_text(value) + " ";
    text += "\t.\n";
  }
  return text;
}

std::vector<ExportedVariable> variables_of_text(const std::string& text) {
  std::vector<ExportedVariable> variables;
  for (const std::string& line : split(text, '\n')) {
    std::vector<std::string> cells = split(line, '\t');
    if (cells.size() < 5 || cells[0].size() != 1) continue;
    ExportedVariable v;
    v.kind = static_cast<ExportedVariable::Kind>(std::string("TIOP").find(cells[0]));
    unsigned reference = 0;
    std::from_chars(cells[1].data(), cells[1].data() + cells[1].size(), reference);
    v.reference = reference;
    v.name = cells[2];
    v.unit = cells[3];
    for (const std::string& word : split(cells[4], ' ')) {
      double value = 0.0;
      if (std::from_chars(word.data(), word.data() + word.size(), value).ec == std::errc()) v.start.push_back(value);
    }
    variables.push_back(std::move(v));
  }
  return variables;
}

}  // namespace footfall
