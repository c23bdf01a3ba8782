#include "mbd_solver/output/run_note.h"

#include "coupler/base/errors.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

using Json = nlohmann::ordered_json;

void write_run_note(const std::string& folder, const RunNote& note) {
  const Json json = {{"footfall", FOOTFALL_VERSION},
                     {"title", note.title},
                     {"scene_file", note.scene_file},
                     {"end_time_s", note.end_time}};
  write_summary(folder + "/" + kRunNote, json);
}

RunNote read_run_note(const std::string& folder) {
  const std::string file = folder + "/" + kRunNote;
  const Json json = read_summary(file);
  try {
    return {json.at("title"), json.at("scene_file"), json.at("end_time_s")};
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file + ": is not the note of a run: " + error.what());
  }
}

}  // namespace footfall
