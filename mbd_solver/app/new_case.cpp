// Copies a scene with the neighbouring folders that its files name as "../NAME/"; these become folders of the copy.
#include "mbd_solver/app/new_case.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/base/child_process.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// Scenes of inputs/ that --from knows; the examples are found by their folders.
constexpr const char* kAdvice = "choose a folder that can be written";
constexpr const char* kOfInputs[][2] = {
    {"lander", "inputs/landing_mr"},      {"drop", "inputs/dropped_sphere"},
    {"winch", "inputs/starters/winch"},   {"hopping_leg", "inputs/starters/hopping_leg"},
    {"tripod", "inputs/starters/tripod"}, {"penetrator", "inputs/starters/penetrator"},
    {"blade", "inputs/starters/blade"},   {"seesaw", "inputs/starters/seesaw"}};

// Not copied: pictures, the scripts that draw them, and the page about the example.
bool is_left_out(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".png" || ending == ".gp" || ending == ".sh" || ending == ".md";
}

bool is_text(const fs::path& file) {
  const std::string name = file.filename().string(), ending = file.extension().string();
  return ending == ".toml" || ending == ".lammps" || name.rfind("in.", 0) == 0;
}

std::string text_of(const fs::path& file) {
  const std::optional<std::string> text = read_whole_file(file.string());
  if (!text) throw InputError(code::kShippedFileMissing, file.string() + ": cannot be read; install footfall again");
  return *text;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

// "02_wheel" -> "wheel"
std::string without_number(const std::string& name) {
  std::size_t k = 0;
  while (k < name.size() && std::isdigit(static_cast<unsigned char>(name[k]))) ++k;
  return k > 0 && k < name.size() && name[k] == '_' ? name.substr(k + 1) : name;
}

std::string title_of(const fs::path& scene) {
  constexpr const char* kTitle = "title = \"";
  const std::string text = text_of(scene);
  std::size_t from = text.find(kTitle);
  if (from == std::string::npos) return scene.parent_path().filename().string();
  from += std::string(kTitle).size();
  return text.substr(from, text.find('"', from) - from);
}

CaseKind kind_in(const std::string& name, const std::string& folder) {
  return {name, title_of(fs::path(shipped_file(folder)) / "scene.toml"), folder};
}

// Neighbours of the source folder that its files name, as in "../regolith/in.bed", become folders of the copy.
class Copy {
 public:
  Copy(fs::path source, fs::path target) : source_(std::move(source)), target_(std::move(target)) {}

  // `shown`: the source folder in the scene's own comments, which is replaced by the folder of the copy.
  void copy(const std::string& shown, const std::string& command) {
    for (const fs::directory_entry& entry : fs::directory_iterator(source_)) {
      if (!entry.is_regular_file() || is_left_out(entry.path())) continue;
      if (!is_text(entry.path())) {
        put(entry.path().filename(), text_of(entry.path()));
        continue;
      }
      std::string text = text_of(entry.path());
      for (const std::string& neighbour : neighbours_in(text)) {
        replace_all(text, "../" + neighbour + "/", neighbour + "/");
        copy_folder(neighbour);
      }
      replace_all(text, "./footfall run " + shown, command + " run " + target_.string());
      put(entry.path().filename(), text);
    }
  }

 private:
  std::vector<std::string> neighbours_in(const std::string& text) const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(source_.parent_path())) {
      const std::string name = entry.path().filename().string();
      if (entry.is_directory() && text.find("../" + name + "/") != std::string::npos) names.push_back(name);
    }
    return names;
  }

  // Unchanged, with the folders inside; what its files call "../OTHER/" becomes a folder of the copy, too.
  void copy_folder(const fs::path& name) {
    if (fs::exists(target_ / name)) return;
    make_folder((target_ / name).string(), "");
    for (const fs::directory_entry& entry : fs::directory_iterator(source_.parent_path() / name)) {
      if (entry.is_directory()) copy_folder(name / entry.path().filename());
      if (!entry.is_regular_file() || is_left_out(entry.path())) continue;
      const std::string text = text_of(entry.path());
      if (is_text(entry.path()))
        for (const std::string& further : neighbours_in(text)) copy_folder(further);
      put(name / entry.path().filename(), text);
    }
  }

  void put(const fs::path& name, const std::string& text) {
    write_whole_file((target_ / name).string(), text, kAdvice);
  }

  fs::path source_, target_;
};

void require_new_folder(const fs::path& folder) {
  const std::string name = folder.filename().string();
  if (!is_plain_name(name))
    throw InputError(code::kNameNotUsable, "footfall new: the name \"" + name +
                                               "\" has characters other than letters, digits and _ - . (or too many), "
                                               "at which LIGGGHTS may split its scripts; choose another name");
  std::error_code error;
  if (fs::exists(fs::symlink_status(folder, error)))
    throw InputError(code::kNameNotUsable, folder.string() + ": exists already; choose another name");
}

}  // namespace

std::vector<CaseKind> case_kinds() {
  std::vector<CaseKind> kinds;
  for (const fs::directory_entry& entry : fs::directory_iterator(shipped_file("examples"))) {
    const std::string folder = entry.path().filename().string();
    if (fs::exists(entry.path() / "scene.toml")) kinds.push_back(kind_in(without_number(folder), "examples/" + folder));
  }
  std::sort(kinds.begin(), kinds.end(), [](const CaseKind& a, const CaseKind& b) { return a.folder < b.folder; });
  for (const auto& [name, folder] : kOfInputs) kinds.push_back(kind_in(name, folder));
  return kinds;
}

void make_case(const std::string& given, const std::string& from) {
  const std::vector<CaseKind> kinds = case_kinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const CaseKind& k) { return k.name == from; });
  if (kind == kinds.end()) {
    std::vector<std::string> names;
    for (const CaseKind& k : kinds) names.push_back(k.name);
    throw InputError(code::kUnknownCase,
                     "footfall new --from " + from + ": unknown example." + known_names("examples", from, names));
  }
  std::string name = given;
  while (name.size() > 1 && name.back() == '/') name.pop_back();
  const fs::path folder(name);
  require_new_folder(folder);
  make_folder(folder.string(), kAdvice);
  try {
    const fs::path source = shipped_file(kind->folder);
    Copy(source, folder).copy(kind->folder, called_as());
    const std::string page =
        "# " + folder.filename().string() + ": " + kind->title + "\n" + "`" + called_as() + " check " + name +
        "` reports every fault of scene.toml; `" + called_as() + " run " + name + "` runs it.\nA copy of " +
        source.string() + ". All keys with units and defaults: " + shipped_file("inputs/reference/scene.toml") + "\n";
    write_whole_file((folder / "README.md").string(), page, kAdvice);
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    throw;
  }
}

bool is_robot_file(const std::string& from) {
  for (const char* ending : {".urdf", ".URDF", ".sdf", ".xml", ".mjcf", ".xacro", ".world"})
    if (ends_with(from, ending)) return true;
  return false;
}

int start_import(const std::vector<std::string>& words) {
  std::string program;
  try {
    program = built_program("footfall_import");
  } catch (const InputError& error) {
    throw InputError(with_addition(error.what(),
                                   ": `./footfall import` in a checkout installs libsdformat-dev and "
                                   "libmujoco-dev, and builds it"));
  }
  std::vector<std::string> line{"footfall"};
  line.insert(line.end(), words.begin(), words.end());
  std::fprintf(stderr, "footfall: %s\n", become_program(program, line).c_str());
  return kExitFailed;
}

}  // namespace footfall
