#pragma once
// A LIGGGHTS script as text, with the files it includes and the variables that the scene gives it. No LIGGGHTS here:
// variables that only LIGGGHTS can compute stay as ${name}.

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
  bool conditional;                // stands in an `if`: LIGGGHTS alone knows whether it is executed

  std::string place() const { return file + ":" + std::to_string(line); }
  bool is_fix(const std::string& style) const { return words[0] == "fix" && words.size() > 3 && words[3] == style; }
  // Some word is left that only LIGGGHTS can compute.
  bool is_computed() const;
};

// The number that a word is, with nothing behind it.
std::optional<double> as_number(const std::string& word);

class ScriptText {
 public:
  // `variables`: as -var on the command line; `here`, the script's folder, is added.
  ScriptText(const std::string& file, const std::map<std::string, std::string>& variables);
  // In the order of the text, commands of both branches of an `if` included.
  const std::vector<ScriptCommand>& commands() const { return commands_; }
  // Contents of the script and of all files it includes, one after the other.
  const std::string& contents() const { return contents_; }
  // Every variable that the text declares or reads.
  const std::set<std::string>& names() const { return names_; }
  // What the variable is worth where its value is plain, from the command line or declared here; empty otherwise.
  std::string value(const std::string& name) const;
  // Was every file read? Not where only LIGGGHTS can compute a name, and not behind `jump`.
  bool whole() const { return whole_; }
  // Does it go through its lines in their order, once? Not with `jump` and `next`.
  bool straight() const;
  // "file:line" of an `include` that includes itself; empty without.
  const std::string& circle() const { return circle_; }

 private:
  void read(const std::string& file, const std::string& asked_at);
  void add(ScriptCommand command);
  void add_branches(const ScriptCommand& command);
  void include(const std::string& name, const std::string& asked_at);
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
