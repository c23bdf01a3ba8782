// Finds programs next to this one or in PATH, and builds the command line of mpirun.
#include "mbd_solver/launch/programs.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/interrupt.h"
#include "coupler/base/text.h"
#include "mbd_solver/launch/codes.h"
#include "mbd_solver/scene/codes.h"
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
  if (std::string program = program_in_path(name); !program.empty()) return program;
  throw InputError(code::kProgramNotInstalled, name + ": no such program; install the Debian package " + package);
}

std::string called_as() {
  const char* name = std::getenv("FOOTFALL_CALLED_AS");
  return name && *name ? name : "footfall";
}

namespace {

// mpirun, what it becomes, and what it starts on other machines where a batch system or a list of hosts names some. A mpirun
// that is a script may start anything: its programs cannot be known.
Rights rights_of_launcher() {
  std::vector<std::string> programs;
  std::vector<const char*> names = {"mpirun", "prterun", "prte", "prted", "orted"};
  if (in_batch_job()) names.insert(names.end(), {"sh", "bash", "ssh", "rsh", "srun", "qrsh", "pbs_tmrsh", "blaunch"});
  for (const char* name : names) {
    const std::string program = program_in_path(name);
    if (program.empty()) continue;
    if (programs.empty() && read_whole_file(program).value_or("").rfind("#!", 0) == 0) return Rights::of_user();
    programs.push_back(program);
  }
  return Rights::starting(std::move(programs));
}

}  // namespace

bool in_batch_job() {
  for (const char* name : {"SLURM_JOB_ID", "PBS_JOBID", "PBS_NODEFILE", "LSB_JOBID", "LSB_HOSTS", "JOB_ID",
                           "OMPI_MCA_orte_default_hostfile", "PRTE_MCA_prte_default_hostfile"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

Command mpirun() {
  Command command{rights_of_launcher(), {"mpirun"}};
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
  if (!in_batch_job() && std::getenv("OMPI_MCA_btl") == nullptr) command.environment["OMPI_MCA_btl"] = "^tcp";
#endif
  return command;
}

void add_program(Command& mpirun, int ranks, const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<std::string>& words = mpirun.words;
  if (std::find(arguments.begin(), arguments.end(), ":") != arguments.end())
    throw InputError(code::kUnsafeValue,
                     program + ": a word of its command line is \":\", which begins another program");
  if (std::find(words.begin(), words.end(), "-np") != words.end()) words.emplace_back(":");
  words.insert(words.end(), {"-np", std::to_string(ranks), program});
  words.insert(words.end(), arguments.begin(), arguments.end());
  mpirun.rights.add(program);
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
    if (const std::string fault = fault_of_variable(name, value); !fault.empty())
      throw InputError(code::kUnsafeValue, script + ": " + fault);
    words.insert(words.end(), {"-var", name});
    // The words of a list, each in a line, are words of LIGGGHTS' index.
    for (const std::string& line : split(value, '\n')) words.push_back(names_file(line) ? short_path(line) : line);
    if (value.empty()) words.emplace_back();
  }
  return words;
}

}  // namespace footfall
