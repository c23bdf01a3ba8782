#pragma once
// A LIGGGHTS script as text, with the files it includes and the variables of the scene, read without LIGGGHTS: variables that
// only LIGGGHTS can compute remain ${name}.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

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

class ScriptText {
 public:
  // `variables`: as -var on the command line; `here`, the script's folder, is added.
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
  void add(ScriptCommand command);
  void add_branches(const ScriptCommand& command);
  void include(const std::string& name, const std::string& included_at);
  void note_names(const std::string& text);
  std::string substitute(std::string text) const;

  std::map<std::string, std::string> fixed_, own_;  // from the command line (these win), from the script
  std::vector<ScriptCommand> commands_;
  std::string contents_;
  std::set<std::string> names_;
  std::vector<std::string> open_;  // files that are being read, the outermost first
  bool whole_ = true;
  std::string circle_;
};

}  // namespace footfall
