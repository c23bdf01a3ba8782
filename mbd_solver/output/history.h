#pragma once
// history.csv: first line `# units: ...`, second the names, then one row per output time. Never a number that is not finite.

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace footfall {

class HistoryWriter {
 public:
  // Opens (and replaces) the file. Throws InputError when it cannot be written.
  HistoryWriter(const std::string& path, const std::vector<std::string>& names, const std::vector<std::string>& units);
  // Throws NumericalError, naming time and column, for a value that is not finite; the file then ends with the row before.
  void write(const std::vector<double>& row);
  void flush();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::vector<std::string> names_;
  std::unique_ptr<std::FILE, Closer> file_;
};

}  // namespace footfall
