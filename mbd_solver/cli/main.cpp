// footfall: the front door. It only arranges mbd_solver and liggghts_mbd.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "coupler/errors.h"
#include "mbd_solver/scene/scene_reader.h"

using namespace footfall;

namespace {

int check_scene_file(const std::string& scene_argument, const std::vector<std::string>& settings) {
  const Scene scene = read_scene(scene_argument, settings);
  for (const std::string& warning : scene.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  std::printf("%s: good. %zu bodies, %zu joints, %zu struts, %zu boundaries.\n", scene.file.c_str(), scene.bodies.size(), scene.joints.size(),
              scene.struts.size(), scene.boundaries.size());
  return kExitDone;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"footfall: flexible multibody mechanisms that touch a bed of particles"};
  app.require_subcommand(1);
  std::string scene = "inputs/landing_mr";
  std::vector<std::string> settings;
  CLI::App* check = app.add_subcommand("check", "Check a scene; every finding as file:line: key: what is wrong");
  check->add_option("SCENE", scene, "Scene file, or folder with scene.toml")->capture_default_str();
  check->add_option("--set", settings, "key=value: change one value of the scene");
  try {
    app.parse(argc, argv);
    return check_scene_file(scene, settings);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kExitDone : kExitBadInput;
  } catch (const InputError& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return kExitBadInput;
  }
}
