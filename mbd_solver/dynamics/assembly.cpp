// Gauss-Newton closes the joints with the smallest correction in the mass metric; given coordinates are reached in steps.

#include "mbd_solver/dynamics/assembly.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/dynamics/codes.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/dynamics/turn_follower.h"
#include "mbd_solver/model/elements/gear.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kContradiction = 1e-8;  // larger remaining gaps cannot be closed [m or rad]
constexpr int kMostClosingSteps = 30;
constexpr double kAssembled = 1e-12;  // accuracy in double precision for mechanisms of metres [m or rad]
// While the joints are open by a gap g, redundant conditions appear independent to about g; they must not influence the
// closing.
constexpr double kClosingRank = 1e-5;

// The angles of gears (state.z) now; with dx, after this step of the bodies.
void follow_turns(const Model& model, const Layout& layout, const Kinematics& kinematics, const Eigen::VectorXd* dx,
                  State& state) {
  for (int j = 0; j < model.joint_count(); ++j) {
    const int z = layout.joint_turns[j];
    if (z < 0) continue;
    const Joint& joint = model.joint(j);
    const PairMotion pair = kinematics.pair(joint.m1.body, joint.m2.body);
    const JointCoordinate q(Coordinate::kAngle, pair, joint.m1, joint.m2);
    state.z[z] = nearest_turn(q.value(), state.z[z]);
    if (dx == nullptr) continue;
    Eigen::VectorXd q_x = Eigen::VectorXd::Zero(pair.size());
    q.add_gradient(1.0, q_x);
    const int bodies[2] = {joint.m1.body, joint.m2.body};
    for (int i = 0; i < 2; ++i) {
      const int n = pair.body[i]->size();
      if (n > 0) state.z[z] += q_x.segment(pair.offset(i), n).dot(dx->segment(layout.body_v[bodies[i]], n));
    }
  }
}

// Gauss-Newton with the smallest correction, until the gaps no longer fall; angles of gears follow. `rows` are evaluated at
// `state` before and after.
void close_joints(const Model& model, const Layout& layout, ConstraintRows& rows, State& state) {
  double last = HUGE_VAL;
  for (int i = 0; i < kMostClosingSteps; ++i) {
    const double now = rows.phi.lpNorm<Eigen::Infinity>();
    if (now <= 1e-15 || (now <= kAssembled && now >= 0.5 * last)) break;
    last = now;
    const Eigen::VectorXd dx = rows.correction(rows.phi, kClosingRank);
    follow_turns(model, layout, rows.kinematics(), &dx, state);
    add_increment(layout, dx, state.q);
    rows.evaluate(state);
  }
  follow_turns(model, layout, rows.kinematics(), nullptr, state);
}

// Names of joints, quoted.
std::string joint_names(const Model& model, const std::vector<int>& joints) {
  std::string out;
  for (int joint : joints) out += (out.empty() ? "\"" : ", \"") + model.joint(joint).name + "\"";
  return out;
}

// Throws InputError naming the joints with the largest entries of `defect` (one per row) if these exceed round-off of `scale`:
// the joints contradict each other, `what` by a number of `unit`.
void check_contradiction(const Model& model, const Layout& layout, const Eigen::VectorXd& defect, double scale,
                         const std::string& what, const std::string& unit) {
  const double largest = defect.lpNorm<Eigen::Infinity>();
  if (largest <= kContradiction * scale) return;
  std::vector<int> worst;
  for (int row = 0; row < defect.size(); ++row) {
    const int joint = layout.row_joint[row];
    if (std::abs(defect[row]) > 0.1 * largest && (worst.empty() || worst.back() != joint)) worst.push_back(joint);
  }
  throw InputError(code::kJointsContradict, "joints " + joint_names(model, worst) + " contradict each other: " + what +
                                                " by " + number_text(largest, 3) + " " + unit +
                                                ". Move one of them, or free one of its directions.");
}

// A joint of another model with the same bodies.
void add_joint(Joint joint, Model& out) {
  if (joint.turn_counter >= 0)
    joint.turn_counter =
        out.add_force(std::make_unique<TurnCounter>("turns/" + joint.name, joint.m1, joint.m2)).index();
  out.add_joint(std::move(joint));
}

void add_joints(const Model& model, Model& out) {
  for (int j = 0; j < model.joint_count(); ++j) add_joint(model.joint(j), out);
}

Model unbendable(const Model& model) {
  Model out;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    BodyState start = model.initial(i);
    if (body.mode_count() == 0) {
      out.add_body(body, start);
      continue;
    }
    ModalBody modal = *body.modal();
    for (Eigen::MatrixXd* shapes : {&modal.Phi, &modal.Psi, &modal.stress_modes}) shapes->resize(shapes->rows(), 0);
    modal.stiffness.resize(0);
    modal.damping.resize(0);
    start.a.resize(0);
    start.da.resize(0);
    out.add_body(Body(body.name(), std::make_shared<const ModalBody>(std::move(modal))), start);
  }
  add_joints(model, out);
  return out;
}

// The bodies and joints of a model, and of its forces the counters of turns.
Model without_forces(const Model& model) {
  Model out;
  for (int i = 0; i < model.body_count(); ++i) out.add_body(model.body(i), model.initial(i));
  add_joints(model, out);
  return out;
}

// Closes the joints of a model without forces by moving its bodies without bending them: in the metric of masses a stiff body
// bends as easily as it turns, and the smallest motion alone would leave it with large forces.
class UnbentClosing {
 public:
  // layout: of the model. Both must outlive this object.
  UnbentClosing(const Model& model, const Layout& layout)
      : layout_(layout), model_(unbendable(model)), rigid_(model_), rows_(model_, rigid_) {
    for (int i = 0; i < model.body_count(); ++i) bends_ = bends_ || model.body(i).mode_count() > 0;
  }
  // Does not change the state if this is not sufficient, or if no body can bend.
  void close(State& state) {
    if (!bends_) return;
    State moved = state;
    moved.q.resize(rigid_.q_size);
    moved.v = Eigen::VectorXd::Zero(rigid_.v_size);
    for (std::size_t i = 0; i < layout_.body_q.size(); ++i)
      moved.q.segment<7>(rigid_.body_q[i]) = state.q.segment<7>(layout_.body_q[i]);
    rows_.evaluate(moved);
    close_joints(model_, rigid_, rows_, moved);
    if (rows_.phi.lpNorm<Eigen::Infinity>() > kContradiction) return;
    for (std::size_t i = 0; i < layout_.body_q.size(); ++i)
      state.q.segment<7>(layout_.body_q[i]) = moved.q.segment<7>(rigid_.body_q[i]);
    state.z = moved.z;
  }

 private:
  const Layout& layout_;
  Model model_;  // the same bodies and joints, and none of the bodies can bend
  Layout rigid_;
  ConstraintRows rows_;
  bool bends_ = false;
};

// The same for the initial positions of a model.
void close_unbent(const Model& model, State& state) {
  const Model joints_alone = without_forces(model);
  const Layout layout(joints_alone);
  State closed = state;
  closed.z = Eigen::VectorXd::Zero(layout.z_size);
  UnbentClosing(joints_alone, layout).close(closed);
  state.q = closed.q;
}

constexpr double kStartStep = 0.05;  // of a coordinate on its way to its start value [rad or m]

// One more condition per given coordinate: from zero at t = 0 to its value at t = 1. Motions of the scene remain at their start.
Model model_on_the_way(const Model& model, const std::vector<StartCoordinate>& start) {
  Model out;
  for (int i = 0; i < model.body_count(); ++i) out.add_body(model.body(i), model.initial(i));
  for (int j = 0; j < model.joint_count(); ++j) {
    Joint joint = model.joint(j);
    for (ConstraintRow& row : joint.rows)
      if (row.motion) row.motion = polynomial({row.motion->at(0.0).value});
    add_joint(std::move(joint), out);
  }
  for (const StartCoordinate& given : start) {
    const Joint& joint = model.joint(given.joint);
    PrescribedMotion motion;
    const auto axis = static_cast<std::size_t>(axis_of(given.coordinate));
    (given.coordinate == Coordinate::kAngle ? motion.rotation : motion.translation[axis]) =
        polynomial({0.0, given.value});
    out.add_joint(prescribed_joint("start of " + joint.name + "." + std::string(name_of(given.coordinate)), joint.m1,
                                   joint.m2, motion));
  }
  return out;
}

// A mechanism without joints to the ground: its first body returns to its initial position.
void put_back_first_body(const Model& model, const Layout& layout, State& state) {
  for (int j = 0; j < model.joint_count(); ++j)
    if (model.joint(j).m1.body == kGround || model.joint(j).m2.body == kGround) return;
  const BodyState& drawn = model.initial(0);
  const Eigen::Vector3d r = state.q.head<3>();
  const Eigen::Matrix3d R = rotation_matrix(drawn.L) * rotation_matrix(state.q.segment<4>(3)).transpose();
  const Eigen::Quaterniond turn(R);
  for (std::size_t i = 0; i < layout.body_q.size(); ++i) {
    const int q = layout.body_q[i];
    const Eigen::Vector3d moved = drawn.r + R * (state.q.segment<3>(q) - r);
    const Eigen::Vector4d L = state.q.segment<4>(q + 3);
    const Eigen::Quaterniond turned = turn * Eigen::Quaterniond(L(0), L(1), L(2), L(3));
    state.q.segment<3>(q) = moved;
    state.q.segment<4>(q + 3) << turned.w(), turned.x(), turned.y(), turned.z();
  }
}

// Moves the coordinates to their values in small steps, so that loops remain on their branch. The joints of `state` are
// closed before and after. Throws InputError if they cannot be closed.
void move_to_start(const Model& model, const std::vector<StartCoordinate>& start, State& state) {
  const Model on_the_way = model_on_the_way(model, start);
  const Layout layout(on_the_way), all(model);
  ConstraintRows rows(on_the_way, layout);
  UnbentClosing unbent(on_the_way, layout);
  Eigen::VectorXd z = state.z;
  state.z = Eigen::VectorXd::Zero(layout.z_size);
  double longest = 0.0;
  for (const StartCoordinate& given : start) longest = std::max(longest, std::abs(given.value));
  const int steps = 1 + static_cast<int>(longest / kStartStep);
  for (int k = 1; k <= steps; ++k) {
    state.time = static_cast<double>(k) / steps;
    unbent.close(state);
    rows.evaluate(state);
    close_joints(on_the_way, layout, rows, state);
    check_contradiction(on_the_way, layout, rows.phi, 1.0,
                        "they cannot be closed on the way to the coordinates of [initial.joints] and stay open",
                        "m or rad");
  }
  state.time = 0.0;
  for (std::size_t j = 0; j < all.joint_turns.size(); ++j)
    if (all.joint_turns[j] >= 0) z[all.joint_turns[j]] = state.z[layout.joint_turns[j]];
  state.z = std::move(z);
  put_back_first_body(model, layout, state);
}

constexpr double kReportedGap = 1e-5;  // larger gaps are reported [m or rad]

State initial_state(const Model& model, const Layout& layout) {
  State state;
  state.q.resize(layout.q_size);
  state.v.resize(layout.v_size);
  state.z = Eigen::VectorXd::Zero(layout.z_size);
  for (int i = 0; i < model.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const BodyState& body = model.initial(i);
    const int s = model.body(i).mode_count();
    state.q.segment(layout.body_q[at], 7 + s) << body.r, body.L, body.a;
    state.v.segment(layout.body_v[at], 6 + s) << body.dr, body.w, body.da;
  }
  for (int i = 0; i < model.force_count(); ++i)
    state.z.segment(layout.force_z[i], model.force(i).state_count()) = model.force(i).initial_state();
  state.load_work = state.work_error.load_work = Eigen::VectorXd::Zero(model.body_count());
  state.angles = Eigen::VectorXd::Zero(layout.angle_count);
  return state;
}

// The given velocities belong to the places in the reference configuration. A mechanism that spins as a whole still does so
// where its bodies start: dr += w x (r - r_drawn), without a change of its momentum.
void move_velocities(const Model& model, const Layout& layout, const Eigen::VectorXd& drawn, State& state) {
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  // added [kg m/s]
  double mass = 0.0;                                   // of the spinning parts [kg]
  const auto w = [&](std::size_t i) { return state.v.segment<3>(layout.body_v[i] + 3); };
  for (std::size_t i = 0; i < layout.body_q.size(); ++i) {
    if (w(i).isZero(0.0)) continue;
    const Eigen::Vector3d way = state.q.segment<3>(layout.body_q[i]) - drawn.segment<3>(layout.body_q[i]);
    const Eigen::Vector3d change = Eigen::Vector3d(w(i)).cross(way);
    state.v.segment<3>(layout.body_v[i]) += change;
    momentum += model.body(static_cast<int>(i)).mass() * change;
    mass += model.body(static_cast<int>(i)).mass();
  }
  for (std::size_t i = 0; i < layout.body_q.size() && mass > 0.0; ++i)
    if (!w(i).isZero(0.0)) state.v.segment<3>(layout.body_v[i]) -= momentum / mass;
}

std::string number(double x) { return number_text(x, 3); }

// Cosine of the angle between required and actual attitude of a joint, for half turns, which its rows do not detect.
double attitude_cosine(const Joint& joint, const PairMotion& pair, double t) {
  double smallest = 1.0;
  if (joint.kind == "fixed" || joint.kind == "prismatic") {
    for (int k = 0; k < 3; ++k)
      smallest = std::min(
          smallest,
          KinematicVector::axis(pair, 0, joint.m1, k).value().dot(KinematicVector::axis(pair, 1, joint.m2, k).value()));
  }
  for (const ConstraintRow& row : joint.rows) {
    if (!row.rotation) continue;  // cos(angle - f) = sin(f) e_j1.e_i2 + cos(f) e_i1.e_i2
    const double f = row.motion->at(t).value;
    const auto axis = [&](const Factor& factor) {
      return KinematicVector::axis(pair, factor.kind == Factor::Kind::kAxis1 ? 0 : 1,
                                   factor.kind == Factor::Kind::kAxis1 ? joint.m1 : joint.m2, factor.axis);
    };
    double cosine = 0.0;
    const double weight[2] = {std::sin(f), std::cos(f)};
    for (int i = 0; i < 2; ++i)
      cosine += weight[i] * axis(row.terms[i].alpha).value().dot(axis(row.terms[i].beta).value());
    smallest = std::min(smallest, cosine);
  }
  return smallest;
}

// Every joint that is open by more than the tolerance, all of them in one message.
double check_gaps(const Model& model, const Layout& layout, const ConstraintRows& rows, double t, double tolerance) {
  std::string findings;
  double largest = 0.0;
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joint(j);
    double gap2 = 0.0, angle = 0.0;
    for (std::size_t k = 0; k < joint.rows.size(); ++k) {
      const double phi = rows.phi[layout.joint_row[j] + static_cast<int>(k)];
      if (joint.rows[k].unit == ConstraintRow::Unit::kLength) {
        gap2 += phi * phi;
      } else {
        angle = std::max(angle, std::abs(phi));
      }
    }
    const PairMotion pair = rows.kinematics().pair(joint.m1.body, joint.m2.body);
    if (attitude_cosine(joint, pair, t) < 0.0) angle = kPi;  // a half turn, which the sines above do not detect
    const double gap = std::sqrt(gap2);
    largest = std::max({largest, gap, angle});
    const std::string where =
        (findings.empty() ? "" : "\n") + std::string("joint \"") + joint.name + "\" (" + joint.kind + "): ";
    if (!(gap <= tolerance)) {
      findings += where + "gap of " + number(gap) + " m in the initial position (limit " + number(tolerance) +
                  " m). Check the positions of its bodies and its point.";
    } else if (!(angle <= tolerance)) {
      findings += where + "its axes are off by " + number((angle > 1.0 ? kPi : std::asin(angle)) * 180.0 / kPi) +
                  " degrees in the initial position. Check the attitudes of its bodies and its axes.";
    }
  }
  if (!findings.empty()) throw InputError(code::kJointGap, findings);
  return largest;
}

// One note per joint with conditions that follow from others.
void note_redundant(const Model& model, const Layout& layout, Assembly& out) {
  std::map<int, std::pair<int, std::set<int>>> found;  // joint: how many, from which joints
  for (const RedundantGroup& group : out.redundant) {
    for (std::size_t k = 0; k < group.dropped.size(); ++k) {
      auto& [count, sources] = found[layout.row_joint[group.dropped[k]]];
      ++count;
      sources.insert(group.sources[k].begin(), group.sources[k].end());
    }
  }
  for (const auto& [joint, entry] : found)
    out.notes.push_back(with_code(code::kRedundantConditions,
                                  "joint \"" + model.joint(joint).name + "\": " + std::to_string(entry.first) +
                                      " of its " + std::to_string(model.joint(joint).rows.size()) +
                                      " conditions follow from " +
                                      joint_names(model, {entry.second.begin(), entry.second.end()}) +
                                      " and are redundant; its reactions are the smallest possible."));
}

// Gears that turned by more than half a turn on the way to the start.
void note_turns(const Model& model, const Layout& layout, Assembly& out) {
  for (int j = 0; j < model.joint_count(); ++j) {
    const int z = layout.joint_turns[j];
    if (z < 0 || std::abs(out.state.z[z]) <= kPi) continue;
    out.notes.push_back(with_code(code::kGearTurn, "joint \"" + model.joint(j).name +
                                                       "\": its gear starts at an angle of " + number(out.state.z[z]) +
                                                       " rad; other laws on this angle and its column count from the "
                                                       "nearest turn."));
  }
}

// The change of the given velocities, and the joint that they did not fit.
void note_speeds(const Model& model, const Layout& layout, const Eigen::VectorXd& rate, const Eigen::VectorXd& change,
                 bool given, double tolerance, Assembly& out) {
  out.largest_speed_change = change.lpNorm<Eigen::Infinity>();
  if (out.largest_speed_change <= tolerance) return;
  Eigen::Index row = 0, entry = 0;
  rate.cwiseAbs().maxCoeff(&row);
  change.cwiseAbs().maxCoeff(&entry);
  std::size_t body = layout.body_v.size() - 1;
  while (layout.body_v[body] > entry) --body;
  const Eigen::Vector3d dv = change.segment<3>(layout.body_v[body]), dw = change.segment<3>(layout.body_v[body] + 3);
  out.notes.push_back(
      with_code(code::kVelocitiesChanged,
                (given ? std::string("the given initial velocities do not fit the joints: joint \"")
                       : std::string("joints move from the start, and no initial velocities are given: joint \"")) +
                    model.joint(layout.row_joint[row]).name + "\" would open at " + number(std::abs(rate[row])) +
                    " m/s or rad/s. Velocities were changed by the smallest correction; body \"" +
                    model.body(static_cast<int>(body)).name() + "\" changed most, by " + number(dv.norm()) +
                    " m/s and " + number(dw.norm()) + " rad/s."));
}

// Modes of force elements that fit the velocities of the start.
void start_modes(const Model& model, const Layout& layout, const Kinematics& kinematics, State& state) {
  for (int i = 0; i < model.force_count(); ++i) {
    const ForceElement& element = model.force(i);
    const Switching* const modes = switching(element);
    if (modes == nullptr) continue;
    const Eigen::VectorXd inputs = Eigen::VectorXd::Zero(element.input_count());
    auto z = state.z.segment(layout.force_z[i], element.state_count());
    SharedCopies shared;
    const std::unique_ptr<ElementScratch> scratch = element.scratch(shared);
    modes->switch_states(element_input(element, kinematics, z, inputs, state.time, scratch.get()), z);
  }
}

}  // namespace

Assembly assemble(const Model& model, const AssemblyOptions& options) {
  const Layout layout(model);
  Assembly out;
  out.state = initial_state(model, layout);
  if (options.carry) options.carry(layout, out.state);
  if (!out.state.z.allFinite())
    throw InputError(code::kNotFinite, "an inner state of a force element is not finite at the start.");
  if (layout.row_count == 0) return out;
  ConstraintRows rows(model, layout);
  rows.evaluate(out.state);
  out.largest_gap = check_gaps(model, layout, rows, out.state.time, options.gap_tolerance);

  if (out.largest_gap > kReportedGap) {
    close_unbent(model, out.state);
    rows.evaluate(out.state);
  }
  close_joints(model, layout, rows, out.state);
  check_contradiction(model, layout, rows.phi, 1.0, "they cannot be closed together and stay open", "m or rad");
  if (out.largest_gap > kReportedGap)
    out.notes.push_back(with_code(code::kJointsClosed,
                                  "joints are open in the reference configuration by up to " + number(out.largest_gap) +
                                      " m or rad; bodies were moved by the smallest displacements that close them."));
  if (!options.start.empty()) {
    const Eigen::VectorXd drawn = out.state.q;
    move_to_start(model, options.start, out.state);
    move_velocities(model, layout, drawn, out.state);
    rows.evaluate(out.state);
    note_turns(model, layout, out);
  }

  // Velocities: the smallest change that satisfies Phi_v v + Phi_t = 0. Twice, because of round-off.
  const Eigen::VectorXd v_given = out.state.v, rate_given = rows.rate;
  for (int i = 0; i < 2 && rows.rate.lpNorm<Eigen::Infinity>() > 0.0; ++i) {
    out.state.v += rows.correction(rows.rate, options.rank_tolerance);
    rows.evaluate(out.state);
  }
  check_contradiction(model, layout, rows.rate, 1.0 + out.state.v.lpNorm<Eigen::Infinity>(), "their speeds differ",
                      "m/s or rad/s");
  note_speeds(model, layout, rate_given, out.state.v - v_given, !v_given.isZero(), options.speed_tolerance, out);

  start_angles(model, layout, rows.kinematics(), out.state);
  start_modes(model, layout, rows.kinematics(), out.state);
  out.redundant = rows.redundant(options.rank_tolerance);
  out.rank = layout.row_count;
  for (int j = 0; j < model.joint_count(); ++j)
    for (const ConstraintRow& row : model.joint(j).rows)
      out.rank -= row.inertia > 0.0 ? 1 : 0;  // rotors are no conditions
  for (const RedundantGroup& group : out.redundant) out.rank -= static_cast<int>(group.dropped.size());
  note_redundant(model, layout, out);
  return out;
}

}  // namespace footfall
