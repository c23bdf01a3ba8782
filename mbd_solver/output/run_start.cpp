#include "mbd_solver/output/run_start.h"

#include "coupler/base/errors.h"
#include "mbd_solver/output/summary.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

std::string file_in(const std::string& folder) { return folder + "/start.json"; }

}  // namespace

void write_run_start(const std::string& folder, const RunStart& start) {
  Json json;
  json["footfall"] = FOOTFALL_VERSION;
  json["scene_file"] = start.scene_file;
  json["settings"] = start.settings;
  json["until"] = start.until;
  json["ranks"] = start.ranks;
  json["scene"] = Json::parse(start.scene);
  write_summary(file_in(folder), json);
}

RunStart read_run_start(const std::string& folder) {
  const Json json = read_summary(file_in(folder));
  try {
    if (json.at("footfall") != FOOTFALL_VERSION)
      throw InputError(file_in(folder) + ": was written by footfall " + json.at("footfall").get<std::string>() +
                       ", and this is " + FOOTFALL_VERSION + ": resume the run with the program that began it");
    return {json.at("scene_file"), json.at("settings"), json.at("until"), json.at("ranks"), json.at("scene").dump()};
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file_in(folder) + ": is not the start of a run: " + error.what());
  }
}

}  // namespace footfall
