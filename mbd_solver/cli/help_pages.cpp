#include "mbd_solver/cli/help_pages.h"

#include <algorithm>
#include <filesystem>

#include "coupler/base/folder.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"

namespace footfall {

namespace {

using Commands = std::vector<const CLI::App*>;
using Options = std::vector<const CLI::Option*>;

// Those that --help lists: an empty group hides.
Commands commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}
Options options_of(const CLI::App& command, bool positional) {
  return command.get_options([&](const CLI::Option* option) {
    return !option->get_group().empty() && option->get_positional() == positional;
  });
}

// "--out", "-L", ...
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}
bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

// "[SCENE]", "DIR": as they stand in a line.
std::string places_of(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : options_of(command, true)) {
    const std::string more = option->get_items_expected_max() > 1 ? "..." : "";
    const std::string name = option->get_name(true) + more;
    text += " " + (option->get_required() ? name : "[" + name + "]");
  }
  return text;
}

// ---- man ----

// A line of plain text: no character in it is a command of man.
std::string roff(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
  return (!safe.empty() && (safe[0] == '.' || safe[0] == '\'') ? "\\&" : "") + safe;
}

std::string head(const std::string& name, const std::string& what) {
  return ".TH " + name + " 1 \"\" \"footfall " + FOOTFALL_VERSION + "\" \"footfall\"\n.SH NAME\n" + roff(name) +
         " \\- " + roff(what) + "\n";
}

std::string options_section(const CLI::App& command) {
  std::string text;
  for (const bool positional : {true, false}) {
    for (const CLI::Option* option : options_of(command, positional)) {
      std::string term = positional ? "\\fI" + roff(option->get_name(true)) + "\\fR" : "";
      if (!positional) {
        for (const std::string& name : names_of(*option))
          term += (term.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
        if (takes_value(*option)) term += " \\fI" + roff(value_name(*option)) + "\\fR";
      }
      text += ".TP\n" + term + "\n" + roff(option->get_description());
      if (const std::string value = option->get_default_str(); !value.empty() && !positional)
        text += " (default: " + roff(value) + ")";
      text += "\n";
    }
  }
  return text;
}

// ---- shells ----

std::string all_names(const Options& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options)
    for (const std::string& name : names_of(*option)) names.push_back(name);
  return joined(names, " ");
}

// In single quotes of a shell; zsh takes [ ] : of a description apart.
std::string described(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\'') {
      safe += "'\\''";
    } else {
      safe += (c == '[' || c == ']' || c == ':' || c == '\\') ? std::string("\\") + c : std::string(1, c);
    }
  }
  return safe;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  std::string text = head("footfall", app.get_description().substr(app.get_description().find(':') + 2));
  text += ".SH SYNOPSIS\n\\fBfootfall\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n.SH COMMANDS\n";
  for (const CLI::App* command : commands_of(app))
    text += ".TP\n\\fBfootfall " + roff(command->get_name() + places_of(*command)) + "\\fR\n" +
            roff(command->get_description()) + ". See \\fBfootfall\\-" + command->get_name() + "\\fR(1).\n";
  text += ".SH OPTIONS\n" + options_section(app);
  text +=
      ".SH EXIT STATUS\n.TP\n0\ndone\n.TP\n1\nthe run failed\n.TP\n2\nbad input\n.TP\n3\ninterrupted\n"
      ".SH ENVIRONMENT\n.TP\n\\fBFOOTFALL_CACHE\\fR\nfolder of settled beds (default: $XDG_CACHE_HOME/footfall, else "
      "~/.cache/footfall)\n"
      ".SH FILES\n.TP\n\\fIruns/NAME\\fR\nresults of a run, unless \\fB\\-\\-out\\fR says otherwise\n"
      ".SH SEE ALSO\n";
  std::vector<std::string> pages;
  for (const CLI::App* command : commands_of(app)) pages.push_back("\\fBfootfall\\-" + command->get_name() + "\\fR(1)");
  return text + joined(pages, ", ") + "\n";
}

std::string man_page_of(const CLI::App& command) {
  const std::string name = command.get_name();
  return head("footfall-" + name, command.get_description()) + ".SH SYNOPSIS\n\\fBfootfall " + name +
         "\\fR [\\fIOPTION\\fR]..." + roff(places_of(command)) + "\n.SH OPTIONS\n" + options_section(command) +
         ".SH SEE ALSO\n\\fBfootfall\\fR(1)\n";
}

std::string value_name(const CLI::Option& option) {
  const std::string type = option.get_type_name();  // "FLOAT:NUMBER > 0"
  const std::string name = type.substr(0, type.find(':'));
  return name == "FLOAT" || name == "INT" || name == "UINT" ? "NUMBER" : name;
}

std::string meant_option(const CLI::App& app, const std::vector<std::string>& line) {
  for (const CLI::App* command : commands_of(app)) {
    if (line.empty() || command->get_name() != line.front()) continue;
    std::vector<std::string> known;
    for (const CLI::Option* option : options_of(*command, false))
      for (const std::string& name : names_of(*option)) known.push_back(name);
    for (const std::string& word : line) {
      const std::string name = word.substr(0, word.find('='));
      if (name.size() < 2 || name[0] != '-' || std::find(known.begin(), known.end(), name) != known.end()) continue;
      const std::string nearest = nearest_name(name, known);
      return nearest.empty() ? "" : " Did you mean \"" + nearest + "\"?";
    }
  }
  return "";
}

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    names.push_back(command->get_name());
    cases += "    " + command->get_name() + ") words='" + all_names(options_of(*command, false)) + "' ;;\n";
  }
  return "# Completion of footfall for bash; made by `footfall help --write DIR`.\n"
         "_footfall() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=''\n"
         "  COMPREPLY=()\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    mapfile -t COMPREPLY < <(compgen -W '" +
         joined(names, " ") + " " + all_names(options_of(app, false)) +
         "' -- \"$word\")\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  if [[ ${COMP_WORDS[1]} == new && $before == --from ]]; then\n"
         "    words=$(\"${COMP_WORDS[0]}\" new --list 2>/dev/null | cut -d ' ' -f 1)\n"
         "  elif [[ ${COMP_WORDS[1]} == plot && $word != -* && COMP_CWORD -gt 2 && -r ${COMP_WORDS[2]}/history.csv ]]; "
         "then\n"
         "    words=$(sed -n 2p \"${COMP_WORDS[2]}/history.csv\" | tr , ' ')\n"
         "  elif [[ $word != -* ]]; then\n"
         "    compopt -o filenames\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
         "    return\n"
         "  fi\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
         "}\n"
         "complete -F _footfall footfall\n";
}

std::string zsh_completion(const CLI::App& app) {
  std::string names, cases;
  for (const CLI::App* command : commands_of(app)) {
    names += "    '" + command->get_name() + ":" + described(command->get_description()) + "'\n";
    cases += "    " + command->get_name() + ") _arguments";
    for (const CLI::Option* option : options_of(*command, false)) {
      for (const std::string& name : names_of(*option)) {
        const bool cases_of_new = command->get_name() == "new" && name == "--from";
        const std::string value =
            cases_of_new ? ":case:($(footfall new --list 2>/dev/null | cut -d \" \" -f 1))" : ":value:_files";
        cases += " \\\n      '" + std::string(option->get_expected_max() > 1 ? "*" : "") + name + "[" +
                 described(option->get_description()) + "]" + (takes_value(*option) ? value : "") + "'";
      }
    }
    cases += " \\\n      '*:file:_files' ;;\n";
  }
  return "#compdef footfall\n# Completion of footfall for zsh; made by `footfall help --write DIR`.\n"
         "_footfall() {\n  local -a commands\n  commands=(\n" +
         names +
         "  )\n  if (( CURRENT == 2 )); then\n    _describe 'command' commands\n    return\n  fi\n"
         "  local name=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $name in\n" +
         cases + "  esac\n}\n_footfall \"$@\"\n";
}

void write_help_pages(const CLI::App& app, const std::string& folder) {
  const std::string advice = "choose a folder that can be written";
  make_folder(folder, advice);
  const auto write = [&](const std::string& name, const std::string& text) {
    write_whole_file((std::filesystem::path(folder) / name).string(), text, advice);
  };
  write("footfall.1", man_page(app));
  for (const CLI::App* command : commands_of(app))
    write("footfall-" + command->get_name() + ".1", man_page_of(*command));
  write("footfall.bash", bash_completion(app));
  write("_footfall", zsh_completion(app));
}

}  // namespace footfall
