#include "mbd_solver/cli/audit_command.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/made_files.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/audit.h"
#include "mbd_solver/cli/launch/check_command.h"
#include "mbd_solver/cli/launch/own_folder.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// Length of a window [s], as the script says; 0 where only LIGGGHTS knows.
double window_length(const Scene& scene) {
  const ParticlesSpec& particles = *scene.particles;
  const ScriptText script(particles.script, particles.variables);
  double dt = 0.0, n = 0.0;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] == "timestep" && w.size() > 1) dt = std::atof(w[1].c_str());
    if (w[0] != "fix" || w.size() < 6 || w[3] != "couple/mbd") continue;
    n = w[5] == "auto" ? scene.coupling.max_substeps : std::atof(w[5].c_str());
  }
  return dt * n;
}

}  // namespace

int audit_command(const AuditArguments& arguments) {
  RunArguments run = arguments.run;
  std::vector<std::string> settings = run.settings;
  if (!run.scheme.empty()) settings.push_back("coupling.scheme=\"" + run.scheme + "\"");
  const Scene scene = checked_scene(run.scene, settings);
  if (!scene.touches_particles())
    throw InputError(scene.file + ": ground.kind is not \"particles\": without grains there is nothing to audit");
  if (run.until <= 0.0) {
    const double H = window_length(scene);
    if (H <= 0.0)
      throw InputError(scene.particles->script +
                       ": only LIGGGHTS knows how long its windows are; say how far to go: --until SECONDS");
    run.until = arguments.windows * H;
  }
  run.audit = true;
  run.quiet = true;
  run.settings.emplace_back("output.plots=false");
  if (run.out.empty()) run.out = new_run_folder("audit");
  std::printf("audit: %s to t = %g s, in %s\n", short_path(scene.file).c_str(), run.until, run.out.c_str());
  std::fflush(stdout);
  if (const int code = run_command(run); code != kExitDone) return code;
  const fs::path out = run.out;
  const std::vector<AuditLine> lines = audit_lines((out / "audit").string());
  const std::string table = audit_table(lines);
  const MadeFiles made(run.out);
  write_whole_file((out / "audit.txt").string(), table);
  std::printf("%s", table.c_str());
  return audit_holds(lines) ? kExitDone : kExitFailed;
}

}  // namespace footfall
