#pragma once
// An FMU as a file: a zip archive with modelDescription.xml, libraries per platform and resources.

#include <stdexcept>
#include <string>
#include <vector>

#include "mbd_solver/base/fmu_description.h"

namespace footfall {

// A file that is no usable FMU. kind: "file", "version", "platform", "tool" or "limit" (base/budget.h).
struct FmuProblem : std::runtime_error {
  FmuProblem(std::string of_kind, const std::string& text) : std::runtime_error(text), kind(std::move(of_kind)) {}
  std::string kind;
};

// Reads modelDescription.xml alone. Throws FmuProblem.
FmuDescription read_fmu(const std::string& file);
// From the text of a modelDescription.xml. Throws FmuProblem.
FmuDescription parse_model_description(const std::string& xml);

// Writes all files of the archive into a folder that exists. Throws FmuProblem.
void unpack_fmu(const std::string& file, const std::string& folder);
// Writes an archive. Throws FmuProblem.
struct FmuEntry {
  std::string name;  // within the archive
  std::string file;  // whose bytes it has; empty: the text
  std::string text;
  bool program = false;  // may be executed
};
void write_fmu(const std::string& file, const std::vector<FmuEntry>& entries);
// The path of the library for this machine, within the FMU.
std::string library_path(const FmuDescription& description);

}  // namespace footfall
