#include "mbd_solver/model/laws/mr_geometry.h"

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"

namespace footfall {

MrDamperParameters mr_damper_from_geometry(const MrGeometry& g, MrDamperParameters law) {
  constexpr std::string_view kWho = "mr_damper geometry";
  require_positive(kWho, "D1", g.D1, "m");
  require_positive(kWho, "d1", g.d1, "m");
  require_positive(kWho, "D2", g.D2, "m");
  require_positive(kWho, "D3", g.D3, "m");
  require_positive(kWho, "L1", g.L1, "m");
  require_not_negative(kWho, "L2", g.L2, "m");
  require_positive(kWho, "L3", g.L3, "m");
  require_not_negative(kWho, "L4", g.L4, "m");
  require_positive(kWho, "eta", g.eta, "Pa s");
  if (g.d1 >= g.D1)
    throw InputError("mr_damper geometry: core diameter d1 = " + number_text(g.d1) +
                     " m does not fit into the bypass cylinder D1 = " + number_text(g.D1) + " m; expected d1 < D1.");
  const double D4 = g.D4.value_or(g.D2), d = g.d.value_or(0.5 * (g.D1 - g.d1));
  require_positive(kWho, "D4", D4, "m");
  require_positive(kWho, "d", d, "m");
  if (g.tau_y.empty())
    throw InputError(
        "mr_damper geometry: the table tau_y is empty; expected pairs of U and yield stress, U from 0 to 1.");

  law.yield_table.clear();
  for (const YieldStress& p : g.tau_y)
    law.yield_table.push_back({p.voltage, 3.0 * kPi * g.L1 * p.stress * 0.5 * (g.D1 + g.d1)});  // [Lin25 14]
  law.yield_force = law.yield_table.back().force;
  law.viscous_coefficient = (12.0 * g.eta * g.L1 / (d * d) +
                             32.0 * g.eta * (g.L2 / (g.D2 * g.D2) + g.L3 / (g.D3 * g.D3) + g.L4 / (D4 * D4))) *
                            0.25 * kPi * g.D3 * g.D3;  // [Lin25 15]
  MrDamper check(law);  // the table's order and range, and the rest of the law, are judged in one place
  return law;
}

}  // namespace footfall
