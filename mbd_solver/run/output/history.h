#pragma once
// history.csv: one row of numbers per output time. First line "# units: s,m,...", second the column names, then the
// rows.

#include <chrono>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace footfall {

enum class Beginning {
  kNew,    // a new file
  kResume  // the file that a run has left, which go_on_at() then cuts
};

class HistoryWriter {
 public:
  // One unit per name; the first column is time. Throws InputError when the file cannot be written.
  HistoryWriter(const std::string& path, const std::vector<std::string>& names, const std::vector<std::string>& units,
                Beginning beginning = Beginning::kNew);

  // One row, in the order of the names. Throws NumericalError, naming the column and time, when a value is not finite:
  // a file never holds one. The row is in the file when this returns. Throws InputError when it cannot be written (full
  // disk, folder gone); the file then ends with the last whole row.
  void write(const std::vector<double>& row);
  // Everything written so far is in the file, and the file is still there. Throws as write().
  void flush();
  // Bytes so far, all of them on the disk itself: a run that is resumed goes on there. Throws as write().
  long position();
  // What a later part of the run wrote behind this position is dropped. Throws InputError when the file is shorter.
  void go_on_at(long position);

 private:
  using Clock = std::chrono::steady_clock;
  void write_whole(const std::string& text);

  std::string path_;
  std::vector<std::string> names_;
  std::ofstream file_;
  std::uintmax_t whole_ = 0;  // size of the whole rows [bytes]
  Clock::time_point looked_;  // when the file was last seen
};

// A history read back: for plots, reports and tests.
struct History {
  std::vector<std::string> names, units;
  std::vector<std::vector<double>> columns;  // one per name, all of the same length

  int find(const std::string& name) const;                           // index, or -1
  const std::vector<double>& column(const std::string& name) const;  // throws InputError with a list of the known names
};
// Throws InputError "file:line: ...".
History read_history(const std::string& path);
// All of it at once; throws as HistoryWriter.
void write_history(const std::string& path, const History& history);

}  // namespace footfall
