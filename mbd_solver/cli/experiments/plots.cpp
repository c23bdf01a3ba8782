#include "mbd_solver/cli/experiments/plots.h"

#include <filesystem>
#include <sstream>

#include "coupler/base/quote.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/experiments/text.h"
#include "mbd_solver/output/history.h"

namespace footfall {

namespace fs = std::filesystem;

std::vector<std::string> draw_plots(const ExperimentSpec& spec, const Results& results, const std::string& folder) {
  std::vector<std::string> scripts;
  for (const PlotSpec& plot : spec.plots) {
    std::ostringstream script;
    std::string curves;
    int color = 0;
    for (const CaseResult& c : results.cases) {
      ++color;
      if (c.done.empty()) continue;
      // The first run of an ensemble stands for it.
      const History history =
          read_history((fs::path(results.runs[c.done.front()].end.folder) / "history.csv").string());
      const std::vector<double>&time = history.column("time"), &values = history.column(plot.column);
      const std::string data = "$d" + std::to_string(color);
      script << data << " << EOD\n";
      for (std::size_t i = 0; i < time.size(); ++i)
        script << number_text(time[i]) << ' ' << number_text(values[i]) << '\n';
      script << "EOD\n";
      curves += (curves.empty() ? "plot " : ", ") + data + " using 1:2 with lines lw 1.6 lc " + std::to_string(color) +
                " title " + gnuplot_text(c.plan.name);
    }
    if (curves.empty()) continue;
    script << "set grid\nset title " << gnuplot_text(plot.title) << " noenhanced\nset xlabel 'time [s]'\nset ylabel "
           << gnuplot_text(plot.label.empty() ? plot.column : plot.label)
           << " noenhanced\nset key outside right top noenhanced\n"
           << "set terminal pngcairo size 1000,560 font 'sans,11'\nset output " << gnuplot_text(plot.name + ".png")
           << "\n"
           << curves << "\nset terminal svg size 1000,560 font 'sans,11'\nset output "
           << gnuplot_text(plot.name + ".svg") << "\nreplot\n";
    write_whole_file((fs::path(folder) / (plot.name + ".gp")).string(), script.str());
    scripts.push_back(plot.name + ".gp");
  }
  return scripts.empty() ? scripts : run_gnuplot(folder, scripts);
}

}  // namespace footfall
