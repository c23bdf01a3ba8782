// The scene runs once, to its start: its columns become outputs, its signals of kind "host" inputs, its numbers parameters. The archive
// has the library, the programs with the files that they are shipped with, and the scene with the files that it names.

#include "mbd_solver/fmi/export/fmu_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "coupler/base/files.h"
#include "mbd_solver/app/check_command.h"
#include "mbd_solver/base/fingerprint.h"
#include "mbd_solver/fmi/codes.h"
#include "mbd_solver/fmi/fmu_file.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/foreign/foreign_code.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/scene/shipped_files.h"
#include "mbd_solver/session/session.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Kind = ExportedVariable::Kind;

constexpr const char *kLibrary = "footfall_fmu.so", *kProgram = "footfall_fmu_model";
constexpr std::size_t kLongestList = 64;  // numbers of a parameter

// Every number and list of numbers of the scene, with its key of --set. Values for output or exchange only are omitted.
void add_parameters(const Json& json, const std::string& key, std::vector<ExportedVariable>& found) {
  const auto inside = [&](const std::string& name) { return key.empty() ? name : key + "." + name; };
  if (json.is_number()) {
    found.push_back({Kind::kParameter, 0, key, "", {json.get<double>()}});
  } else if (json.is_object()) {
    for (const auto& [name, value] : json.items()) {
      const bool other =
          key.empty() && (name == "output" || name == "coupling" || name == "arrays" || name == "particles");
      if (!other && name.find_first_of(".\"= ") == std::string::npos) add_parameters(value, inside(name), found);
    }
  } else if (json.is_array() && !json.empty()) {
    const bool numbers = std::all_of(json.begin(), json.end(), [](const Json& item) { return item.is_number(); });
    if (numbers && json.size() <= kLongestList)
      found.push_back({Kind::kParameter, 0, key, "", json.get<std::vector<double>>()});
    for (const Json& item : json)
      if (item.is_object() && item.contains("name") && item["name"].is_string())
        add_parameters(item, inside(item["name"].get<std::string>()), found);
  }
}

std::vector<ExportedVariable> variables_of(const Session& simulation, const Scene& scene) {
  std::vector<ExportedVariable> all = {{Kind::kTime, 0, "time", "s", {0.0}}};
  const std::vector<std::string> inputs = simulation.signals();
  for (const std::string& name : inputs) all.push_back({Kind::kInput, 0, name, "", {simulation.signal(name)}});
  for (std::size_t i = 0; i < simulation.names().size(); ++i) {
    const std::string &name = simulation.names()[i], &unit = simulation.units()[i];
    if (name != "time") all.push_back({Kind::kOutput, 0, name, unit == "-" ? "" : unit, {0.0}});
  }
  all.push_back({Kind::kOutput, 0, kBalanceColumn, "", {0.0}});
  all.push_back({Kind::kOutput, 0, kErrorColumn, "", {0.0}});
  std::vector<ExportedVariable> parameters;
  add_parameters(Json::parse(scene_json(scene)), "", parameters);
  std::set<std::string> names;
  for (const std::string& name : inputs) names.insert("signals." + name + ".initial");  // the start value of the input
  for (const ExportedVariable& v : all) names.insert(v.name);
  for (ExportedVariable& v : parameters)
    if (names.insert(v.name).second) all.push_back(std::move(v));
  unsigned next = 0;
  for (ExportedVariable& v : all) {
    v.reference = next;
    next += static_cast<unsigned>(v.start.size());
  }
  return all;
}

// The scene, its base scenes, and every file that they name, relative to the folder that holds them all.
class SceneFiles {
 public:
  explicit SceneFiles(const Scene& scene) : scene_(fs::weakly_canonical(scene.file)) {
    add(scene_);
    for (std::size_t k = 0; k < files_.size(); ++k)
      if (files_[k].extension() == ".toml") add_named_in(files_[k]);
    root_ = scene_.parent_path();
    for (const fs::path& file : files_)
      while (fs::relative(file, root_).native().rfind("..", 0) == 0) root_ = root_.parent_path();
  }
  std::string scene() const { return fs::relative(scene_, root_).string(); }
  std::vector<FmuEntry> entries() const {
    std::vector<FmuEntry> all;
    for (const fs::path& file : files_)
      all.push_back({"resources/scene/" + fs::relative(file, root_).string(), file.string(), "", false});
    return all;
  }
  std::string contents() const {
    std::string all;
    for (const fs::path& file : files_) all += read_whole_file(file.string()).value_or("");
    return all;
  }

 private:
  void add(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return;
    if (std::find(files_.begin(), files_.end(), file) == files_.end()) files_.push_back(file);
  }
  void add_named_in(const fs::path scene) {  // a copy: files are added
    const std::string text = read_whole_file(scene.string()).value_or("");
    static const std::regex kText("\"([^\"\\n]+)\"|'([^'\\n]+)'");
    for (auto at = std::sregex_iterator(text.begin(), text.end(), kText); at != std::sregex_iterator(); ++at) {
      const std::string name = (*at)[1].matched ? (*at)[1].str() : (*at)[2].str();
      std::error_code error;
      for (fs::path path : {scene.parent_path() / name, scene.parent_path() / name / "scene.toml"})
        if (fs::is_regular_file(path, error)) add(fs::weakly_canonical(path));
    }
  }

  fs::path scene_, root_;
  std::vector<fs::path> files_;
};

// The files that the programs of the model read, as in an installation.
void add_shipped(std::vector<FmuEntry>& entries) {
  for (const char* folder : {"inputs/box", "inputs/soils", "inputs/grounds", "inputs/scripts"}) {
    const fs::path source = shipped_file(folder);
    std::set<fs::path> files;  // in an order that is the same on every machine
    for (const fs::directory_entry& each : fs::recursive_directory_iterator(source))
      if (each.is_regular_file()) files.insert(each.path());
    for (const fs::path& file : files)
      entries.push_back({"resources/share/footfall/" + std::string(folder) + "/" + fs::relative(file, source).string(),
                         file.string(), "", false});
  }
}

// In the folder of this program, or in the place of an installation.
std::string library_file() {
  const fs::path folder = fs::path(built_program(kProgram)).parent_path();
  for (const fs::path& path : {folder / kLibrary, folder / "../lib/footfall" / kLibrary}) {
    std::error_code error;
    if (fs::exists(path, error)) return path.string();
  }
  throw InputError(code::kFmuParts,
                   (folder / kLibrary).string() + ": is missing; ./footfall fmu in a checkout builds it");
}

}  // namespace

int fmu_command(const FmuArguments& a) {
  const Scene scene = checked_scene(a.scene, a.settings);
  require_trust(scene, a.trust_script);
  require_foreign_code(scene);
  const bool foreign = runs_foreign_code(scene);
  const std::string library = library_file();
  const Session model(scene, SessionOptions{true, false});  // at its start
  const SceneFiles files(scene);
  std::string settings;
  for (const std::string& setting : a.settings) settings += setting + "\n";

  ExportedScene exported;
  const fs::path file = fs::absolute(scene.file).lexically_normal();
  exported.name = file.filename() == "scene.toml" ? file.parent_path().filename().string() : file.stem().string();
  exported.title = scene.title;
  exported.token = "{" + fingerprint(files.contents() + settings + FOOTFALL_VERSION) + "}";
  exported.end_time = scene.end_time;
  exported.step = scene.output.interval < scene.end_time ? scene.output.interval : 0.5 * scene.end_time;
  exported.has_state = foreign_code_without_state(scene).empty();
  exported.variables = variables_of(model, scene);

  std::vector<FmuEntry> entries = files.entries();
  entries.push_back({"modelDescription.xml", "", model_description(exported), false});
  entries.push_back({"resources/variables.txt", "", text_of_variables(exported.variables), false});
  entries.push_back({"resources/token.txt", "", exported.token, false});
  entries.push_back({"resources/scene.txt", "", files.scene(), false});
  entries.push_back({"resources/settings.txt", "", settings, false});
  if (a.trust_script) entries.push_back({"resources/trusted.txt", "", "programs of the scene\n", false});
  std::vector<std::string> programs = {kProgram};
  if (foreign) programs.push_back("footfall_fmu_host");
  for (const std::string& name : programs) {
    std::error_code error;
    if (name == "footfall_fmu_host" && !fs::exists(fs::path(built_program(kProgram)).parent_path() / name, error))
      continue;  // Python files alone
    entries.push_back({"resources/bin/" + name, built_program(name), "", true});
  }
  add_shipped(entries);
  FmuDescription own;
  own.version = "3.0";
  own.identifier = "footfall_fmu";
  entries.push_back({library_path(own), library, "", true});
  try {
    write_fmu(a.out, entries);
  } catch (const FmuProblem& problem) {
    throw InputError(code::kFmuNotWritten, a.out + ": " + problem.what());
  } catch (const fs::filesystem_error& error) {
    throw InputError(code::kFmuNotWritten, a.out + ": cannot be written: " + error.code().message());
  }
  if (!a.quiet) {
    const auto count = [&](Kind kind) {
      return std::count_if(exported.variables.begin(), exported.variables.end(),
                           [&](const ExportedVariable& v) { return v.kind == kind; });
    };
    std::printf("%s: an FMU (FMI 3.0, co-simulation) with %ld inputs, %ld outputs and %ld parameters.\n", a.out.c_str(),
                static_cast<long>(count(Kind::kInput)), static_cast<long>(count(Kind::kOutput)),
                static_cast<long>(count(Kind::kParameter)));
  }
  return kExitDone;
}

}  // namespace footfall
