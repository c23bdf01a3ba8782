// mbd_solver/scene/script_mesh.h: meshes taken over from a LIGGGHTS script.
#include <gtest/gtest.h>

#include "coupler/base/pi.h"
#include "mbd_solver/scene/boundary_surface.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

constexpr const char* kTriangle =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 10 0 0\nvertex 20 0 0\nvertex 10 5 0\nendloop\nendfacet\nendsolid "
    "t\n";
constexpr double kSingle = 1e-6;  // STL is read in single precision

// The first corner of the mesh, (10, 0, 0) in the file, after the words of its line in the script.
Eigen::Vector3d first_corner(const std::string& words) {
  const SceneText text;
  text.write("t.stl", kTriangle);
  text.write("in.run", "variable size index 0.001\nfix m all mesh/surface/stress file ${here}/t.stl type 2 " + words +
                           " stress on\nfix mbd all couple/mbd every 1 mesh m b\n");
  const Scene scene = text.read(
      "end_time = 1\n[[bodies]]\nname = \"b\"\nmass = 1\ninertia = [1, 1, 1]\nposition = [0, 0, 0]\n"
      "[[boundaries]]\nbody = \"b\"\nsurface = { from_script = \"m\" }\n[particles]\nscript = \"in.run\"\n");
  return boundary_surface(scene, scene.boundaries[0]).vertices[0];
}

void expect_at(const std::string& words, const Eigen::Vector3d& place) {
  EXPECT_LT((first_corner(words) - place).norm(), kSingle * place.norm()) << words;
}

TEST(ScriptMesh, ScaleRotateAndMoveActInTheOrderOfTheScript) {
  expect_at("", {10, 0, 0});
  expect_at("scale ${size}", {0.01, 0, 0});
  expect_at("scale ${size} rotate axis 0 0 2 angle 90 move 1 0 0", {1, 0.01, 0});
  expect_at("move 0 0 1 scale 2 rotate axis 1 0 0 angle 90", {20, -2, 0});
  expect_at("rotate axis 0 0 1 angle 90 rotate axis 1 0 0 angle 90", {0, 0, 10});
}

}  // namespace
}  // namespace footfall
