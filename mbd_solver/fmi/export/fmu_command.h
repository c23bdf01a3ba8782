#pragma once
// footfall fmu: a scene as an FMU for co-simulation (FMI 3.0), for use in other programs.

#include <map>
#include <string>
#include <vector>

#include "mbd_solver/fmi/model/exported_model.h"

namespace footfall {

struct FmuArguments {
  std::string scene, out;
  std::vector<std::string> settings;  // --set key=value
  bool trust_script = false, quiet = false;
};

// Writes the FMU. Returns the exit code; throws InputError, NumericalError.
int fmu_command(const FmuArguments& arguments);

// ---- its parts ----

// Exponents of kg, m, s, A and rad of a unit such as "N m s/rad"; empty where one of its words is unknown.
std::map<std::string, int> base_units(const std::string& unit);

struct ExportedScene {
  std::string name, title, token;
  double end_time = 0.0, step = 0.0;  // [s]
  bool has_state = true;              // which can be read, set and stored
  std::vector<ExportedVariable> variables;
};
std::string model_description(const ExportedScene& scene);

}  // namespace footfall
