#pragma once
// Text of another finite-element code, line by line, with places for messages; Nastran cards.

#include <cstddef>
#include <string>
#include <vector>

#include "mbd_solver/base/text_reader.h"

namespace footfall {

// The whole file. Throws InputError if it is no regular file or cannot be read.
std::string bytes_of_model(const std::string& path);

class ModelText : public TextReader {
 public:
  // `name`: for messages "name:line: ...".
  ModelText(std::string bytes, std::string name);

  bool blank() const { return without_blanks(line()).empty(); }
  // Cells between commas, without blanks at their ends; of a line without commas, its words.
  std::vector<std::string> cells();
  std::vector<std::string> words() const { return blank_words(line()); }
  // Also as Fortran and Nastran write them: 1.5D+10, 1.5+10. Throws InputError naming the word.
  double number(std::string_view word) const;
};

// Fields of one bulk-data card with its continuations, in small, large or free format, without the fields of continuation
// marks. The first is the card's name in upper case, without its star. Comments ($) are left out.
class NastranCards {
 public:
  explicit NastranCards(ModelText& text) : text_(text) {}

  bool next();
  const std::vector<std::string>& fields() const { return fields_; }
  // The card's first line, without blanks at its ends.
  const std::string& line() const { return line_; }
  // Field i as a number; an empty or missing one is `otherwise`.
  double number(std::size_t i, double otherwise) const;
  long whole(std::size_t i, long low, long high) const;
  bool given(std::size_t i) const { return i < fields_.size() && !fields_[i].empty(); }
  [[noreturn]] void fail(const std::string& what) const { text_.fail(what); }

 private:
  ModelText& text_;
  std::vector<std::string> fields_;
  std::string line_;
};

std::string upper_case(std::string text);

}  // namespace footfall
