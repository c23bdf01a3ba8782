// Finds programs next to this one or in PATH, and builds the command line of mpirun.
#include "mbd_solver/bed/programs.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/interrupt.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/scene/particle_script.h"

namespace footfall {

namespace fs = std::filesystem;

std::string short_path(const std::string& path) {
  std::error_code error;
  const std::string absolute = fs::absolute(path, error).lexically_normal().string();
  const std::string near = fs::path(absolute).lexically_proximate(fs::current_path(error)).string();
  return near.size() < absolute.size() ? near : absolute;
}

std::string built_program(const std::string& name) {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path program = self.parent_path() / name;
  if (!fs::exists(program, error))
    throw InputError(code::kProgramNotBuilt,
                     program.string() + ": no such program; build footfall with ./footfall or cmake --build" +
                         (name == "footfall_campaign" ? ", or install the package footfall-campaign" : ""));
  return program.string();
}

std::string installed_program(const std::string& name, const std::string& package) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string program = (fs::path(folder.empty() ? "." : folder) / name).string();
    if (access(program.c_str(), X_OK) == 0 && !fs::is_directory(program)) return program;
  }
  throw InputError(code::kProgramNotInstalled, name + ": no such program; install the Debian package " + package);
}

std::string called_as() {
  const char* name = std::getenv("FOOTFALL_CALLED_AS");
  return name && *name ? name : "footfall";
}

Command mpirun() {
  Command command;
  command.words = {"mpirun"};
  if (geteuid() == 0) {
    command.environment["OMPI_ALLOW_RUN_AS_ROOT"] = "1";
    command.environment["OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"] = "1";
  }
  // mbd_solver sleeps while the grains move: one process more than there are cores costs nothing.
  command.words.insert(command.words.end(), {"--oversubscribe", "--bind-to", "none"});
#if FOOTFALL_OPEN_MPI < 5
  command.words.emplace_back("--quiet");
#else
  // mpirun of Open MPI 5 with Debian's PMIx dies of several programs on its line, unless this plugin stays away. It passes on
  // variables that nothing here reads.
  command.environment["PMIX_MCA_pmdl"] = "^ompi";
  // All ranks are on this machine, outside of a batch job: no look at its network, which prints warnings.
  bool batch = false;
  for (const char* name : {"SLURM_JOB_ID", "PBS_JOBID", "LSB_JOBID", "JOB_ID"}) batch |= std::getenv(name) != nullptr;
  if (!batch && std::getenv("OMPI_MCA_btl") == nullptr) command.environment["OMPI_MCA_btl"] = "^tcp";
#endif
  return command;
}

void leave_time_to_end(Command& mpirun) {
  // SIGCONT, so many seconds, SIGTERM, as many again, SIGKILL.
  mpirun.environment[FOOTFALL_OPEN_MPI < 5 ? "OMPI_MCA_odls_base_sigkill_timeout"
                                           : "PRTE_MCA_odls_base_sigkill_timeout"] = "3";
  mpirun.environment[kLauncherWarns] = "1";
}

std::vector<std::string> script_arguments(const std::string& script,
                                          const std::map<std::string, std::string>& variables) {
  std::vector<std::string> words = {"-in", short_path(script), "-var", "here",
                                    short_path(fs::path(script).parent_path().string())};
  for (const auto& [name, value] : variables) {
    words.insert(words.end(), {"-var", name});
    std::istringstream lines(value);  // the words of a list, each in a line, are words of LIGGGHTS' index
    bool any = false;
    for (std::string line; std::getline(lines, line); any = true)
      words.push_back(names_file(line) ? short_path(line) : line);
    if (!any) words.emplace_back();
  }
  return words;
}

}  // namespace footfall
