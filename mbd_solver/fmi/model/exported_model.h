#pragma once
// The variables of an exported FMU: resources/variables.txt, which the command writes, and which the library of the FMU
// and the program of the model read.
//
// The library starts the program and sends it requests (base/helper_process.h). A request is a letter and its content:
//   N  text: a line per setting "KEY=VALUE"    makes the simulation                                         answer V
//   S  until, early, inputs...                 to this time [s]; early: may end at an event before          answer V
//   G                                          its state                                                    answer B
//   R  bytes of G                              makes the simulation of that state                           answer V
// and an answer: V time, ended early, finished, outputs..., then warnings as text; B bytes; E text: an error, the state is as before.

#include <string>
#include <vector>

namespace footfall {

struct ExportedVariable {
  enum class Kind { kTime, kInput, kOutput, kParameter };
  Kind kind = Kind::kOutput;
  unsigned reference = 0;     // place of its first number in the list of all numbers
  std::string name;           // signal, column, or key of --set
  std::string unit;           // empty: none
  std::vector<double> start;  // one number, or the numbers of a list
};

inline const std::string kBalanceColumn = "balance.energy", kErrorColumn = "balance.integration";

std::string text_of_variables(const std::vector<ExportedVariable>& variables);
std::vector<ExportedVariable> variables_of_text(const std::string& text);

}  // namespace footfall
