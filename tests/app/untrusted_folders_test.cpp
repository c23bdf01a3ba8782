// Folders of runs that other people have made, with links to files and folders outside: no command writes, changes or
// removes anything through them, and none waits for ever or crashes.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/app/programs.h"

namespace footfall::app {
namespace {

namespace fs = std::filesystem;

// What a run, a resumed run or a command on a run writes.
const std::vector<std::string> kFiles = {"history.csv",
                                         "history.csv.part",
                                         "summary.json",
                                         "summary.json.part",
                                         "run.json",
                                         "run.json.part",
                                         "ledger.csv",
                                         "ledger.csv.part",
                                         "failed",
                                         ".footfall.lock",
                                         "liggghts.log",
                                         "motion/plate.csv",
                                         "motion/plate.stl",
                                         "bodies.pvd",
                                         "bodies_0000.vtu",
                                         "bodies_0001.vtu.part",
                                         "grains_0.txt",
                                         "view.html",
                                         "view.html.part",
                                         "report.html.part",
                                         "plots/energy.gp",
                                         "plots/energy.png",
                                         "plots/energy.svg",
                                         "plots/gnuplot.log",
                                         "plots/overview.png",
                                         "plots/columns_plate_z.gp",
                                         "plots/columns_plate_z.png",
                                         "pictures/grains_0.rgb",
                                         "paraview.py",
                                         "audit.txt"};
const std::vector<std::string> kFolders = {"motion", "plots", "checkpoint", "pictures", "compare", "script", "audit"};

class UntrustedFolders : public ::testing::TestWithParam<std::string> {
 protected:
  // The run, with its checkpoint, as it was unpacked.
  void renew(const Folder& folder, const std::string& link) const {
    fs::remove_all(folder.path() / "run");
    fs::remove_all(folder.path() / "outside");
    fs::copy(folder.path() / "whole", folder.path() / "run", fs::copy_options::recursive);
    fs::create_directories(folder.path() / "outside/folder/12.part");
    folder.write("outside/file", "as it was\n");
    folder.write("outside/folder/12.part/file", "as it was\n");
    folder.write("outside/folder/energy.png", "as it was\n");
    const fs::path at = folder.path() / "run" / link;
    fs::remove_all(at);
    fs::create_directories(at.parent_path());
    const bool is_folder = std::find(kFolders.begin(), kFolders.end(), link) != kFolders.end();
    fs::create_symlink(folder.path() / "outside" / (is_folder ? "folder" : "file"), at);
  }
  bool is_touched(const Folder& folder) const {
    int entries = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "outside")) entries += entry.exists();
    if (entries != 5) return true;
    for (const char* file : {"outside/file", "outside/folder/12.part/file", "outside/folder/energy.png"})
      if (folder.read(file) != "as it was\n") return true;
    return false;
  }
};

TEST_P(UntrustedFolders, LeadNowhere) {
  const Folder folder("links");
  const std::string scene = "run " + kPlate + " --quiet --until 0.01 --set output.plots=true --set output.vtk=true" +
                            " --set output.checkpoint_interval=0.004";
  folder.done(scene + " --out whole");
  fs::create_directories(folder.path() / "whole/checkpoint");
  std::vector<std::string> links = kFiles;
  if (GetParam() == "compare") links = {"compare/in.stock", "compare/forces.txt", "compare/liggghts.log"};
  links.insert(links.end(), kFolders.begin(), kFolders.end());
  for (const std::string& link : links) {
    renew(folder, link);
    std::string line = GetParam() + " run";
    if (GetParam() == "new") line = scene + " --out run";
    if (GetParam() == "force") line = scene + " --force --out run";
    if (GetParam() == "resume") line = "run --resume run --until 0.012 --quiet";
    if (GetParam() == "plot") line += " plate.z";
    if (GetParam() == "pictures") line = "view --pictures run";
    const test::Outcome outcome = folder.footfall(line, 60);
    EXPECT_FALSE(is_touched(folder)) << link << ": " << line << "\n" << outcome.text;
    EXPECT_LE(outcome.exit_code, 3) << link << ": " << line << "\n" << outcome.text;
  }
}

INSTANTIATE_TEST_SUITE_P(Command, UntrustedFolders,
                         ::testing::Values("new", "force", "resume", "plot", "view", "report", "compare", "pictures"));

}  // namespace
}  // namespace footfall::app
