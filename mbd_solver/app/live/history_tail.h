#pragma once
// The rows of a history.csv that is being written: each call reads what was appended since the one before.

#include <cstdint>
#include <string>
#include <vector>

namespace footfall {

// Names and last complete row of a history.csv, which may be in writing; empty without a row.
struct LastRow {
  std::vector<std::string> names;
  std::vector<double> values;
  long rows = 0;
};

class HistoryTail {
 public:
  explicit HistoryTail(std::string file) : file_(std::move(file)) {}

  // The complete lines of rows that were appended, with their ends; at most so many bytes. A file that has become shorter is
  // read again from its beginning.
  std::string read(std::size_t most = std::string::npos);
  // The last row of all that was read; throws InputError for a row that is no row of numbers.
  LastRow last() const;

  // Of the head; empty before it is complete.
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& units() const { return units_; }
  long rows() const { return rows_; }

 private:
  void read_head(const std::string& text);

  std::string file_, last_line_;
  std::uintmax_t read_ = 0;  // [bytes]
  std::vector<std::string> names_, units_;
  long rows_ = 0;
};

// The numbers of a row. Throws InputError where there are not as many as names.
std::vector<double> row_values(const std::string& line, std::size_t count, const std::string& file);

}  // namespace footfall
