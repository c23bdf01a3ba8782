#pragma once
// What LIGGGHTS and the partners of the tests write, read back.

#include <Eigen/Dense>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace footfall::test {

using Rows = std::vector<std::vector<double>>;

// Columns of a CSV file by name.
class Table {
 public:
  explicit Table(const std::filesystem::path& path);
  const std::vector<double>& operator[](const std::string& name) const;
  std::size_t rows() const { return columns_.empty() ? 0 : columns_.begin()->second.size(); }
  Eigen::Vector3d vector(std::size_t row, const std::string& x, const std::string& y, const std::string& z) const {
    return {(*this)[x][row], (*this)[y][row], (*this)[z][row]};
  }

 private:
  std::map<std::string, std::vector<double>> columns_;
};

// The numbers of one line, up to the first word that is none.
std::vector<double> numbers_of(const std::string& line);

// Rows of a dump by time step, sorted by id: the first number of each row.
using Dump = std::map<long, Rows>;
Dump read_dumps(const std::string& text);
// Largest difference of two dumps of the same grains at the same steps, each column relative to its largest number in
// `expected`. Infinite when steps, grains or columns differ.
double relative_difference(const Dump& expected, const Dump& found);

// Rows of a dump of one step, in the order of the file.
Rows read_dump(const std::string& text);

// Lines of thermo output in a log file: the words of each line that starts with a step number.
std::vector<std::vector<std::string>> thermo_lines(const std::string& log);

// How often `part` occurs in `text`.
std::size_t count(const std::string& text, const std::string& part);

}  // namespace footfall::test
