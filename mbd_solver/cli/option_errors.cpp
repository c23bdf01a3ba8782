#include "mbd_solver/cli/option_errors.h"

#include <cctype>

#include "coupler/base/text.h"
#include "mbd_solver/cli/help_pages.h"

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

}  // namespace footfall
