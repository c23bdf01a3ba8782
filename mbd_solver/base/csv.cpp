// Text tables line by line, without copies of the cells but of lines with quotes. Numbers by from_chars, and by strtod beyond the range of double.

#include "mbd_solver/base/csv.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include "coupler/base/input_file.h"
#include "coupler/base/number.h"
#include "mbd_solver/base/budget.h"

namespace footfall {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed_view(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == std::string_view::npos ? text.substr(0, 0)
                                         : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

bool read_number(std::string_view text, double& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) value = read_number(std::string(text).c_str(), nullptr);
  return error != std::errc::invalid_argument && end == text.data() + text.size();
}

CsvReader::CsvReader(const std::string& path, const std::string& expected, Separators separators)
    : path_(path), separators_(separators) {
  require_regular_file(path);
  file_.open(path);
  if (!file_) throw InputError(code::kTableNotReadable, path + ": cannot be read; expected " + expected);
}

bool CsvReader::next() {
  while (read_line(file_, content_, path_)) {
    if (++line_ == 1 && content_.rfind("\xEF\xBB\xBF", 0) == 0)
      content_.erase(0, 3);  // byte order mark of spreadsheets
    if (content_.find('"') != std::string::npos) {
      if (split_quoted()) return true;
      continue;
    }
    const std::string_view row = trimmed_view(std::string_view(content_).substr(0, content_.find('#')));
    if (row.empty()) continue;
    cells_.clear();
    const bool any = separators_ == Separators::kAny;
    const std::string_view marks = any ? ",; \t\r" : ",";
    for (std::size_t begin = 0; begin <= row.size();) {
      const std::size_t end = std::min(row.find_first_of(marks, begin), row.size());
      if (!any || end > begin) cells_.push_back(trimmed_view(row.substr(begin, end - begin)));
      begin = end + 1;
    }
    if (!cells_.empty()) return true;
  }
  return false;
}

bool CsvReader::split_quoted() {
  const bool any = separators_ == Separators::kAny;
  const std::string_view separators = any ? ",; \t\r" : ",";
  const int first = line_;
  std::string cell;
  bool quoted = false, closed = false,
       empty = true;  // closed: after the second quote; empty: the line has no cells so far
  const auto end_cell = [&] {
    if (!closed) cell = std::string(trimmed_view(cell));
    if (!any || closed || !cell.empty()) unquoted_.push_back(cell);
    cell.clear();
    closed = false;
  };
  unquoted_.clear();
  ReadBudget bytes(limit::kLine, path_ + ":" + std::to_string(first));
  bytes.take(content_.size());
  for (std::size_t at = 0; at < content_.size() || quoted; ++at) {
    if (at == content_.size()) {
      std::string more;
      if (!read_line(file_, more, path_)) {
        line_ = first;
        fail(code::kTableCell, "a cell begins with a quote and never ends, expected another quote");
      }
      ++line_;
      bytes.take(more.size() + 1);
      content_ += '\n' + more;
    }
    const char c = content_[at];
    const bool blank = kBlanks.find(c) != std::string_view::npos;
    if (quoted && c == '"' && content_.compare(at, 2, "\"\"") != 0) {
      quoted = false, closed = true;
    } else if (quoted) {
      cell += c;
      if (c == '"') ++at;
    } else if (c == '#') {
      break;
    } else if (separators.find(c) != std::string_view::npos) {
      end_cell();
      empty = empty && blank;
    } else if (c == '"' && !closed && trimmed_view(cell).empty()) {
      cell.clear();
      quoted = true, empty = false;
    } else if (!closed) {
      cell += c;
      empty = empty && blank;
    } else if (!blank) {
      fail(code::kTableCell, "has text after a cell in quotes, expected a separator");
    }
  }
  end_cell();
  cells_.assign(unquoted_.begin(), unquoted_.end());
  return !empty && !cells_.empty();
}

double CsvReader::number(std::size_t column) const {
  double value = 0.0;
  if (read_number(cells_.at(column), value) && std::isfinite(value)) return value;
  fail(code::kTableCell, "\"" + text(column).substr(0, 40) + "\", expected a finite number such as -12.5 or 3e4");
}

void CsvReader::require_width(std::size_t cells) const {
  if (cells_.size() != cells)
    fail(code::kTableWidth, "has " + std::to_string(cells_.size()) + " cells, expected " + std::to_string(cells));
}

std::string CsvReader::place() const { return path_ + ":" + std::to_string(line_) + ": "; }

void CsvReader::fail(const MessageCode& code, const std::string& what) const { throw InputError(code, place() + what); }

}  // namespace footfall
