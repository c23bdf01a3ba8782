#include "mbd_solver/run/checkpoint.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "mbd_solver/run/output/summary.h"
#include "mbd_solver/scene/scene_schema.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

std::string memory_file(const std::string& folder) { return folder + "/run.txt"; }

}  // namespace

void write_checkpoint(const std::string& folder, const Scene& scene, double until, int ranks,
                      const std::function<void(Archive&)>& visit) {
  const std::string file = std::filesystem::absolute(scene.file).lexically_normal().string();
  write_run_start(folder, {file, scene.settings, until, ranks, scene_json(scene)});
  Archive archive;
  visit(archive);
  write_whole_file(memory_file(folder), archive.text());
}

void restore_checkpoint(const std::string& folder, const Scene& scene, const std::function<void(Archive&)>& visit) {
  const Json kept = Json::parse(read_run_start(folder).scene), now = Json::parse(scene_json(scene));
  if (const Json difference = Json::diff(kept, now); !difference.empty())
    throw InputError(scene.file +
                     ": is not the scene that the run began with: " + difference[0].at("path").get<std::string>() +
                     " differs from that in " + folder + ": resume the run with the scene as it was");
  const std::string file = memory_file(folder);
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) throw InputError(file + ": cannot be read");
  Archive archive(file, *text);
  visit(archive);
  archive.finish();
}

}  // namespace footfall
