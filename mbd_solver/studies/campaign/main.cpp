// footfall_campaign: sweep files with drawn runs. A program of its own, so that neither other sweeps nor landings need
// OpenTURNS; footfall_studies starts it with the words of the user.
#include "mbd_solver/app/command_line.h"
#include "mbd_solver/studies/campaign/campaign.h"
#include "mbd_solver/studies/campaign/sweep_options.h"

namespace footfall {
namespace {

Action drawn_sweep(CLI::App& command) {
  const auto a = sweep_options(command);
  return [a] { return campaign_command(*a); };
}

std::vector<Subcommand> with_sweep(std::vector<Subcommand> commands) {
  for (Subcommand& command : commands) command.prepare = std::string(command.name) == "sweep" ? drawn_sweep : nullptr;
  return commands;
}

}  // namespace
}  // namespace footfall

int main(int argc, char** argv) {
  return footfall::run_command_line(argc, argv, footfall::with_sweep(footfall::subcommands()));
}
