#include "mbd_solver/app/command_line.h"

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "coupler/interrupt.h"

namespace footfall {
namespace {

std::string with_small_letter(std::string text) {
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0)
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

// The subcommand that the line has begun with; null for none.
const CLI::App* command_of(const CLI::App& app, const std::vector<std::string>& line) {
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!line.empty() && command->get_name() == line.front()) return command;
  return nullptr;
}

std::string missing_command(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); }))
    names.push_back(command->get_name());
  return "the command is missing, expected one of: " + joined(names) + ".";
}

std::string missing_place(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0)
      return option->get_name(true) + " is missing, expected: " + with_small_letter(option->get_description()) + ".";
  return "";
}

// "--ranks: 1 required INT:NUMBER > 0 missing"
std::string missing_value(const CLI::App& command, const std::string& what) {
  const CLI::Option* const option = command.get_option_no_throw(what.substr(0, what.find(':')));
  if (option == nullptr) return "";
  return option->get_name() + " is given without its value, expected: " + option->get_name() + " " +
         value_name(*option) + ": " + with_small_letter(option->get_description()) + ".";
}

// "Could not convert: --times = a"
std::string wrong_value(const CLI::App& command, const std::string& what) {
  const std::string begin = "Could not convert: ";
  const std::size_t equals = what.find(" = ");
  if (what.rfind(begin, 0) != 0 || equals == std::string::npos) return "";
  const std::string name = what.substr(begin.size(), equals - begin.size());
  const CLI::Option* const option = command.get_option_no_throw(name);
  if (option == nullptr) return "";
  const bool whole = option->get_type_name().rfind("INT", 0) == 0 || option->get_type_name().rfind("UINT", 0) == 0;
  return name + ": is \"" + what.substr(equals + 3) + "\", expected a " + (whole ? "whole " : "") +
         "number: " + with_small_letter(option->get_description()) + ".";
}

// "--ranks requires --time"; `word` stands between two options.
std::string about_two(const std::string& what, const std::string& word, const std::string& said) {
  const std::size_t at = what.find(word);
  return at == std::string::npos ? "" : what.substr(0, at) + said + what.substr(at + word.size());
}

// "The following argument was not expected: y"
std::string not_expected(const std::string& what) {
  const std::size_t colon = what.find(": ");
  return colon == std::string::npos ? "" : "not expected here: " + what.substr(colon + 2) + ".";
}

}  // namespace

std::string option_error(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& line) {
  const CLI::App* const command = command_of(app, line);
  if (command == nullptr)
    return "footfall: " + (dynamic_cast<const CLI::RequiredError*>(&error) ? missing_command(app) : error.what()) +
           " `footfall --help` tells what each does.";
  std::string what;
  if (dynamic_cast<const CLI::RequiredError*>(&error)) what = missing_place(*command);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) what = missing_value(*command, error.what());
  if (dynamic_cast<const CLI::ConversionError*>(&error)) what = wrong_value(*command, error.what());
  if (dynamic_cast<const CLI::RequiresError*>(&error))
    what = about_two(error.what(), " requires ", " means nothing without ") + "; add it.";
  if (dynamic_cast<const CLI::ExcludesError*>(&error))
    what = about_two(error.what(), " excludes ", " cannot stand beside ") + "; leave one of them out.";
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) what = not_expected(error.what());
  if (what.empty()) what = error.what() + std::string(".");
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) what += meant_option(app, line);
  return "footfall " + command->get_name() + ": " + what + " `footfall " + command->get_name() +
         " --help` tells what there is.";
}

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

namespace {

// What was meant by a first word that is neither a subcommand nor an option.
void require_subcommand(const std::string& word, const std::vector<Subcommand>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const Subcommand& subcommand : commands) names.emplace_back(subcommand.name);
  if (word == "help") return;
  if (word.empty() || word[0] == '-' || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw InputError("footfall " + word + ": unknown command." + known_names("commands", word, names) +
                   " `footfall --help` tells what each does.");
}

}  // namespace

int front_door(int argc, char** argv, const std::vector<Subcommand>& commands,
               const std::function<Action(CLI::App& app, CLI::App& command)>& help) {
  CLI::App app{"footfall: a flexible multibody mechanism with controlled dampers touches a bed of particles"};
  app.set_version_flag("--version", std::string("footfall ") + FOOTFALL_VERSION);
  app.require_subcommand(1);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of the write
  Action action;
  for (const Subcommand& subcommand : commands) {
    CLI::App* command = app.add_subcommand(subcommand.name, subcommand.what);
    command->callback([&action, act = subcommand.prepare(*command)] { action = act; });
  }
  if (help) {
    CLI::App* command = app.add_subcommand("help", "Print help, or write man pages and completion")->group("");
    command->callback([&action, act = help(app, *command)] { action = act; });
  }
  try {
    if (argc > 1) require_subcommand(argv[1], commands);
    app.parse(argc, argv);
    return action();
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    std::fprintf(stderr, "%s\n", option_error(app, e, {argv + 1, argv + argc}).c_str());
    return kExitBadInput;
  } catch (const InputError& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return kExitBadInput;
  } catch (const Interrupted& e) {
    std::fprintf(stderr, "footfall: %s\n", e.what());
    return kExitInterrupted;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "footfall: %s\n", e.what());
    return kExitFailed;
  }
}

}  // namespace footfall
