#include "mbd_solver/cli/help_command.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "mbd_solver/cli/help_pages.h"

namespace footfall {
namespace {

const CLI::App& command_named(const CLI::App& app, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
    if (command->get_name() == name) return *command;
    names.push_back(command->get_name());
  }
  throw InputError("footfall help " + name + ": unknown command." + known_names("commands", name, names));
}

}  // namespace

Action print_help(CLI::App& app, CLI::App& command) {
  struct Arguments {
    std::string command, folder;
    bool man = false, bash = false, zsh = false;
  };
  const auto a = std::make_shared<Arguments>();
  command.add_option("COMMAND", a->command, "Of this command");
  command.add_flag("--man", a->man, "As a man page");
  command.add_flag("--bash", a->bash, "Completion for bash");
  command.add_flag("--zsh", a->zsh, "Completion for zsh");
  command.add_option("--write", a->folder, "Write all man pages and both completions into this folder");
  return [a, &app] {
    if (!a->folder.empty()) {
      write_help_pages(app, a->folder);
      return kExitDone;
    }
    const CLI::App* one = a->command.empty() ? nullptr : &command_named(app, a->command);
    std::string text;
    if (a->bash || a->zsh) {
      text = a->bash ? bash_completion(app) : zsh_completion(app);
    } else if (a->man) {
      text = one ? man_page_of(*one) : man_page(app);
    } else {
      text = app.get_formatter()->make_help(one ? one : &app, "footfall" + (one ? " " + a->command : ""),
                                            CLI::AppFormatMode::Normal);
    }
    std::printf("%s", text.c_str());
    return kExitDone;
  };
}

}  // namespace footfall
