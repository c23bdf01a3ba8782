#include "mbd_solver/cli/rigs/rig.h"

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"

namespace footfall {

const std::vector<Rig>& all_rigs() {
  static const std::vector<Rig> rigs = {
      {"plate",
       "pressure over sinkage, Bekker's k_c, k_phi and n",
       "sinkage [m]",
       "pressure [Pa]",
       evaluate_plate,
       demand_plate,
       true,
       {}},
      {"cone",
       "cone index over depth, and its gradient",
       "depth of the tip [m]",
       "cone index [Pa]",
       evaluate_cone,
       demand_cone,
       true,
       {}},
      {"wheel",
       "drawbar pull, torque and sinkage over slip",
       "slip",
       "drawbar pull / load",
       evaluate_wheel,
       demand_wheel,
       true,
       {}},
      {"shear",
       "friction angle and cohesion under a ring with lugs",
       "normal stress [Pa]",
       "shear stress [Pa]",
       evaluate_shear,
       demand_shear,
       true,
       {}},
      {"box",
       "friction angle and cohesion in a direct shear box",
       "normal stress [Pa]",
       "shear stress [Pa]",
       evaluate_box,
       demand_box,
       true,
       {},
       checks_of_holding_bodies},
      {"repose",
       "angle of repose",
       "x [m]",
       "height of the surface [m]",
       evaluate_repose,
       demand_repose,
       true,
       {},
       checks_of_holding_bodies},
      {"sphere",
       "drag of a dropped sphere, k and d1 of Katsuragi and Durian",
       "depth [m]",
       "(a + g) / g",
       evaluate_sphere,
       demand_sphere,
       false,
       {{"force k z + m v^2 / d1 explains the trajectories: R^2 at least 0.9", "R^2", 0.9, 1.0,
         "Katsuragi and Durian, Nature Phys. 3, 420 (2007)"},
        {"k d1 / (m g) sqrt(rho_b / rho_s) = 3 whatever the friction, within a factor of 1.5", "k d1 over its law", 2.0,
         4.5, "Katsuragi and Durian, PRE 87, 052208 (2013)"},
        {"depth is linear in the speed of impact: R^2 at least 0.95", "R^2 of depth linear in speed", 0.95, 1.0,
         "Goldman and Umbanhowar, PRE 77, 021308 (2008)"},
        {"time to the stop is the same at high speeds, within 10 %", "time to the stop, largest speed over the next",
         0.9, 1.1, "Goldman and Umbanhowar, PRE 77, 021308 (2008)"}}},
      {"rft",
       "stress on a plate drawn at angles beta and gamma, against resistive force theory",
       "alpha of the theory",
       "measured stress per depth [Pa/m]",
       evaluate_rft,
       demand_rft,
       true,
       {{"the printed coefficients and one scalar: R^2 at least 0.9", "R^2", 0.9, 1.0,
         "Li, Zhang and Goldman, Science 339, 1408 (2013)"}}},
  };
  return rigs;
}

const Rig& rig_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Rig& rig : all_rigs()) {
    if (rig.name == name) return rig;
    names.emplace_back(rig.name);
  }
  throw InputError("footfall rig " + name + ": there is no such rig." + known_names("rigs", name, names));
}

}  // namespace footfall
