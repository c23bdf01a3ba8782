// liggghts_mbd: Debian's LIGGGHTS library, not rebuilt, with footfall's fix styles, and with replacements of the functions that
// replaced/README.md lists. Options, output, exit codes and, without our fixes, all bits are as in liggghts. Coupled:
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

#include "coupler/abort_guard.h"
#include "coupler/base/codes.h"
#include "coupler/base/confinement.h"
#include "coupler/base/errors.h"
#include "coupler/base/interrupt.h"
#include "coupler/base/pulse.h"
#include "coupler/base/start.h"
#include "coupler/communicator.h"
#include "coupler/link.h"
#include "coupler/programs.h"
#include "coupler/transport_mpi.h"
#include "input.h"
#include "lammps.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/contact/fix_wall_gran_beam.h"
#include "liggghts_fix/contact/fix_wall_gran_smooth.h"
#include "liggghts_fix/couple/fix_bed_follow.h"
#include "liggghts_fix/couple/fix_couple_mbd.h"
#include "liggghts_fix/couple/fix_couple_mbd_geometry.h"
#include "liggghts_fix/couple/fix_insert_exact.h"
#include "liggghts_fix/couple/fix_remove_region.h"
#include "liggghts_fix/couple/grain_audit.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/replaced/comm_world.h"
#include "liggghts_fix/replaced/screen.h"
#include "signal_handling.h"

namespace {

using namespace footfall;

// How long the partner may be silent before its Accept brings coupling.timeout of the scene, whose default this is [s].
constexpr double kPatience = 300.0;

// How long an orderly end after a failure may take before it is forced [s].
constexpr unsigned kFailedEnd = 4;

// As LIGGGHTS: SIGINT and SIGTERM end the run after the step, with a restart file.
void stop_as_liggghts(int signal) { LAMMPS_NS::SignalHandler::int_handler(signal); }

// Each rank has its own quit flag: ranks that leave the loop at different steps would wait for each other for ever.
void stop_with_time_limit(int signal) {
  alarm(kEndingTime);
  stop_as_liggghts(signal);
}

// The result is of use only when it is complete.
void stop_at_once(int) {
  (void)!write(STDERR_FILENO, kStoppedLine, std::strlen(kStoppedLine));
  _exit(kExitInterrupted);
}

// Without a partner: as LIGGGHTS' own main, except that several ranks end within a time limit. SIGUSR1 requests a restart
// file.
void install_signal_handlers(int ranks) {
  const bool all_or_nothing = std::getenv(kAllOrNothing) != nullptr;
  std::signal(SIGUSR1, all_or_nothing ? stop_at_once : LAMMPS_NS::SignalHandler::usr1_handler);
  for (const int signal : {SIGINT, SIGTERM})
    std::signal(signal, all_or_nothing ? stop_at_once : ranks > 1 ? stop_with_time_limit : stop_as_liggghts);
  for (const int signal : {SIGHUP, SIGQUIT}) std::signal(signal, all_or_nothing ? stop_at_once : SIG_DFL);
}

// The value of LIGGGHTS' option, by its long or short name; null when it is not given.
char** option(int argc, char** argv, const char* name, const char* short_name) {
  for (int i = 1; i + 1 < argc; ++i)
    if (std::strcmp(argv[i], name) == 0 || std::strcmp(argv[i], short_name) == 0) return &argv[i + 1];
  return nullptr;
}

// With `-screen none` LIGGGHTS prints to a null stream as soon as a script has a mesh. The option is replaced by a file
// that can be written to. True when the option is given.
bool replace_screen_none(int argc, char** argv) {
  static char null_device[] = "/dev/null";
  char** screen = option(argc, argv, "-screen", "-sc");
  if (!screen || std::strcmp(*screen, "none") != 0) return false;
  *screen = null_device;
  return true;
}

template <class FixStyle>
LAMMPS_NS::Fix* create_fix(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) {
  return new FixStyle(lmp, narg, arg);
}

// MPI has started and opened its files; some it still creates or removes. The log may be a link to somewhere else.
void confine_script() {
  Confinement rights{folders_of_script(), {}};
  for (const std::string& folder : folders_of_mpi()) rights.writable.push_back(folder);
  if (const std::string why = confine(rights); !why.empty())
    throw InputError(code::kNotConfined, "the kernel does not confine the script of the scene (" + why +
                                             "); read the script, and if you trust it, add --trust-script");
}

int run(int argc, char** argv, const Communicator& communicator, DemLink& dem_link) {
  const bool silent = replace_screen_none(argc, argv);
  if (silent) hide_restart_version();
  char** log = option(argc, argv, "-log", "-l");
  std::FILE* const hidden = silent ? open_hidden_screen(log ? *log : "log.liggghts") : nullptr;
  if (script_is_confined()) confine_script();
  // Not owned by a smart pointer, which would delete it when an exception leaves: a LIGGGHTS stopped within a step cannot be
  // destroyed in order.
  auto* lmp = new LAMMPS_NS::LAMMPS(argc, argv, communicator.world());
  if (hidden) lmp->screen = hidden;
  // Line by line: readers of the log see the progress of LIGGGHTS.
  if (lmp->logfile) std::setvbuf(lmp->logfile, nullptr, _IOLBF, BUFSIZ);
  attach_dem_link(lmp, dem_link);
  register_fix_style(lmp, "couple/mbd/geometry", create_fix<LAMMPS_NS::FixCoupleMbdGeometry>);
  register_fix_style(lmp, "couple/mbd", create_fix<LAMMPS_NS::FixCoupleMbd>);
  register_fix_style(lmp, "insert/exact", create_fix<LAMMPS_NS::FixInsertExact>);
  register_fix_style(lmp, "remove/region", create_fix<LAMMPS_NS::FixRemoveRegion>);
  register_fix_style(lmp, "bed/follow", create_fix<LAMMPS_NS::FixBedFollow>);
  register_fix_style(lmp, "wall/gran/beam", create_fix<LAMMPS_NS::FixWallGranBeam>);
  register_fix_style(lmp, "wall/gran", create_fix<LAMMPS_NS::FixWallGranSmooth>);
  make_meshes_resumable(lmp);
  const std::unique_ptr<LAMMPS_NS::GrainAudit> audit = LAMMPS_NS::audit_if_required(lmp, dem_link);
  lmp->input->file();
  // The end of the scene stops a run as a signal would; the script then continues after that run.
  while (LAMMPS_NS::SignalHandler::request_quit && dem_link.finished() && !dem_link.runs().script_is_over() &&
         interrupted() == 0) {
    LAMMPS_NS::SignalHandler::request_quit = false;
    lmp->input->file();
  }
  int exit_code = kExitDone;
  if (LAMMPS_NS::SignalHandler::request_quit && dem_link.has_partner() && !dem_link.finished()) {
    exit_code = kExitInterrupted;
    const std::string reason = with_code(code::kLiggghtsInterrupted, "LIGGGHTS was stopped by a signal");
    if (!dem_link.fail(reason, Status::kInterrupted)) abort_both_programs(exit_code);
  }
  dem_link.script_ended();
  delete lmp;
  return exit_code;
}

void print_error(const std::exception& error) {
  std::fflush(stdout);
  std::fprintf(stderr, "liggghts_mbd: ERROR: %s\n", error.what());
  std::fflush(stderr);
}

// Errors of footfall occur on all ranks: the root prints them, and all inform the partner together. Returns the exit code.
int stop(const std::exception& error, int exit_code, const Communicator& communicator, DemLink& dem_link) {
  if (communicator.is_root()) print_error(error);
  const Status status = exit_code == kExitBadInput      ? Status::kBadInput
                        : exit_code == kExitInterrupted ? Status::kInterrupted
                                                        : Status::kFailed;
  // MPI_Finalize would wait for a partner that does not answer.
  if (!dem_link.fail(error.what(), status)) abort_both_programs(exit_code);
  return exit_code;
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
  } catch (const std::exception& error) {  // an internal error or lack of memory, possibly on this rank only
    print_error(error);
    note_failure(error.what());
    abort_both_programs(kExitFailed);
  }
}

}  // namespace

int main(int argc, char** argv) {
  keep_streams();
  open_pulse();
  end_on_signals("liggghts_mbd");
  MPI_Init(&argc, &argv);
  int exit_code = kExitDone;
  try {
    const Communicator communicator;
    redirect_comm_world(communicator.world());
    AbortGuard::install(communicator);
    if (!communicator.has_partner()) install_signal_handlers(communicator.size());
    std::unique_ptr<TransportMpi> transport;
    std::unique_ptr<Link> link;
    if (communicator.has_partner()) {
      transport = std::make_unique<TransportMpi>(communicator, kMbdProgram);
      link = std::make_unique<Link>(*transport, kPatience);
    }
    DemLink dem_link(link.get());
    // LIGGGHTS ends a wrong script with MPI_Finalize and exit(1): then this message is still sent.
    AbortGuard::set_final_message([&] {
      transport->stop_forwarding();
      return dem_link.fail(own_error(errors_on_screen()));
    });
    exit_code = run_and_report(argc, argv, communicator, dem_link);
    redirect_comm_world(MPI_COMM_WORLD);
    AbortGuard::release();
  } catch (const std::exception& error) {
    print_error(error);
    exit_code = kExitBadInput;
    AbortGuard::release();
  }
  if (exit_code == kExitFailed) note_failure();
  // MPI_Finalize waits for the partner, which may be stopped or hang.
  if (exit_code != kExitDone) end_within(kFailedEnd, exit_code);
  MPI_Finalize();
  return exit_code;
}
