// mbd_solver: the multibody side of footfall. Alone it runs scenes without grains:
//   mbd_solver scene.toml --out DIR
// with LIGGGHTS under one mpirun scenes with grains:
//   mpirun -np 2 liggghts_mbd -in in.script : -np 1 mbd_solver scene.toml --out DIR
// and as a worker of a sweep with drawn runs one scene after another (mbd_solver/campaign/worker_pool.h):
//   mbd_solver --serve

#include <mpi.h>

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "coupler/abort_guard.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/interrupt.h"
#include "coupler/base/start.h"
#include "coupler/communicator.h"
#include "coupler/link.h"
#include "coupler/programs.h"
#include "coupler/transport_mpi.h"
#include "mbd_solver/base/line_channel.h"
#include "mbd_solver/base/option_checks.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/output/checkpoint_folder.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/session/run_scene.h"
#include "mbd_solver/session/simulation.h"

namespace {

using namespace footfall;

// Time until the end of a failed run is forced [s].
constexpr unsigned kForcedEnd = 4;
constexpr int kLook = 1000;  // for an interruption, while there is no task [ms]

struct Arguments {
  std::string scene;
  std::vector<std::string> settings;
  RunOptions run;
  std::string resume;  // folder of the run to resume; empty: a new run
  bool start_only = false;
};

// Throws CLI::ParseError.
Arguments parse(CLI::App& app, int argc, char** argv) {
  Arguments arguments;
  std::string scheme, integrator;
  app.set_version_flag("--version", std::string("mbd_solver ") + FOOTFALL_VERSION);
  CLI::Option* file = app.add_option("SCENE", arguments.scene, "Scene file, or folder with scene.toml");
  CLI::Option* resume =
      app.add_option("--resume", arguments.resume, "Resume the run in this folder from its newest checkpoint");
  CLI::Option* out =
      app.add_option("--out", arguments.run.out, "Folder for results (created if missing)")->capture_default_str();
  app.add_option("--until", arguments.run.until, "End earlier than the scene [s]")->check(positive());
  CLI::Option* settings = app.add_option("--set", arguments.settings, "key=value: change one value of the scene");
  CLI::Option* of_scheme = app.add_option("--scheme", scheme, "Coupling scheme (coupling.scheme)");
  CLI::Option* of_integrator = app.add_option("--integrator", integrator, "Integrator (solver.integrator)");
  // The checkpoint stores the options with which a run was started.
  for (CLI::Option* option : {file, out, settings, of_scheme, of_integrator}) resume->excludes(option);
  app.add_option("--keep-every", arguments.run.keep_every,
                 "Wall-clock checkpoint interval without output.checkpoint_interval [s]; 0: none")
      ->check(not_negative())
      ->capture_default_str();
  app.add_flag("--quiet", arguments.run.quiet, "No progress line");
  app.add_flag("--trust-script", arguments.run.trusted, "Programs that the scene names (FMUs) may run");
  app.add_flag("--start", arguments.start_only, "Build and settle the mechanism as a run without grains does, and stop")
      ->excludes(resume);
  app.add_option("--try-for", arguments.run.try_for,
                 "Trial: end after this wall-clock time [s] and report the pace in summary.json; no checkpoints")
      ->check(positive())
      ->excludes(resume);
  app.parse(argc, argv);
  if (arguments.scene.empty() && arguments.resume.empty()) throw CLI::RequiredError("SCENE, or --resume DIR,");
  if (!scheme.empty()) arguments.settings.push_back("coupling.scheme=\"" + scheme + "\"");
  if (!integrator.empty()) arguments.settings.push_back("solver.integrator=\"" + integrator + "\"");
  return arguments;
}

int report(const std::exception& error, int code) {
  std::fflush(stdout);
  std::fprintf(stderr, "mbd_solver: %s\n", error.what());
  return code;
}

// With --resume: with the scene and the settings of the run that is resumed.
Arguments completed(Arguments arguments) {
  if (arguments.resume.empty()) return arguments;
  arguments.run.out = arguments.resume;
  arguments.run.checkpoint = newest_checkpoint(arguments.resume);
  const RunStart start = read_run_start(arguments.run.checkpoint);
  arguments.scene = start.scene_file;
  arguments.settings = start.settings;
  if (!(arguments.run.until > 0.0)) arguments.run.until = start.until;
  return arguments;
}

// All that a run does before its first step, for `footfall check`. Where grains are does not matter: their height may be unknown.
int start_only(const Arguments& arguments) {
  Scene scene = read_scene(arguments.scene, arguments.settings);
  if (scene.touches_particles() && scene.particles->grains.empty() && !scene.particles->surface_height)
    scene.particles->surface_height = 0.0;
  const volatile std::sig_atomic_t stops = 1;
  Simulation(scene, scene.end_time, nullptr).run([](const Sample&) {}, stops);
  return kExitDone;
}

int run_alone(const Arguments& given) {
  if (given.start_only) return start_only(given);
  const Arguments arguments = completed(given);
  const Scene scene = read_scene(arguments.scene, arguments.settings);
  if (scene.touches_particles())
    throw InputError(code::kWrongPrograms,
                     scene.file +
                         ": ground.kind = \"particles\" needs LIGGGHTS: use `footfall run`, or start both programs:\n  "
                         "mpirun -np " +
                         std::to_string(scene.particles->ranks) + " liggghts_mbd -in " + scene.particles->script +
                         " : -np 1 mbd_solver " + arguments.scene);
  return run_scene(scene, arguments.run, nullptr, interrupted());
}

// Errors of input are sent to the partner as well: neither program outlives the other.
int run_with(const Arguments& given, Transport& transport) {
  try {
    const Arguments arguments = completed(given);
    const Scene scene = read_scene(arguments.scene, arguments.settings);
    if (!scene.touches_particles())
      throw InputError(code::kWrongPrograms,
                       scene.file +
                           ": ground.kind is not \"particles\", but LIGGGHTS was started next to it: run `mbd_solver " +
                           arguments.scene + "` alone");
    return run_scene(scene, arguments.run, &transport, interrupted());
  } catch (const InputError& error) {
    if (!transport.closing()) Link(transport).fail(error.what(), Status::kBadInput);
    throw;
  }
}

int guarded(const std::function<int()>& work, const std::function<int(const std::exception&, int)>& told = report) {
  try {
    return work();
  } catch (const InputError& error) {
    return told(error, kExitBadInput);
  } catch (const ProtocolError& error) {
    return told(error, kExitBadInput);
  } catch (const std::filesystem::filesystem_error& error) {
    return told(as_input_error(error), kExitBadInput);
  } catch (const Interrupted& error) {
    return told(error, kExitInterrupted);
  } catch (const std::exception& error) {
    return told(error, kExitFailed);
  }
}

// Each line of standard input is a run without grains: {"scene", "settings", "until", "out", "trusted"}. The answer is a line "CODE MESSAGE".
int serve() {
  const int answers = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);  // whatever else is printed
  LineChannel lines(STDIN_FILENO, answers);
  write_all_files_in_place();
  std::string line;
  for (;;) {
    const LineChannel::Heard heard = lines.receive(line, kLook);
    if (heard == LineChannel::Heard::kGone || interrupted() != 0) return kExitDone;
    if (heard == LineChannel::Heard::kNothing) continue;
    std::string message;
    const int code = guarded(
        [&] {
          const auto task = nlohmann::json::parse(line);
          RunOptions options;
          options.out = task.at("out").get<std::string>();
          options.until = task.at("until").get<double>();
          options.quiet = true;
          options.keep_every = 0.0;
          options.fleeting = true;
          options.trusted = task.value("trusted", false);
          const Scene scene =
              read_scene(task.at("scene").get<std::string>(), task.at("settings").get<std::vector<std::string>>());
          if (scene.touches_particles())
            throw InputError(code::kWrongPrograms, scene.file + ": a run on grains needs LIGGGHTS: use `footfall run`");
          return run_scene(scene, options, nullptr, interrupted());
        },
        [&](const std::exception& error, int failed) {
          message = error.what();
          return failed;
        });
    for (char& c : message)
      if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    if (!lines.send(std::to_string(code) + " " + message)) return kExitFailed;
    if (code == kExitInterrupted) return code;
  }
}

int run_coupled(const Arguments& arguments, const Communicator& communicator) {
  if (communicator.size() != 1)
    throw InputError(code::kSeveralRanks, "mbd_solver runs on one rank, got " + std::to_string(communicator.size()) +
                                              ": write `: -np 1 mbd_solver ...`");
  TransportMpi transport(communicator, "liggghts_mbd");
  Arguments with_ranks = arguments;
  MPI_Comm_size(MPI_COMM_WORLD, &with_ranks.run.ranks);
  --with_ranks.run.ranks;  // this one
  char version[MPI_MAX_LIBRARY_VERSION_STRING] = "";
  int length = 0;
  MPI_Get_library_version(version, &length);
  with_ranks.run.mpi_version = std::string(version).substr(0, std::string(version).find(','));
  const int code = guarded([&] { return run_with(with_ranks, transport); });
  // MPI_Finalize would wait for a partner that is suspended or hangs.
  if (transport.unanswered()) abort_both_programs(code);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  keep_streams();
  if (argc == 2 && std::string(argv[1]) == "--serve") {
    end_on_signals("mbd_solver");
    return serve();
  }
  CLI::App app{"mbd_solver: flexible multibody mechanisms, alone or on grains of LIGGGHTS"};
  Arguments arguments;
  try {
    arguments = parse(app, argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitDone : kExitBadInput;
  }
  end_on_signals("mbd_solver");
  const auto prepare = [&] {
    prepare_start(argc, argv);
    require_current_folder();
    return kExitDone;
  };
  if (const int code = guarded(prepare); code != kExitDone) return code;

  // MPI is started only under mpirun: scenes without grains need none.
  if (!under_mpirun()) return guarded([&] { return run_alone(arguments); });

  MPI_Init(&argc, &argv);
  const int code = guarded([&] {
    const Communicator communicator;
    AbortGuard::install(communicator);
    if (!communicator.has_partner()) return run_alone(arguments);
    return run_coupled(arguments, communicator);
  });
  AbortGuard::release();
  if (code == kExitFailed) note_failure();
  // MPI_Finalize waits for the partner, which may be suspended, hang, or not know of this end.
  if (code != kExitDone) end_within(kForcedEnd, code);
  MPI_Finalize();
  return code;
}
