// footfall_campaign: calibrations, fits of the ground, and sweep files with drawn runs. A separate program, so that neither
// other sweeps nor landings need OpenTURNS; footfall and, for sweeps, footfall_studies start it with the words of the user.
#include <memory>
#include <string>

#include "mbd_solver/app/command_line.h"
#include "mbd_solver/campaign/calibrate/calibration_run.h"
#include "mbd_solver/campaign/campaign.h"
#include "mbd_solver/campaign/ground/ground_fit.h"
#include "mbd_solver/studies/sweep_options.h"

namespace footfall {
namespace {

Action drawn_sweep(CLI::App& command) {
  const auto a = sweep_options(command);
  return [a] { return campaign_command(*a); };
}

Action check(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Sweep file with drawn runs")->required();
  return [file] { return check_campaign(*file); };
}

Action calibrate(CLI::App& command) {
  const auto a = std::make_shared<CalibrateArguments>();
  command.add_option("FILE", a->file, "Calibration file, as in inputs/calibrations")->required();
  add_out(command, a->out, "runs/calibrations");
  add_jobs(command, a->jobs);
  command.add_option("--table", a->table, "Also write the page to this file, as Markdown");
  command.add_flag("--estimate", a->estimate, "Carry out the runs of the start, estimate the time of all, and stop");
  command.add_flag("--so-far", a->so_far, "Print the results so far, also while the calibration is in progress");
  return [a] { return calibrate_command(*a); };
}

Action ground(CLI::App& command) {
  const auto a = std::make_shared<GroundArguments>();
  command.add_option("ACTION", a->action, "fit: the numbers of a soil without grains from runs on grains")
      ->required()
      ->check(CLI::IsMember({"fit"}));
  command.add_option("FILE", a->file, "Sweep file with 5 to 20 runs of one pad, as in inputs/ground_fits")->required();
  command.add_option("--law", a->law, "Law that is fitted")
      ->check(CLI::IsMember({"rft", "pressure_sinkage"}))
      ->capture_default_str();
  command.add_option("--speed", a->speed, "What grows with speed: its square (inertia), or speed times depth")
      ->check(CLI::IsMember({"square", "depth"}))
      ->capture_default_str();
  add_out(command, a->out, "runs/grounds");
  command.add_option("--set", a->settings, "Change one value of the scene in every run: key=value")
      ->allow_extra_args(false);
  add_jobs(command, a->jobs);
  command.add_flag("--short", a->short_form, "The short form of the file, as in tests; its results have no meaning");
  add_only(command, a->only);
  add_list_and_beds(command, a->list, a->beds);
  return [a] { return ground_command(*a); };
}

}  // namespace
}  // namespace footfall

int main(int argc, char** argv) {
  using namespace footfall;
  return run_command_line(
      argc, argv,
      commands_with({{"sweep", drawn_sweep}, {"check", check}, {"calibrate", calibrate}, {"ground", ground}}));
}
