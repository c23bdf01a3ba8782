// Views of the line, but of a line with quotes copies of its cells.

#include "mbd_solver/base/csv.h"

#include "mbd_solver/base/budget.h"

namespace footfall {

CsvReader::CsvReader(const std::string& path, const std::string& expected, Separators separators)
    : text_(path, code::kTableNotReadable, expected), separators_(separators) {}

bool CsvReader::next() {
  while (text_.next()) {
    const std::string_view line = text_.line();
    if (line.find('"') != std::string_view::npos) {
      if (split_quoted()) return true;
      continue;
    }
    split_fields(line.substr(0, line.find('#')), separators_, cells_);
    if (!cells_.empty()) return true;
  }
  return false;
}

bool CsvReader::split_quoted() {
  const bool any = separators_ == Separators::kAny;
  const auto separates = [&](char c) { return c == ',' || (any && (c == ';' || is_blank(c))); };
  const std::string where = text_.place();
  std::string content = text_.line(), cell;
  bool quoted = false, closed = false,
       empty = true;  // closed: after the second quote; empty: the line has no cells so far
  const auto end_cell = [&] {
    if (!closed) cell = std::string(without_blanks(cell));
    if (!any || closed || !cell.empty()) unquoted_.push_back(cell);
    cell.clear();
    closed = false;
  };
  unquoted_.clear();
  ReadBudget bytes(limit::kLine, where);
  bytes.take(content.size());
  for (std::size_t at = 0; at < content.size() || quoted; ++at) {
    if (at == content.size()) {
      content += text_.ending();
      if (!text_.next())
        throw InputError(code::kTableCell, where,
                         ": a cell begins with a quote and never ends, expected another quote");
      bytes.take(text_.line().size() + 1);
      content += text_.line();
    }
    const char c = content[at];
    const bool blank = is_blank(c);
    if (quoted && c == '"' && content.compare(at, 2, "\"\"") != 0) {
      quoted = false, closed = true;
    } else if (quoted) {
      cell += c;
      if (c == '"') ++at;
    } else if (c == '#') {
      break;
    } else if (separates(c)) {
      end_cell();
      empty = empty && blank;
    } else if (c == '"' && !closed && without_blanks(cell).empty()) {
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

double CsvReader::number(std::size_t column) const { return text_.number(cells_.at(column), code::kTableCell); }

void CsvReader::require_width(std::size_t cells) const {
  if (cells_.size() != cells) fail(code::kTableWidth, "has ", cells_.size(), " cells, expected ", cells);
}

}  // namespace footfall
