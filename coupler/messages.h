#pragma once
// All messages between the two programs: structs, pack and unpack for both. message_fields.h lists the members of each
// struct.
//
//   DEM side                         multibody side
//   Hello  (first fix of ours)   ->  checks versions and units
//                                <-  Geometry (boundaries, modes and initial poses of all coupled bodies)
//   Start  (first run: dt, n)    ->  checks dt, n, names
//                                <-  Accept (scheme, end time)
//   then per window              <-  Motion (position at t_k, rates of the path from there)
//   Load   (means over window)   ->
//   CheckpointDone (after the Load, where Motion required a checkpoint)   ->
//   until a Motion with last_window; after its Load both sides send Close. A side that fails sends Close with its
//   reason at any time.

#include <cstdint>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/body_motion.h"
#include "coupler/codes.h"
#include "coupler/load_average.h"
#include "coupler/modal_boundary.h"
#include "coupler/window.h"

namespace footfall {

inline constexpr std::int32_t kProtocolVersion = 11;
inline constexpr const char* kFootfallVersion = FOOTFALL_VERSION;

// LIGGGHTS' name for SI units, which both programs use.
inline constexpr const char* kUnitStyle = "si";

// Also the MPI tag of the message.
enum class MessageKind : std::int32_t {
  kHello = 1,
  kGeometry,
  kStart,
  kAccept,
  kMotion,
  kLoad,
  kClose,
  kCheckpointDone
};
std::string message_name(MessageKind kind);

// The status word in the head of every message: bytes 12 to 15, after magic, kind and protocol version (four bytes
// each). Its values are the exit codes of the programs, so that both end with the same one.
enum class Status : std::int32_t { kOk = 0, kFailed = 1, kBadInput = 2, kInterrupted = 3 };

using Bytes = std::vector<std::uint8_t>;

// protocol: the sender's version. unpack refuses another one, except in Hello and Close, which every version must read.
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

struct Geometry {
  static constexpr MessageKind kKind = MessageKind::kGeometry;
  std::string footfall_version = kFootfallVersion;
  std::vector<CoupledBody> bodies;  // every body of the scene that grains may touch
  std::string resume;               // folder of the checkpoint from which the run resumes; empty: a new run
};

// A static wall of the script: a mesh, or a plane if it has no corners. Grains touch it from both sides.
struct StaticWall {
  std::string name;                                  // of its fix
  std::vector<Eigen::Vector3d> corners;              // three for each triangle, in W [m]
  Eigen::Vector3d point = Eigen::Vector3d::Zero();   // of the plane, in W [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // of the plane, unit vector in W; zero for a mesh
};

struct Start {
  static constexpr MessageKind kKind = MessageKind::kStart;
  double dt = 0.0;                  // DEM step [s]
  std::int32_t n = 0;               // DEM steps per window; 0: each Motion gives the number ("every auto")
  std::int64_t step = 0;            // LIGGGHTS' step number at the first window
  std::vector<std::string> bodies;  // names coupled by the script; fixes the order in Motion and Load
  // Gravity on the grains by the script's fix gravity; zero without one [m/s2]. Not known: it varies, nothing moves the
  // grains, or the script has `gravity script`.
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  bool gravity_known = false;
  bool may_end_early = false;         // the end of the script may end the coupled run before the scene ends
  std::vector<std::string> warnings;  // for the user; the multibody side prints them
  bool requires_masses = false;       // the DEM side requires Motion::inverse_masses
  std::string dem_version;            // of LIGGGHTS, in its own words
  std::vector<StaticWall> walls;      // which bodies of the scene must not pass
};

struct Accept {
  static constexpr MessageKind kKind = MessageKind::kAccept;
  std::string scheme;      // a name that make_scheme knows
  double t_end = 0.0;      // end of the scene [s]
  std::int32_t n_max = 0;  // largest n of any Motion to come
  double patience = 0.0;   // how long each side waits for the other in a run [s]; 0: the receiver's own value
  std::vector<std::string> held_by_walls;  // bodies in contact with the script's planes and static meshes: [[contacts]]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // of the scene [m/s2]
  bool gravity_known = false;                         // false: it is not compared with the gravity of the grains
  bool outflow = false;                               // grains may leave the box
};

// Meaning of a body's BodyMotion here:
//   r, L, a          the computed state at t_k
//   dr, w, da        rates of the path in this window: the computed ones, except that scheme `tangent` sends the mean
//                    rates that it predicts, and that every scheme reduces the rates of elastic modes that oscillate within
//                    the window
//   ddr, dw, dda     the computed accelerations; zero for such modes in dda
// So r, L, a are the state; dr, w, da and dda need not be.
struct Motion {
  static constexpr MessageKind kKind = MessageKind::kMotion;
  std::int64_t window = 0;  // k, counts from 0
  double time = 0.0;        // t_k [s]
  std::int32_t n = 0;       // DEM steps of this window (the last one may be shorter)
  bool last_window = false;
  std::string checkpoint;    // folder into which the DEM side saves its state after this window; empty: it does not
  bool undisturbed = false;  // it saves only if the run then continues with unchanged bits
  // DEM steps in which the gap between the boundary and r, L, a closes, at least n: no fewer than those that made it.
  std::int32_t closing = 0;
  std::vector<BodyMotion> bodies;  // order of Start; see above
  // For every body whose poses do not depend on the grains: these poses; without columns: the path follows from its
  // motion. Empty: there is no such body.
  std::vector<KnownPath> paths;
  // 1/m of the mass that contacts of each body act on [1/kg], 0: fixed or driven. Empty unless the script requires them.
  std::vector<double> inverse_masses;
};

// Window means of the contacts' tangent stiffness and damping on (r, theta, of W), for linearly implicit schemes.
struct ContactTangent {
  Eigen::Matrix<double, 6, 6> K = Eigen::Matrix<double, 6, 6>::Zero();  // [N/m, N, N m]
  Eigen::Matrix<double, 6, 6> C = Eigen::Matrix<double, 6, 6>::Zero();  // [N s/m, ...]
};

// The largest size of the mean force of a DEM step, in a window.
struct ForcePeak {
  double force = 0.0;      // [N]
  std::int64_t step = 0;   // that DEM step, from 1; 0: none
  std::int64_t steps = 0;  // DEM steps in a row, that one among them, with at least kOfPeak of that force
};
inline constexpr double kOfPeak = 0.9;

struct BodyLoad {
  MeanLoad mean;
  std::int64_t contacts = 0;       // at the window's last DEM step
  double mean_contacts = 0.0;      // over its DEM steps
  double contact_stiffness = 0.0;  // mean over the window of the sum of normal stiffnesses [N/m]; 0 when not estimated
  double max_overlap_over_radius = 0.0;  // largest in the window [-]
  // Radius of the contact patch, sqrt(2 R overlap), over the width of its facet; the largest in the window on curved
  // parts of a mesh [-]
  double max_patch_over_facet = 0.0;
  // Largest values over the grains in contact in the window: m (v^2/2 + g R) + k overlap^2/2, v relative to the body [J];
  // mass [kg]; stiffness of a contact over the mass of its grain [1/s2]. 0 when not known
  double grain_energy = 0.0, grain_mass = 0.0, grain_omega2 = 0.0;
  ForcePeak peak;
  std::vector<ContactTangent> tangent;  // empty, or one
};

// Kinetic energy and m g . x of grains that were inserted, left, or changed otherwise than by forces, since the start.
struct GrainChanges {
  double inserted = 0.0;   // with grains that appeared [J]
  double left = 0.0;       // minus the energy of grains that left the box or were deleted [J]
  double changed = 0.0;    // of grains that a command or fix gave another velocity, place or size [J]
  double lost_mass = 0.0;  // of grains lost by LIGGGHTS [kg]
  // By a bed that follows a body: numbers of grains, and their mass [kg].
  double added = 0.0, removed = 0.0, added_mass = 0.0, removed_mass = 0.0;
};

struct Load {
  static constexpr MessageKind kKind = MessageKind::kLoad;
  std::int64_t window = 0;     // the same k as the Motion it answers
  std::int64_t particles = 0;  // grains now
  std::int64_t lost = 0;       // grains lost by LIGGGHTS since the start; those that the script deleted do not count
  GrainChanges changes;
  std::vector<std::string> warnings;  // new ones, for the user; the multibody side prints them
  bool end_requested = false;  // by a signal to one of its ranks; both programs end after a checkpoint if possible
  // Wall-clock time of the DEM side since its last Load or Accept, with set-up and output, without waiting [s]
  double wall_seconds = 0.0;
  double waited_seconds = 0.0;          // until all ranks had the Motion of this window [s]
  std::vector<BodyLoad> bodies;         // order of Start
  std::vector<std::string> gone_walls;  // of Start::walls: removed, or moving now
};

// The DEM side has finished its part of a checkpoint.
struct CheckpointDone {
  static constexpr MessageKind kKind = MessageKind::kCheckpointDone;
  std::int64_t window = 0;  // of the Motion that required it
  std::int64_t step = 0;    // LIGGGHTS' step number
  bool done = true;         // false: not possible undisturbed; nothing was written
};

struct Close {
  static constexpr MessageKind kKind = MessageKind::kClose;
  Status status = Status::kOk;  // kOk before the last window: the script has ended (Start::may_end_early)
  std::string reason;           // empty when kOk
};

// For Hello and Geometry: throws ProtocolError, naming both values, unless protocol and version are equal to this
// program's.
void check_partner(const std::string& partner, std::int32_t protocol, const std::string& version);

// The bytes of any message, by the lists in message_fields.h. Packing a Motion or Load of unchanged shape into the same
// buffer does not allocate.
template <class Message>
void pack(const Message& message, Bytes& out);

// Throws ProtocolError for anything but a complete message of that kind and of a readable protocol version. Bodies of a
// Motion or Load whose sizes fit are overwritten in place.
template <class Message>
void unpack(const Bytes& bytes, Message& message);

// Place of the first number that is infinite or not a number, in a message or in a part of one: "bodies[0].mean.work",
// "bodies[1].boundary.rho0". Empty when all are finite; then nothing is allocated (except for Geometry and its parts).
template <class Message>
std::string first_not_finite(const Message& message);

// For messages before the first window. Throws NumericalError that names message, sender and place.
template <class Message>
void require_finite(const Message& message, const std::string& sender) {
  if (const std::string place = first_not_finite(message); !place.empty())
    throw NumericalError(code::kMessageNotFinite,
                         "message " + message_name(Message::kKind) + " of " + sender + ": " + place + " is not finite");
}

// Equal to round-off [m/s2].
bool is_same_gravity(const Eigen::Vector3d& script, const Eigen::Vector3d& scene);
// The message when they differ (code::kGravityDiffers). when: " at the start" for gravity that varies, otherwise empty.
std::string gravity_differs(const Eigen::Vector3d& script, const Eigen::Vector3d& scene, const std::string& when);

}  // namespace footfall
