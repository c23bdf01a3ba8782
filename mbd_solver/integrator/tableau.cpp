// Coefficients as published; the weights of the continuous extension are solved for here.

#include "mbd_solver/integrator/tableau.h"

#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

using Row = std::array<double, kMostStages>;

Tableau make_tr_bdf2() {
  const double gamma = 1.0 - std::sqrt(0.5), w = std::sqrt(2.0) / 4.0;
  return {"tr_bdf2",
          3,
          2,
          2,
          gamma,
          {0.0, 2.0 * gamma, 1.0},
          {Row{}, Row{gamma}, Row{w, w}},
          {w - (1.0 - w) / 3.0, w - (3.0 * w + 1.0) / 3.0, 2.0 * gamma / 3.0},
          {}};
}

Tableau make_esdirk3() {
  const double gamma = 1767732205903.0 / 4055673282236.0;
  Tableau tableau = {
      "esdirk3",
      4,
      3,
      2,
      gamma,
      {0.0, 2.0 * gamma, 0.6, 1.0},
      {Row{}, Row{gamma}, Row{2746238789719.0 / 10658868560708.0, -640167445237.0 / 6845629431997.0},
       Row{1471266399579.0 / 7840856788654.0, -4482444167858.0 / 7529755066697.0, 11266239266428.0 / 11593286722821.0}},
      {},
      {}};
  const Row embedded = {2756255671327.0 / 12835298489170.0, -10771552573575.0 / 22201958757719.0,
                        9247589265047.0 / 10645013368117.0, 2193209047091.0 / 5459859503100.0};
  for (std::size_t j = 0; j < 4; ++j) tableau.error[j] = (j < 3 ? tableau.a[3][j] : gamma) - embedded[j];
  return tableau;
}

Tableau make_esdirk5() {
  Tableau tableau = {
      "esdirk5",
      7,
      5,
      4,
      0.184,
      {0.0, 0.368, 0.62821529547664945, 0.13881019830028329, 0.69995861940457471, 0.90837696335078533, 1.0},
      {Row{}, Row{0.184}, Row{0.2221076477383247, 0.22210764773832475},
       Row{-0.014049475381926274, -0.014049475381926283, -0.017090850935864151},
       Row{-0.40838859254931487, -0.40838859254931464, 0.16646399821362964, 1.1662718062895745},
       Row{-0.53929072355881114, -0.53929072355881136, -0.24223442884542501, 1.4888806111225146, 0.55631222819131843},
       Row{-0.039466069109740348, -0.039466069109740258, 0.27263649025024267, 0.43216517252028819, 0.35241608623288911,
           -0.16228561078393952}},
      {},
      {-1.6817110573142924, 2.3292644139818779, -0.89893183175172486, 1.5109687669744825, -2.8082293071537645,
       0.92966967466969508, 0.61896934059372688}};
  const Row embedded = {-0.080689466566647272, -0.080689466566647439, 0.18289968461343553, 0.51701387376623098,
                        0.42659973130245432,   -0.10432685796713498,  0.13919250141830897};
  for (std::size_t j = 0; j < 7; ++j) tableau.error[j] = (j < 6 ? tableau.a[6][j] : tableau.gamma) - embedded[j];
  return tableau;
}

}  // namespace

const Tableau& tr_bdf2() {
  static const Tableau tableau = make_tr_bdf2();
  return tableau;
}

const Tableau& esdirk3() {
  static const Tableau tableau = make_esdirk3();
  return tableau;
}

const Tableau& esdirk5() {
  static const Tableau tableau = make_esdirk5();
  return tableau;
}

const Tableau& tableau_of_order(int order) {
  FOOTFALL_DEMAND(order == 2 || order == 3 || order == 5);
  return order == 2 ? tr_bdf2() : order == 3 ? esdirk3() : esdirk5();
}

}  // namespace footfall
