#pragma once
// A LIGGGHTS script as text, with the files it includes and the variables that the scene gives it. No LIGGGHTS here:
// variables that only LIGGGHTS can compute stay as ${name}.

#include <map>
#include <string>
#include <vector>

namespace footfall {

struct ScriptCommand {
  std::string file;
  int line;
  std::vector<std::string> words;
};

class ScriptText {
 public:
  // `variables`: as -var on the command line; `here`, the script's folder, is added. Files that cannot be read count as
  // empty. Throws InputError that names file and line for a script that includes itself, and for a variable of the
  // command line that names itself, through others or at once: LIGGGHTS would go round for ever.
  ScriptText(const std::string& file, const std::map<std::string, std::string>& variables);
  const std::vector<ScriptCommand>& commands() const { return commands_; }
  // Contents of the script and of all files it includes, one after the other.
  const std::string& contents() const { return contents_; }

 private:
  void read(const std::string& file);
  void add(const std::string& file, int line, const std::string& text);
  // `inside`: the variables whose values are being replaced.
  std::string substitute(std::string text, const std::vector<std::string>& inside = {}) const;

  std::map<std::string, std::string> fixed_, own_;  // from the command line (these win), from the script
  std::vector<ScriptCommand> commands_;
  std::string contents_;
  std::vector<std::string> open_;  // the files that are being read, each included by the one before
};

}  // namespace footfall
