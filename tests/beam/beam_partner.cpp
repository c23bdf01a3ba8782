// A multibody side for tests of the grains' side: bodies that move as a text file says, whatever the grains
// do to them.
//   mpirun -np N liggghts_mbd -in in.script : -np 1 beam_partner motion.txt loads.csv
//
// motion.txt, one statement per line, lengths in m, times in s:
//   start T               end T                      of the scene; start is 0 unless a run is resumed
//   scheme NAME                                      css-trapezoid unless said otherwise
//   body NAME             what follows is about this body
//   node X Y Z            triangle A B C             segment A B RADIUS CHAIN
//   at X Y Z              turned X Y Z               place of Bo, rotation vector, at t = 0
//   velocity X Y Z        spin X Y Z                 constant, in W
//   sway X Y Z OMEGA      one mode: node j of N moves by (X Y Z) (j/(N-1))^2 a, a = sin(OMEGA t); sections
//   turn with the axis
// loads.csv: a line per window and body: window, body, mean force (3), mean moment about Bo in B (3), mean
// modal force, work, contacts.
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "coupler/abort_guard.h"
#include "coupler/base/errors.h"
#include "coupler/communicator.h"
#include "coupler/link.h"
#include "coupler/transport_mpi.h"

namespace {

using namespace footfall;

struct ScriptedBody {
  std::string name;
  std::vector<Eigen::Vector3d> nodes;
  std::vector<Eigen::Vector3i> triangles;
  std::vector<BeamSegment> segments;
  Eigen::Vector3d at = Eigen::Vector3d::Zero(), turned = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), spin = Eigen::Vector3d::Zero();
  Eigen::Vector3d sway = Eigen::Vector3d::Zero();
  double omega = 0.0;

  bool sways() const { return !sway.isZero(0.0); }

  ModalBoundary boundary() const {
    const Eigen::Index count = static_cast<Eigen::Index>(nodes.size());
    Eigen::Matrix3Xd rho0(3, count);
    Eigen::MatrixXd Phi, Psi;
    if (sways()) {
      Phi.setZero(3 * count, 1);
      Psi.setZero(3 * count, 1);
    }
    for (Eigen::Index j = 0; j < count; ++j) {
      rho0.col(j) = nodes[static_cast<std::size_t>(j)];
      if (!sways()) continue;
      // Displacement d s^2, slope 2 d s / length; the section turns by tangent x slope.
      const double s = static_cast<double>(j) / static_cast<double>(count - 1);
      const Eigen::Vector3d axis = nodes.back() - nodes.front();
      Phi.middleRows<3>(3 * j) = sway * (s * s);
      Psi.middleRows<3>(3 * j) = axis.cross(sway) * (2.0 * s / axis.squaredNorm());
    }
    return ModalBoundary(name, rho0, triangles, segments, Phi, Psi);
  }

  BodyMotion motion(double t) const {
    BodyMotion m(sways() ? 1 : 0);
    m.r = at + t * velocity;
    m.L = footfall::turned(footfall::turned(Eigen::Vector4d(1.0, 0.0, 0.0, 0.0), turned), t * spin);
    m.dr = velocity;
    m.w = spin;
    if (sways()) {
      m.a[0] = std::sin(omega * t);
      m.da[0] = omega * std::cos(omega * t);
      m.dda[0] = -omega * omega * std::sin(omega * t);
    }
    return m;
  }
};

struct Plan {
  double start = 0.0, end = 0.0;  // [s]
  std::string scheme = "css-trapezoid";
  std::vector<ScriptedBody> bodies;
};

Plan read(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError("cannot read " + path);
  Plan plan;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream in(line);
    std::string word;
    if (!(in >> word)) continue;
    const auto vector = [&in](Eigen::Vector3d& out) { in >> out.x() >> out.y() >> out.z(); };
    if (word == "start") {
      in >> plan.start;
    } else if (word == "end") {
      in >> plan.end;
    } else if (word == "scheme") {
      in >> plan.scheme;
    } else if (word == "body") {
      plan.bodies.emplace_back();
      in >> plan.bodies.back().name;
    } else {
      if (plan.bodies.empty()) throw InputError(path + ": `" + line + "` before the first body");
      ScriptedBody& body = plan.bodies.back();
      if (word == "node") {
        vector(body.nodes.emplace_back());
      } else if (word == "triangle") {
        Eigen::Vector3i& t = body.triangles.emplace_back();
        in >> t[0] >> t[1] >> t[2];
      } else if (word == "segment") {
        BeamSegment& s = body.segments.emplace_back();
        in >> s.start >> s.end >> s.radius >> s.chain;
      } else if (word == "at") {
        vector(body.at);
      } else if (word == "turned") {
        vector(body.turned);
      } else if (word == "velocity") {
        vector(body.velocity);
      } else if (word == "spin") {
        vector(body.spin);
      } else if (word == "sway") {
        vector(body.sway);
        in >> body.omega;
      } else {
        throw InputError(path + ": unknown statement `" + line + "`");
      }
    }
    if (!in) throw InputError(path + ": cannot read `" + line + "`");
  }
  return plan;
}

void write(std::FILE* out, const Load& load, const Start& start) {
  for (std::size_t i = 0; i < load.bodies.size(); ++i) {
    const BodyLoad& body = load.bodies[i];
    const MeanLoad& mean = body.mean;
    std::fprintf(out, "%lld,%s", static_cast<long long>(load.window), start.bodies[i].c_str());
    for (int c = 0; c < 3; ++c) std::fprintf(out, ",%.17g", mean.F_W[c]);
    for (int c = 0; c < 3; ++c) std::fprintf(out, ",%.17g", mean.T_B[c]);
    std::fprintf(out, ",%.17g,%.17g,%lld\n", mean.Q_a.size() > 0 ? mean.Q_a[0] : 0.0, mean.work,
                 static_cast<long long>(body.contacts));
  }
}

void play(const Plan& plan, Link& link, std::FILE* out) {
  Hello hello;
  link.receive_patiently(hello);
  Geometry geometry;
  for (const ScriptedBody& body : plan.bodies) geometry.bodies.push_back({body.boundary(), body.motion(plan.start)});
  link.send(geometry);
  Start start;
  link.receive_patiently(start);
  std::vector<const ScriptedBody*> coupled;
  for (const std::string& name : start.bodies)
    for (const ScriptedBody& body : plan.bodies)
      if (body.name == name) coupled.push_back(&body);
  FOOTFALL_DEMAND(coupled.size() == start.bodies.size());
  Accept accept;
  accept.scheme = plan.scheme;
  accept.t_end = plan.end;
  accept.n_max = start.n;
  link.send(accept);

  const long steps = std::lround((plan.end - plan.start) / start.dt);
  Motion motion;
  Load load;
  for (long done = 0; done < steps; done += motion.n, ++motion.window) {
    motion.time = plan.start + static_cast<double>(done) * start.dt;
    motion.n = static_cast<int>(std::min<long>(start.n, steps - done));
    motion.last_window = done + motion.n == steps;
    motion.bodies.clear();
    for (const ScriptedBody* body : coupled) motion.bodies.push_back(body->motion(motion.time));
    link.send(motion);
    link.receive_patiently(load);
    write(out, load, start);
  }
  link.close();
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int code = kExitDone;
  {
    const Communicator communicator;
    AbortGuard::install(communicator);
    try {
      if (argc != 3 || !communicator.has_partner()) throw InputError("usage: see beam_partner.cpp");
      TransportMpi transport(communicator, "liggghts_mbd");
      Link link(transport);
      std::FILE* out = std::fopen(argv[2], "w");
      if (out == nullptr) throw InputError(std::string("cannot write ") + argv[2]);
      try {
        const Plan plan = read(argv[1]);
        play(plan, link, out);
      } catch (const std::exception& error) {
        link.fail(error.what());
        throw;
      }
      std::fclose(out);
    } catch (const std::exception& error) {
      std::cerr << "beam_partner: " << error.what() << std::endl;
      code = kExitFailed;
    }
    AbortGuard::release();
  }
  MPI_Finalize();
  return code;
}
