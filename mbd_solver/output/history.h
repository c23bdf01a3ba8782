#pragma once
// history.csv: one row of numbers per output time. First line "# units: s,m,...", second the column names, then the
// rows.

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace footfall {

class HistoryWriter {
 public:
  // One unit per name; the first column is time. Makes a new file. Throws InputError when it cannot be written.
  HistoryWriter(const std::string& path, const std::vector<std::string>& names, const std::vector<std::string>& units);

  // One row, in the order of the names. Throws NumericalError, naming the column and time, when a value is not finite:
  // a file never holds one. Throws as flush.
  void write(const std::vector<double>& row);
  // Everything written so far is in the file; each row is when `write` returns. Throws InputError when it cannot be
  // written (full disk, folder gone); the file then ends with the last whole row.
  void flush();

 private:
  std::string path_;
  std::vector<std::string> names_;
  std::ofstream file_;
  std::uintmax_t whole_ = 0;  // size of the whole rows [bytes]
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
