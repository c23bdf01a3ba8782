#pragma once
// A LIGGGHTS script as text, with the files it includes and the variables of the scene, read without LIGGGHTS: variables that
// only LIGGGHTS can compute remain ${name}.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mbd_solver/base/budget.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

struct ScriptCommand {
  std::string file;
  int line;
  std::string text;                // as written, lines joined
  std::vector<std::string> words;  // quoted words without their quotes
  bool conditional;                // is in an `if`: only LIGGGHTS knows whether it is executed

  std::string place() const { return file + ":" + std::to_string(line); }
  bool is_fix(const std::string& style) const { return words[0] == "fix" && words.size() > 3 && words[3] == style; }
  // A word remains that only LIGGGHTS can compute.
  bool is_computed() const;
};

// The whole word as a number.
std::optional<double> as_number(const std::string& word);

// Whether the value of a variable is the absolute path of a file. LIGGGHTS gets it from the current folder (script_arguments).
bool names_file(const std::string& value);

// What is wrong with a variable of a script, which becomes words of the command line of LIGGGHTS and of mpirun (a word for each
// line of the value): "the variable k ..., expected ..."; empty: nothing. Names have letters, digits and _. Words have letters,
// digits, blanks, quotes and _ . , + - * / ^ = ( ) [ ] < > ! % @ ~ $ { } : & |. ":" alone would begin another program, and a word
// with "-" in front an option, unless it is a number.
std::string fault_of_variable(const std::string& name, const std::string& value);

// As LIGGGHTS splits a line: outside of quotes blanks separate words, and `#` begins a comment.
std::vector<std::string> script_words(const std::string& text);

class ScriptText {
 public:
  // `variables`: as -var on the command line; `here`, the script's folder, is added. Throws InputError where files that include
  // files, or variables that name variables, make more text than base/budget.h allows.
  ScriptText(const std::string& file, const std::map<std::string, std::string>& variables);
  // In the order of the text, with the commands of all branches of an `if`.
  const std::vector<ScriptCommand>& commands() const { return commands_; }
  // Contents of the script and of all files it includes, one after the other.
  const std::string& contents() const { return contents_; }
  // All variables that the text declares or reads.
  const std::set<std::string>& names() const { return names_; }
  // The value of a variable of the command line or the script if it is plain; else empty.
  std::string value(const std::string& name) const;
  // All files were read: none has a name that only LIGGGHTS can compute, and there is no `jump` to another file.
  bool whole() const { return whole_; }
  // Its lines are executed once, in their order: there is no `jump` or `next`.
  bool straight() const;
  // "file:line" of an `include` that leads back to itself; else empty.
  const std::string& circle() const { return circle_; }

 private:
  void read(const std::string& file, const std::string& included_at);
  void add(const ScriptCommand& command);  // its words hidden
  void add_branches(const ScriptCommand& command);
  void include(const std::string& name, const std::string& included_at);
  void note_names(const std::string& text);
  std::string hidden_value(const std::string& name) const;
  std::string substitute(const std::string& text);

  // From the command line (these win), from the script. What would split a path is hidden.
  std::map<std::string, std::string> fixed_, own_;
  std::vector<ScriptCommand> commands_;
  std::string contents_;
  std::set<std::string> names_;
  std::vector<std::string> open_;  // files that are being read, the outermost first
  ReadBudget files_, bytes_, words_;
  bool whole_ = true;
  std::string circle_;
};

// A mesh of the LIGGGHTS script as the surface of a boundary.
// File, scale, orientation and position of
//   fix ID group mesh/surface... file FILE ... [scale s] [rotate axis x y z angle phi] [move x y z] ...
// LIGGGHTS applies scale, rotate (about the origin, phi in degrees) and move in their order in the line; any order gives x -> R s x + p:   scale f: s -> f s, p -> f p;   rotate Q: R -> Q R, p -> Q p;   move d: p -> p + d.
// here: the script's folder. Throws InputError without a place if the line cannot be used.
SurfaceSpec mesh_in_script(const ScriptCommand& command, const std::string& here);

// Fills every surface with from_script = "ID" from the script's mesh of this id. A line that cannot be used is a finding.
void resolve_script_meshes(Scene& scene, Findings& findings);

}  // namespace footfall
