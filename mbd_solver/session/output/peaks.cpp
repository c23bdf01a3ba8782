// A row per column: name, unit, least value and its time, largest value and its time.
#include "mbd_solver/session/output/peaks.h"

#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/csv.h"

namespace footfall {
namespace {

constexpr int kPeakDigits = 10;
constexpr std::size_t kWidth = 6;

}  // namespace

void ColumnPeaks::visit(Archive& archive) {
  archive.members<&ColumnPeaks::least, &ColumnPeaks::least_time, &ColumnPeaks::largest, &ColumnPeaks::largest_time>(
      *this);
}

Peaks::Peaks(const std::vector<std::string>& names, const std::vector<std::string>& units) {
  FOOTFALL_DEMAND(!names.empty() && names.size() == units.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    columns_.emplace_back();
    columns_.back().name = names[i];
    columns_.back().unit = units[i];
  }
}

void Peaks::see(const std::vector<double>& row) {
  const double time = row[0];
  for (std::size_t i = 0; i < row.size(); ++i) {
    ColumnPeaks& column = columns_[i];
    if (empty_ || row[i] < column.least) {
      column.least = row[i];
      column.least_time = time;
    }
    if (empty_ || row[i] > column.largest) {
      column.largest = row[i];
      column.largest_time = time;
    }
  }
  empty_ = false;
}

void Peaks::write(const std::string& path) const {
  std::string text = "column,unit,least,at_time,largest,at_time\n";
  for (const ColumnPeaks& column : columns_) {
    text += column.name + "," + column.unit;
    for (const double number : {column.least, column.least_time, column.largest, column.largest_time}) {
      text += ',';
      append_number(text, number, kPeakDigits);
    }
    text += '\n';
  }
  write_whole_file(path, text);
}

void Peaks::visit(Archive& archive) {
  archive("columns", columns_);
  archive("empty", empty_);
}

std::vector<ColumnPeaks> read_peaks(const std::string& path) {
  std::vector<ColumnPeaks> peaks;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return peaks;
  CsvReader csv(path, "the peaks.csv of a run");
  csv.next();  // the names
  while (csv.next()) {
    csv.require_width(kWidth);
    peaks.push_back({csv.text(0), csv.text(1), csv.number(2), csv.number(3), csv.number(4), csv.number(5)});
  }
  return peaks;
}

}  // namespace footfall
