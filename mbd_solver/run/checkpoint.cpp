#include "mbd_solver/run/checkpoint.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/scene/scene_json.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;  // of the set

std::string start_file(const std::string& folder) { return folder + "/start.json"; }
std::string memory_file(const std::string& folder) { return folder + "/run.txt"; }

Json start_of(const std::string& folder) {
  const std::string file = start_file(folder);
  Json start = read_summary(file);
  if (start.value("checkpoint", 0) != kVersion || start.value("footfall", "") != FOOTFALL_VERSION)
    throw InputError(file + ": was written by footfall " + start.value("footfall", "of another kind") +
                     ", and this is " + FOOTFALL_VERSION + ": resume the run with the program that began it");
  return start;
}

}  // namespace

void write_checkpoint(const std::string& folder, const Scene& scene, double until,
                      const std::function<void(Archive&)>& visit) {
  Json start;
  start["checkpoint"] = kVersion;
  start["footfall"] = FOOTFALL_VERSION;
  start["scene_file"] = std::filesystem::absolute(scene.file).lexically_normal().string();
  start["settings"] = scene.settings;
  start["until"] = until;
  start["scene"] = Json::parse(scene_json(scene));
  write_summary(start_file(folder), start);
  Archive archive;
  visit(archive);
  write_whole_file(memory_file(folder), archive.text());
}

RunStart read_run_start(const std::string& folder) {
  const Json start = start_of(folder);
  try {
    return {start.at("scene_file"), start.at("settings"), start.at("until")};
  } catch (const nlohmann::json::exception& error) {
    throw InputError(start_file(folder) + ": " + error.what());
  }
}

void restore_checkpoint(const std::string& folder, const Scene& scene, const std::function<void(Archive&)>& visit) {
  const Json kept = start_of(folder)["scene"], now = Json::parse(scene_json(scene));
  if (kept != now) {
    const Json difference = Json::diff(kept, now);
    const std::string where = difference.empty() ? "" : difference[0].value("path", "");
    throw InputError(scene.file + ": is not the scene that the run began with: " + where +
                     " differs from the checkpoint in " + folder + ": resume with the scene as it was");
  }
  const std::string file = memory_file(folder);
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) throw InputError(file + ": cannot be read");
  Archive archive(file, *text);
  visit(archive);
  archive.finish();
}

}  // namespace footfall
