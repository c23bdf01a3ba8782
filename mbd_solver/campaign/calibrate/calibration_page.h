#pragma once
// The results of a calibration: a page, tables, and pictures.

#include <string>
#include <vector>

#include "mbd_solver/campaign/calibrate/calibration_run.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

// Before the end of the calibration (no CalibrationOutcome::best) for the sets known so far, without intervals. `command`
// makes the page. `pictures`: PNG files, of draw_calibration.
StudyPage calibration_page(const CalibrationSpec& spec, const CalibrationOutcome& outcome, const Sets& comparable,
                           const std::string& command, const std::vector<std::string>& pictures);

// way.csv: every set of every stage in the order of the search: stage, parameters, misfit, targets.
Table path_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome);
// Writes parameters.csv and targets.csv into `folder` and draws them, and misfits from way.csv. Throws InputError when gnuplot
// is missing or fails.
std::vector<std::string> draw_calibration(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                          const std::string& folder);

}  // namespace footfall
