#pragma once
// The sections of an experiment's file that say what is told: figures, statements, fits.

#include "mbd_solver/cli/experiments/experiment.h"
#include "mbd_solver/cli/experiments/table_reader.h"

namespace footfall {

// One entry each. Throws InputError "file:line: key: what is wrong, what was expected".
void read_figure(TableReader& table, FigureSpec& figure);
void read_printed(TableReader& table, PrintedSpec& printed);
void read_statement(TableReader& table, StatementSpec& statement);
void read_plot(TableReader& table, PlotSpec& plot);
void read_fit(TableReader& table, FitSpec& fit);

// That what they name is there in the whole file, and that parameters in sums of fits have numbers for values. Throws
// InputError.
void check_sections(const TableReader& file, const ExperimentSpec& spec);

}  // namespace footfall
