#pragma once
// The modelDescription.xml of an FMU, and the lines in which the host of FMUs (mbd_solver/fmi) reports it.

#include <map>
#include <string>
#include <vector>

namespace footfall {

struct FmuVariable {
  // The size of an array in one direction: a number, or the value of a structural parameter.
  struct Dimension {
    long size = 0;
    unsigned parameter = 0;  // its value reference
    bool fixed = true;
  };

  std::string name;
  std::string type;  // "Float64", "Int32", "Boolean", "Enumeration", "String", "Binary", "Clock" ...
  std::string causality, variability;
  std::string unit;
  std::string start;  // one value, or the values of an array with blanks between
  unsigned reference = 0;
  std::vector<Dimension> dimensions;  // none: no array

  // Values of it are numbers.
  bool is_number() const { return type != "String" && type != "Binary" && type != "Clock"; }
};

using FmuStarts = std::map<std::string, std::string>;  // values that replace start values, by variable

struct FmuDescription {
  std::string version;       // "2.0", "3.0"
  std::string model;         // its name
  std::string identifier;    // of its library
  std::string token;         // instantiationToken or guid
  bool keeps_state = false;  // its state can be read and restored as bytes
  std::string obstacle;      // why it cannot run here: "platform ..." or "tool ..."; empty: it can
  std::vector<FmuVariable> variables;

  const FmuVariable* find(const std::string& name) const;  // null: none
  // Rows, columns ... of an array, with these start values; empty: no array.
  std::vector<long> sizes(const FmuVariable& variable, const FmuStarts& starts) const;
  static long count(const std::vector<long>& sizes);
};

// A name that a scene gives: a variable, or an element of an array as "y[2]" or "A[1,2]", counted from 1.
struct FmuElement {
  const FmuVariable* variable = nullptr;  // null: unknown
  long place = 0;                         // in the array, row by row
  std::string problem;                    // the fault of the indices; empty: none
};
FmuElement find_element(const FmuDescription& description, const std::string& name, const FmuStarts& starts);

std::string text_of(const FmuDescription& description);
FmuDescription fmu_description_of(const std::string& text);

// The program that reads and runs FMUs: in the folder of this program, or in PATH; empty: not built.
std::string fmu_host();

}  // namespace footfall
