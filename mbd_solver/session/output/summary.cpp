// All files are written whole (write_whole_file). Numbers are checked before: JSON cannot express NaN, and the library
// would write null.

#include "mbd_solver/session/output/summary.h"

#include <sys/utsname.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <thread>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/input_file.h"
#include "coupler/base/run_directory.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/output/former_names.h"

namespace footfall {

std::string compiler_version() {
#if defined(__clang__)
  return std::string("Clang ") + __clang_version__;
#elif defined(__GNUC__)
  return std::string("GCC ") + __VERSION__;
#else
  return "unknown";
#endif
}

nlohmann::ordered_json machine() {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (TextReader text = TextReader::if_there("/proc/cpuinfo"); !json.contains("processor") && text.next();)
    if (const std::size_t colon = text.line().find(':');
        colon != std::string::npos && text.line().rfind("model name", 0) == 0)
      json["processor"] = trimmed(text.line().substr(colon + 1));
  if (const unsigned cores = std::thread::hardware_concurrency(); cores > 0) json["cores"] = cores;
  utsname system{};
  if (uname(&system) == 0) json["system"] = std::string(system.sysname) + " " + system.release + " " + system.machine;
  return json;
}

using Json = nlohmann::ordered_json;

namespace {

// What the library says of a damaged file, such as "[json.exception.parse_error.101] parse error at line 3, column 5: ...",
// in plain words.
std::string json_fault(const std::string& what) {
  const auto between = [&](const std::string& begin, const std::string& end) -> std::string {
    const std::size_t from = what.find(begin);
    if (from == std::string::npos) return "";
    const std::size_t start = from + begin.size(), stop = what.find(end, start);
    return stop == std::string::npos ? "" : what.substr(start, stop - start);
  };
  if (const std::string place = between("parse error at ", ":"); !place.empty()) return "no JSON at " + place;
  if (const std::string key = between("key '", "'"); !key.empty()) return "\"" + key + "\" is missing";
  return "an entry has another type than expected";
}

}  // namespace

void write_run_note(const std::string& folder, const RunNote& note) {
  const Json json = {{"footfall", FOOTFALL_VERSION},
                     {"title", note.title},
                     {"scene_file", note.scene_file},
                     {"end_time_s", note.end_time}};
  write_summary(folder + "/" + kRunNote, json);
}

void add_live_note(const std::string& folder, const LiveNote& note) {
  const std::string file = folder + "/" + kRunNote;
  Json json = read_summary(file);
  if (note.dt_dem > 0.0) json["dt_dem_s"] = note.dt_dem;
  json["scene"] = note.scene;
  write_summary(file, json);
}

LiveNote read_live_note(const std::string& folder) {
  const Json json = read_summary(folder + "/" + kRunNote);
  return with_summary_of(folder, [&] { return LiveNote{json.value("dt_dem_s", 0.0), json.value("scene", Json())}; });
}

RunNote read_run_note(const std::string& folder) {
  const std::string file = folder + "/" + kRunNote;
  const Json json = read_summary(file);
  try {
    return {json.at("title"), json.at("scene_file"), json.at("end_time_s")};
  } catch (const nlohmann::json::exception& error) {
    throw InputError(code::kSummaryDamaged, file + ": is not the " + kRunNote +
                                                " of a run: " + json_fault(error.what()) +
                                                "; it was cut off or edited, repeat the run");
  }
}

namespace {

std::string file_in(const std::string& folder) { return folder + "/start.json"; }

}  // namespace

void write_run_start(const std::string& folder, const RunStart& start) {
  Json json;
  json["footfall"] = FOOTFALL_VERSION;
  json["checkpoint_format"] = kCheckpointFormat;
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
    const int format = json.contains("checkpoint_format") ? json.at("checkpoint_format").get<int>() : 1;
    if (json.at("footfall") != FOOTFALL_VERSION || format != kCheckpointFormat)
      throw InputError(code::kCheckpointVersion,
                       file_in(folder) + ": was written by footfall " + json.at("footfall").get<std::string>() +
                           " (checkpoint format " + std::to_string(format) + "), this program is " + FOOTFALL_VERSION +
                           " (format " + std::to_string(kCheckpointFormat) +
                           "): resume the run with the program that began it, or start it again");
    return {json.at("scene_file"), json.at("settings"), json.at("until"), json.at("ranks"), json.at("scene").dump()};
  } catch (const nlohmann::json::exception& error) {
    throw InputError(code::kSummaryDamaged, file_in(folder) +
                                                ": is not the start.json of a run: " + json_fault(error.what()) +
                                                "; it was cut off or edited, repeat the run");
  }
}

namespace {

void require_finite(const nlohmann::ordered_json& value, const std::string& path) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw NumericalError(code::kOutputNotFinite, "summary: \"" + path + "\" is no longer finite");
  if (!value.is_structured()) return;
  for (const auto& [key, inner] : value.items()) require_finite(inner, path.empty() ? key : path + "." + key);
}

}  // namespace

void write_summary(const std::string& path, const nlohmann::ordered_json& summary) {
  require_finite(summary, "");
  write_whole_file(path, summary.dump(2) + "\n");
}

void note_end_of_run(const std::string& folder, const std::string& status, const std::string& reason) {
  const std::string file = folder + "/summary.json";
  std::error_code none;
  const bool known = std::filesystem::exists(file, none);
  Json summary = known ? read_summary(file) : Json::object();
  if (known && summary.value("status", "") == status && summary.contains("reason")) return;
  summary["status"] = status;
  summary["reason"] = reason;
  if (!known && status == "failed") summary[kFailedAtStart] = true;
  write_summary(file, summary);
}

std::string end_text(const Json& summary) {
  std::string text = summary.value("status", "unknown");
  if (text == "failed" && summary.value(kFailedAtStart, false)) text += " at the start";
  std::string reason = summary.value("reason", "");  // one line, also in tables
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return reason.empty() ? text : text + ": " + reason;
}

void throw_incomplete_summary(const std::string& folder, const std::string& what) {
  throw InputError(code::kSummaryDamaged, folder + "/summary.json: is incomplete (" + json_fault(what) +
                                              "): it was cut off or edited; repeat the run");
}

nlohmann::ordered_json read_summary(const std::string& path) {
  require_regular_file(path, kLargestText);
  guard_folder(std::filesystem::path(path).parent_path().string());  // what is read is written to by and by
  const std::optional<std::string> text = read_whole_file(path);
  if (!text) throw InputError(code::kSummaryDamaged, path + ": cannot be read; expected the summary.json of a run");
  try {
    const nlohmann::ordered_json summary = nlohmann::ordered_json::parse(*text);
    if (!summary.is_object())
      throw InputError(code::kSummaryDamaged, path + ": is not the summary of a run: no object { ... }");
    nlohmann::ordered_json present = nlohmann::ordered_json::object();
    for (const auto& [key, value] : summary.items()) present[present_name(key)] = value;
    return present;
  } catch (const nlohmann::json::exception& e) {
    throw InputError(code::kSummaryDamaged, path + ": is not the summary of a run: " + json_fault(e.what()) +
                                                "; it was cut off or edited, repeat the run");
  }
}

}  // namespace footfall
