// One of two programs under one mpirun, for tests of the communicator: pair ROLE SCENARIO. Roles: grains,
// body.

#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <string>

#include "coupler/abort_guard.h"
#include "coupler/base/errors.h"
#include "coupler/communicator.h"
#include "coupler/link.h"
#include "coupler/transport_mpi.h"

namespace {

using namespace footfall;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Windows of a motion of this many modes; every rank of the grains' side must get the same.
void exchange(Link& link, const Communicator& communicator, bool grains, int windows, int modes) {
  Motion motion;
  Load load;
  for (int k = 0; k < windows; ++k) {
    if (grains) {
      link.receive(motion);
      double sum = motion.bodies[0].a.sum(), highest = sum, lowest = sum;
      MPI_Allreduce(MPI_IN_PLACE, &highest, 1, MPI_DOUBLE, MPI_MAX, communicator.world());
      MPI_Allreduce(MPI_IN_PLACE, &lowest, 1, MPI_DOUBLE, MPI_MIN, communicator.world());
      if (highest != lowest || motion.window != k) throw ProtocolError("ranks got different motions");
      load.window = k;
      load.bodies.resize(1);
      load.bodies[0].mean = MeanLoad(modes);
      load.bodies[0].mean.Q_a.setConstant(sum);
      link.send(load);
    } else {
      motion.window = k;
      motion.bodies.assign(1, BodyMotion(modes));
      motion.bodies[0].a.setConstant(k + 0.5);
      link.send(motion);
      link.receive(load);
      if (load.window != k || load.bodies[0].mean.Q_a[modes - 1] != motion.bodies[0].a.sum())
        throw ProtocolError("the load does not answer the motion");
    }
  }
  link.close();
}

int run(const std::string& role, const std::string& scenario, const Communicator& communicator) {
  const bool grains = role == "grains";
  if (scenario == "who") {
    std::printf("%s rank %d of %d partner %d\n", role.c_str(), communicator.rank(), communicator.size(),
                communicator.has_partner() ? communicator.partner_root() : -1);
    return kExitDone;
  }
  TransportMpi transport(communicator, grains ? "body" : "grains");
  Link link(transport, 20.0);
  if (scenario == "exchange") {
    exchange(link, communicator, grains, 200, 3);
  } else if (scenario == "large") {
    exchange(link, communicator, grains, 2, 300000);  // 7 MB a motion
  } else if (scenario == "wait") {
    // The body side thinks for two seconds: the grains' side must not burn a core meanwhile.
    Motion motion;
    if (grains) {
      const double before = cpu_seconds();
      link.receive(motion);
      std::printf("grains rank %d used %.3f s of processor time\n", communicator.rank(), cpu_seconds() - before);
    } else {
      const struct timespec two = {2, 0};
      nanosleep(&two, nullptr);
      link.send(motion);
    }
    link.close();
  } else if (scenario == "vanish" || scenario == "last-words") {
    if (grains) {
      if (scenario == "last-words")
        AbortGuard::set_final_message([&] {
          transport.stop_forwarding();
          return link.fail("the script is wrong");
        });
      MPI_Finalize();  // as LIGGGHTS ends on an error
      std::exit(1);
    }
    Load load;
    link.receive(load);
  }
  return kExitDone;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const std::string role = argc > 1 ? argv[1] : "", scenario = argc > 2 ? argv[2] : "";
  int code = kExitFailed;
  try {
    const Communicator communicator;
    AbortGuard::install(communicator);
    code = run(role, scenario, communicator);
    AbortGuard::release();
  } catch (const std::exception& error) {
    std::printf("%s: %s\n", role.c_str(), error.what());
    std::fflush(stdout);
    AbortGuard::release();
  }
  MPI_Finalize();
  return code;
}
