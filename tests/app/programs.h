#pragma once
// footfall as a program, in a folder of a test.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/run_folder.h"

namespace footfall::app {

const std::string kSource = FOOTFALL_SOURCE_DIR;
const std::string kInputs = kSource + "/inputs", kExamples = kSource + "/examples";
const std::string kPlate = kSource + "/tests/app/plate";  // a plate on four grains
// Mechanism without grains; a run of 0.02 s takes no time.
const std::string kSliderCrank = kInputs + "/accuracy/scenes/slider_crank.toml";
// A sphere on some hundred grains, settled in a second.
const std::string kSmallSphere =
    kInputs +
    "/dropped_sphere --set bodies.ball.shape.radius=0.07 --set particles.variables.width=0.42"
    " --set particles.bed.variables.width=0.42 --set particles.bed.variables.depth=0.2"
    " --set particles.bed.variables.settle=0.5 --set output.plots=false";

class Folder : public test::RunFolder {
 public:
  using test::RunFolder::RunFolder;
  // `footfall LINE` (a line for the shell) in this folder.
  test::Outcome footfall(const std::string& line, int limit_seconds = 120) const;
  // The same; a failure of the test where it does not end with 0.
  test::Outcome done(const std::string& line, int limit_seconds = 120) const;
  // The same; a failure of the test where it is not refused: exit code 2 and a message with this code ("E0123").
  test::Outcome refused(const std::string& line, const std::string& code) const;
  // A line for bash.
  test::Outcome shell(const std::string& line, int limit_seconds = 60) const;
  nlohmann::json summary(const std::string& run) const;
  std::string file(const std::string& name) const { return (path() / name).string(); }
};

// A program in the background, in a session of its own.
class Background {
 public:
  // Returns when the file `ready` is there.
  Background(const Folder& folder, const std::string& line, const std::string& ready);
  ~Background();
  // Ends the program, or all that it started as well, with a signal, and waits until it is gone.
  void end(int signal, bool all);
  // Waits for its end.
  void wait() { end(0, false); }

 private:
  int pid_ = 0;
};

// `text` as one word of a shell.
std::string quoted(const std::string& text);
bool holds(const std::string& text, const std::string& part);
int lines_of(const std::string& text);
// Matches of a regular expression.
int count(const std::string& text, const std::string& pattern);

// Folder of a run that a test of CTest made (CMakeLists.txt, footfall_run) and other tests read.
std::string shared_run(const std::string& name);

// Processes that work in this folder or below: "12 mbd_solver, 13 liggghts_mbd".
std::string processes_in(const std::filesystem::path& folder);

}  // namespace footfall::app
