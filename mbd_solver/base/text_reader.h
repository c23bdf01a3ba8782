#pragma once
// Text files that users and other programs write, line by line: only regular files, lines of at most limit::kLine, fields,
// numbers, and the place of a fault. A byte order mark at the start is left out.
//
//   TextReader text(path, code::kTableCell, "a list of masses");
//   while (text.next()) use(text.number(text.fields(Separators::kComma).front()));

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "coupler/base/input_file.h"
#include "mbd_solver/base/codes.h"

namespace footfall {

enum class Separators {
  kComma,   // cells between commas, which may be empty
  kBlanks,  // words
  kAny      // words between commas, semicolons or blanks, any number of them
};

inline bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
std::string_view without_blanks(std::string_view text);  // at both ends
std::string in_quotes(std::string_view text);            // for messages, its first 40 characters
// The fields of a line, without blanks around them, as views of it.
void split_fields(std::string_view line, Separators separators, std::vector<std::string_view>& fields);
std::vector<std::string> blank_words(std::string_view line);

// The next word between blanks from `at` on, which goes behind it; empty at the end of the text.
std::string_view next_word(std::string_view text, std::size_t& at);

// Read the text as one number; false unless the whole text is a number. inf and nan count as numbers.
bool read_number(std::string_view text, double& value);
bool read_whole(std::string_view text, long& value);

class TextReader {
 public:
  enum class Ends { kAny, kNewline };  // lines end in CR, LF or both; in LF alone, as LIGGGHTS reads its scripts

  // Throws InputError "PATH: cannot be read; expected EXPECTED". `code`: for this and for errors of `number`, `whole`, `fail`.
  TextReader(const std::string& path, const MessageCode& code, const std::string& expected,
             std::uint64_t largest = kLargestFile, Ends ends = Ends::kAny);
  // A text that has been read; `name` replaces the path in messages.
  TextReader(std::string text, std::string name, const MessageCode& code);
  // Without lines if there is no regular file; see opened().
  static TextReader if_there(const std::string& path, Ends ends = Ends::kAny);
  // The last line with text among the last few thousand bytes of a file, without blanks at its ends; "" if there is none.
  static std::string last_line_of(const std::string& path);

  bool opened() const { return file_.is_open(); }

  // Goes to the next line; false at the end. Throws InputError where a line is too long.
  bool next();
  // Stays before the line just read.
  void back() { again_ = true; }
  const std::string& line() const { return line_; }        // without its end
  const char* ending() const { return ending_; }           // "\n", "\r", "\r\n"; "" at the end of the file
  int number_of_line() const { return number_ - again_; }  // counted from 1
  // The size of a text that has been read, and the position of its next line [bytes].
  std::size_t bytes() const { return buffer_.size(); }
  std::size_t position() const { return at_; }

  // Views are valid until the next line. All fields of a line; no word of it is left.
  const std::vector<std::string_view>& fields(Separators separators);
  // The next word between blanks: in this line, or also in later ones; false at their end.
  bool word_in_line(std::string_view& word);
  bool next_word(std::string_view& word);

  // Throw InputError naming the field: a finite number; a whole one within [low, high].
  double number(std::string_view field) const { return number(field, code_); }
  double number(std::string_view field, const MessageCode& code) const;
  long whole(std::string_view field, long low, long high) const;

  const std::string& name() const { return name_; }
  std::string place() const { return name_ + ":" + std::to_string(number_of_line()); }  // "file:12"
  // Throw InputError "file:12: WHAT".
  template <class... Pieces>
  [[noreturn]] void fail(const Pieces&... what) const {
    fail(code_, what...);
  }
  template <class... Pieces>
  [[noreturn]] void fail(const MessageCode& code, const Pieces&... what) const {
    throw InputError(code, place(), ": ", what...);
  }

 private:
  TextReader() = default;
  bool read_on();

  std::string name_, line_;
  MessageCode code_ = code::kTableCell;
  Ends ends_ = Ends::kAny;
  std::ifstream file_;
  std::string buffer_;       // of the file, or the whole text
  std::size_t at_ = 0;       // of the next line in buffer_
  std::size_t newline_ = 0;  // the first LF from at_ on, once a line was read; the size of buffer_: none
  std::size_t word_at_ = 0;  // in line_, behind the words that were taken
  const char* ending_ = "";
  int number_ = 0;
  bool again_ = false;
  std::vector<std::string_view> fields_;
};

}  // namespace footfall
