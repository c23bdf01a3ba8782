#pragma once
// Records of a plain text file: the lines that hold something, split at blanks, with the place of each for
// error messages.

#include <fstream>
#include <string>
#include <vector>

namespace footfall {

class TextRecords {
 public:
  // comment: everything from this character to the end of the line is skipped. Throws InputError if the file
  // cannot be read.
  TextRecords(const std::string& path, char comment);

  // Goes to the next record; false at the end of the file.
  bool next();
  // The same, but throws InputError at the end of the file, saying what was expected.
  void require_next(const std::string& expected);

  const std::vector<std::string>& words() const { return words_; }
  std::size_t size() const { return words_.size(); }
  // Words as numbers; throw InputError naming the word. integer: within [low, high].
  double number(std::size_t i) const;
  int integer(std::size_t i, int low, int high) const;

  // Throws InputError "path:line: message".
  [[noreturn]] void fail(const std::string& message) const;

 private:
  std::string path_;
  char comment_;
  std::ifstream stream_;
  int line_ = 0;
  std::vector<std::string> words_;
};

}  // namespace footfall
