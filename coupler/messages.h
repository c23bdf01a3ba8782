#pragma once
// Every message between the two programs, in one place: struct, pack and unpack are used by both. The members of each
// struct are listed in message_fields.h.
//
//   DEM side                         multibody side
//   Hello  (first fix of ours)   ->  checks versions and units
//                                <-  Geometry (boundaries, modes and initial poses of all coupled bodies)
//   Start  (first run: dt, n)    ->  checks dt, n, names
//                                <-  Accept (scheme, end time)
//   then per window              <-  Motion (place at t_k, rates of the path from there)
//   Load   (means over window)   ->
//   Kept   (where Motion asked for a checkpoint, after its Load)   ->
//   until a Motion says last_window; after its Load both sides send Close. A side that fails sends Close with
//   its reason at any time.

#include <cstdint>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/body_motion.h"
#include "coupler/load_average.h"
#include "coupler/modal_boundary.h"

namespace footfall {

inline constexpr std::int32_t kProtocolVersion = 8;
inline constexpr const char* kFootfallVersion = FOOTFALL_VERSION;

// LIGGGHTS' name of the units that both programs use.
inline constexpr const char* kUnitStyle = "si";

// Also the MPI tag of the message.
enum class MessageKind : std::int32_t { kHello = 1, kGeometry, kStart, kAccept, kMotion, kLoad, kClose, kKept };
std::string message_name(MessageKind kind);

// The status word: stands in the head of every message, bytes 12..15 after magic, kind and protocol version (four bytes
// each). Values as the exit codes of the programs, so that both end with the same one.
enum class Status : std::int32_t { kOk = 0, kFailed = 1, kBadInput = 2, kInterrupted = 3 };

using Bytes = std::vector<std::uint8_t>;

// `protocol` is what the sender speaks; unpack refuses a foreign one (except in Hello and Close, which every version
// must read).
struct Hello {
  static constexpr MessageKind kKind = MessageKind::kHello;
  std::int32_t protocol = kProtocolVersion;
  std::string footfall_version = kFootfallVersion;
  std::string unit_style;  // must be kUnitStyle
};

struct CoupledBody {
  ModalBoundary boundary;
  BodyMotion initial;
};

// (Not "Scene": that is the struct of a scene file, in the same namespace.)
struct Geometry {
  static constexpr MessageKind kKind = MessageKind::kGeometry;
  std::string footfall_version = kFootfallVersion;
  std::vector<CoupledBody> bodies;  // every body of the scene that grains may touch
  std::string resume;               // folder of the checkpoint that the run goes on from; empty: a new run
};

// A wall of the script that stands still: a mesh, or a plane where it has no corners. Grains touch it from both sides.
struct StaticWall {
  std::string name;                                  // of its fix
  std::vector<Eigen::Vector3d> corners;              // three for each triangle, in W [m]
  Eigen::Vector3d point = Eigen::Vector3d::Zero();   // of the plane, in W [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // of the plane, unit vector in W; zero for a mesh
};

struct Start {
  static constexpr MessageKind kKind = MessageKind::kStart;
  double dt = 0.0;                  // substep of the grains [s]
  std::int32_t n = 0;               // substeps per window; 0: each Motion says ("every auto")
  std::int64_t step = 0;            // LIGGGHTS' step number at the first window
  std::vector<std::string> bodies;  // names coupled by the script; fixes the order in Motion and Load
  // Of the grains, by the script's fix gravity; zero where there is none [m/s2]. Unknown: it varies, nothing moves the
  // grains, or the script says that it is its own affair.
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  bool gravity_known = false;
  bool may_end_early = false;         // the script's end may end the coupled run before the scene's
  std::vector<std::string> warnings;  // for the user, who reads them from the mechanism's side
  bool wants_masses = false;          // the grains' side asks for Motion::inverse_masses
  std::string grains_version;         // of LIGGGHTS, as it names itself
  std::vector<StaticWall> walls;      // what bodies of the scene must not go through
};

struct Accept {
  static constexpr MessageKind kKind = MessageKind::kAccept;
  std::string scheme;      // a name that make_scheme knows
  double t_end = 0.0;      // end of the scene [s]
  std::int32_t n_max = 0;  // largest n that any Motion will ask for
  double patience = 0.0;   // how long each side bears the other's silence in a run [s]; 0: as the receiver has it
  std::vector<std::string> held_by_walls;  // bodies that planes and static meshes of the script stop: [[contacts]]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // of the scene [m/s2]
  bool gravity_known = false;                         // else that of the grains is not held against it
};

// What a body's BodyMotion carries here:
//   r, L, a          the computed state at t_k
//   dr, w, da        rates of the path in this window: the computed ones, except that scheme `tangent` sends the mean
//                    rates that it expects, and that every scheme slows down elastic modes that swing within the window
//   ddr, dw, dda     the computed accelerations; dda is taken away from such modes
// So r, L, a may be read as the state; dr, w, da and dda may not.
struct Motion {
  static constexpr MessageKind kKind = MessageKind::kMotion;
  std::int64_t window = 0;  // k, counts from 0
  double time = 0.0;        // t_k [s]
  std::int32_t n = 0;       // substeps of this window (the last one may be shorter)
  bool last_window = false;
  std::string checkpoint;  // folder in which the grains' side keeps itself after this window; empty: it does not
  bool quietly = false;    // it does so without a trace in what follows, or not at all
  std::vector<BodyMotion> bodies;  // order of Start; see above
  // 1/m of the mass that the contacts of each body meet [1/kg], 0: held or led. Empty unless the script asks for them.
  std::vector<double> inverse_masses;
};

// Window means of the contacts' tangent stiffness and damping on (r, theta, of W), for linearly implicit schemes.
struct ContactTangent {
  Eigen::Matrix<double, 6, 6> K = Eigen::Matrix<double, 6, 6>::Zero();  // [N/m, N, N m]
  Eigen::Matrix<double, 6, 6> C = Eigen::Matrix<double, 6, 6>::Zero();  // [N s/m, ...]
};

struct BodyLoad {
  MeanLoad mean;
  std::int64_t contacts = 0;       // at the window's last substep
  double mean_contacts = 0.0;      // over its substeps
  double contact_stiffness = 0.0;  // mean over the window of the sum of normal stiffnesses [N/m]; 0 when not estimated
  double max_overlap_over_radius = 0.0;  // largest in the window [-]
  // sqrt(2 R overlap), the radius of the contact patch, over the width of the facet it stands on, largest in the window
  // on curved parts of a mesh [-]
  double max_patch_over_facet = 0.0;
  std::vector<ContactTangent> tangent;  // empty, or one
};

struct Load {
  static constexpr MessageKind kKind = MessageKind::kLoad;
  std::int64_t window = 0;            // the same k as the Motion it answers
  std::int64_t particles = 0;         // grains now
  std::int64_t lost = 0;              // since the start: grains that LIGGGHTS lost, and that the script did not delete
  std::vector<std::string> warnings;  // new ones; for the user, who reads them from the mechanism's side
  bool asked_to_end = false;  // by a signal to one of its ranks; both programs end after a checkpoint, if they can
  // of the DEM side since its last Load or Accept, set-up and output included, waiting excluded [s]
  double wall_seconds = 0.0;
  double waited_seconds = 0.0;          // for the Motion of this window, from asking until all ranks had it [s]
  std::vector<BodyLoad> bodies;         // order of Start
  std::vector<std::string> gone_walls;  // of Start::walls: no longer there, or they move now
};

// The grains' side has written its files of the checkpoint.
struct Kept {
  static constexpr MessageKind kKind = MessageKind::kKept;
  std::int64_t window = 0;  // that of the Motion that asked for it
  std::int64_t step = 0;    // LIGGGHTS' step number there
  bool done = true;         // false: it could not be done quietly; nothing was written
};

struct Close {
  static constexpr MessageKind kKind = MessageKind::kClose;
  Status status = Status::kOk;  // kOk before the last window: the script has ended, as it may (Start::may_end_early)
  std::string reason;           // empty when kOk
};

// For the two that say who they are (Hello, Geometry): throws ProtocolError, naming both values, unless protocol and
// version are ours.
void check_partner(const std::string& partner, std::int32_t protocol, const std::string& version);

// For every message; the bytes follow from the lists in message_fields.h. One buffer per link is reused: packing a
// Motion or Load of unchanged shape does not allocate.
template <class Message>
void pack(const Message& message, Bytes& out);

// Throws ProtocolError for anything but a whole message of that kind and of a protocol version that is understood. For
// Motion and Load, bodies whose sizes already fit are overwritten in place.
template <class Message>
void unpack(const Bytes& bytes, Message& message);

// The first number in a message or in a part of it that is infinite or not a number, as its place: "bodies[0].mean.work",
// "bodies[1].boundary.rho0". Empty when all are finite; nothing is allocated then (Geometry and its parts excepted).
template <class Message>
std::string first_not_finite(const Message& message);

// For the messages before the first window. Throws NumericalError that names message, sender and place.
template <class Message>
void demand_finite(const Message& message, const std::string& sender) {
  if (const std::string place = first_not_finite(message); !place.empty())
    throw NumericalError("message " + message_name(Message::kKind) + " of " + sender + ": " + place + " is not finite");
}

// The same but for rounding [m/s2].
bool is_same_gravity(const Eigen::Vector3d& script, const Eigen::Vector3d& scene);
// What to say where they differ; without gravity of the script: that the grains have no weight. when: " at the start",
// of one that varies; else empty.
std::string gravity_differs(const Eigen::Vector3d& script, const Eigen::Vector3d& scene, const std::string& when);

}  // namespace footfall
