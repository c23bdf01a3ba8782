#include <cctype>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/scene/field_reader.h"

namespace footfall {

std::vector<Eigen::Vector2d> read_two_columns(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file + ": cannot be read; expected a text file with two columns of numbers");
  std::vector<Eigen::Vector2d> rows;
  std::string line;
  bool first = true;  // of the lines that hold anything: it may name the columns
  for (int number = 1; std::getline(stream, line); ++number) {
    line = line.substr(0, line.find('#'));
    for (char& c : line) {
      if (c == ',' || c == ';') c = ' ';
    }
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream numbers(line);
    Eigen::Vector2d row;
    std::string rest;
    const char begin = line[line.find_first_not_of(" \t")];
    const bool names = first && (std::isalpha(static_cast<unsigned char>(begin)) || begin == '"');
    first = false;
    if (names) continue;
    if (!(numbers >> row[0] >> row[1]) || (numbers >> rest))
      throw InputError(file + ":" + std::to_string(number) + ": expected two numbers, found \"" + line + "\"");
    rows.push_back(row);
  }
  return rows;
}

}  // namespace footfall
