#pragma once
// A table of an experiment: CSV for programs, Markdown for pages; and the texts of its cells.

#include <optional>
#include <string>
#include <vector>

namespace footfall {

// Rows of cells. Rows shorter than the head stay short.
class Table {
 public:
  explicit Table(std::vector<std::string> head) : rows_{std::move(head)} {}

  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  int column(const std::string& name) const;  // its number, from 1; 0: there is none
  std::string csv() const;                    // RFC 4180: cells with a comma or a quote stand in quotes
  std::string page() const;                   // Markdown

 private:
  std::vector<std::vector<std::string>> rows_;  // the head first
};

void append(std::vector<std::string>& row, const std::vector<std::string>& more);

// A number in a table: empty where there is none.
std::string cell(double value, int digits = 6);
// As people read it: three digits, and round-off is zero.
std::string rounded(double value);
std::string percent(double share);

// The number that a text is; none when it is more or less than one.
std::optional<double> number_in(const std::string& text);

}  // namespace footfall
