// Gears of the scene, between coordinates of its joints.

#include "mbd_solver/base/pi.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/build/time_functions.h"
#include "mbd_solver/model/elements/gear.h"

namespace footfall {

void add_gears(const Scene& scene, Mechanism& mechanism) {
  for (const GearSpec& spec : scene.gears) {
    std::vector<GearMember> members;
    for (std::size_t i = 0; i < spec.joints.size(); ++i)
      members.push_back({scene.joint_index(spec.joints[i]), scene.coordinate_of(spec, i), spec.factors[i]});
    if (!spec.curve.empty()) {
      auto [q, y] = columns_of(spec.curve);
      if (spec.closed && members.back().coordinate == Coordinate::kAngle) q.back() = q.front() + 2.0 * kPi;  // exactly
      members.back().curve =
          std::make_shared<CubicSpline>("gears." + spec.name + ".curve", q, y,
                                        spec.closed ? CubicSpline::Ends::kClosed : CubicSpline::Ends::kNatural);
    }
    mechanism.gears.push_back({spec.name, add_gear(mechanism.model, spec.name, members), members[0].coordinate});
  }
}

}  // namespace footfall
