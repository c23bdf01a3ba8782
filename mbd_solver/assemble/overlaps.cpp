// The energy of each contact in the reference configuration, as a height. Where joints move to other coordinates before the
// start, or the mechanism settles, the start is not known here.

#include <cmath>
#include <map>

#include "coupler/base/text.h"
#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kWeight = 9.81;  // heights are those on the Earth [m/s2]

BodyKinematics at_rest(const Model& model, int index) {
  BodyKinematics body;
  if (index == kGround) return body;
  const BodyState& state = model.initial(index);
  body.ground = false;
  body.modes = model.body(index).mode_count();
  body.r = state.r;
  body.L = state.L;
  body.A = rotation_matrix(state.L);
  body.a = state.a;
  body.da = body.dda = Eigen::VectorXd::Zero(body.modes);
  return body;
}

double size_of(const BodyBoundary& entry) {
  const Eigen::Matrix3Xd& nodes = entry.boundary.rho0();
  return (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).norm();
}

}  // namespace

void warn_of_overlaps(const Scene& scene, Mechanism& mechanism) {
  if (scene.initial.settle || !scene.initial.joints.empty()) return;
  const Model& model = mechanism.model;
  std::map<int, double> sizes;  // of bodies [m]
  for (const BodyBoundary& entry : mechanism.boundaries) sizes[entry.body] = size_of(entry);
  ElementScratches scratch(model);
  for (const ContactEntry& entry : mechanism.contacts) {
    const ContactElement& contact = entry.force.of(model);
    const std::array<int, 2>& bodies = contact.bodies();
    if (sizes.find(bodies[0]) == sizes.end()) continue;  // a hull, which is above the ground at the start
    const BodyKinematics motion[2] = {at_rest(model, bodies[0]), at_rest(model, bodies[1])};
    StoredEnergy stored;
    Dissipated power;
    const Eigen::VectorXd z = contact.initial_state();
    ElementInput in{{{&motion[0], &motion[1]}}, z, mechanism.inputs};
    in.scratch = scratch.of(entry.force.index());
    contact.add_energy(in, stored, power);
    double mass = HUGE_VAL, size = HUGE_VAL;
    std::string names;
    for (const int body : bodies) {
      if (body == kGround) continue;
      mass = std::min(mass, model.body(body).mass());
      size = std::min(size, sizes.at(body));
      names += (names.empty() ? "body \"" : " and \"") + model.body(body).name() + "\"";
    }
    const double height = stored.total() / (mass * kWeight);
    if (size == 0.0 || !(height > size)) continue;
    const bool pair = bodies[0] != kGround && bodies[1] != kGround;
    mechanism.warnings.push_back(with_code(
        code::kThrownAtStart, names, pair ? " overlap at the start" : ": is below the surface of a plane at the start",
        ": the contact would throw ", number_text(mass, 3), " kg up by ", number_text(height, 2),
        " m. Move one of them",
        pair ? ", or add a [[contacts]] entry with ignore = true." : ", for example by initial.clearance."));
  }
}

}  // namespace footfall
