// Heights are rounded to 0.1 mm: they are drawn, not computed with.

#include "mbd_solver/session/observe/terrain_patch.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace footfall {

using Json = nlohmann::ordered_json;

std::string terrain_text(const Scene& scene, const Mechanism& mechanism) {
  const std::shared_ptr<const Terrain> surface =
      scene.touches_particles() ? build_bed_surface(scene) : mechanism.terrain;
  if (!surface) return "";
  Terrain terrain = *surface;
  constexpr int kCells = 160;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL), high = -low;
  const auto take = [&](const Eigen::Vector2d& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  };
  if (scene.touches_particles()) {  // its rocks are bodies
    const BoxSpec& box = *scene.particles->box;
    take({box.centre[0] - 0.5 * box.size[0], box.centre[1] - 0.5 * box.size[1]});
    take({box.centre[0] + 0.5 * box.size[0], box.centre[1] + 0.5 * box.size[1]});
  } else {
    for (const BodyBoundary& entry : mechanism.boundaries) {
      const BodyState& body = mechanism.model.initial(entry.body);
      const double reach = entry.boundary.rho0().colwise().norm().maxCoeff();
      take(body.r.head<2>() - Eigen::Vector2d::Constant(reach));
      take(body.r.head<2>() + Eigen::Vector2d::Constant(reach));
    }
    if (!(high.x() > low.x())) return "";
    const double size = (high - low).maxCoeff();
    const Eigen::Vector2d way = scene.initial.velocity.head<2>() * scene.end_time;
    take(low + way);
    take(high + way);
    low.array() -= size;
    high.array() += size;
  }
  const Eigen::Vector2d step = (high - low) / kCells;
  const auto rounded = [](double x) { return std::round(1e4 * x) / 1e4; };
  Json out;
  out["first"] = {low.x(), low.y()};
  out["step"] = {step.x(), step.y()};
  out["counts"] = {kCells + 1, kCells + 1};
  Json& heights = out["heights"] = Json::array();
  for (const double height : terrain.sketch(low, step, {kCells + 1, kCells + 1})) heights.push_back(rounded(height));
  Json& rocks = out["rocks"] = Json::array();
  for (const Terrain::Sphere& rock : terrain.rocks()) {
    const Eigen::Vector2d place = rock.centre.head<2>();
    if ((place - low).minCoeff() < 0.0 || (high - place).minCoeff() < 0.0) continue;
    rocks.push_back({rounded(place.x()), rounded(place.y()), rounded(rock.centre.z()), rounded(rock.radius)});
  }
  return out.dump() + "\n";
}

}  // namespace footfall
