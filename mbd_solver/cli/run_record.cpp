#include "mbd_solver/cli/run_record.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/errors.h"
#include "mbd_solver/scene/scene_json.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

std::string record_file(const std::string& folder) { return folder + ".done.json"; }

}  // namespace

std::string made_from(const Scene& scene) {
  std::ostringstream text;
  text << scene_json(scene);
  const auto add_file = [&](const std::string& file) {
    if (!file.empty()) text << std::ifstream(file).rdbuf();
  };
  if (scene.particles) add_file(scene.particles->script);
  for (const ControllerSpec& controller : scene.controllers)
    if (controller.kind == ControllerKind::kFuzzy) add_file(controller.file);
  return text.str();
}

std::string run_recipe(const std::string& scene_file, const std::vector<std::string>& settings, double until) {
  std::ostringstream text;
  text << "until " << until << '\n';
  try {
    text << made_from(read_scene(scene_file, settings));
  } catch (const InputError&) {
    return "";
  }
  return text.str();
}

nlohmann::ordered_json recorded_cost(const std::string& folder, const std::string& recipe) {
  std::ifstream in(record_file(folder));
  if (recipe.empty() || !in || !fs::exists(fs::path(folder) / "summary.json")) return {};
  const nlohmann::ordered_json record = nlohmann::ordered_json::parse(in, nullptr, false);
  if (!record.is_object() || record.value("recipe", "") != recipe) return {};
  return record.value("cost", nlohmann::ordered_json());
}

void record_run(const std::string& folder, const std::string& recipe, const nlohmann::ordered_json& cost) {
  if (!recipe.empty()) std::ofstream(record_file(folder)) << nlohmann::ordered_json{{"cost", cost}, {"recipe", recipe}}.dump(1) << '\n';
}

}  // namespace footfall
