#pragma once
// Scene file -> Scene: complete, checked, with defaults; or an InputError with all findings.

#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"
#include "mbd_solver/scene/toml_file.h"

namespace footfall {

// `argument`: a scene file, or a folder that holds scene.toml. `settings`: "key=value" of --set, applied to the file
// before it is read. Steps: parse, set, read, copy arrays, resolve (mass properties, paths, names), check.
// Throws InputError, one finding per line: "file:line: key: what is wrong, what was expected, what to do [code]".
Scene read_scene(const std::string& argument, const std::vector<std::string>& settings = {});

// The same of a scene without a file, as text. Its paths are relative to `folder`; messages name it kSceneText there.
inline constexpr const char* kSceneText = "scene_text";
Scene read_scene_text(const std::string& text, const std::string& folder = "",
                      const std::vector<std::string>& settings = {});

// The scene file of such an argument. Throws InputError if there is none.
std::string scene_file(const std::string& argument);

// large.toml in its folder: the same scene on more and finer grains. Throws InputError if there is none.
std::string large_scene_file(const std::string& argument);

}  // namespace footfall
