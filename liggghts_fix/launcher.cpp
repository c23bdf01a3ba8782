// liggghts_mbd: Debian's unmodified LIGGGHTS plus the fix styles of footfall. Same command line, same output, same exit
// code as liggghts; alone it is LIGGGHTS, and next to mbd_solver under one mpirun it is the grains' side of a coupled
// run:
//   mpirun -np 2 liggghts_mbd -in in.script : -np 1 mbd_solver scene.toml

#include <mpi.h>

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "coupler/abort_guard.h"
#include "coupler/base/errors.h"
#include "coupler/communicator.h"
#include "coupler/interrupt.h"
#include "coupler/link.h"
#include "coupler/programs.h"
#include "coupler/transport_mpi.h"
#include "input.h"
#include "lammps.h"
#include "liggghts_fix/dem_link.h"
#include "liggghts_fix/fix_couple_mbd.h"
#include "liggghts_fix/fix_couple_mbd_audit.h"
#include "liggghts_fix/fix_couple_mbd_geometry.h"
#include "liggghts_fix/fix_wall_gran_beam.h"
#include "liggghts_fix/fix_wall_gran_smooth.h"
#include "liggghts_fix/last_words.h"
#include "liggghts_fix/liggghts_access.h"
#include "liggghts_fix/past_screen.h"
#include "liggghts_fix/program_world.h"
#include "signal_handling.h"

namespace {

using namespace footfall;

// How long a partner may be silent before it counts as lost [s], until it has said how long (coupling.timeout of the
// scene, whose default this is).
constexpr double kPatience = 300.0;

// How long an end that failed may take before it is forced [s].
constexpr unsigned kFailedEnd = 4;

// LIGGGHTS' own: SIGINT and SIGTERM end the run after the step, with a restart file.
void stop_as_liggghts(int signal) { LAMMPS_NS::SignalHandler::int_handler(signal); }

// The quit flag is one of each rank: ranks that leave the loop at different steps wait for each other for ever.
void stop_some_ranks(int signal) {
  alarm(kEndingTime);
  stop_as_liggghts(signal);
}

// What LIGGGHTS makes here is of use only when it is whole.
void stop_at_once(int) {
  (void)!write(STDERR_FILENO, kStoppedLine, std::strlen(kStoppedLine));
  _exit(kExitInterrupted);
}

// Without a partner: as LIGGGHTS' own main, but that several ranks end for certain. SIGUSR1 asks for a restart file.
void install_signal_handlers(int ranks) {
  const bool all_or_nothing = std::getenv(kAllOrNothing) != nullptr;
  std::signal(SIGUSR1, all_or_nothing ? stop_at_once : LAMMPS_NS::SignalHandler::usr1_handler);
  for (const int signal : {SIGINT, SIGTERM})
    std::signal(signal, all_or_nothing ? stop_at_once : ranks > 1 ? stop_some_ranks : stop_as_liggghts);
  for (const int signal : {SIGHUP, SIGQUIT}) std::signal(signal, all_or_nothing ? stop_at_once : SIG_DFL);
}

// The value of LIGGGHTS' option, by its long or short name; nullptr when it is not given.
char** option(int argc, char** argv, const char* name, const char* short_name) {
  for (int i = 1; i + 1 < argc; ++i)
    if (std::strcmp(argv[i], name) == 0 || std::strcmp(argv[i], short_name) == 0) return &argv[i + 1];
  return nullptr;
}

// `-screen none` makes LIGGGHTS print through a null stream as soon as a script has a mesh: nowhere is then a better
// place, until the screen is kept. True when the option is given.
bool mend_screen_none(int argc, char** argv) {
  static char nowhere[] = "/dev/null";
  char** screen = option(argc, argv, "-screen", "-sc");
  if (!screen || std::strcmp(*screen, "none") != 0) return false;
  *screen = nowhere;
  return true;
}

template <class FixStyle>
LAMMPS_NS::Fix* create_fix(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) {
  return new FixStyle(lmp, narg, arg);
}

int run(int argc, char** argv, const Communicator& communicator, DemLink& dem_link) {
  const bool silent = mend_screen_none(argc, argv);
  if (silent) silence_what_goes_past_the_screen();
  // Not owned by a pointer that deletes it on the way of an exception: a LIGGGHTS stopped in mid-step cannot be taken
  // down in order.
  auto* lmp = new LAMMPS_NS::LAMMPS(argc, argv, communicator.world());
  if (silent) {
    char** log = option(argc, argv, "-log", "-l");
    if (std::FILE* kept = screen_kept_for_last_words(log ? *log : "log.liggghts")) lmp->screen = kept;
  }
  // Line by line: who reads the log while it is written sees what LIGGGHTS is at.
  if (lmp->logfile) std::setvbuf(lmp->logfile, nullptr, _IOLBF, BUFSIZ);
  attach_dem_link(lmp, dem_link);
  register_fix_style(lmp, "couple/mbd/geometry", create_fix<LAMMPS_NS::FixCoupleMbdGeometry>);
  register_fix_style(lmp, "couple/mbd", create_fix<LAMMPS_NS::FixCoupleMbd>);
  register_fix_style(lmp, "wall/gran/beam", create_fix<LAMMPS_NS::FixWallGranBeam>);
  register_fix_style(lmp, "wall/gran", create_fix<LAMMPS_NS::FixWallGranSmooth>);
  let_meshes_resume(lmp);
  const std::unique_ptr<LAMMPS_NS::GrainAudit> audit = LAMMPS_NS::audit_if_asked(lmp, dem_link);
  lmp->input->file();
  // The scene's end has stopped a run as a signal would; the script goes on behind that run.
  while (LAMMPS_NS::SignalHandler::request_quit && dem_link.finished() && interrupted() == 0) {
    LAMMPS_NS::SignalHandler::request_quit = false;
    lmp->input->file();
  }
  int code = kExitDone;
  if (LAMMPS_NS::SignalHandler::request_quit && dem_link.has_partner() && !dem_link.finished()) {
    code = kExitInterrupted;
    if (!dem_link.fail("LIGGGHTS was stopped by a signal", Status::kInterrupted)) abort_both_programs(code);
  }
  dem_link.script_ended();
  delete lmp;
  return code;
}

void say(const std::exception& error) {
  std::fflush(stdout);
  std::fprintf(stderr, "liggghts_mbd: ERROR: %s\n", error.what());
  std::fflush(stderr);
}

// Our errors arise on all ranks alike: one says it, all tell the partner together. Returns the exit code.
int stop(const std::exception& error, int code, const Communicator& communicator, DemLink& dem_link) {
  if (communicator.is_root()) say(error);
  // A partner that does not hear it would keep MPI_Finalize waiting.
  const Status status = code == kExitBadInput      ? Status::kBadInput
                        : code == kExitInterrupted ? Status::kInterrupted
                                                   : Status::kFailed;
  if (!dem_link.fail(error.what(), status)) abort_both_programs(code);
  return code;
}

int run_and_report(int argc, char** argv, const Communicator& communicator, DemLink& dem_link) {
  try {
    return run(argc, argv, communicator, dem_link);
  } catch (const InputError& error) {
    return stop(error, kExitBadInput, communicator, dem_link);
  } catch (const ProtocolError& error) {
    return stop(error, kExitBadInput, communicator, dem_link);
  } catch (const Interrupted& error) {
    return stop(error, kExitInterrupted, communicator, dem_link);
  } catch (const PartnerError& error) {
    return stop(error, interrupted() ? kExitInterrupted : kExitFailed, communicator, dem_link);
  } catch (const NumericalError& error) {
    return stop(error, kExitFailed, communicator, dem_link);
  } catch (const FileError& error) {
    return stop(error, kExitFailed, communicator, dem_link);
  } catch (const std::exception& error) {  // a mistake of ours or no memory: perhaps on this rank alone
    say(error);
    abort_both_programs(kExitFailed);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of the write
  end_on_signals("liggghts_mbd");
  MPI_Init(&argc, &argv);
  int code = kExitDone;
  try {
    const Communicator communicator;
    let_world_mean(communicator.world());
    AbortGuard::install(communicator);
    if (!communicator.has_partner()) install_signal_handlers(communicator.size());
    std::unique_ptr<TransportMpi> transport;
    std::unique_ptr<Link> link;
    if (communicator.has_partner()) {
      transport = std::make_unique<TransportMpi>(communicator, kMbdProgram);
      link = std::make_unique<Link>(*transport, kPatience);
    }
    DemLink dem_link(link.get());
    // LIGGGHTS ends a wrong script with MPI_Finalize and exit(1): then this is still said.
    AbortGuard::set_final_message([&] {
      transport->stop_forwarding();
      const std::string errors = errors_on_screen();
      return dem_link.fail("LIGGGHTS ended with an error of its own" +
                           (errors.empty() ? "; its message stands in its output and log file" : ": " + errors));
    });
    code = run_and_report(argc, argv, communicator, dem_link);
    let_world_mean(MPI_COMM_WORLD);
    AbortGuard::release();
  } catch (const std::exception& error) {
    say(error);
    code = kExitBadInput;
    AbortGuard::release();
  }
  if (code == kExitFailed) note_failure();
  // It waits for the partner, which may be stopped or hung.
  if (code != kExitDone) end_within(kFailedEnd, code);
  MPI_Finalize();
  return code;
}
