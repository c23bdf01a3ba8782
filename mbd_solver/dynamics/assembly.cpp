#include "mbd_solver/dynamics/assembly.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/dynamics/joint_closing.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/dynamics/unbent_closing.h"

namespace footfall {
namespace {

constexpr double kTellGap = 1e-5;  // [m or rad]: gaps beyond the digits of a drawing are told

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
    state.z.segment(layout.force_z[static_cast<std::size_t>(i)], model.force(i).state_count()) =
        model.force(i).initial_state();
  state.load_work = Eigen::VectorXd::Zero(model.body_count());
  return state;
}

std::string number(double x) { return number_text(x, 3); }

// Cosine of the angle between the attitude a joint wants and the one it has, where dot products alone cannot
// tell a half turn.
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
      const double phi = rows.phi[layout.joint_row[static_cast<std::size_t>(j)] + static_cast<int>(k)];
      if (joint.rows[k].unit == ConstraintRow::Unit::kLength) {
        gap2 += phi * phi;
      } else {
        angle = std::max(angle, std::abs(phi));
      }
    }
    const PairMotion pair = rows.kinematics().pair(joint.m1.body, joint.m2.body);
    if (attitude_cosine(joint, pair, t) < 0.0) angle = kPi;  // a half turn, which the sines above do not see
    const double gap = std::sqrt(gap2);
    largest = std::max({largest, gap, angle});
    const std::string where =
        (findings.empty() ? "" : "\n") + std::string("joint \"") + joint.name + "\" (" + joint.kind + "): ";
    if (!(gap <= tolerance)) {
      findings += where + "gap of " + number(gap) + " m in the initial position; at most " + number(tolerance) +
                  " m is closed silently. Check the positions of its bodies and its point.";
    } else if (!(angle <= tolerance)) {
      findings += where + "its axes are off by " + number((angle > 1.0 ? kPi : std::asin(angle)) * 180.0 / kPi) +
                  " degrees in the initial position. Check the attitudes of its bodies and its axes.";
    }
  }
  if (!findings.empty()) throw InputError(findings);
  return largest;
}

// One note per joint with conditions that follow from others.
void note_redundant(const Model& model, const Layout& layout, Assembly& out) {
  std::map<int, std::pair<int, std::set<int>>> found;  // joint: how many, from which joints
  for (const RedundantGroup& group : out.redundant) {
    for (std::size_t k = 0; k < group.dropped.size(); ++k) {
      auto& [count, sources] = found[layout.row_joint[static_cast<std::size_t>(group.dropped[k])]];
      ++count;
      sources.insert(group.sources[k].begin(), group.sources[k].end());
    }
  }
  for (const auto& [joint, entry] : found)
    out.notes.push_back("joint \"" + model.joint(joint).name + "\": " + std::to_string(entry.first) + " of its " +
                        std::to_string(model.joint(joint).rows.size()) + " conditions follow from " +
                        joint_names(model, {entry.second.begin(), entry.second.end()}) +
                        " and are redundant: its reactions are the smallest that hold.");
}

// What a gear turned by more than half a turn on the way to the start: laws and histories count from the turn it is in.
void note_turns(const Model& model, const Layout& layout, Assembly& out) {
  for (int j = 0; j < model.joint_count(); ++j) {
    const int z = layout.joint_turns[static_cast<std::size_t>(j)];
    if (z < 0 || std::abs(out.state.z[z]) <= kPi) continue;
    out.notes.push_back("joint \"" + model.joint(j).name + "\": its gear starts with an angle of " +
                        number(out.state.z[z]) +
                        " rad; what else acts on that angle, and its column, count from the nearest turn.");
  }
}

// What the given velocities were changed by, and where they did not fit.
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
  out.notes.push_back((given ? "the given initial velocities do not fit the joints: joint \""
                             : "joints move from the start, and no initial velocities are given: joint \"") +
                      model.joint(layout.row_joint[static_cast<std::size_t>(row)]).name + "\" would open at " +
                      number(std::abs(rate[row])) + " m/s or rad/s. The smallest change that fits was made; body \"" +
                      model.body(static_cast<int>(body)).name() + "\" is changed most, by " + number(dv.norm()) +
                      " m/s and " + number(dw.norm()) + " rad/s.");
}

}  // namespace

Assembly assemble(const Model& model, const AssemblyOptions& options) {
  const Layout layout(model);
  Assembly out;
  out.state = initial_state(model, layout);
  if (!out.state.z.allFinite()) throw InputError("an inner state of a force element is not finite at the start.");
  if (layout.row_count == 0) return out;
  ConstraintRows rows(model, layout);
  rows.evaluate(out.state);
  out.largest_gap = check_gaps(model, layout, rows, out.state.time, options.gap_tolerance);

  if (out.largest_gap > kTellGap) {
    close_unbent(model, out.state);
    rows.evaluate(out.state);
  }
  close_joints(model, layout, rows, out.state);
  check_contradiction(model, layout, rows.phi, 1.0, "together they cannot be closed; they stay open", "m or rad");
  if (out.largest_gap > kTellGap)
    out.notes.push_back("the drawing does not quite close: joints were open by up to " + number(out.largest_gap) +
                        " m or rad, and bodies were moved by the least that closes them.");
  if (!options.start.empty()) {
    move_to_start(model, options.start, out.state);
    rows.evaluate(out.state);
    note_turns(model, layout, out);
  }

  // Velocities: the smallest change that satisfies Phi_v v + Phi_t = 0. Twice, for round-off.
  const Eigen::VectorXd v_given = out.state.v, rate_given = rows.rate;
  for (int i = 0; i < 2 && rows.rate.lpNorm<Eigen::Infinity>() > 0.0; ++i) {
    out.state.v += rows.correction(rows.rate, options.rank_tolerance);
    rows.evaluate(out.state);
  }
  check_contradiction(model, layout, rows.rate, 1.0 + out.state.v.lpNorm<Eigen::Infinity>(), "their speeds differ",
                      "m/s or rad/s");
  note_speeds(model, layout, rate_given, out.state.v - v_given, !v_given.isZero(), options.speed_tolerance, out);

  out.redundant = rows.redundant(options.rank_tolerance);
  out.rank = layout.row_count;
  for (int j = 0; j < model.joint_count(); ++j)
    for (const ConstraintRow& row : model.joint(j).rows) out.rank -= row.inertia > 0.0 ? 1 : 0;  // rotors hold nothing
  for (const RedundantGroup& group : out.redundant) out.rank -= static_cast<int>(group.dropped.size());
  note_redundant(model, layout, out);
  return out;
}

}  // namespace footfall
