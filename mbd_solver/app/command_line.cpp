// Reads a command line with CLI11 and rewrites its errors: where, what is, what was expected, what to do. Only here
// exceptions become exit codes.
#include "mbd_solver/app/command_line.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/start.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/launch/programs.h"

namespace footfall {
namespace {

using Line = std::vector<std::string>;  // the words after the program's name

// Commands that have become options; for one release they answer with the new line.
constexpr const char* kRenamed[][2] = {{"surfaces", "check SCENE --surfaces"},
                                       {"pictures", "view DIR --pictures"},
                                       {"watch", "view DIR --follow"},
                                       {"audit", "run SCENE --audit"},
                                       {"trial", "check SCENE --time"}};

std::string with_small_letter(std::string text) {
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0)
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

// The command that the line begins with; null for none.
const CLI::App* command_of(const CLI::App& app, const Line& line) {
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!line.empty() && command->get_name() == line.front()) return command;
  return nullptr;
}

std::string missing_place(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0)
      return option->get_name(true) + " is missing, expected: " + with_small_letter(option->get_description()) + ".";
  return "";
}

// "TEXT", "NUMBER", ...: what follows an option.
std::string value_name(const CLI::Option& option) {
  const std::string type = option.get_type_name();  // "FLOAT:NUMBER > 0"
  const std::string name = type.substr(0, type.find(':'));
  return name == "FLOAT" || name == "INT" || name == "UINT" ? "NUMBER" : name;
}

// CLI11: "--ranks: 1 required INT:NUMBER > 0 missing"
std::string missing_value(const CLI::App& command, const std::string& what) {
  const CLI::Option* const option = command.get_option_no_throw(what.substr(0, what.find(':')));
  if (option == nullptr) return "";
  const bool some = what.find("received") != std::string::npos;  // "--camera: At least 2 required but received 1"
  return option->get_name() + (some ? " has too few values, expected: " : " has no value, expected: ") +
         option->get_name() + " " + value_name(*option) + ": " + with_small_letter(option->get_description()) + ".";
}

// CLI11: "Could not convert: --times = a"
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

// CLI11: "--ranks requires --time".
std::string missing_other(std::string what) {
  const std::string word = " requires ";
  const std::size_t at = what.find(word);
  return at == std::string::npos ? "" : what.replace(at, word.size(), " has no effect without ") + "; add it.";
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// ' Did you mean "--until"?', or which commands have it, for the first option of the line that the command does not have; empty if none.
std::string suggested_option(const CLI::App& app, const CLI::App& command, const Line& line) {
  const std::vector<std::string> known = options_of(command);
  for (const std::string& word : line) {
    const std::string name = word.substr(0, word.find('='));
    if (name.size() < 2 || name[0] != '-' || std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::vector<std::string> others;
    for (const CLI::App* other : app.get_subcommands([](const CLI::App*) { return true; }))
      if (const std::vector<std::string> names = options_of(*other);
          std::find(names.begin(), names.end(), name) != names.end())
        others.push_back(other->get_name());
    if (!others.empty()) return " " + name + " is an option of " + joined(others) + ".";
    const std::string nearest = nearest_name(name, known);
    return nearest.empty() ? "" : " Did you mean \"" + nearest + "\"?";
  }
  return "";
}

std::string option_error(const CLI::App& app, const CLI::ParseError& error, const Line& line) {
  const std::string help = " See `footfall ";
  const CLI::App* const command = command_of(app, line);
  if (command == nullptr) return std::string("footfall: ") + error.what() + "." + help + "--help`.";
  std::string what;
  if (dynamic_cast<const CLI::RequiredError*>(&error)) what = missing_place(*command);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) what = missing_value(*command, error.what());
  if (dynamic_cast<const CLI::ConversionError*>(&error)) what = wrong_value(*command, error.what());
  if (dynamic_cast<const CLI::RequiresError*>(&error)) what = missing_other(error.what());
  if (dynamic_cast<const CLI::ExcludesError*>(&error)) what = error.what() + std::string("; leave one of them out.");
  if (const auto* extras = dynamic_cast<const CLI::ExtrasError*>(&error)) {
    const std::string text = extras->what();  // "The following argument was not expected: y"
    what = "unexpected argument" + text.substr(std::min(text.size(), text.rfind(": "))) + "." +
           suggested_option(app, *command, line);
  }
  if (what.empty()) what = error.what() + std::string(".");
  return "footfall " + command->get_name() + ": " + what + help + command->get_name() + " --help`.";
}

// Throws InputError for a line that begins with no command.
void require_command(const Line& line, const std::vector<Subcommand>& commands) {
  std::vector<std::string> names;
  for (const Subcommand& subcommand : commands) names.emplace_back(subcommand.name);
  if (line.empty())
    throw InputError(code::kUnknownCommand,
                     "footfall: a command is missing, expected one of: " + joined(names) + ". See `footfall --help`.");
  const std::string& word = line.front();
  if (word.rfind("-", 0) == 0 || std::find(names.begin(), names.end(), word) != names.end()) return;
  for (const auto& [old, now] : kRenamed)
    if (word == old)
      throw InputError(code::kRenamedCommand, "footfall: `" + word + "` is now `" + called_as() + " " + now + "`.");
  throw InputError(code::kUnknownCommand, "footfall: unknown command \"" + word + "\"." +
                                              known_names("commands", word, names) + " See `footfall --help`.");
}

}  // namespace

std::vector<Subcommand> commands_with(const std::vector<std::pair<std::string, Prepare>>& own) {
  const auto program_of = [](const std::string& part) {
    if (part == "landing" || part == "test") return std::string("footfall");
    return "footfall_" + (part == "fmi" ? "fmu" : part);
  };
  std::vector<Subcommand> all = {
#define COMMAND(name, part, what) {#name, what, program_of(#part), nullptr},
#define SCRIPT_COMMAND(name, part, what)
#include "mbd_solver/app/commands.def"
#undef COMMAND
#undef SCRIPT_COMMAND
  };
  for (Subcommand& command : all)
    for (const auto& [name, prepare] : own)
      if (name == command.name) command.prepare = prepare;
  return all;
}

int run_command_line(int argc, char** argv, const std::vector<Subcommand>& commands) {
  keep_streams();
  CLI::App app{"footfall: a flexible multibody mechanism with controlled dampers on a bed of particles", "footfall"};
  app.set_version_flag("--version", std::string("footfall ") + FOOTFALL_VERSION);
  app.require_subcommand(1);
  app.footer("`footfall COMMAND --help` lists the options of a command.");
  Action action;
  // `help` and `help COMMAND` are `--help` and `COMMAND --help`.
  Line line(argv + 1, argv + argc);
  if (!line.empty() && line.front() == "help") {
    line.erase(line.begin());
    line.push_back("--help");
  }
  try {
    for (const Subcommand& subcommand : commands) {
      CLI::App* command = app.add_subcommand(subcommand.name, subcommand.what)->footer("");
      if (subcommand.prepare != nullptr)
        command->callback([&action, prepared = subcommand.prepare(*command)] { action = prepared; });
    }
    prepare_start(argc, argv);
    require_command(line, commands);
    app.parse(Line(line.rbegin(), line.rend()));  // --help and --version end here
    require_current_folder();
    const int exit_code = action();
    const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (written || output_is_unread()) return exit_code;
    print_error(code::kOutputNotWritten,
                "the standard output cannot be written in full; free space there, or send it elsewhere");
    return exit_code == 0 ? kExitFailed : exit_code;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    std::fprintf(stderr, "%s\n", with_code(code::kWrongOption, option_error(app, e, line)).c_str());
    return kExitBadInput;
  } catch (const InputError& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return kExitBadInput;
  } catch (const std::filesystem::filesystem_error& e) {
    std::fprintf(stderr, "footfall: %s\n", as_input_error(e).what());
    return kExitBadInput;
  } catch (const Interrupted& e) {
    std::fprintf(stderr, "footfall: %s\n", e.what());
    return kExitInterrupted;
  } catch (const std::exception& e) {
    const std::string text = e.what(), library = "[json.exception.";
    if (text.rfind(library, 0) == 0) {
      print_error(code::kRunDamaged,
                  "a JSON file that was read is incomplete: it was cut off or edited; repeat the run that wrote it");
      return kExitBadInput;
    }
    std::fprintf(stderr, "footfall: %s\n", text.c_str());
    return kExitFailed;
  }
}

}  // namespace footfall
