// Adding a part checks its name, its bodies and its initial state.

#include "mbd_solver/model/model.h"

#include "coupler/base/errors.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

void demand_known_body(const std::string& what, int body, int count) {
  if (body < kGround || body >= count)
    throw InputError(code::kNotInModel, what + ": it names body number " + std::to_string(body) + ", but there are " +
                                            std::to_string(count) + " bodies.");
}

}  // namespace

int Model::add_body(Body body, const BodyState& initial) {
  if (body_names_.count(body.name()) > 0)
    throw InputError(code::kTwiceInModel, "body \"" + body.name() + "\": there are two bodies of this name.");
  BodyState state = initial;
  const int s = body.mode_count();
  if (state.a.size() == 0) state.a = Eigen::VectorXd::Zero(s);
  if (state.da.size() == 0) state.da = Eigen::VectorXd::Zero(s);
  FOOTFALL_DEMAND(state.a.size() == s && state.da.size() == s);
  const bool finite = state.r.allFinite() && state.L.allFinite() && state.dr.allFinite() && state.w.allFinite() &&
                      state.a.allFinite() && state.da.allFinite();
  if (!finite || !(state.L.norm() > 0.0))
    throw InputError(code::kInitialState, "body \"" + body.name() + "\": its initial state is not finite.");
  state.L.normalize();
  body_names_.emplace(body.name(), body_count());
  bodies_.push_back(std::move(body));
  initial_.push_back(std::move(state));
  return body_count() - 1;
}

int Model::add_joint(Joint joint) {
  if (joint_names_.count(joint.name) > 0)
    throw InputError(code::kTwiceInModel, "joint \"" + joint.name + "\": there are two joints of this name.");
  demand_known_body("joint \"" + joint.name + "\"", joint.m1.body, body_count());
  demand_known_body("joint \"" + joint.name + "\"", joint.m2.body, body_count());
  joint_names_.emplace(joint.name, joint_count());
  joints_.push_back(std::move(joint));
  return joint_count() - 1;
}

int Model::add_element(std::unique_ptr<ForceElement> element) {
  FOOTFALL_DEMAND(element != nullptr);
  const std::array<int, 2>& bodies = element->bodies();
  if (force_names_.count(element->name()) > 0)
    throw InputError(code::kTwiceInModel, "force element \"" + element->name() + "\": there are two of this name.");
  for (int body : bodies) demand_known_body("force element \"" + element->name() + "\"", body, body_count());
  if (bodies[0] == bodies[1])
    throw InputError(code::kOneBodyOnly, "force element \"" + element->name() +
                                             "\": it must act between two different bodies, or a body and the ground.");
  force_names_.emplace(element->name(), force_count());
  forces_.push_back(std::move(element));
  return force_count() - 1;
}

std::optional<int> Model::find_body(const std::string& name) const {
  const auto found = body_names_.find(name);
  return found == body_names_.end() ? std::nullopt : std::optional<int>(found->second);
}

int Model::body_index(const std::string& name) const {
  if (const std::optional<int> found = find_body(name)) return *found;
  std::string known;
  for (int i = 0; i < body_count(); ++i) known += (i > 0 ? ", " : "") + body(i).name();
  throw InputError(code::kNotInModel, "unknown body \"" + name + "\". Known bodies: " + known + ".");
}

Marker Model::marker_at(int index, const Eigen::Vector3d& p_W, const Eigen::Matrix3d& axes_W) const {
  if (index == kGround) return ground_marker(p_W, axes_W);
  const BodyState& state = initial(index);
  const Eigen::Matrix3d A = rotation_matrix(state.L);
  return body_marker(index, body(index), A.transpose() * (p_W - state.r), A.transpose() * axes_W);
}

Eigen::Vector3d Model::initial_position(const Marker& marker) const {
  if (marker.body == kGround) return marker.s0;
  const BodyState& state = initial(marker.body);
  Eigen::Vector3d s = marker.s0;
  if (marker.S.cols() > 0) s += marker.S * state.a;
  return state.r + rotation_matrix(state.L) * s;
}

ElementScratches::ElementScratches(const Model& model) {
  SharedCopies shared;
  for (int i = 0; i < model.force_count(); ++i) scratches_.push_back(model.force(i).scratch(shared));
}

}  // namespace footfall
