#include "mbd_solver/run/output/history.h"

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/run/output/checkpoint_folder.h"

namespace footfall {
namespace {

constexpr int kDigits = 10;
constexpr std::chrono::milliseconds kLook(50);  // between two looks at whether the file is still there

const std::string kUnitsMark = "# units: ";

// The number at the start of a cell, and what follows it. from_chars is several times as fast as strtod, which takes what
// it refuses: blanks and signs before a number, and numbers that count as zero.
double number_at(const char* cell, const char* end_of_line, const char*& end) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(cell, end_of_line, value);
  end = stop;
  if (error == std::errc() && (stop == end_of_line || *stop == ',')) return value;
  char* rest = nullptr;
  value = std::strtod(cell, &rest);
  end = rest;
  return value;
}

[[noreturn]] void throw_bad_row(const std::string& path, int number, const std::string& line,
                                const std::vector<std::string>& names, std::size_t column) {
  const std::vector<std::string> cells = split(line, ',');
  const std::string where = path + ":" + std::to_string(number) + ": ";
  if (cells.size() != names.size())
    throw InputError(where + "has " + std::to_string(cells.size()) + " values, expected " +
                     std::to_string(names.size()));
  throw InputError(where + "\"" + names[column] + "\" is \"" + cells[column].substr(0, 40) +
                   "\", expected a finite number");
}

}  // namespace

HistoryWriter::HistoryWriter(const std::string& path, const std::vector<std::string>& names,
                             const std::vector<std::string>& units, Beginning beginning)
    : path_(path), names_(names) {
  FOOTFALL_DEMAND(!names.empty() && names.size() == units.size());
  if (beginning == Beginning::kResume) return;
  file_.open(path);
  if (!file_) throw InputError(path + ": cannot be written; choose another folder with --out");
  write_whole(kUnitsMark + joined(units, ",") + "\n" + joined(names, ",") + "\n");
}

void HistoryWriter::write(const std::vector<double>& row) {
  FOOTFALL_DEMAND(row.size() == names_.size());
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!std::isfinite(row[i])) {
      file_.flush();
      throw NumericalError("at t = " + number_text(row[0]) + " s \"" + names_[i] + "\" is no longer finite; " + path_ +
                           " ends before this row");
    }
    if (i > 0) line += ',';
    append_number(line, row[i], kDigits);
  }
  line += '\n';
  write_whole(line);
}

// In one call of the system: a thousand rows cost as much as a second of a rigid mechanism otherwise.
void HistoryWriter::write_whole(const std::string& text) {
  errno = 0;
  file_.write(text.data(), static_cast<std::streamsize>(text.size()));
  file_.flush();
  std::error_code error;
  const Clock::time_point now = Clock::now();
  if (now - looked_ > kLook) {  // is it still there?
    if (!std::filesystem::exists(path_, error) && !error)
      error = std::make_error_code(std::errc::no_such_file_or_directory);
    looked_ = now;
  }
  if (file_ && !error) {
    whole_ += text.size();
    return;
  }
  const std::string why = error ? error.message() : errno != 0 ? std::strerror(errno) : "is the disk full?";
  file_.close();
  std::filesystem::resize_file(path_, whole_, error);  // half a row is none
  throw InputError(path_ + ": cannot be written: " + why + "; its rows end before this one");
}

void HistoryWriter::flush() {
  looked_ = {};
  write_whole({});
}

long HistoryWriter::position() {
  flush();
  sync_to_disk(path_);
  return static_cast<long>(file_.tellp());
}

void HistoryWriter::go_on_at(long position) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path_, error), at = static_cast<std::uintmax_t>(position);
  if (error || size < at)
    throw InputError(path_ + ": has " + std::to_string(error ? 0 : size) + " bytes, the checkpoint expects at least " +
                     std::to_string(position) + ": was the file changed since?");
  file_.close();
  std::filesystem::resize_file(path_, at, error);
  file_.open(path_, std::ios::in | std::ios::out | std::ios::ate);
  whole_ = at;
  if (error || !file_) throw InputError(path_ + ": cannot be written");
}

int History::find(const std::string& name) const {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<int>(i);
  }
  return -1;
}

const std::vector<double>& History::column(const std::string& name) const {
  const int index = find(name);
  if (index < 0) throw InputError("the history has no column \"" + name + "\"; it has " + joined(names, ","));
  return columns[static_cast<std::size_t>(index)];
}

History read_history(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": cannot be read; expected a history.csv of a run");
  History history;
  std::string line;
  std::getline(file, line);
  if (line.rfind(kUnitsMark, 0) != 0) throw InputError(path + ":1: expected \"" + kUnitsMark + "...\"");
  history.units = split(line.substr(kUnitsMark.size()), ',');
  std::getline(file, line);
  history.names = split(line, ',');
  history.columns.resize(history.names.size());
  if (history.units.size() != history.names.size())
    throw InputError(path + ":2: has " + std::to_string(history.names.size()) + " names for " +
                     std::to_string(history.units.size()) + " units");
  for (int number = 3; std::getline(file, line); ++number) {
    const char *cell = line.c_str(), *const end_of_line = cell + line.size();
    for (std::size_t i = 0; i < history.names.size(); ++i) {
      const char* end = nullptr;
      const double value = number_at(cell, end_of_line, end);
      const bool last = i + 1 == history.names.size();
      if (end == cell || *end != (last ? '\0' : ',') || !std::isfinite(value))
        throw_bad_row(path, number, line, history.names, i);
      history.columns[i].push_back(value);
      cell = end + 1;
    }
  }
  return history;
}

void write_history(const std::string& path, const History& history) {
  HistoryWriter writer(path, history.names, history.units);
  std::vector<double> row(history.names.size());
  for (std::size_t k = 0; k < history.columns.front().size(); ++k) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = history.columns[i][k];
    writer.write(row);
  }
  writer.flush();
}

}  // namespace footfall
