#pragma once
// Tables in text files: a line per row, cells separated by commas, # starts a comment, empty lines do not count. Cells in
// quotes as in RFC 4180: they may hold separators, #, ends of lines, and quotes as "".
//
//   CsvReader csv(path, "a table of forces");
//   while (csv.next()) use(csv.number(0), csv.number(1));

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "mbd_solver/base/codes.h"

namespace footfall {

class CsvReader {
 public:
  enum class Separators { kComma, kAny };  // kAny: commas, semicolons or blanks, any number of them

  // expected: what the file should be, for messages. Throws InputError if it cannot be read.
  CsvReader(const std::string& path, const std::string& expected, Separators separators = Separators::kComma);

  // Goes to the next line that has cells; false at the end of the file. Throws InputError for a quote that is not closed, or
  // is followed by text.
  bool next();
  // Of this line, without blanks around them; valid until the next line.
  const std::vector<std::string_view>& cells() const { return cells_; }
  std::string text(std::size_t column) const { return std::string(cells_.at(column)); }
  // Throws InputError if the cell is not a finite number.
  double number(std::size_t column) const;
  // Throws InputError unless the line has so many cells.
  void require_width(std::size_t cells) const;

  const std::string& path() const { return path_; }
  int line() const { return line_; }                                               // counted from 1
  std::string place() const;                                                       // "file:12: "
  [[noreturn]] void fail(const MessageCode& code, const std::string& what) const;  // InputError at this line

 private:
  bool split_quoted();  // of a line with quotes; false if it has no cells

  std::string path_;
  Separators separators_;
  std::ifstream file_;
  std::string content_;                // of this line
  std::vector<std::string> unquoted_;  // its cells, where some are in quotes
  std::vector<std::string_view> cells_;
  int line_ = 0;
};

// Reads the text as one number; false unless the whole text is a number. inf and nan count as numbers.
bool read_number(std::string_view text, double& value);

}  // namespace footfall
