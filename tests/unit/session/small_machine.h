#pragma once
// A scene with one of everything that a history has columns for, and its sample at the start, without a run.

#include <string>

#include "mbd_solver/session/observe/sampler.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall::test {

// A cabin on a flexible leg, a controlled strut between them, a plane below.
const std::string kSmallMachine = R"(end_time = 0.1
gravity = [0, 0, -1.62]
[materials.steel]
density = 7850
young_GPa = 207
[[bodies]]
name = "cabin"
mass = 10.0
inertia = [1.0, 1.0, 1.0]
position = [0, 0, 1.2]
[[bodies]]
name = "leg"
material = "steel"
shape = { kind = "rod", from = [0, 0, 0.9], to = [0, 0, 0.1], diameter = 0.04 }
flexible = { modes = 3 }
[[bodies]]
name = "wheel"
mass = 2.0
inertia = [0.1, 0.2, 0.1]
position = [1, 0, 1.2]
[[joints]]
name = "axle"
kind = "revolute"
bodies = ["cabin", "wheel"]
point = [1, 0, 1.2]
axis = "y"
[[joints]]
name = "slide"
kind = "prismatic"
bodies = ["cabin", "leg"]
point = [0, 0, 0.9]
axis = "z"
[[struts]]
name = "damper"
bodies = ["cabin", "leg"]
points = [[0, 0, 1.2], [0, 0, 0.9]]
mr = { yield_force = 20, viscous = 8, controller = "brain.U1" }
[[forces]]
name = "thruster"
body = "cabin"
direction = "x"
force = { polynomial = [0] }
[[drives]]
name = "spinner"
kind = "torque"
joint = "axle"
command = { polynomial = [0] }
[[drives]]
name = "pusher"
kind = "torque"
joint = "slide"
command = { polynomial = [0] }
[[controllers]]
name = "brain"
kind = "constant"
body = "cabin"
outputs = ["U1"]
voltages = [0.5]
[[signals]]
name = "sum"
kind = "expression"
input = "time + 2 * slide.displacement_rate"
[[states]]
name = "first"
[[states]]
name = "second"
[[events]]
name = "late"
when = "time > 1000"
to = "second"
[[boundaries]]
body = "leg"
[boundaries.beams]
radius = 0.02
[ground]
kind = "plane"
[ground.plane]
young_MPa = 35
restitution = 0.4
impact_speed = 1.0
[output]
reactions = true
[initial]
velocity = [0.1, 0.2, -1.0]
)";

// Everything that a sample views. Change `state` and take() again for another instant.
struct Bench {
  explicit Bench(const std::string& toml, const std::vector<std::string>& settings = {})
      : scene(SceneText().read(toml, settings)),
        mechanism(build_mechanism(scene)),
        assembly(assemble(mechanism.model)),
        equations(mechanism.model, assembly),
        state(assembly.state),
        rates(Eigen::VectorXd::Zero(equations.layout().size())),
        sampler({scene, mechanism, equations.layout()}, equations, state, rates, inputs) {
    inputs.values = mechanism.inputs;
    take();
  }
  Subject subject() const { return {scene, mechanism, equations.layout()}; }
  const Sample& take(long window = 0, const CouplingSample* coupling = nullptr) {
    equations.saddle().accelerations(state, inputs, rates);
    sampler.update(window, false, coupling);
    return sampler.sample();
  }

  Scene scene;
  Mechanism mechanism;
  Assembly assembly;
  Equations equations;
  State state;
  Inputs inputs;
  Eigen::VectorXd rates;
  Sampler sampler;
};

}  // namespace footfall::test
