// A mechanism of one's own on LIGGGHTS' grains: a plate of 4 kg on a spring, whose upper end is let down and shakes.
//   mpirun -np 1 liggghts_mbd -in in.tamper : -np 1 ./tamper > tamper.csv
// The grains' side moves the plate's surface; this side moves the plate. Once per window of n substeps they trade the
// plate's motion for the mean force of the grains on it.
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "coupler/abort_guard.h"
#include "coupler/communicator.h"
#include "coupler/link.h"
#include "coupler/schemes/registry.h"
#include "coupler/transport_mpi.h"

using namespace footfall;

constexpr double kMass = 4.0, kGravity = 9.81, kStiffness = 2e4, kDamping = 60.0;  // [kg], [m/s2], [N/m], [N s/m]
constexpr double kStart = 0.14, kEnd = 1.0;  // of the plate's centre [m], of the run [s]

// The upper end of the spring, less its length: 70 mm down in half a second, then 1 mm up and down, 20 times a second.
double anchor(double t) { return kStart - 0.14 * std::fmin(t, 0.5) + 1e-3 * std::sin(2.0 * M_PI * 20.0 * t); }
double pull(double t, double z, double v) { return kStiffness * (anchor(t) - z) - kDamping * v; }  // [N]

// The plate, 120 x 120 x 20 mm, as grains see it: nodes in its own axes, triangles with their normals outward.
ModalBoundary plate() {
  Eigen::Matrix3Xd nodes(3, 8);
  for (int i = 0; i < 8; ++i) nodes.col(i) << (i & 1 ? 0.06 : -0.06), (i & 2 ? 0.06 : -0.06), (i & 4 ? 0.01 : -0.01);
  using T = Eigen::Vector3i;
  return ModalBoundary("plate", nodes,
                       {T(0, 2, 1), T(1, 2, 3), T(4, 5, 6), T(5, 7, 6), T(0, 1, 4), T(1, 5, 4), T(2, 6, 3), T(3, 6, 7),
                        T(0, 4, 2), T(2, 4, 6), T(1, 3, 5), T(3, 7, 5)});
}

// From t on for H under this force of the grains, by the midpoint rule. Returns the impulse of the spring [N s].
double advance(double t, double H, double force, BodyMotion& m) {
  const double h = H / 20;
  double impulse = 0.0;
  for (int k = 0; k < 20; ++k, t += h) {
    const double half = m.dr.z() + 0.5 * h * ((pull(t, m.r.z(), m.dr.z()) + force) / kMass - kGravity);
    const double middle = pull(t + 0.5 * h, m.r.z() + 0.5 * h * m.dr.z(), half);
    m.r.z() += h * half;
    m.dr.z() += h * ((middle + force) / kMass - kGravity);
    impulse += h * middle;
  }
  m.ddr.z() = (pull(t, m.r.z(), m.dr.z()) + force) / kMass - kGravity;
  return impulse;
}

void run(Link& link) {
  BodyMotion now;
  now.r.z() = kStart;
  Hello hello;
  link.receive_without_limit(hello);  // the script comes to its first fix of ours once the bed has settled
  check_partner(link.partner(), hello.protocol, hello.footfall_version);
  link.send(Geometry{kFootfallVersion, {{plate(), now}}, ""});
  Start start;
  link.receive_without_limit(start);
  const long steps = std::lround(kEnd / start.dt);
  link.send(Accept{std::string(kDefaultScheme), static_cast<double>(steps) * start.dt, start.n, 60.0});
  Motion motion;
  Load load;
  double impulse = 0.0;  // of all forces on the plate [N s]
  std::printf("time,z,vz,force\n");
  for (long done = 0; done < steps; ++motion.window, done += motion.n) {
    motion.time = static_cast<double>(done) * start.dt;
    motion.n = static_cast<int>(std::min<long>(start.n, steps - done));
    motion.last_window = done + motion.n == steps;
    motion.bodies = {now};
    link.send(motion);
    link.receive(load);
    const double H = motion.n * start.dt, force = load.bodies[0].mean.F_W.z();
    impulse += H * (force - kMass * kGravity) + advance(motion.time, H, force, now);
    std::printf("%.6f,%.6f,%.6f,%.3f\n", motion.time + H, now.r.z(), now.dr.z(), force);
  }
  link.close();
  std::fprintf(stderr, "momentum %.9f N s, impulse %.9f N s\n", kMass * now.dr.z(), impulse);
}

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const Communicator communicator;
  if (!communicator.has_partner())
    return std::fprintf(stderr, "tamper: start it together with liggghts_mbd, see above\n"), 2;
  AbortGuard::install(communicator);
  TransportMpi transport(communicator, "liggghts_mbd");
  Link link(transport, 60.0);
  int code = 0;
  try {
    run(link);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tamper: %s\n", error.what());
    code = 1;
    if (!link.fail(error.what())) abort_both_programs(code);
  }
  AbortGuard::release();
  MPI_Finalize();
  return code;
}
