// Text with one value per line; numbers as %a, which restores every bit.

#include "coupler/archive.h"

#include <cstdlib>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/codes.h"

namespace footfall {
namespace {

// A text as one line, and back.
std::string in_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) line += c == '\n' ? "\\n" : c == '\\' ? "\\\\" : std::string(1, c);
  return line;
}

std::string of_one_line(const std::string& line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool escaped = line[i] == '\\' && i + 1 < line.size();
    if (escaped) ++i;
    text += escaped && line[i] == 'n' ? '\n' : line[i];
  }
  return text;
}

}  // namespace

Archive::Archive(std::string file, std::string text)
    : restores_(true), file_(std::move(file)), text_(std::move(text)) {}

void Archive::fail(const std::string& what) const {
  throw InputError(code::kCheckpointDamaged,
                   file_ + ":" + std::to_string(line_) + ": " + what +
                       ": the checkpoint is damaged, or belongs to another scene or another version of footfall");
}

void Archive::finish() const {
  if (restores_ && next_ < text_.size()) fail("expected the end of the file");
}

void Archive::begin(std::string_view name) {
  const std::string full = path_ + std::string(name);
  if (!restores_) {
    text_ += full;
    return;
  }
  const std::size_t end = text_.find_first_of(" \n", next_);
  const std::string found = text_.substr(next_, end == std::string::npos ? end : end - next_);
  if (found != full) fail("expected \"" + full + "\", found \"" + found + "\"");
  next_ += found.size();
}

std::string Archive::word() {
  if (next_ >= text_.size() || text_[next_] != ' ') fail("a value is missing");
  const std::size_t begin = next_ + 1, end = text_.find_first_of(" \n", begin);
  next_ = end == std::string::npos ? text_.size() : end;
  return text_.substr(begin, next_ - begin);
}

void Archive::end() {
  if (!restores_) {
    text_ += '\n';
    return;
  }
  if (next_ >= text_.size() || text_[next_] != '\n') fail("the line has another length than expected");
  ++next_;
  ++line_;
}

void Archive::operator()(std::string_view name, bool& value) {
  long number = value ? 1 : 0;
  (*this)(name, number);
  value = number != 0;
}

void Archive::operator()(std::string_view name, int& value) {
  long number = value;
  (*this)(name, number);
  value = static_cast<int>(number);
}

void Archive::operator()(std::string_view name, long& value) {
  begin(name);
  if (restores_) {
    const std::string text = word();
    char* rest = nullptr;
    value = std::strtol(text.c_str(), &rest, 10);
    if (text.empty() || *rest != '\0') fail("\"" + text + "\" is not a whole number");
  } else {
    text_ += " " + std::to_string(value);
  }
  end();
}

void Archive::operator()(std::string_view name, double& value) {
  begin(name);
  numbers(&value, 1);
}

void Archive::operator()(std::string_view name, std::string& value) {
  begin(name);
  if (restores_) {
    if (next_ >= text_.size() || text_[next_] != ' ') fail("a text is missing");
    const std::size_t begin = next_ + 1, end = text_.find('\n', begin);
    next_ = end == std::string::npos ? text_.size() : end;
    value = of_one_line(text_.substr(begin, next_ - begin));
  } else {
    text_ += " " + in_one_line(value);
  }
  end();
}

void Archive::operator()(std::string_view name, std::vector<bool>& value) {
  std::string marks;
  for (const bool mark : value) marks += mark ? '1' : '0';
  (*this)(name, marks);
  if (!restores_) return;
  checked_count(static_cast<long>(marks.size()), value.size());
  value.clear();
  for (const char mark : marks) value.push_back(mark == '1');
}

void Archive::shape(std::string_view name, Eigen::Index& rows, Eigen::Index& cols, std::array<int, 2> fixed) {
  begin(name);
  if (!restores_) {
    text_ += " " + std::to_string(rows) + " " + std::to_string(cols);
    return;
  }
  const std::array<Eigen::Index, 2> before = {rows, cols};
  rows = std::strtol(word().c_str(), nullptr, 10);
  cols = std::strtol(word().c_str(), nullptr, 10);
  const auto most = static_cast<Eigen::Index>(text_.size());
  const auto fits = [](Eigen::Index found, int type) { return type == Eigen::Dynamic || found == type; };
  if (rows < 0 || cols < 0 || rows > most || cols > most || rows * cols > most || !fits(rows, fixed[0]) ||
      !fits(cols, fixed[1]) || (before[0] * before[1] > 0 && (rows != before[0] || cols != before[1])))
    fail("has " + std::to_string(rows) + " x " + std::to_string(cols) + " numbers, expected " +
         std::to_string(before[0]) + " x " + std::to_string(before[1]));
}

void Archive::numbers(double* values, Eigen::Index count) {
  for (Eigen::Index i = 0; i < count; ++i) {
    if (!restores_) {
      text_ += " " + hexadecimal(values[i]);
      continue;
    }
    const std::string text = word();
    char* rest = nullptr;
    values[i] = read_number(text.c_str(), &rest);
    if (text.empty() || *rest != '\0') fail("\"" + text + "\" is not a number");
  }
  end();
}

long Archive::checked_count(long count, std::size_t present) const {
  if (count < 0 || count > static_cast<long>(text_.size()) || (present > 0 && count != static_cast<long>(present)))
    fail("has " + std::to_string(count) + " items, expected " + std::to_string(present));
  return count;
}

}  // namespace footfall
