#include "mbd_solver/cli/analysis/report_parts.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// how scenes and scripts mark what the paper does not print
const std::vector<std::string> kMarks = {"[A]", "(assumed"};

std::string contents(const fs::path& path) { return read_whole_file(path.string()).value_or(""); }

// The scene file, the scenes it is built on, and the scripts of the grains.
std::vector<fs::path> sources_of(const Json& summary) {
  std::vector<fs::path> files;
  fs::path next = summary.value("scene_file", "");
  while (!next.empty() && fs::is_regular_file(next) && files.size() < 9) {
    files.push_back(next);
    std::istringstream lines(contents(next));
    const fs::path folder = next.parent_path();
    next.clear();
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("base", 0) != 0) continue;
      const std::size_t open = line.find('"'), close = line.find('"', open + 1);
      if (close == std::string::npos) continue;
      next = (folder / line.substr(open + 1, close - open - 1)).lexically_normal();
      if (fs::is_directory(next)) next /= "scene.toml";
    }
  }
  const Json& scene = summary.at("scene");
  if (!scene.contains("particles") || !scene.at("particles").is_object()) return files;
  std::vector<fs::path> scripts = {scene.at("particles").value("script", "")};
  if (scene.at("particles").at("bed").is_object())
    scripts.emplace_back(scene.at("particles").at("bed").value("script", ""));
  for (const fs::path& script : scripts) {
    if (!fs::is_regular_file(script)) continue;
    files.push_back(script);
    const ScriptText text(script.string(), {});
    for (const ScriptCommand& command : text.commands())
      if (std::find(files.begin(), files.end(), fs::path(command.file)) == files.end())
        files.emplace_back(command.file);
  }
  return files;
}

}  // namespace

std::string short_text(double value) { return number_text(value, 5); }

bool has_content(const std::string& file) {
  std::error_code error;
  return fs::file_size(file, error) > 0 && !error;
}

std::vector<std::string> pictures_in(const std::string& folder) {
  std::vector<std::string> pictures;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".png" && entry.path().stem() != "overview" &&
        entry.path().filename() != kLedgerPicture && has_content(entry.path().string()))
      pictures.push_back(entry.path().string());
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

void show_pictures(const std::string& folder, const std::string& heading, HtmlPage& page) {
  const std::vector<std::string> pictures = pictures_in(folder);
  if (pictures.empty()) return;
  page.section(heading);
  for (const std::string& picture : pictures) page.picture(picture);
}

void show_scene(const Json& summary, HtmlPage& page) {
  page.section("Scene and assumptions");
  if (!summary.contains("scene")) return;
  const Json settings = summary.value("settings", Json::array());
  if (!settings.empty()) {
    std::string text;
    for (const Json& setting : settings) text += "--set " + setting.get<std::string>() + "\n";
    page.paragraph("Changed for this run:");
    page.preformatted(text);
  }
  const std::vector<fs::path> files = sources_of(summary);
  Rows rows = {{"where", "assumed, because the paper does not print it"}};
  for (const fs::path& file : files) {
    std::istringstream lines(contents(file));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (line.rfind("#", 0) == 0) continue;  // explains the marks
      if (std::none_of(kMarks.begin(), kMarks.end(),
                       [&](const std::string& m) { return line.find(m) != std::string::npos; }))
        continue;
      rows.push_back({(file.parent_path().filename() / file.filename()).string() + ":" + std::to_string(number), line});
    }
  }
  if (rows.size() > 1) page.table(rows);
  for (const fs::path& file : files)
    page.folded((file.parent_path().filename() / file.filename()).string() + ", as it is now", contents(file), kMarks);
  page.folded("the scene as it was run, with all defaults", summary.at("scene").dump(2));
}

void show_versions(const Json& summary, HtmlPage& page) {
  page.section("Versions");
  Rows rows;
  const Json versions = summary.value("versions", Json::object());
  for (const auto& [name, version] : versions.items())
    rows.push_back({name, version.is_string() ? version.get<std::string>() : version.dump()});
  const Json machine = summary.value("machine", Json::object());
  for (const auto& [name, value] : machine.items())
    rows.push_back({name, value.is_string() ? value.get<std::string>() : value.dump()});
  rows.push_back({"integrator", summary.value("integrator", "unknown")});
  page.table(rows, false);
}

}  // namespace footfall
