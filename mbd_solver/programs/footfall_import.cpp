// footfall_import: the command import of footfall. A separate program, so that no run needs its libraries (sdformat,
// MuJoCo); footfall starts it for this command.
#include <memory>

#include "mbd_solver/app/command_line.h"
#include "mbd_solver/import/import_command.h"

namespace footfall {
namespace {

Action import_robot(CLI::App& command) {
  const auto a = std::make_shared<ImportArguments>();
  command.add_option("FILE", a->file, "Robot: URDF (expanded xacro), SDF 1.4 to 1.11, or MJCF")->required();
  command.add_option("--out", a->out, "Folder to create (default: the name of the file)");
  command.add_flag("--strict", a->strict,
                   "Refuse a file with parts that a scene cannot represent, instead of listing them");
  ImportOptions& o = a->options;
  command.add_option("--ground", o.ground,
                     "Put it on a ground: plane, grains, or a soil of inputs/soils, at its lowest point");
  command.add_flag("--fix-base", o.fix_base, "Fix the root of the robot to the ground");
  command.add_flag("--merge-fixed", o.merge_fixed, "Make one body of links that fixed joints connect");
  command.add_flag("--hold", o.hold, "Hold joints without a motor where they start, by motors with assumed gains");
  command.add_flag("--host", o.host, "Give each motor a signal of kind host, which a Python program sets");
  command.add_flag("--bare", o.bare, "Leave out collision geometry");
  command.add_option("--package", o.packages, "Folder in which package:// and model:// are looked for")
      ->allow_extra_args(false);
  command.add_flag("--quiet", a->quiet, "Print errors and the summary only");
  return [a] { return import_command(*a); };
}

}  // namespace
}  // namespace footfall

int main(int argc, char** argv) {
  return footfall::run_command_line(argc, argv, footfall::commands_with({{"import", footfall::import_robot}}));
}
