#include "mbd_solver/cli/experiments/table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "coupler/base/text.h"

namespace footfall {

namespace {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string(2, '"') : std::string(1, c);
  return field + '"';
}

}  // namespace

int Table::column(const std::string& name) const {
  const auto found = std::find(rows_.front().begin(), rows_.front().end(), name);
  return found == rows_.front().end() ? 0 : static_cast<int>(found - rows_.front().begin()) + 1;
}

std::string Table::csv() const {
  std::string text;
  for (std::vector<std::string> row : rows_) {
    for (std::string& field : row) field = csv_field(field);
    text += joined(row, ",") + "\n";
  }
  return text;
}

std::string Table::page() const {
  std::string text;
  for (const std::vector<std::string>& row : rows_) {
    text += "| " + joined(row, " | ") + " |\n";
    if (&row == &rows_.front()) text += "|" + joined(std::vector<std::string>(row.size(), "---"), "|") + "|\n";
  }
  return text;
}

void append(std::vector<std::string>& row, const std::vector<std::string>& more) {
  row.insert(row.end(), more.begin(), more.end());
}

std::string cell(double value, int digits) { return std::isfinite(value) ? number_text(value, digits) : ""; }

std::string rounded(double value) { return cell(std::abs(value) < 1e-9 ? 0.0 : value, 3); }

std::string percent(double share) { return number_text(100.0 * share, 2); }

std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

}  // namespace footfall
