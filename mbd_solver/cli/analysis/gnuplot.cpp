#include "mbd_solver/cli/analysis/gnuplot.h"

#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/quote.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/launch/child.h"

namespace footfall {

namespace fs = std::filesystem;

std::string write_drawing(const std::string& folder, const std::string& name, const PictureSize& size,
                          const std::string& setup, const std::string& drawing) {
  const std::string paper =
      " size " + std::to_string(size.width) + "," + std::to_string(size.height) + " font \"DejaVu Sans,11\"";
  const auto on = [&](const std::string& terminal, const std::string& file) {
    return "set terminal " + terminal + "\nset output " + gnuplot_text(file) + "\n" + drawing;
  };
  const std::string script = name + ".gp";
  write_whole_file((fs::path(folder) / script).string(),
                   "# gnuplot " + gnuplot_text(script) + " draws a PNG and an SVG\n" + setup +
                       on("pngcairo" + paper, name + ".png") +
                       on("svg" + paper + " background rgb \"white\"", name + ".svg"));
  return script;
}

std::vector<std::string> run_gnuplot(const std::string& folder, const std::vector<std::string>& scripts) {
  std::vector<std::string> pictures;
  if (scripts.empty()) return pictures;
  const std::string log = "gnuplot.log";
  Command command{{"gnuplot"}, {}, log, folder};
  command.words.insert(command.words.end(), scripts.begin(), scripts.end());
  const ChildEnd end = run_child(command);
  if (end.code != 0)
    throw InputError("gnuplot ended with code " + std::to_string(end.code) + "; see " +
                     (fs::path(folder) / log).string());
  for (const std::string& script : scripts)
    pictures.push_back((fs::path(folder) / fs::path(script).replace_extension(".png")).string());
  return pictures;
}

}  // namespace footfall
