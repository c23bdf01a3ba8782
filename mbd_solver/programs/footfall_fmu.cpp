// footfall_fmu: the command fmu of footfall, which starts this program. Separate, so that no run needs its libraries.
#include <memory>

#include "mbd_solver/app/command_line.h"
#include "mbd_solver/fmi/export/fmu_command.h"

namespace footfall {
namespace {

Action export_scene(CLI::App& command) {
  const auto a = std::make_shared<FmuArguments>();
  command.add_option("SCENE", a->scene, "Scene file, or folder with scene.toml")->required();
  command.add_option("--out", a->out, "The FMU to write, NAME.fmu")->required();
  command.add_option("--set", a->settings, "key=value: change one value of the scene")->allow_extra_args(false);
  command.add_flag("--trust-script", a->trust_script,
                   "The FMU also carries and runs programs that the scene names (FMUs, Python files)");
  command.add_flag("--quiet", a->quiet, "Print errors only");
  return [a] { return fmu_command(*a); };
}

}  // namespace
}  // namespace footfall

int main(int argc, char** argv) {
  return footfall::run_command_line(argc, argv, footfall::commands_with({{"fmu", footfall::export_scene}}));
}
