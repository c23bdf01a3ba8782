// A partner for liggghts_mbd whose every move is known: bodies with prescribed motion, or one mass on one
// spring, under the mean load. It replaces the multibody program in tests of the grains' side, and it
// can misbehave.
//
//   scripted_partner [option VALUE...] body NAME STL-FILE X Y Z MOTION...  [body ...]
//   scripted_partner [option VALUE...] motion FILE
// Options: scheme NAME, until T [s], out FILE.csv, n N (substeps per window when the script has `every
// auto`), misbehave WHAT:
//   version      answers Hello with another protocol version          die K    kills itself in window K
//   hang K       sleeps for ever in window K                          fail K   reports a failure in window K
//   interrupt K  is stopped by its user in window K, and says so
//   wrong-window K   sends the Motion of another window               not-a-number K  sends NaN in window K
//   lose K       drops the connection in window K without a word, by MPI_Finalize and exit
// MOTION:
//   prescribed VX VY VZ WX WY WZ                 constant velocity of the body's origin [m/s] and angular
//   velocity in W [rad/s] modal VX VY VZ shift|bowl RATE               constant velocity, and one mode that
//   shifts z in B by a (shift) or a (x^2 + y^2) (bowl);
//                                                a = RATE t
//   free MASS STIFFNESS VX VY VZ AX AY AZ        a mass [kg] with this initial velocity on springs [N/m] to a
//   point that is (AX, AY, AZ)
//                                                from its initial place; the exact motion under the window's
//                                                mean force
// FILE, one statement per line, lengths in m, times in s:
//   start T               end T                      of the scene; start is 0 unless a run is resumed
//   scheme NAME
//   body NAME             what follows is about this body
//   node X Y Z            triangle A B C             segment A B RADIUS CHAIN
//   at X Y Z              turned X Y Z               place of Bo, rotation vector, at t = 0
//   velocity X Y Z        spin X Y Z                 constant, in W
//   sway X Y Z OMEGA      one mode: node j of N moves by (X Y Z) (j/(N-1))^2 a, a = sin(OMEGA t); sections turn with the axis

#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "coupler/abort_guard.h"
#include "coupler/base/errors.h"
#include "coupler/base/interrupt.h"
#include "coupler/communicator.h"
#include "coupler/link.h"
#include "coupler/schemes/registry.h"
#include "coupler/transport_mpi.h"
#include "tests/coupled/stl.h"

namespace {

using namespace footfall;

struct Body {
  enum class Kind { kPrescribed, kModal, kSway, kFree };
  std::string name;
  test::Surface surface;
  std::vector<BeamSegment> segments;
  Kind kind = Kind::kPrescribed;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();    // rotation vector at t = 0
  Eigen::Vector3d sway = Eigen::Vector3d::Zero();    // of the last node
  double omega = 0.0;                                // of the sway [rad/s]
  double mass = 0.0, stiffness = 0.0;                // [kg], [N/m]
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  // of the springs, in W [m]
  std::string shape;                                 // of the mode
  double rate = 0.0;                                 // da
  BodyMotion state;
};

struct Options {
  std::string scheme{kDefaultScheme};
  std::string out;
  double start = 0.0, until = 0.0;  // [s]
  int n = 0;
  std::string misbehave;
  long misbehave_at = -1;
  std::vector<Body> bodies;
};

// Statements of a motion file.
void read_motion(const std::string& path, Options& options) {
  std::ifstream file(path);
  if (!file) throw InputError("cannot read " + path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    std::string word;
    if (!(in >> word)) continue;
    const auto vector = [&in](auto& out) { in >> out[0] >> out[1] >> out[2]; };
    Body* const body = options.bodies.empty() ? nullptr : &options.bodies.back();
    if (word == "start") {
      in >> options.start;
    } else if (word == "end") {
      in >> options.until;
    } else if (word == "scheme") {
      in >> options.scheme;
    } else if (word == "body") {
      options.bodies.emplace_back();
      in >> options.bodies.back().name;
    } else if (body == nullptr) {
      throw InputError(path + ": `" + line + "` before the first body");
    } else if (word == "node") {
      Eigen::Matrix3Xd& nodes = body->surface.nodes;
      nodes.conservativeResize(3, nodes.cols() + 1);
      in >> nodes(0, nodes.cols() - 1) >> nodes(1, nodes.cols() - 1) >> nodes(2, nodes.cols() - 1);
    } else if (word == "triangle") {
      vector(body->surface.triangles.emplace_back());
    } else if (word == "segment") {
      BeamSegment& s = body->segments.emplace_back();
      in >> s.start >> s.end >> s.radius >> s.chain;
    } else if (word == "at") {
      vector(body->place);
    } else if (word == "turned") {
      vector(body->turn);
    } else if (word == "velocity") {
      vector(body->v);
    } else if (word == "spin") {
      vector(body->w);
    } else if (word == "sway") {
      body->kind = Body::Kind::kSway;
      vector(body->sway);
      in >> body->omega;
    } else {
      throw InputError(path + ": unknown statement `" + line + "`");
    }
    if (!in) throw InputError(path + ": cannot read `" + line + "`");
  }
}

Options parse(int argc, char** argv) {
  Options options;
  int i = 1;
  const auto next = [&]() -> std::string {
    if (i >= argc) throw InputError("scripted_partner: an argument is missing");
    return argv[i++];
  };
  const auto number = [&] { return std::stod(next()); };
  const auto vector = [&] {
    Eigen::Vector3d value;
    for (double& x : value) x = number();
    return value;
  };
  while (i < argc) {
    const std::string word = next();
    if (word == "scheme") {
      options.scheme = next();
    } else if (word == "until") {
      options.until = number();
    } else if (word == "out") {
      options.out = next();
    } else if (word == "n") {
      options.n = std::stoi(next());
    } else if (word == "misbehave") {
      options.misbehave = next();
      if (options.misbehave != "version") options.misbehave_at = std::stol(next());
    } else if (word == "motion") {
      read_motion(next(), options);
    } else if (word == "body") {
      Body body;
      body.name = next();
      body.surface = test::read_stl(next());
      body.place = vector();
      const std::string motion = next();
      if (motion == "prescribed") {
        body.v = vector();
        body.w = vector();
      } else if (motion == "modal") {
        body.kind = Body::Kind::kModal;
        body.v = vector();
        body.shape = next();
        body.rate = number();
      } else if (motion == "free") {
        body.kind = Body::Kind::kFree;
        body.mass = number();
        body.stiffness = number();
        body.v = vector();
        body.anchor = body.place + vector();
      } else {
        throw InputError("scripted_partner: unknown motion " + motion);
      }
      options.bodies.push_back(body);
    } else {
      throw InputError("scripted_partner: unknown word " + word);
    }
  }
  return options;
}

ModalBoundary boundary(const Body& body) {
  const Eigen::Matrix3Xd& nodes = body.surface.nodes;
  Eigen::MatrixXd Phi, Psi;
  if (body.kind == Body::Kind::kModal || body.kind == Body::Kind::kSway) Phi = Eigen::MatrixXd::Zero(nodes.size(), 1);
  if (body.kind == Body::Kind::kSway) Psi = Phi;
  const Eigen::Vector3d axis = nodes.cols() > 0 ? nodes.rightCols<1>() - nodes.leftCols<1>() : body.place;
  for (Eigen::Index j = 0; Phi.size() > 0 && j < nodes.cols(); ++j) {
    if (body.kind == Body::Kind::kModal) {
      Phi(3 * j + 2, 0) = body.shape == "shift" ? 1.0 : nodes.col(j).head<2>().squaredNorm();
      continue;
    }
    // Displacement d s^2, slope 2 d s / length; the section turns by tangent x slope.
    const double s = static_cast<double>(j) / static_cast<double>(nodes.cols() - 1);
    Phi.middleRows<3>(3 * j) = body.sway * (s * s);
    Psi.middleRows<3>(3 * j) = axis.cross(body.sway) * (2.0 * s / axis.squaredNorm());
  }
  return ModalBoundary(body.name, nodes, body.surface.triangles, body.segments, Phi, Psi);
}

// The state of a body with prescribed motion.
void prescribe(const Body& body, double t, BodyMotion& state) {
  state.r = body.place + t * body.v;
  state.L = turned(turned(Eigen::Vector4d(1.0, 0.0, 0.0, 0.0), body.turn), t * body.w);
  state.dr = body.v;
  state.w = body.w;
  if (body.kind == Body::Kind::kModal) {
    state.a[0] = body.rate * t;
    state.da[0] = body.rate;
  } else if (body.kind == Body::Kind::kSway) {
    state.a[0] = std::sin(body.omega * t);
    state.da[0] = body.omega * std::cos(body.omega * t);
    state.dda[0] = -body.omega * body.omega * std::sin(body.omega * t);
  }
}

// Exact motion of the mass on its spring under a constant force during H.
void integrate_free(const Body& body, const Eigen::Vector3d& F, double H, BodyMotion& state) {
  const Eigen::Vector3d x = state.r - body.anchor;
  if (body.stiffness > 0.0) {
    const double om = std::sqrt(body.stiffness / body.mass), c = std::cos(om * H), s = std::sin(om * H);
    const Eigen::Vector3d rest = F / body.stiffness;
    const Eigen::Vector3d amplitude = x - rest;
    state.r = body.anchor + rest + c * amplitude + (s / om) * state.dr;
    state.dr = c * state.dr - (om * s) * amplitude;
  } else {
    state.r += H * state.dr + (0.5 * H * H / body.mass) * F;
    state.dr += (H / body.mass) * F;
  }
  state.ddr = (F - body.stiffness * (state.r - body.anchor)) / body.mass;
}

// What the grains' program hears from a partner that speaks another protocol.
void answer_in_another_protocol(TransportMpi& transport, const Geometry& geometry) {
  Bytes bytes;
  pack(geometry, bytes);
  const std::int32_t foreign = kProtocolVersion + 998;
  std::memcpy(bytes.data() + 8, &foreign, sizeof foreign);
  transport.send(MessageKind::kGeometry, bytes);
}

// Stopped by the user.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void misbehave(const Options& options) {
  if (options.misbehave == "die") std::raise(SIGKILL);
  if (options.misbehave == "hang")
    for (;;) pause();
  if (options.misbehave == "interrupt") throw Interrupted("stopped by hand");
  if (options.misbehave == "fail") throw NumericalError("the spring of the test broke");
  if (options.misbehave == "lose") {
    MPI_Finalize();
    std::exit(0);
  }
}

struct Output {
  explicit Output(const std::string& path) : file(path) {
    file.precision(17);
    file << "window,time,body,x,y,z,vx,vy,vz,fx,fy,fz,mx,my,mz,q,work,jump_work,ix,iy,iz,contacts,stiffness,"
            "overlap,particles,lost,turn_slope\n";
  }
  void row(const Motion& motion, std::size_t i, const Load& load) {
    const BodyMotion& state = motion.bodies[i];
    const BodyLoad& body = load.bodies[i];
    const auto put = [this](const Eigen::Vector3d& v) { file << "," << v[0] << "," << v[1] << "," << v[2]; };
    file << motion.window << "," << motion.time << "," << i;
    put(state.r);
    put(state.dr);
    put(body.mean.F_W);
    put(body.mean.T_B);
    file << "," << (body.mean.Q_a.size() > 0 ? body.mean.Q_a[0] : 0.0) << "," << body.mean.work << ","
         << body.mean.jump_work;
    put(body.mean.impulse_W);
    file << "," << body.contacts << "," << body.contact_stiffness << "," << body.max_overlap_over_radius << ","
         << load.particles << "," << load.lost << ","  // stiffness against turning about y [N m], of scheme tangent
         << (body.tangent.empty() ? 0.0 : body.tangent[0].K(4, 4)) << "\n";
  }
  std::ofstream file;
};

void couple(const Options& options, TransportMpi& transport, Link& link) {
  Hello hello;
  link.receive_without_limit(hello);
  check_partner(link.partner(), hello.protocol, hello.footfall_version);
  Geometry geometry;
  std::vector<Body> bodies = options.bodies;
  for (Body& body : bodies) {
    ModalBoundary one = boundary(body);
    body.state.resize(one.mode_count());
    prescribe(body, options.start, body.state);
    geometry.bodies.push_back({one, body.state});
  }
  if (options.misbehave == "version") {
    answer_in_another_protocol(transport, geometry);
  } else {
    link.send(geometry);
  }

  Start start;
  link.receive_without_limit(start);
  for (const std::string& warning : start.warnings) std::printf("scripted_partner: warning: %s\n", warning.c_str());
  std::vector<Body*> coupled;  // in the order of Start
  for (const std::string& name : start.bodies)
    for (Body& body : bodies)
      if (body.name == name) coupled.push_back(&body);
  const int n = start.n > 0 ? start.n : options.n;
  const auto steps = static_cast<std::int64_t>(std::llround((options.until - options.start) / start.dt));
  Accept accept;
  accept.scheme = options.scheme;
  accept.t_end = options.start + static_cast<double>(steps) * start.dt;
  accept.n_max = n;
  link.send(accept);

  std::unique_ptr<Output> output;
  if (!options.out.empty()) output = std::make_unique<Output>(options.out);
  Motion motion;
  Load load;
  double initial_energy = 0.0, residual = 0.0;
  for (const Body* body : coupled) initial_energy += 0.5 * body->mass * body->state.dr.squaredNorm();
  for (std::int64_t done = 0; done < steps;) {
    motion.n = static_cast<std::int32_t>(std::min<std::int64_t>(n, steps - done));
    motion.time = options.start + static_cast<double>(done) * start.dt;
    motion.last_window = done + motion.n == steps;
    motion.bodies.clear();
    for (const Body* body : coupled) motion.bodies.push_back(body->state);
    motion.inverse_masses.clear();
    for (const Body* body : coupled)
      if (start.requires_masses)
        motion.inverse_masses.push_back(body->kind == Body::Kind::kFree ? 1.0 / body->mass : 0.0);
    if (motion.window == options.misbehave_at) misbehave(options);
    Motion sent = motion;
    if (motion.window == options.misbehave_at && options.misbehave == "wrong-window") sent.window += 7;
    if (motion.window == options.misbehave_at && options.misbehave == "not-a-number")
      sent.bodies[0].dr[1] = std::numeric_limits<double>::quiet_NaN();
    link.send(sent);
    try {
      link.receive(load);
    } catch (const PartnerError&) {
      if (!start.may_end_early || link.partner_status() != Status::kOk) throw;
      std::printf("scripted_partner: the script has ended in window %lld\n", static_cast<long long>(motion.window));
      return;
    }
    if (load.end_requested) throw Interrupted("the grains' side was asked to end by a signal");
    for (const std::string& warning : load.warnings) std::printf("scripted_partner: warning: %s\n", warning.c_str());
    if (output)
      for (std::size_t i = 0; i < coupled.size(); ++i) output->row(motion, i, load);
    done += motion.n;
    for (std::size_t i = 0; i < coupled.size(); ++i) {
      Body& body = *coupled[i];
      const Eigen::Vector3d before = body.state.r;
      if (body.kind == Body::Kind::kFree) {
        integrate_free(body, load.bodies[i].mean.F_W, motion.n * start.dt, body.state);
        residual += load.bodies[i].mean.work - load.bodies[i].mean.F_W.dot(body.state.r - before);
      } else {
        prescribe(body, options.start + static_cast<double>(done) * start.dt, body.state);
      }
    }
    ++motion.window;
  }
  link.close();
  std::printf("scripted_partner: windows %lld residual %.10g initial energy %.10g\n",
              static_cast<long long>(motion.window), residual, initial_energy);
  for (const Body* body : coupled)
    std::printf("scripted_partner: body %s at %.15g %.15g %.15g velocity %.15g %.15g %.15g\n", body->name.c_str(),
                body->state.r[0], body->state.r[1], body->state.r[2], body->state.dr[0], body->state.dr[1],
                body->state.dr[2]);
}

int run(int argc, char** argv, const Communicator& communicator) {
  std::unique_ptr<TransportMpi> transport;
  std::unique_ptr<Link> link;
  const auto stop = [&](const std::exception& error, int code) {
    std::fprintf(stderr, "scripted_partner: ERROR: %s\n", error.what());
    const Status status = code == kExitBadInput ? Status::kBadInput : Status::kFailed;
    if (link && !link->fail(error.what(), status)) abort_both_programs(code);
    return code;
  };
  try {
    if (!communicator.has_partner()) throw InputError("scripted_partner needs liggghts_mbd under the same mpirun");
    transport = std::make_unique<TransportMpi>(communicator, "liggghts_mbd");
    link = std::make_unique<Link>(*transport, 120.0);
    couple(parse(argc, argv), *transport, *link);
    return kExitDone;
  } catch (const Interrupted& error) {
    link->fail(error.what(), Status::kInterrupted);
    return kExitInterrupted;
  } catch (const InputError& error) {
    return stop(error, kExitBadInput);
  } catch (const ProtocolError& error) {
    return stop(error, kExitBadInput);
  } catch (const std::exception& error) {
    const bool interrupted = link && link->partner_status() == Status::kInterrupted;
    return stop(error, interrupted ? kExitInterrupted : kExitFailed);
  }
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int code = kExitFailed;
  {
    const Communicator communicator;
    AbortGuard::install(communicator);
    code = run(argc, argv, communicator);
    AbortGuard::release();
  }
  MPI_Finalize();
  return code;
}
