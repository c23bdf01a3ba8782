#include "mbd_solver/cli/experiments/run_record.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/launch/fingerprint.h"
#include "mbd_solver/scene/scene_json.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

std::string record_file(const std::string& folder) { return folder + ".done.json"; }

// A line for every text in `value` that is the name of a file. Read as LIGGGHTS reads it: with the files it includes,
// if it has any.
void add_files(const nlohmann::ordered_json& value, std::ostream& text) {
  for (const auto& inner : value)
    if (inner.is_structured())
      add_files(inner, text);
    else if (std::error_code ignored; inner.is_string() && fs::is_regular_file(inner.get<std::string>(), ignored))
      text << inner.get<std::string>() << ' ' << fingerprint(ScriptText(inner.get<std::string>(), {}).contents())
           << '\n';
}

}  // namespace

std::string made_from(const Scene& scene) {
  const std::string json = scene_json(scene);
  std::ostringstream text;
  text << json << '\n';
  add_files(nlohmann::ordered_json::parse(json), text);
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
  if (!recipe.empty())
    write_whole_file(record_file(folder), nlohmann::ordered_json{{"cost", cost}, {"recipe", recipe}}.dump(1) + "\n");
}

}  // namespace footfall
