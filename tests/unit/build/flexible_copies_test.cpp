// Legs of an array are reduced once: mbd_solver/fe/turned_model.h.

#include <gtest/gtest.h>

#include "mbd_solver/build/mechanism.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

const char* const kHub = R"(end_time = 1.0
[arrays.leg]
count = 3
start_deg = 20
step_deg = 120
axis = [0, 0, 1]
[materials.steel]
density = 7850
young = 207e9
[[bodies]]
name = "hub"
mass = 50
inertia = [5, 5, 5]
position = [0, 0, 0]
)";
const char* const kHips = R"(
[[joints]]
name = "hip_{leg}"
type = "fixed"
bodies = ["hub", "leg_{leg}"]
point = [0.3, 0, 0.2]
)";

// A tube in each place of the array.
std::string tubes(const std::string& name, const std::string& wall) {
  return "[[bodies]]\nname = \"" + name +
         "_{leg}\"\nmaterial = \"steel\"\nflexible = { modes = 4, elements = 6 }\n"
         "shape = { kind = \"tube\", from = [0.3, 0, 0.2], to = [1.1, 0.1, -0.4], diameter = 0.05, wall = " +
         wall + " }\n";
}

// Two that are reduced each for itself differ in their last bits; a copy does not.
TEST(FlexibleCopies, LegsOfAnArrayAreTurnedCopiesOfTheFirst) {
  const SceneText folder;
  const Scene scene =
      folder.read(kHub + tubes("leg", "0.004") + tubes("stiff", "0.005") + tubes("bare", "0.004") + kHips);
  std::vector<std::string> warnings;
  const std::vector<FlexibleBody> bodies = build_flexible_bodies(scene, warnings);
  const auto of = [&](const std::string& name) -> const FlexibleBody& {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      if (scene.bodies[i].name == name) return bodies[i];
    ADD_FAILURE() << name;
    return bodies.front();
  };
  const FlexibleBody& first = of("leg_1");
  for (const char* name : {"leg_2", "leg_3"}) {
    const FlexibleBody& copy = of(name);
    EXPECT_EQ(copy.modal->name, name);
    EXPECT_EQ(copy.modal->stiffness, first.modal->stiffness);
    EXPECT_EQ(copy.modal->stress_modes, first.modal->stress_modes);
    EXPECT_EQ(copy.modal->static_error, first.modal->static_error);
    // Where it stands: turned about the axis of the array, a third of a turn each.
    EXPECT_NEAR(copy.p_DBo.norm(), first.p_DBo.norm(), 1e-12);
    EXPECT_NEAR(copy.p_DBo.head<2>().normalized().dot(first.p_DBo.head<2>().normalized()), -0.5, 1e-12);
    EXPECT_NEAR(copy.p_DBo.z(), first.p_DBo.z(), 1e-12);
  }
  EXPECT_NE(of("stiff_1").modal->stiffness, first.modal->stiffness);
  EXPECT_NE(of("bare_1").modal->stiffness, first.modal->stiffness) << "the same tube, held nowhere";
  EXPECT_EQ(of("stiff_3").modal->stiffness, of("stiff_1").modal->stiffness);
}

}  // namespace
}  // namespace footfall
