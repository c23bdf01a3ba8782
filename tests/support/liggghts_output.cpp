#include "tests/support/liggghts_output.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace footfall::test {

Table::Table(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::string line, word;
  std::getline(in, line);
  std::vector<std::string> names;
  for (std::istringstream words(line); std::getline(words, word, ',');) names.push_back(word);
  while (std::getline(in, line)) {
    std::size_t column = 0;
    for (std::istringstream words(line); std::getline(words, word, ',');)
      columns_[names.at(column++)].push_back(std::stod(word));
  }
}

const std::vector<double>& Table::operator[](const std::string& name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end()) throw std::runtime_error("no column " + name);
  return found->second;
}

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> row;
  std::istringstream words(line);
  for (double value = 0.0; words >> value;) row.push_back(value);
  return row;
}

Dump read_dumps(const std::string& text) {
  std::istringstream in(text);
  Dump dump;
  std::string line;
  Rows* rows = nullptr;
  while (std::getline(in, line)) {
    if (line.rfind("ITEM: TIMESTEP", 0) == 0) {
      std::getline(in, line);
      rows = &dump[std::stol(line)];
      rows->clear();
    } else if (line.rfind("ITEM: ATOMS", 0) == 0) {
      if (rows == nullptr) throw std::runtime_error("a dump has grains before its first time step");
      while (in.peek() != 'I' && std::getline(in, line)) rows->push_back(numbers_of(line));
      std::sort(rows->begin(), rows->end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
    }
  }
  return dump;
}

double relative_difference(const Dump& expected, const Dump& found) {
  const double different = std::numeric_limits<double>::infinity();
  std::vector<double> largest;  // of each column
  for (const auto& [step, rows] : expected)
    for (const auto& row : rows) {
      largest.resize(row.size(), 0.0);
      for (std::size_t k = 0; k < row.size(); ++k) largest[k] = std::max(largest[k], std::abs(row[k]));
    }
  double worst = 0.0;
  if (found.size() != expected.size()) return different;
  for (const auto& [step, rows] : expected) {
    const auto same_step = found.find(step);
    if (same_step == found.end() || same_step->second.size() != rows.size()) return different;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::vector<double>& row = same_step->second[i];
      if (row.size() != rows[i].size() || row[0] != rows[i][0]) return different;
      for (std::size_t k = 1; k < row.size(); ++k) {
        const double difference = std::abs(row[k] - rows[i][k]);
        if (difference != 0.0) worst = std::max(worst, difference / largest[k]);
      }
    }
  }
  return worst;
}

Rows read_dump(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line) && line.rfind("ITEM: ATOMS", 0) != 0) {
  }
  Rows rows;
  while (std::getline(in, line)) rows.push_back(numbers_of(line));
  return rows;
}

std::vector<std::vector<std::string>> thermo_lines(const std::string& log) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(log);
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> words;
    std::istringstream split(line);
    for (std::string word; split >> word;) words.push_back(word);
    if (!words.empty() && words[0] == "Step") {
      inside = true;
    } else if (words.size() > 1 && words[0] == "Loop") {
      inside = false;
    } else if (inside) {
      lines.push_back(words);
    }
  }
  return lines;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace footfall::test
