#pragma once
// The common part of sweep and calibration files: how they are read, and faults in them.

#include <filesystem>
#include <string>
#include <type_traits>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/named_file.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/sweep_file.h"

namespace footfall {

// Reads the keys of a file, described by visit_fields(). `expected` names the kind of file in messages. Throws InputError.
struct CalibrationSpec;
template <class Spec>
Spec read_study(const std::string& file, const std::string& expected, const std::string& examples, Findings& findings) {
  require_file(file, expected + " (TOML), as in " + examples);
  const ConfigNode root = parse_toml_file(file);
  if (root.find("bodies") || root.find("base"))
    throw InputError(code::kSceneGiven, file + ": is a scene, expected " + expected +
                                            ", which names a scene and what to vary; see " + examples +
                                            ", or run the scene: footfall run " + file);
  const bool calibrates = root.find("targets") || root.find("stages");
  bool sweeps = false;
  for (const char* key : {"curves", "outcomes", "runs", "statements", "plots", "limits", "expect", "repeats"})
    sweeps = sweeps || root.find(key) != nullptr;
  if (calibrates != sweeps && calibrates != std::is_same_v<Spec, CalibrationSpec>)
    throw InputError(code::kOtherStudy, file + ": is a " + (calibrates ? "calibration" : "sweep") + " file, expected " +
                                            expected + "; run it with: footfall " +
                                            (calibrates ? "calibrate " : "sweep ") + file);
  Spec s;
  s.file = file;
  s.folder = std::filesystem::absolute(file).parent_path().string();
  read_fields(
      root, s.folder, [&](FieldVisitor& reader) { visit_fields(reader, s); }, findings);
  findings.throw_if_errors();
  // Defaults that the file may override.
  s.settings.insert(s.settings.begin(), {"output.vtk=false", "output.plots=false"});
  return s;
}

// Finds contradictions. The spec must outlive it.
template <class Spec>
class StudyValidator {
 protected:
  StudyValidator(Spec& spec, Findings& findings) : spec_(spec), findings_(findings) {}

  void wrong(const MessageCode& code, const Source& at, const std::string& key, const std::string& what) {
    findings_.error(code, at, key, what);
  }
  std::string in_folder(const std::string& file) const {  // of the study
    return (std::filesystem::path(spec_.folder) / file).lexically_normal().string();
  }
  void require_metric(const Source& at, const std::string& key, const std::string& name) {
    if (index_of(spec_.metrics, name) < 0)
      wrong(code::kUnknownMetric, at, key,
            "\"" + name + "\" is not one of [[figures]]." + known_names("metrics", name, names_in(spec_.metrics)));
  }
  // Where its number comes from.
  void validate_source(const MetricSpec& f) {
    if ((f.key.empty() ? 0 : 1) + (f.columns.empty() ? 0 : 1) + (f.slope.empty() ? 0 : 1) != 1)
      wrong(code::kConflictingKeys, f.source, "key",
            "expected one of key (of summary.json), columns (of history.csv) and slope (of the bed)");
    else if (!f.slope.empty() && (f.slope.size() != 2 || !(f.slope[0] < f.slope[1])))
      wrong(code::kConflictingKeys, f.source, "slope",
            "expected two heights [m], the lower one first, such as [-0.06, -0.02]");
  }

  Spec& spec_;
  Findings& findings_;
};

}  // namespace footfall
