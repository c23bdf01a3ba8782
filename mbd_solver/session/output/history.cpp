// Every row is written and flushed at once, so that readers see whole rows. After an error the file is cut to its last
// whole row.

#include "mbd_solver/session/output/history.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "coupler/base/codes.h"
#include "coupler/base/errors.h"
#include "coupler/base/run_directory.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/output/checkpoint_folder.h"
#include "mbd_solver/session/output/former_names.h"

namespace footfall {
namespace {

constexpr int kDigits = 10;
constexpr std::chrono::milliseconds kCheckInterval(50);  // of the existence of the file

const std::string kUnitsMark = "# units: ";

}  // namespace

HistoryWriter::HistoryWriter(const std::string& path, const std::vector<std::string>& names,
                             const std::vector<std::string>& units, Beginning beginning)
    : path_(path), names_(names) {
  FOOTFALL_DEMAND(!names.empty() && names.size() == units.size());
  if (beginning == Beginning::kResume) return;
  if (!open_file(file_, path, FileStart::kNew))
    throw InputError(code::kFileNotWritten,
                     path + ": cannot be written: " + reason_of(errno) + "; choose another folder with --out");
  write_whole(kUnitsMark + joined(units, ",") + "\n" + joined(names, ",") + "\n");
}

void HistoryWriter::write(const std::vector<double>& row) {
  FOOTFALL_DEMAND(row.size() == names_.size());
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!std::isfinite(row[i])) {
      file_.flush();
      throw NumericalError(code::kOutputNotFinite, "t = " + number_text(row[0]) + " s: \"" + names_[i] +
                                                       "\" is no longer finite; " + path_ + " ends before this row");
    }
    if (i > 0) line += ',';
    append_number(line, row[i], kDigits);
  }
  line += '\n';
  write_whole(line);
}

// One system call: with more, a thousand rows cost as much as a second of a rigid mechanism.
void HistoryWriter::write_whole(const std::string& text) {
  errno = 0;
  file_.write(text.data(), static_cast<std::streamsize>(text.size()));
  file_.flush();
  std::error_code error;
  const Clock::time_point now = Clock::now();
  if (now - looked_ > kCheckInterval) {  // does it still exist?
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
  std::filesystem::resize_file(path_, whole_, error);  // without a partial row
  throw InputError(code::kFileNotWritten, path_ + ": cannot be written: " + why + "; it ends with the last whole row");
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

void HistoryWriter::resume_at(long position) {
  file_.close();
  const int file = GuardedPath(path_).open(O_RDWR);
  const int problem = file < 0 ? errno : 0;
  struct stat status {};
  const long size = file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) ? status.st_size : 0;
  const bool done = file >= 0 && size >= position && ftruncate(file, position) == 0;
  if (file >= 0) close(file);
  if (problem != 0 && problem != ENOENT)
    throw InputError(code::kFileNotWritten, path_ + ": cannot be written: " + reason_of(problem));
  if (size < position)
    throw InputError(code::kHistoryChanged, path_ + ": has " + std::to_string(size) +
                                                " bytes, the checkpoint expects at least " + std::to_string(position) +
                                                ": the file was changed after the checkpoint");
  whole_ = static_cast<std::uintmax_t>(position);
  if (!done || !open_file(file_, path_, FileStart::kEnd))
    throw InputError(code::kFileNotWritten, path_ + ": cannot be written: " + reason_of(errno));
}

int History::find(const std::string& given) const {
  const std::string& name = present_name(given);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<int>(i);
  }
  return -1;
}

const std::vector<double>& History::column(const std::string& name) const {
  const int index = find(name);
  if (index < 0)
    throw InputError(code::kNoSuchColumn, "the history has no column \"" + name + "\"; it has " + joined(names, ","));
  return columns[index];
}

History read_history(const std::string& path) {
  CsvReader csv(path, "the history.csv of a run");
  History history;
  TextReader head = TextReader::if_there(path);
  const std::string units = head.next() ? head.line() : "";
  if (units.rfind(kUnitsMark, 0) != 0)
    throw InputError(code::kHistoryDamaged, path + ":1: expected \"" + kUnitsMark + "...\"");
  history.units = split(units.substr(kUnitsMark.size()), ',');
  if (!csv.next()) throw InputError(code::kHistoryDamaged, path + ": has no column names");
  for (std::size_t i = 0; i < csv.cells().size(); ++i) history.names.push_back(present_name(csv.text(i)));
  if (history.units.size() != history.names.size())
    csv.fail(code::kHistoryDamaged, "has " + std::to_string(history.names.size()) + " names for " +
                                        std::to_string(history.units.size()) + " units");
  history.columns.resize(history.names.size());
  const bool complete = std::filesystem::exists(std::filesystem::path(path).parent_path() / "summary.json");
  while (csv.next()) {
    if (csv.is_unfinished() && !complete) break;  // of a run in progress, or that was killed
    csv.require_width(history.names.size());
    for (std::size_t i = 0; i < history.names.size(); ++i) history.columns[i].push_back(csv.number(i));
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
