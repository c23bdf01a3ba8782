#include "mbd_solver/cli/user_commands.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "mbd_solver/cli/analysis/column_plot.h"
#include "mbd_solver/cli/analysis/watch.h"
#include "mbd_solver/cli/help_pages.h"
#include "mbd_solver/cli/launch/new_case.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/option_checks.h"
#include "mbd_solver/cli/rigs/rig.h"
#include "mbd_solver/cli/rigs/rig_command.h"

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

Action new_case(CLI::App& command) {
  struct Arguments {
    std::string name, from;
    bool list = false;
  };
  const auto a = std::make_shared<Arguments>();
  CLI::Option* name = command.add_option("NAME", a->name, "Folder to be made");
  command.add_option("--from", a->from, "What it is a copy of; --list names all")->type_name("CASE");
  command.add_flag("--list", a->list, "List the cases, and stop")->excludes(name);
  return [a] {
    if (a->list) {
      for (const CaseKind& kind : case_kinds())
        std::printf("%-14s %-38s %s\n", kind.name.c_str(), kind.title.c_str(), kind.folder.c_str());
      return kExitDone;
    }
    if (a->name.empty() || a->from.empty())
      throw InputError("footfall new: expected a name and a case, as in `" + called_as() +
                       " new my_wheel --from wheel`; `" + called_as() + " new --list` lists the cases");
    make_case(a->name, a->from);
    std::printf("%s: a copy of \"%s\" to edit\nNext: %s check %s; %s run %s\n", a->name.c_str(), a->from.c_str(),
                called_as().c_str(), a->name.c_str(), called_as().c_str(), a->name.c_str());
    return kExitDone;
  };
}

Action rig(CLI::App& command) {
  const auto a = std::make_shared<RigArguments>();
  std::string names;
  for (const Rig& one : all_rigs()) names += std::string(names.empty() ? "" : "; ") + one.name + ": " + one.what;
  command.add_option("NAME", a->name, names)->required();
  command
      .add_option("--file", a->file, "Experiment instead of inputs/rigs/NAME.toml: a copy of it that you have edited")
      ->check(CLI::ExistingFile);
  command.add_option("--out", a->out, "Folder for results (default: runs/rigs/NAME)");
  command.add_option("--set", a->settings, "key=value: change one value of the scene, in every run")
      ->allow_extra_args(false);
  command.add_option("--gravity", a->gravity, "earth, moon, mars, or a number [m/s2] (default: the scene's, earth)");
  command.add_option("--samples", a->samples, "Samples of the bed (default: 3)")->check(positive());
  command.add_flag(
      "--checks", a->checks,
      "Also with a bed of twice the size, grains of half the size, and at half the speed: tells what moves "
      "by more than 5 %. Takes many times as long");
  command.add_option("--jobs", a->jobs, "Runs at once (default: as many as fit the cores)")->check(positive());
  command.add_flag("--short", a->short_form,
                   "A short form on a small bed, as the tests run it; its answers mean nothing");
  command.add_option("--only", a->only, "This run alone, without tables")->check(within(0, 1 << 30));
  command.add_flag("--list", a->list, "Make the beds, list the runs, and stop");
  return [a] { return rig_command(*a); };
}

Action plot_columns(CLI::App& command) {
  const auto a = std::make_shared<ColumnPlot>();
  command.add_option("DIR", a->run, "Folder of a run")->required();
  command
      .add_option("COLUMN", a->columns,
                  "Columns of history.csv: cabin.az; patterns: 'leg_*_primary.stroke', 'struts.*.force'; cabin.v: all "
                  "three axes. None: list them")
      ->expected(0, -1);
  command.add_option("--out", a->out, "File of the picture, .png or .svg (default: both, in DIR/plots)")
      ->type_name("FILE");
  command.add_option("--title", a->title, "Line above the picture (default: the scene's title)");
  return [a] {
    for (const std::string& line : plot_columns(*a)) std::printf("%s\n", line.c_str());
    return kExitDone;
  };
}

Action watch_run(CLI::App& command) {
  const auto a = std::make_shared<WatchArguments>();
  command.add_option("DIR", a->run, "Folder of a run")->required();
  command.add_flag("--page", a->page, "Keep DIR/watch.html up to date as well: a page that refreshes itself");
  command.add_flag("--once", a->once, "Say where the run is, and stop");
  command.add_option("--interval", a->interval, "Time between two looks [s]")->check(positive())->capture_default_str();
  return [a] { return watch_run(*a); };
}

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
