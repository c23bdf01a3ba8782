// Numbers, texts, lists, tables and choices of a scene file. Vectors and rotations: vector_reader.cpp.
#include "mbd_solver/scene/value_reader.h"

#include <charconv>
#include <cmath>
#include <filesystem>

#include "coupler/base/text.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/value_checks.h"

namespace footfall {

using namespace code;

namespace {

using Kind = ConfigNode::Kind;

// Names of arrays stand in braces until their entries are copied: "leg_{leg}".
std::string without_braces(std::string text) {
  for (char& c : text)
    if (c == '{' || c == '}') c = '_';
  return text;
}

}  // namespace

std::string read_value(const ConfigNode& node, const ValueContext& c, double& target) {
  if (!node.is_number()) return is_expected(node, with_unit("a number", c.rule));
  const double value = node.number * c.factor;
  const std::string problem = check_range(value, c.rule);
  if (problem.empty()) target = value;
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext& c, int& target) {
  if (node.kind != Kind::kInteger || std::abs(node.number) > 1e9) return is_expected(node, "a whole number");
  const std::string problem = check_range(node.number, c.rule);
  if (problem.empty()) target = static_cast<int>(node.number);
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext&, bool& target) {
  if (node.kind != Kind::kFlag) return is_expected(node, "true or false");
  target = node.flag;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::string& target) {
  if (c.rule.meaning == Meaning::kWords && node.is_number()) {
    const bool whole = node.kind == Kind::kInteger;  // seeds have many digits
    target = whole ? std::to_string(static_cast<long long>(node.number)) : number_text(node.number);
    return "";
  }
  if (node.kind != Kind::kText) return is_expected(node, "text in quotes");
  if (node.text.empty() && c.rule.required) return with_code(kMissingKey, "is empty, expected a name");
  if (c.rule.meaning == Meaning::kName && !node.text.empty() && !is_plain_name(without_braces(node.text)))
    return with_code(kBadName, "is " + node.description() + ", expected a name of at most " +
                                   std::to_string(kLongestName) +
                                   " letters, digits, _ - and . (not first): it becomes a column and a file");
  target = node.text;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<std::string>& target) {
  if (c.rule.meaning != Meaning::kWords || node.kind == Kind::kList)
    return read_list(node, c, "a list of texts", target);
  std::string word;
  const std::string problem = read_value(node, c, word);
  if (problem.empty()) target = {word};
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::array<std::string, 2>& target) {
  return read_pair(node, c, "two names of bodies", target);
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<double>& target) {
  if (!node.is_number()) return read_numbers(node, c, 0, target);
  double value = 0.0;  // one number is a list of one
  const std::string problem = read_value(node, c, value);
  if (problem.empty()) target = {value};
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<int>& target) {
  return read_list(node, c, "a list of whole numbers", target);
}

std::vector<Eigen::Vector2d> read_two_columns(const std::string& file) {
  CsvReader csv(file, "a text file with two columns of numbers", CsvReader::Separators::kAny);
  std::vector<Eigen::Vector2d> rows;
  for (bool first = true; csv.next(); first = false) {
    const char begin = csv.cells().front().front();
    if (first && (std::isalpha(static_cast<unsigned char>(begin)) || begin == '"')) continue;  // names of the columns
    csv.require_width(2);
    rows.emplace_back(csv.number(0), csv.number(1));
  }
  return rows;
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<Eigen::Vector2d>& target) {
  std::vector<Eigen::Vector2d> result;
  if (node.kind == Kind::kText) {
    try {
      result = read_two_columns((std::filesystem::path(c.folder) / node.text).string());
    } catch (const InputError& e) {
      return e.what();
    }
    for (Eigen::Vector2d& row : result) row[1] *= c.factor;
  } else {
    const std::string expected = "pairs [[x, y], [x, y], ...], or the name of a CSV file with two columns";
    if (node.kind != Kind::kList) return is_expected(node, expected);
    for (const ConfigNode& item : node.list) {
      if (item.kind != Kind::kList || item.list.size() != 2 || !item.list[0].is_number() || !item.list[1].is_number())
        return with_code(kWrongType, "contains " + item.description() + ", expected " + expected);
      result.emplace_back(item.list[0].number, item.list[1].number * c.factor);
    }
  }
  if (result.size() < 2)
    return with_code(kWrongCount, "has " + std::to_string(result.size()) + " rows, expected at least two");
  for (std::size_t i = 1; i < result.size(); ++i) {
    if (!(result[i][0] > result[i - 1][0]))
      return with_code(kNotRising, "does not rise: row " + std::to_string(i + 1) + " begins with " +
                                       number_text(result[i][0]) + " after " + number_text(result[i - 1][0]) +
                                       "; expected a rising first column");
  }
  target = std::move(result);
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::map<std::string, std::string>& target) {
  if (node.kind != Kind::kTable) return is_expected(node, "a table { name = value, ... }");
  std::map<std::string, std::string> result;
  for (const auto& [key, value] : node.table) {
    if (value.kind == Kind::kText) {
      result[key] = value.text;
    } else if (value.is_number() && c.rule.meaning == Meaning::kWords) {
      read_value(value, c, result[key]);  // the same text as in a list of words
    } else if (value.is_number()) {
      char buffer[40];  // the shortest text that reads back as the same number
      result[key] = std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value.number).ptr);
    } else {
      return "variable \"" + key + "\" " + is_expected(value, "a number or text");
    }
  }
  target = std::move(result);
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext&, Choice& target) {
  for (std::size_t i = 0; i < target.names.size(); ++i) {
    if (node.kind != Kind::kText || node.text != target.names[i]) continue;
    target.value = static_cast<int>(i);
    return "";
  }
  return with_code(kUnknownChoice, "is " + node.description() + ", which is none of the choices." +
                                       known_names("choices", node.text, target.names));
}

std::string read_value(const ConfigNode& node, const ValueContext& c, NumberOrWord& target) {
  if (node.kind != Kind::kText) return read_value(node, c, *target.number);
  if (node.text != target.word) return is_expected(node, with_unit("a number", c.rule) + " or \"" + target.word + "\"");
  *target.is_word = true;
  return "";
}

}  // namespace footfall
