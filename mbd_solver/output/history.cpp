#include "mbd_solver/output/history.h"

#include <cerrno>
#include <cmath>
#include <cstring>

#include "coupler/errors.h"

namespace footfall {
namespace {

void write_names(std::FILE* file, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) std::fprintf(file, "%s%s", i == 0 ? "" : ",", names[i].c_str());
  std::fprintf(file, "\n");
}

}  // namespace

HistoryWriter::HistoryWriter(const std::string& path, const std::vector<std::string>& names, const std::vector<std::string>& units)
    : path_(path), names_(names), file_(std::fopen(path.c_str(), "w")) {
  FOOTFALL_DEMAND(names.size() == units.size());
  if (!file_) throw InputError(path + ": cannot be written: " + std::strerror(errno) + "; choose another folder with --out");
  std::fprintf(file_.get(), "# units: ");
  write_names(file_.get(), units);
  write_names(file_.get(), names);
}

void HistoryWriter::write(const std::vector<double>& row) {
  FOOTFALL_DEMAND(row.size() == names_.size());
  for (std::size_t i = 0; i < row.size(); ++i)
    if (!std::isfinite(row[i]))
      throw NumericalError("t = " + std::to_string(row[0]) + " s: " + names_[i] + " is not finite; " + path_ + " ends before it");
  for (std::size_t i = 0; i < row.size(); ++i) std::fprintf(file_.get(), i == 0 ? "%.12g" : ",%.12g", row[i]);
  std::fprintf(file_.get(), "\n");
  if (std::ferror(file_.get()) != 0) throw NumericalError(path_ + ": writing failed: " + std::strerror(errno));
}

void HistoryWriter::flush() { std::fflush(file_.get()); }

}  // namespace footfall
