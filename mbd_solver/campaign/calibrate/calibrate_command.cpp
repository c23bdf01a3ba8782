// footfall calibrate: starts the calibration in its locked folder and writes pages, tables and settings at the end.
#include <cstdio>
#include <filesystem>
#include <optional>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/campaign/calibrate/calibration_page.h"
#include "mbd_solver/campaign/calibrate/calibration_run.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/sweep_command.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// Commands with the settings of every scene's run at the set, to be copied.
std::string settings_text(const CalibrationSpec& spec, const Evaluations& evaluations, const UnitPoint& point) {
  std::string text;
  for (std::size_t i = 0; i < point.size(); ++i)
    text += "# " + spec.parameters[i].name + " = " + spec.parameters[i].text(point[i]) + "\n";
  for (std::size_t scene = 0; scene < spec.scenes.size(); ++scene) {
    text += "footfall run " + shell_word(spec.scenes[scene].scene);
    for (const std::string& setting : evaluations.settings(full_fidelity(spec), scene, point))
      if (setting.rfind("output.", 0) != 0) text += " --set " + shell_word(setting);
    text += "\n";
  }
  return text;
}

void write_all(const CalibrationSpec& spec, const CalibrationRun& run, const Evaluations& evaluations,
               const OutputFolder& output) {
  const CalibrationOutcome& outcome = run.outcome();
  const Sets sets = run.comparable();
  write_whole_file(output.path("way.csv"), path_table(spec, outcome).csv());
  write_whole_file(output.path("best.txt"), settings_text(spec, evaluations, outcome.best->point));
  write_whole_file(output.path("most_met.txt"), settings_text(spec, evaluations, most_met(spec, sets)->point));
  std::vector<std::string> pictures;
  try {
    pictures = draw_calibration(spec, outcome, output.folder);
  } catch (const InputError& e) {
    warn_missing_file("picture", e);
  }
  const StudyPage page = calibration_page(spec, outcome, sets, output.command, pictures);
  write_page(page, output);
  std::printf("%s", page.markdown().c_str());
  for (const char* file : {"way.csv", "best.txt", "most_met.txt", "report.html"})
    std::printf("%s\n", output.path(file).c_str());
}

}  // namespace

int calibrate_command(const CalibrateArguments& a) {
  const CalibrationSpec spec = read_calibration(a.file);
  const OutputFolder output(a);
  const std::string& folder = output.folder;
  if (a.so_far && !fs::is_directory(folder))
    throw InputError(code::kNoRun,
                     folder + ": no such folder; --so-far requires a calibration in progress or interrupted");
  make_folder(folder);
  std::optional<FileLock> lock;
  if (!a.so_far) lock.emplace(lock_folder(folder));
  Evaluations evaluations(spec, output.path("runs"), output.path("numbers.jsonl"), a.jobs, a.so_far);
  CalibrationRun run(spec, evaluations);
  if (!a.so_far) std::printf("runs of the start\n");
  std::fflush(stdout);
  if (!run.start()) {
    if (!a.so_far) return study_interrupted();
    throw InputError(
        code::kStartNotDone,
        a.file + ": the runs of the start are not done; try again after the misfit of the start is printed");
  }
  if (a.so_far) {
    if (run.search()) {
      std::printf("%s: the calibration has ended; without --so-far the same command prints its page\n", a.file.c_str());
      return kExitDone;
    }
    const std::string page =
        calibration_page(spec, run.outcome(), run.comparable(), output.command + " --so-far", {}).markdown();
    if (!a.table.empty()) write_whole_file(a.table, page);
    std::printf("%s", page.c_str());
    return kExitDone;
  }
  std::printf("start: misfit %s, %d of %zu targets met\n%s\nruns at once: %d\n",
              number_text(run.outcome().start->misfit, 5).c_str(), run.outcome().start->met(), spec.targets.size(),
              joined(run.prediction(), "\n").c_str(), evaluations.jobs());
  std::fflush(stdout);
  if (a.estimate) return kExitDone;
  if (!run.search()) return study_interrupted();
  write_all(spec, run, evaluations, output);
  std::printf("%d runs done, %d done before\n", evaluations.runs_done(), evaluations.runs_reused());
  return kExitDone;
}

}  // namespace footfall
