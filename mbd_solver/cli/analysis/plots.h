#pragma once
// The pictures of a run, as [Lin25 Figure 11]: acceleration, velocity, descent, mechanical energy and its parts, strut
// strokes, contact forces.

#include <string>
#include <vector>

#include "mbd_solver/cli/analysis/plot_script.h"
#include "mbd_solver/output/history.h"

namespace footfall {

// The figures that a history with these columns can show, none with more curves than there are colours. `observed`: the body whose motion is drawn; empty: the first
// with an acceleration.
std::vector<Figure> standard_figures(const History& history, const std::string& observed);

// Where the energy is, as bands whose sum is constant; parts too small to be seen are left out. `ledger`: as
// energy_ledger makes it.
Figure ledger_figure(const History& ledger);

}  // namespace footfall
