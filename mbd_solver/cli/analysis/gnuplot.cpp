#include "mbd_solver/cli/analysis/gnuplot.h"

#include <filesystem>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/launch/child.h"

namespace footfall {

namespace fs = std::filesystem;

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
