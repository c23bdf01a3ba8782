// Each line is taken with its number, which later messages name.

#include "mbd_solver/assemble/law_files.h"

#include <algorithm>
#include <map>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/budget.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/model/codes.h"

namespace footfall {

TableLawParameters read_table_law(const std::filesystem::path& file) {
  CsvReader csv(file.string(), "a table of forces over stroke and rate");
  TableLawParameters p;
  p.source = file.string();
  std::vector<std::vector<double>> rows;
  ReadBudget cells(limit::kTableCells, p.source);
  while (csv.next()) {
    const std::size_t width = csv.cells().size();
    cells.take(width);
    if (p.rate.empty()) {  // the head: a label, then the rates
      if (width < 3)
        csv.fail(code::kTableWidth, "the first line has ", width, " cells, expected a label and at least two rates");
      for (std::size_t i = 1; i < width; ++i) p.rate.push_back(csv.number(i));
      continue;
    }
    csv.require_width(p.rate.size() + 1);
    const double stroke = csv.number(0);
    if (!p.stroke.empty() && stroke <= p.stroke.back())
      csv.fail(code::kTableCell, "stroke ", csv.text(0), " m does not exceed the one before; expected rising strokes");
    p.stroke.push_back(stroke);
    p.lines.push_back(csv.line());
    rows.emplace_back();
    for (std::size_t i = 1; i < width; ++i) rows.back().push_back(csv.number(i));
  }
  if (rows.size() < 2)
    throw InputError(code::kTableShape, p.source, ": ", rows.size(),
                     " lines of forces; expected a line of rates and at least two strokes.");
  p.force.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(p.rate.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    p.force.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(rows[i].data(), static_cast<Eigen::Index>(rows[i].size()));
  return p;
}

namespace {

const std::map<std::string, std::vector<std::string>> kFllKeys = {
    {"Engine", {"description"}},
    {"InputVariable", {"description", "enabled", "range", "lock-range", "term"}},
    {"OutputVariable",
     {"description", "enabled", "range", "lock-range", "aggregation", "defuzzifier", "default", "lock-previous",
      "term"}},
    {"RuleBlock", {"description", "enabled", "conjunction", "disjunction", "implication", "activation", "rule"}},
};

std::string first_word(const std::string& text) { return text.substr(0, text.find_first_of(" \t")); }

}  // namespace

FllText read_fll(const std::filesystem::path& file) {
  TextReader in(file.string(), code::kFllSyntax, "a fuzzy controller (.fll). Check the path.", kLargestText);
  FllText out{file.string(), {}};
  std::vector<FllBlock>& blocks = out.blocks;
  std::map<std::string, int> variables, terms;  // lines; terms of this block
  ReadBudget lines(limit::kFllLines, file.string());
  while (in.next()) {
    lines.take();
    const int number = in.number_of_line();
    const std::string line = trimmed(in.line().substr(0, in.line().find('#')));
    if (line.empty()) continue;
    const auto colon = line.find(':');
    if (colon == std::string::npos)
      in.fail("\"", line, "\" has no colon; expected \"key: value\", for example \"range: 0 5\".");
    const FllLine entry{number, trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1))};
    if (kFllKeys.count(entry.key) > 0) {
      if (entry.key.find("Variable") != std::string::npos)
        if (const auto [other, is_new] = variables.emplace(entry.value, number); !is_new)
          in.fail("variable \"", entry.value, "\" is already defined in line ", other->second, ".");
      blocks.push_back({entry, {}});
      terms.clear();
      continue;
    }
    if (blocks.empty()) in.fail("\"", entry.key, "\" precedes the first block; expected \"Engine: name\" first.");
    FllBlock& block = blocks.back();
    const std::vector<std::string>& known = kFllKeys.at(block.head.key);
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      in.fail("unknown key \"", entry.key, "\" in ", block.head.key, " \"", block.head.value,
              "\". Known keys: ", joined(known), ".");
    if (entry.key == "term")
      if (const auto [other, is_new] = terms.emplace(first_word(entry.value), number); !is_new)
        in.fail("term \"", first_word(entry.value), "\" of \"", block.head.value, "\" is already defined in line ",
                other->second, ".");
    block.lines.push_back(entry);
  }
  return out;
}

}  // namespace footfall
