#pragma once
// footfall rig NAME: an experiment of inputs/rigs, and what it makes of the soil.

#include <string>
#include <vector>

namespace footfall {

struct RigArguments {
  std::string name, file, out, gravity;  // file empty: inputs/rigs/NAME.toml; gravity empty: the scene's
  std::vector<std::string> settings;     // of every run, before what the rig varies
  int samples = 0;                       // of the bed; 0: as many as the file has
  int jobs = 0, only = -1;
  bool checks = false, short_form = false, list = false;
};

// "earth", "moon", "mars" or a number [m/s2] as a setting. Throws InputError.
std::string gravity_setting(const std::string& name);

// Returns the exit code: 0; 1 when a run failed; 3 when interrupted. Throws InputError.
int rig_command(const RigArguments& arguments);

}  // namespace footfall
