#pragma once
// Tables in text files: a line per row, cells separated by commas, # starts a comment, empty lines do not count. Cells in
// quotes as in RFC 4180: they may hold separators, #, ends of lines, and quotes as "".
//
//   CsvReader csv(path, "a table of forces");
//   while (csv.next()) use(csv.number(0), csv.number(1));

#include <string>
#include <string_view>
#include <vector>

#include "mbd_solver/base/text_reader.h"

namespace footfall {

class CsvReader {
 public:
  using Separators = footfall::Separators;

  // expected: what the file should be, for messages. Throws InputError if it cannot be read.
  CsvReader(const std::string& path, const std::string& expected, Separators separators = Separators::kComma);

  // Goes to the next line that has cells; false at the end of the file. Throws InputError for a quote that is not closed, or
  // is followed by text.
  bool next();
  // The cells of this line, without blanks around them; valid until the next line.
  const std::vector<std::string_view>& cells() const { return cells_; }
  std::string text(std::size_t column) const { return std::string(cells_.at(column)); }
  // Throws InputError if the cell is not a finite number.
  double number(std::size_t column) const;
  // Throws InputError unless the line has this many cells.
  void require_width(std::size_t cells) const;

  const std::string& path() const { return text_.name(); }
  int line() const { return text_.number_of_line(); }  // counted from 1
  std::string place() const { return text_.place() + ": "; }
  // The file ends within this line, or with it.
  bool is_unfinished() const { return *text_.ending() == '\0'; }
  // InputError at this line.
  template <class... Pieces>
  [[noreturn]] void fail(const MessageCode& code, const Pieces&... what) const {
    text_.fail(code, what...);
  }

 private:
  bool split_quoted();  // of a line with quotes; false if it has no cells

  TextReader text_;
  Separators separators_;
  std::vector<std::string> unquoted_;  // cells of this line, where some are in quotes
  std::vector<std::string_view> cells_;
};

}  // namespace footfall
