// The file of a table law: text to numbers, every complaint with its line.

#include <charconv>
#include <cmath>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/laws/table_law.h"

namespace footfall {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t comma = line.find(',', begin);
    result.push_back(trimmed(line.substr(begin, comma == std::string::npos ? comma : comma - begin)));
    if (comma == std::string::npos) return result;
    begin = comma + 1;
  }
}

double number(const std::string& cell, const std::string& where) {
  double value = 0.0;
  const char* begin = cell.data() + (cell.size() > 1 && cell[0] == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    throw InputError(where + ": \"" + cell +
                     "\" is not a number; expected one like -12.5 or 3e4, cells separated by commas.");
  return value;
}

}  // namespace

TableLawParameters read_table_law(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    throw InputError(file.string() +
                     ": cannot be read. Expected a table of forces over stroke and rate; check the path.");
  TableLawParameters p;
  p.source = file.string();
  std::vector<std::vector<double>> rows;
  std::string line;
  int line_number = 0;
  while (std::getline(in, line)) {
    ++line_number;
    const std::string where = p.source + ":" + std::to_string(line_number);
    const std::string text = trimmed(line.substr(0, line.find('#')));
    if (text.empty()) continue;
    const std::vector<std::string> cell = cells(text);
    if (p.rate.empty()) {  // the head: a label, then the rates
      if (cell.size() < 3)
        throw InputError(where + ": " + std::to_string(cell.size()) +
                         " cells in the first line; expected a label and at least two rates.");
      for (std::size_t i = 1; i < cell.size(); ++i) p.rate.push_back(number(cell[i], where));
      continue;
    }
    if (cell.size() != p.rate.size() + 1)
      throw InputError(where + ": " + std::to_string(cell.size()) + " cells; expected " +
                       std::to_string(p.rate.size() + 1) + ": a stroke and one force for each of the " +
                       std::to_string(p.rate.size()) + " rates of the first line.");
    const double stroke = number(cell[0], where);
    if (!p.stroke.empty() && stroke <= p.stroke.back())
      throw InputError(where + ": stroke " + cell[0] +
                       " m does not lie above the one before; expected strictly rising strokes.");
    p.stroke.push_back(stroke);
    p.lines.push_back(line_number);
    rows.emplace_back();
    for (std::size_t i = 1; i < cell.size(); ++i) rows.back().push_back(number(cell[i], where));
  }
  if (rows.size() < 2)
    throw InputError(p.source + ": " + std::to_string(rows.size()) +
                     " lines of forces; expected a line of rates and at least two strokes.");
  p.force.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(p.rate.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    p.force.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(rows[i].data(), static_cast<Eigen::Index>(rows[i].size()));
  return p;
}

}  // namespace footfall
