#pragma once
// A scene file as a tree of values with their lines, independent of the library that parses it.

#include <string>
#include <utility>
#include <vector>

namespace footfall {

struct ConfigNode {
  enum class Kind { kTable, kList, kText, kInteger, kNumber, kFlag, kOther };

  Kind kind = Kind::kTable;
  int line = 0;                                           // Source::kFromSet for what --set gave
  std::string text;                                       // kText
  double number = 0.0;                                    // kInteger, kNumber
  bool flag = false;                                      // kFlag
  std::vector<std::pair<std::string, ConfigNode>> table;  // kTable, by key
  std::vector<ConfigNode> list;                           // kList
  std::string spelt;  // the key by which the file names it, if that is an accepted spelling of another; else empty

  const ConfigNode* find(const std::string& key) const;
  ConfigNode* find(const std::string& key);
  bool is_number() const { return kind == Kind::kInteger || kind == Kind::kNumber; }
  // The name of an entry of a list of tables: its "name", else its "body"; empty if it has neither.
  std::string entry_name() const;
  // For messages: 'text "abc"', "the number 5", "a table".
  std::string description() const;
};

class Findings;

// [arrays.NAME] of a scene, with their counts. In texts "{leg}" becomes the number of each copy, "{leg=2}" in the name of an entry
// for the number of one copy alone, "{leg!2!3}" for the numbers of all others.
using ArrayCounts = std::vector<std::pair<std::string, int>>;
ArrayCounts arrays_of(const ConfigNode& root);
// The place in a list of tables of one copy of an array by its name, "leg_2" of "leg_{leg}", which becomes an entry of its own behind
// the others; -1: no array makes it. Its points are taken from the drawing, before the copy is turned to its place.
int own_copy(ConfigNode& list, const std::string& name, const ArrayCounts& arrays);

// Gives keys of a scene that have a second spelling their own: `type` for `kind`, `every` and `frames` of [particles.box]. Where
// both are given, the one from --set counts; otherwise the second one remains and is an unknown key.
void rename_second_spellings(ConfigNode& root);

// Throws InputError "file:line: ..." if the file cannot be read or is no TOML.
ConfigNode parse_toml_file(const std::string& file);
// A text; file: its name in messages. Throws likewise.
ConfigNode parse_toml(const std::string& text, const std::string& file);
// Parses "key=value" (value as TOML; a bare word counts as text) and sets the value at the dotted path; entries of lists
// of tables are addressed by name ("bodies.cabin.mass") or index. Errors go to `findings`.
void apply_setting(ConfigNode& root, const std::string& setting, Findings& findings);

// base = "../landing_mr": a scene that lists only its differences from another one.
// Parses the scene of `argument` (file or folder) and, when its key `base` names another scene (path relative to its
// folder), lays its own keys over that one; a base may have a base. Tables are merged key by key; entries of lists of
// tables with the same name are merged and others appended; every other value replaces; `without = ["mr"]` in a table
// removes keys of the base's table. Paths of the base remain relative to the base's folder.
// Throws InputError: not readable, no TOML, a base that leads back to itself, an experiment instead of a scene.
ConfigNode parse_scene_with_base(const std::string& argument);
// The same of a text; file: its name in messages, in the folder to which its paths are relative.
ConfigNode parse_scene_with_base(const std::string& text, const std::string& file);

}  // namespace footfall
