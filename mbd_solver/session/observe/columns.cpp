// Each table lists names, units and values of columns that belong to one thing (a body, a joint, ...). A scene has those
// of its parts, in the order of history_columns().

#include "mbd_solver/session/observe/columns.h"

#include <algorithm>

#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/strut.h"

namespace footfall {
namespace {

double itself(const double& x) { return x; }

// ---- the registry: a column is an entry here and a line in docs/reference/history.md ----

constexpr Entry<Sample> kTime[] = {{"time", "s", [](const Sample& s) { return s.state.time; }}};

constexpr Entry<FlexibleMetrics> kFlexible[] = {
    {"<body>.strain_energy", "J", [](const FlexibleMetrics& f) { return f.strain_energy; }},
    {"<body>.deflection", "m", [](const FlexibleMetrics& f) { return f.deflection; }},
    {"<body>.von_mises", "Pa", [](const FlexibleMetrics& f) { return f.von_mises; }}};

constexpr Entry<GeneralizedForce> kContact[] = {
    {"<body>.contact.fx", "N", [](const GeneralizedForce& Q) { return Q.F_W.x(); }},
    {"<body>.contact.fy", "N", [](const GeneralizedForce& Q) { return Q.F_W.y(); }},
    {"<body>.contact.fz", "N", [](const GeneralizedForce& Q) { return Q.F_W.z(); }},
    {"<body>.contact.mx", "N m", [](const GeneralizedForce& Q) { return Q.T_W.x(); }},
    {"<body>.contact.my", "N m", [](const GeneralizedForce& Q) { return Q.T_W.y(); }},
    {"<body>.contact.mz", "N m", [](const GeneralizedForce& Q) { return Q.T_W.z(); }}};

// On mode <k> of a flexible body, counted from 1.
constexpr Entry<double> kModalForce[] = {{"<body>.contact.mode_<k>", "J", itself}};

constexpr Entry<CoordinateValue> kAngle[] = {
    {"<joint>.angle", "rad", [](const CoordinateValue& q) { return q.value; }},
    {"<joint>.angle_rate", "rad/s", [](const CoordinateValue& q) { return q.rate; }}};

constexpr Entry<CoordinateValue> kDisplacement[] = {
    {"<joint>.displacement", "m", [](const CoordinateValue& q) { return q.value; }},
    {"<joint>.displacement_rate", "m/s", [](const CoordinateValue& q) { return q.rate; }}};

constexpr Entry<CoordinateValue> kDisplacementX[] = {
    {"<joint>.displacement_x", "m", [](const CoordinateValue& q) { return q.value; }},
    {"<joint>.displacement_x_rate", "m/s", [](const CoordinateValue& q) { return q.rate; }}};

constexpr Entry<CoordinateValue> kDisplacementY[] = {
    {"<joint>.displacement_y", "m", [](const CoordinateValue& q) { return q.value; }},
    {"<joint>.displacement_y_rate", "m/s", [](const CoordinateValue& q) { return q.rate; }}};

constexpr Entry<Vector6d> kReaction[] = {{"<joint>.fx", "N", [](const Vector6d& R) { return R(0); }},
                                         {"<joint>.fy", "N", [](const Vector6d& R) { return R(1); }},
                                         {"<joint>.fz", "N", [](const Vector6d& R) { return R(2); }},
                                         {"<joint>.mx", "N m", [](const Vector6d& R) { return R(3); }},
                                         {"<joint>.my", "N m", [](const Vector6d& R) { return R(4); }},
                                         {"<joint>.mz", "N m", [](const Vector6d& R) { return R(5); }}};

constexpr Entry<JointForceSample> kDriveTorque[] = {
    {"<drive>.joint_torque", "N m", [](const JointForceSample& s) { return s.force; }}};
constexpr Entry<JointForceSample> kDriveForce[] = {
    {"<drive>.joint_force", "N", [](const JointForceSample& s) { return s.force; }}};
constexpr Entry<JointForceSample> kDrivePower[] = {
    {"<drive>.power", "W", [](const JointForceSample& s) { return s.supply; }}};

// On the first coordinate of the gear.
constexpr Entry<double> kGearTorque[] = {{"<gear>.torque", "N m", itself}};
constexpr Entry<double> kGearForce[] = {{"<gear>.force", "N", itself}};

constexpr Entry<StrutSample> kStrut[] = {{"<strut>.stroke", "m", [](const StrutSample& s) { return s.stroke; }},
                                         {"<strut>.rate", "m/s", [](const StrutSample& s) { return s.rate; }},
                                         {"<strut>.force", "N", [](const StrutSample& s) { return s.force; }}};

constexpr Entry<double> kControllerOutput[] = {{"<controller>.<output>", "-", itself}};

constexpr Entry<double> kSignal[] = {{"signal.<signal>", "-", itself}};
constexpr Entry<double> kState[] = {{"state.<state>", "-", itself}};
constexpr Entry<double> kStateSince[] = {{"state.since", "s", itself}};

constexpr Entry<LandingValues> kLanding[] = {
    {"landing.stability_distance", "m", [](const LandingValues& l) { return l.stability_distance; }},
    {"landing.tip_energy_margin", "J", [](const LandingValues& l) { return l.tip_energy_margin; }},
    {"landing.tilt", "rad", [](const LandingValues& l) { return l.tilt; }},
    {"landing.slid", "m", [](const LandingValues& l) { return l.slid; }},
    {"landing.pads_touching", "-", [](const LandingValues& l) { return static_cast<double>(l.pads_touching); }},
    {"landing.struts_at_stops", "-", [](const LandingValues& l) { return static_cast<double>(l.struts_at_stops); }}};
constexpr Entry<double> kClearance[] = {{"landing.clearance.<point>", "m", itself}};

constexpr Entry<double> kStored[] = {{"energy.<form>", "J", itself}};
constexpr Entry<StoredEnergy> kEnergyTotal[] = {{"energy.total", "J", [](const StoredEnergy& E) { return E.total(); }}};

constexpr Entry<double> kDissipated[] = {{"dissipated.<kind>", "J", itself}};

constexpr Entry<State> kWork[] = {{"work.contact", "J", [](const State& s) { return s.load_work.sum(); }}};
constexpr Entry<double> kSupplied[] = {{"work.<source>", "J", itself}};

constexpr Entry<CouplingSample> kCoupling[] = {
    {"coupling.energy_error", "J", [](const CouplingSample& c) { return c.energy_residual; }},
    {"coupling.substeps", "-", [](const CouplingSample& c) { return static_cast<double>(c.substeps); }},
    {"coupling.grains_inserted", "J", [](const CouplingSample& c) { return c.changes.inserted; }},
    {"coupling.grains_left", "J", [](const CouplingSample& c) { return c.changes.left; }},
    {"coupling.grains_changed", "J", [](const CouplingSample& c) { return c.changes.changed; }}};

constexpr Entry<CouplingSample> kFollowingBed[] = {
    {"bed.grains_added", "-", [](const CouplingSample& c) { return c.changes.added; }},
    {"bed.grains_removed", "-", [](const CouplingSample& c) { return c.changes.removed; }},
    {"bed.mass_added", "kg", [](const CouplingSample& c) { return c.changes.added_mass; }},
    {"bed.mass_removed", "kg", [](const CouplingSample& c) { return c.changes.removed_mass; }}};

constexpr Entry<CouplingSample> kChosenWindows[] = {
    {"coupling.estimate", "-", [](const CouplingSample& c) { return c.estimate; }}};

constexpr Entry<double> kOmegaH[] = {{"coupling.omega_h.<body>", "-", itself}};

template <class Visit>
void for_each_table(Visit visit) {
  visit(kTime), visit(kBodyEntries), visit(kAttitudeEntries), visit(kFlexible), visit(kContact), visit(kModalForce),
      visit(kAngle), visit(kDisplacement), visit(kDisplacementX), visit(kDisplacementY), visit(kReaction),
      visit(kDriveTorque), visit(kDriveForce), visit(kDrivePower), visit(kGearTorque), visit(kGearForce), visit(kStrut),
      visit(kCableEntries), visit(kControllerOutput), visit(kSignal), visit(kState), visit(kStateSince),
      visit(kLanding), visit(kClearance);
  visit(kStored), visit(kEnergyTotal);
  visit(kDissipated), visit(kWork), visit(kSupplied), visit(kCoupling), visit(kFollowingBed), visit(kChosenWindows),
      visit(kOmegaH);
}

// ---- from the registry to the columns of a scene ----

// The pattern with <...> replaced, in its order, by these names.
std::string with_names(std::string pattern, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::size_t first = pattern.find('<');
    pattern.replace(first, pattern.find('>') - first + 1, name);
  }
  return pattern;
}

class Columns {
 public:
  // A column per entry; thing(sample) is what the entries read.
  template <class Thing, std::size_t count, class Get>
  void add(const Entry<Thing> (&entries)[count], const std::vector<std::string>& names, Get thing,
           Column::Reads reads = Column::Reads::kSample) {
    for (const Entry<Thing>& entry : entries)
      columns.push_back({with_names(entry.pattern, names), entry.unit, entry.pattern,
                         [thing, value = entry.value](const Sample& s) { return value(thing(s)); }, reads});
  }
  std::vector<Column> columns;
};

bool recorded(const OutputSpec& output, const std::string& body) {
  return output.bodies.empty() || std::find(output.bodies.begin(), output.bodies.end(), body) != output.bodies.end();
}

// Prescribed motions have a column in every history.
bool has_work_column(const Scene& scene, Supply source) {
  switch (source) {
    case Supply::kMotion: return true;
    case Supply::kForce: return !scene.forces.empty();
    case Supply::kDrive: return !scene.drives.empty();
  }
  return false;
}

void add_coupling(const Subject& subject, Columns& out) {
  const auto coupling = [](const Sample& s) -> const CouplingSample& { return *s.coupling; };
  out.add(kCoupling, {}, coupling);
  const auto& grains = subject.scene.particles;
  if (grains && grains->box && !grains->box->follow.empty()) out.add(kFollowingBed, {}, coupling);
  if (subject.agreement->substeps == 0) out.add(kChosenWindows, {}, coupling);
  for (std::size_t k = 0; k < subject.agreement->boundaries.size(); ++k) {
    const std::size_t boundary = subject.agreement->boundaries[k];
    out.add(kOmegaH, {subject.mechanism.boundaries[boundary].boundary.name()},
            [k](const Sample& s) { return s.coupling->omega_h[k]; });
  }
}

void add_joints(const Subject& subject, const JointObserver& joints, Columns& out) {
  const Mechanism& mechanism = subject.mechanism;
  for (std::size_t k = 0; subject.scene.output.joints && k < mechanism.coordinates.size(); ++k) {
    const CoordinateEntry& entry = mechanism.coordinates[k];
    const auto coordinate = [k, &joints](const Sample&) -> const CoordinateValue& { return joints.coordinate(k); };
    switch (entry.coordinate) {
      case Coordinate::kAngle: out.add(kAngle, {entry.name}, coordinate, Column::Reads::kJoints); break;
      case Coordinate::kDisplacement: out.add(kDisplacement, {entry.name}, coordinate, Column::Reads::kJoints); break;
      case Coordinate::kDisplacementX: out.add(kDisplacementX, {entry.name}, coordinate, Column::Reads::kJoints); break;
      case Coordinate::kDisplacementY: out.add(kDisplacementY, {entry.name}, coordinate, Column::Reads::kJoints); break;
    }
  }
  for (std::size_t j = 0; subject.scene.output.reactions && j < subject.scene.joints.size(); ++j)
    out.add(
        kReaction, {subject.scene.joints[j].name},
        [j, &joints](const Sample&) -> const Vector6d& { return joints.reaction(j); }, Column::Reads::kJoints);
  for (const DriveEntry& drive : mechanism.drives) {
    const auto sample = [subject, force = drive.force](const Sample& s) { return sample_of(force, subject, s); };
    if (drive.coordinate == Coordinate::kAngle) {
      out.add(kDriveTorque, {drive.name}, sample);
    } else {
      out.add(kDriveForce, {drive.name}, sample);
    }
    out.add(kDrivePower, {drive.name}, sample);
  }
  for (const GearEntry& gear : mechanism.gears) {
    const int row = subject.layout.joint_row[gear.joint];
    const auto reaction = [row, count = subject.layout.row_count](const Sample& s) {
      return -s.rates.tail(count)[row];
    };
    if (gear.coordinate == Coordinate::kAngle) {
      out.add(kGearTorque, {gear.name}, reaction);
    } else {
      out.add(kGearForce, {gear.name}, reaction);
    }
  }
}

}  // namespace

std::vector<Column> history_columns(const Subject& subject, const FlexibleBodies& flexible, const JointObserver& joints,
                                    const LandingWatch* landing) {
  const Mechanism& mechanism = subject.mechanism;
  Columns out;
  out.add(kTime, {}, [](const Sample& s) -> const Sample& { return s; });
  for (int i = 0; i < mechanism.model.body_count(); ++i) {
    const std::string& name = mechanism.model.body(i).name();
    if (!recorded(subject.scene.output, name)) continue;
    const auto body = [i](const Sample& s) -> const BodyKinematics& { return s.kinematics.of(i); };
    out.add(kBodyEntries, {name}, body);
    if (subject.scene.output.attitudes) out.add(kAttitudeEntries, {name}, body);
    if (const int k = flexible.find(i); k >= 0)
      out.add(
          kFlexible, {name}, [k, &flexible](const Sample&) -> const FlexibleMetrics& { return flexible.now(k); },
          Column::Reads::kFlexible);
  }
  if (subject.scene.ground.kind != GroundKind::kNone || !mechanism.contacts.empty())
    for (const BodyBoundary& entry : mechanism.boundaries) {
      const std::size_t i = entry.body;
      out.add(kContact, {entry.boundary.name()},
              [i](const Sample& s) -> const GeneralizedForce& { return s.contact[i]; });
      if (!subject.scene.output.modal_forces) continue;
      for (int k = 0; k < mechanism.model.body(entry.body).mode_count(); ++k)
        out.add(kModalForce, {entry.boundary.name(), std::to_string(k + 1)},
                [i, k](const Sample& s) { return s.contact[i].Q_a[k]; });
    }
  add_joints(subject, joints, out);
  for (const StrutEntry& strut : mechanism.struts)
    out.add(kStrut, {strut.name},
            [subject, force = strut.force](const Sample& s) { return sample_of(force, subject, s); });
  for (const CableEntry& cable : mechanism.cables)
    out.add(kCableEntries, {cable.name},
            [subject, force = cable.force](const Sample& s) { return sample_of(force, subject, s); });
  for (const ControllerEntry& controller : mechanism.controllers)
    for (std::size_t k = 0; k < controller.outputs.size(); ++k)
      out.add(kControllerOutput, {controller.name, controller.outputs[k]},
              [i = controller.first_input + static_cast<int>(k)](const Sample& s) { return s.inputs.values(i); });
  for (const PlaceEntry& signal : mechanism.signals)
    out.add(kSignal, {signal.name}, [i = signal.place](const Sample& s) { return s.values(i); });
  for (const PlaceEntry& state : mechanism.states)
    out.add(kState, {state.name}, [i = state.place](const Sample& s) { return s.values(i); });
  if (mechanism.state_since >= 0)
    out.add(kStateSince, {}, [i = mechanism.state_since](const Sample& s) { return s.state.time - s.values(i); });
  if (landing != nullptr) {
    const auto values = [landing](const Sample&) -> const LandingValues& { return landing->now(); };
    out.add(kLanding, {}, values, Column::Reads::kLanding);
    for (std::size_t k = 0; k < subject.scene.landing->points.size(); ++k)
      out.add(
          kClearance, {subject.scene.landing->points[k].name},
          [landing, k](const Sample&) { return landing->now().clearance[k]; }, Column::Reads::kLanding);
  }
  for (int k = 0; k < count_of<Stored>(); ++k) {
    const auto form = static_cast<Stored>(k);
    out.add(kStored, {std::string(name_of(form))}, [form](const Sample& s) { return s.energy.stored[form]; });
  }
  out.add(kEnergyTotal, {}, [](const Sample& s) -> const StoredEnergy& { return s.energy.stored; });
  for (int k = 0; k < count_of<Dissipation>(); ++k) {
    const auto kind = static_cast<Dissipation>(k);
    const bool missing = std::any_of(kOwnDissipations.begin(), kOwnDissipations.end(), [&](const OwnDissipation& own) {
      return own.dissipation == kind && !mechanism.has(own.kind);
    });
    if (missing) continue;
    out.add(kDissipated, {std::string(name_of(kind))}, [kind](const Sample& s) { return s.state.dissipated[kind]; });
  }
  out.add(kWork, {}, [](const Sample& s) -> const State& { return s.state; });
  for (int k = 0; k < count_of<Supply>(); ++k) {
    const auto source = static_cast<Supply>(k);
    if (!has_work_column(subject.scene, source)) continue;
    out.add(kSupplied, {std::string(name_of(source))}, [source](const Sample& s) { return s.state.supplied[source]; });
  }
  if (subject.agreement) add_coupling(subject, out);
  return out.columns;
}

std::vector<ColumnPattern> column_patterns() {
  std::vector<ColumnPattern> patterns;
  for_each_table([&](const auto& entries) {
    for (const auto& entry : entries) patterns.push_back({entry.pattern, entry.unit});
  });
  return patterns;
}

}  // namespace footfall
