#pragma once
// Reads what says a figure in the file of a sweep or study: key, or columns with reduce, average and prominence; and
// over.

#include "mbd_solver/cli/experiments/sweep_figure.h"
#include "mbd_solver/cli/experiments/table_reader.h"

namespace footfall {

// Throws InputError "file:line: key: what is wrong, what was expected".
void take_figure(TableReader& table, SweepFigure& figure);

}  // namespace footfall
