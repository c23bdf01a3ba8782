#pragma once
// history.csv: one row of numbers per output time. The first line is "# units: s,m,...", the second the column names.

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

namespace footfall {

enum class Beginning {
  kNew,    // a new file
  kResume  // the file of an earlier part of the run, which resume_at() cuts
};

class HistoryWriter {
 public:
  // One unit per name; the first column is time. Throws InputError when the file cannot be written.
  HistoryWriter(const std::string& path, const std::vector<std::string>& names, const std::vector<std::string>& units,
                Beginning beginning = Beginning::kNew);

  // One row, in the order of the names. The row is in the file when this returns. Throws NumericalError, naming column
  // and time, when a value is not finite (a file never contains one), and InputError when the file cannot be written
  // (full disk, folder gone); the file then ends with the last whole row.
  void write(const std::vector<double>& row);
  // Checks that everything written so far is in the file, and that the file still exists. Throws as write().
  void flush();
  // Bytes so far, all synced to the disk: where a resumed run continues. Throws as write().
  long position();
  // Drops what was written after this position. Throws InputError when the file is shorter.
  void resume_at(long position);

 private:
  using Clock = std::chrono::steady_clock;
  void write_whole(const std::string& text);

  std::string path_;
  std::vector<std::string> names_;
  std::ofstream file_;
  std::uintmax_t whole_ = 0;  // size of the whole rows [bytes]
  Clock::time_point looked_;  // last check that the file exists
};

// A history read from a file.
struct History {
  std::vector<std::string> names, units;
  std::vector<std::vector<double>> columns;  // one per name, all of the same length

  int find(const std::string& name) const;                           // index, or -1
  const std::vector<double>& column(const std::string& name) const;  // throws InputError
};
// Throws InputError "file:line: ...".
History read_history(const std::string& path);
// Throws as HistoryWriter.
void write_history(const std::string& path, const History& history);

}  // namespace footfall
