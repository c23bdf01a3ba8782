// The folders are handed on in the environment. liggghts_mbd confines itself once MPI has started; stock LIGGGHTS is
// confined before, and may therefore write to the folders of MPI as well.

#include "mbd_solver/launch/confined_programs.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "coupler/base/codes.h"
#include "coupler/base/confinement.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"

namespace footfall {

namespace fs = std::filesystem;

void limit_script(Command& mpirun, bool trusted, const std::vector<std::string>& folders) {
  if (trusted) {
    mpirun.rights = Rights::of_user();
    return;
  }
  std::vector<std::string> absolute;
  for (const std::string& folder : folders) absolute.push_back(fs::absolute(folder).lexically_normal().string());
  mpirun.environment[kMayWrite] = joined(absolute, "\n");
  mpirun.environment[kNoPrograms] = "1";
  // To other machines as well.
  mpirun.unshown["OMPI_MCA_mca_base_env_list"] = std::string(kMayWrite) + ";" + kNoPrograms;
  // Landlock keeps a process from reading the memory of others, by which MPI would copy long messages.
  mpirun.unshown["OMPI_MCA_btl_vader_single_copy_mechanism"] = "none";
  mpirun.unshown["UCX_TLS"] = "^cma";
  for (const char* own : {"OMPI_MCA_mca_base_env_list", "UCX_TLS"})
    if (std::getenv(own) != nullptr) mpirun.unshown.erase(own);
}

int become_confined(int argc, char** argv) {
  if (argc < 3 || !script_is_confined()) {
    std::fprintf(stderr, "footfall confined: is started by footfall compare only\n");
    return kExitBadInput;
  }
  Confinement rights{folders_of_script(), {argv[2]}};
  for (const std::string& folder : folders_of_mpi()) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    rights.writable.push_back(folder);
  }
  std::string why = confine(rights);
  if (why.empty()) why = become_program(argv[2], {argv + 2, argv + argc});
  const std::string text = std::string(argv[2]) + ": cannot be confined to the files of its script (" + why +
                           "); read the script, and if you trust it, add --trust-script";
  std::fprintf(stderr, "footfall: %s\n", with_code(code::kNotConfined, text).c_str());
  return kExitBadInput;
}

}  // namespace footfall
