// mbd_solver as it is, with every number of its coupled body written down in every window, with all digits.
//   recording_solver SCENE TABLE.csv [key=value ...]
// A row at the start and after every window: time, state of the body then (r, L, a, dr, w, da, dda), what it got from
// the grains over the window (F_W, T_B, Q_a), the work that they did on its boundary and the work that it received,
// both since the start.

#include <mpi.h>

#include <csignal>
#include <cstdio>
#include <fstream>

#include "coupler/abort_guard.h"
#include "coupler/base/errors.h"
#include "coupler/communicator.h"
#include "coupler/transport_mpi.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/simulation.h"

namespace {

using namespace footfall;

class Table {
 public:
  Table(const std::string& path, const Simulation& simulation)
      : simulation_(simulation),
        body_(simulation.mechanism().boundaries.at(0).body),
        motion_(simulation.mechanism().model.body(body_).mode_count()),
        file_(path) {
    file_.precision(17);
    file_ << "time";
    for (const char* name : {"x", "y", "z", "l0", "l1", "l2", "l3"}) file_ << "," << name;
    modal("a");
    for (const char* name : {"vx", "vy", "vz", "wx", "wy", "wz"}) file_ << "," << name;
    modal("da");
    modal("dda");
    for (const char* name : {"fx", "fy", "fz", "mx", "my", "mz"}) file_ << "," << name;
    modal("q");
    file_ << ",work,received\n";
  }
  void write(const Sample& sample) {
    fill_motion(sample.kinematics.of(body_), motion_);
    file_ << sample.state.time;
    put(motion_.r);
    put(motion_.L);
    put(motion_.a);
    put(motion_.dr);
    put(motion_.w);
    put(motion_.da);
    put(motion_.dda);
    const ExternalLoad& load = sample.inputs.loads[static_cast<std::size_t>(body_)];
    put(load.F_W);
    put(load.T_B);
    put(load.Q_a.size() > 0 ? load.Q_a : Eigen::VectorXd(Eigen::VectorXd::Zero(motion_.mode_count())));
    if (sample.window > 0) work_ += simulation_.coupled()->load().bodies.at(0).mean.work;
    file_ << "," << work_ << "," << sample.state.load_work(body_) << "\n";
  }

 private:
  void modal(const std::string& name) {
    for (int k = 0; k < motion_.mode_count(); ++k) file_ << "," << name << k;
  }
  void put(const Eigen::VectorXd& x) {
    for (Eigen::Index i = 0; i < x.size(); ++i) file_ << "," << x[i];
  }

  const Simulation& simulation_;
  int body_;
  BodyMotion motion_;
  std::ofstream file_;
  double work_ = 0.0;  // [J]
};

int run(int argc, char** argv, const Communicator& communicator) {
  TransportMpi transport(communicator, "liggghts_mbd");
  const volatile std::sig_atomic_t never = 0;
  const Scene scene = read_scene(argv[1], std::vector<std::string>(argv + 3, argv + argc));
  Simulation simulation(scene, scene.end_time, &transport);
  Table table(argv[2], simulation);
  simulation.run([&table](const Sample& sample) { table.write(sample); }, never);
  return kExitDone;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int code = kExitFailed;
  {
    const Communicator communicator;
    AbortGuard::install(communicator);
    try {
      if (argc < 3 || !communicator.has_partner())
        throw InputError("recording_solver SCENE TABLE [key=value ...], with liggghts_mbd under the same mpirun");
      code = run(argc, argv, communicator);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "recording_solver: ERROR: %s\n", error.what());
      abort_both_programs(code);
    }
    AbortGuard::release();
  }
  MPI_Finalize();
  return code;
}
