// A checkpoint may only be restored into the scene that wrote it: both are compared as JSON with all defaults.

#include "mbd_solver/session/checkpoint.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

std::string state_file(const std::string& folder) { return folder + "/run.txt"; }

}  // namespace

void write_checkpoint(const std::string& folder, const Scene& scene, double until, int ranks,
                      const std::function<void(Archive&)>& visit) {
  const std::string file = std::filesystem::absolute(scene.file).lexically_normal().string();
  write_run_start(folder, {file, scene.settings, until, ranks, scene_json(scene)});
  Archive archive;
  visit(archive);
  write_whole_file(state_file(folder), archive.text());
}

void restore_checkpoint(const std::string& folder, const Scene& scene, const std::function<void(Archive&)>& visit) {
  const Json saved = Json::parse(read_run_start(folder).scene), now = Json::parse(scene_json(scene));
  if (const Json difference = Json::diff(saved, now); !difference.empty())
    throw InputError(code::kSceneChanged, scene.file + ": has changed since the run began: " +
                                              difference[0].at("path").get<std::string>() + " differs from that in " +
                                              folder + ": resume the run with the original scene, or start it again");
  const std::string file = state_file(folder);
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) throw InputError(code::kCheckpointFile, file + ": cannot be read");
  Archive archive(file, *text);
  visit(archive);
  archive.finish();
}

}  // namespace footfall
