#include "mbd_solver/cli/front_door.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/interrupt.h"
#include "mbd_solver/cli/option_errors.h"

namespace footfall {
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
