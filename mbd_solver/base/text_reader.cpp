// A buffer moves over the file and grows to the length of a line; a text that has been read is a buffer without a file. Numbers by
// from_chars, and by strtod beyond the range of double.

#include "mbd_solver/base/text_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

#include "coupler/base/number.h"
#include "mbd_solver/base/budget.h"

namespace footfall {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;  // of a file that is read at once [bytes]
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// The next piece of `text` from `at` on without separators; empty at its end. `at` goes behind it.
template <class IsSeparator>
std::string_view next_piece(std::string_view text, std::size_t& at, const IsSeparator& is_separator) {
  while (at < text.size() && is_separator(text[at])) ++at;
  const std::size_t from = at;
  while (at < text.size() && !is_separator(text[at])) ++at;
  return text.substr(from, at - from);
}

// from_chars takes no sign of positive numbers.
std::string_view without_plus(std::string_view number) {
  return number.size() > 1 && number[0] == '+' && number[1] != '-' ? number.substr(1) : number;
}

std::size_t found_or_end(const std::string& text, char c, std::size_t from) {
  return std::min(text.find(c, from), text.size());
}

}  // namespace

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string in_quotes(std::string_view text) { return "\"" + std::string(text.substr(0, 40)) + "\""; }

void split_fields(std::string_view line, Separators separators, std::vector<std::string_view>& fields) {
  fields.clear();
  const auto cut = [&](const auto& is_separator) {
    std::size_t at = 0;
    for (std::string_view word; !(word = next_piece(line, at, is_separator)).empty();) fields.push_back(word);
  };
  if (separators == Separators::kBlanks) return cut(is_blank);
  if (separators == Separators::kAny) return cut([](char c) { return is_blank(c) || c == ',' || c == ';'; });
  if (without_blanks(line).empty()) return;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t end = std::min(line.find(',', from), line.size());
    fields.push_back(without_blanks(line.substr(from, end - from)));
    from = end + 1;
  }
}

std::string_view next_word(std::string_view text, std::size_t& at) { return next_piece(text, at, is_blank); }

std::vector<std::string> blank_words(std::string_view line) {
  std::vector<std::string_view> words;
  split_fields(line, Separators::kBlanks, words);
  return {words.begin(), words.end()};
}

bool read_number(std::string_view text, double& value) {
  text = without_plus(text);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) value = read_number(std::string(text).c_str(), nullptr);
  return error != std::errc::invalid_argument && end == text.data() + text.size();
}

bool read_whole(std::string_view text, long& value) {
  text = without_plus(text);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

TextReader::TextReader(const std::string& path, const MessageCode& code, const std::string& expected,
                       std::uint64_t largest, Ends ends)
    : name_(path), code_(code), ends_(ends) {
  require_regular_file(path, largest);
  file_.open(path, std::ios::binary);
  if (!file_) throw InputError(code, path + ": cannot be read; expected " + expected);
}

TextReader::TextReader(std::string text, std::string name, const MessageCode& code)
    : name_(std::move(name)), code_(code), buffer_(std::move(text)) {
  newline_ = found_or_end(buffer_, '\n', 0);
}

TextReader TextReader::if_there(const std::string& path, Ends ends) {
  TextReader reader;
  reader.name_ = path;
  reader.ends_ = ends;
  std::error_code none;
  if (std::filesystem::is_regular_file(path, none)) reader.file_.open(path, std::ios::binary);
  return reader;
}

std::string TextReader::last_line_of(const std::string& path) {
  constexpr std::streamoff kTail = 4096;
  TextReader tail = if_there(path);
  tail.file_.seekg(0, std::ios::end);
  tail.file_.seekg(std::max<std::streamoff>(0, tail.file_.tellg() - kTail));
  std::string last;
  while (tail.next())
    if (const std::string_view text = without_blanks(tail.line_); !text.empty()) last = text;
  return last;
}

// False at the end of the file.
bool TextReader::read_on() {
  if (!file_.is_open()) return false;
  buffer_.erase(0, at_);
  at_ = 0;
  const std::size_t held = buffer_.size();
  buffer_.resize(held + std::max(kPiece, held));
  file_.read(&buffer_[held], static_cast<std::streamsize>(buffer_.size() - held));
  buffer_.resize(held + static_cast<std::size_t>(file_.gcount()));
  newline_ = found_or_end(buffer_, '\n', 0);
  return buffer_.size() > held;
}

bool TextReader::next() {
  word_at_ = 0;
  if (std::exchange(again_, false)) return true;
  std::size_t length = 0;
  do {  // until the character behind the end of the line is known: CR may be one half of CR LF
    if (newline_ < at_) newline_ = found_or_end(buffer_, '\n', at_);
    length = newline_ - at_;
    if (ends_ == Ends::kAny) length = std::min(std::string_view(buffer_).substr(at_, length).find('\r'), length);
    if (length > limit::kLine.most) ReadBudget(limit::kLine, name_).take(length);
  } while (at_ + length + 1 >= buffer_.size() && read_on());
  if (at_ == buffer_.size()) {
    word_at_ = line_.size();
    return false;
  }
  line_.assign(buffer_, at_, length);
  at_ += length;
  const bool both = at_ + 1 < buffer_.size() && buffer_[at_] == '\r' && buffer_[at_ + 1] == '\n';
  ending_ = at_ == buffer_.size() ? "" : both ? "\r\n" : buffer_[at_] == '\n' ? "\n" : "\r";
  at_ += std::char_traits<char>::length(ending_);
  if (++number_ == 1 && line_.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0)
    line_.erase(0, kByteOrderMark.size());
  return true;
}

const std::vector<std::string_view>& TextReader::fields(Separators separators) {
  split_fields(line_, separators, fields_);
  word_at_ = line_.size();
  return fields_;
}

bool TextReader::word_in_line(std::string_view& word) {
  word = footfall::next_word(line_, word_at_);
  return !word.empty();
}

bool TextReader::next_word(std::string_view& word) {
  while (!word_in_line(word))
    if (!next()) return false;
  return true;
}

double TextReader::number(std::string_view field, const MessageCode& code) const {
  double value = 0.0;
  if (read_number(field, value) && std::isfinite(value)) return value;
  fail(code, in_quotes(field) + ", expected a finite number such as -12.5 or 3e4");
}

long TextReader::whole(std::string_view field, long low, long high) const {
  long value = 0;
  if (read_whole(field, value) && value >= low && value <= high) return value;
  fail(in_quotes(field) + ", expected a whole number from " + std::to_string(low) + " to " + std::to_string(high));
}

}  // namespace footfall
