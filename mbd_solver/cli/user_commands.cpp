#include "mbd_solver/cli/user_commands.h"

#include <cstdio>
#include <memory>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/analysis/column_plot.h"
#include "mbd_solver/cli/analysis/watch.h"
#include "mbd_solver/cli/launch/new_case.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/option_checks.h"

namespace footfall {

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

}  // namespace footfall
