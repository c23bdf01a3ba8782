#pragma once
// The results of a calibration: pages as Markdown and HTML, tables, and pictures.

#include <string>
#include <vector>

#include "mbd_solver/studies/calibrate/calibration_run.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

struct PagePart {
  std::string heading;                         // empty: continues the part before
  std::string text;                            // before the table
  std::vector<std::vector<std::string>> rows;  // the head first; empty: no table
  std::vector<std::string> pictures;           // PNG files
};
std::string markdown(const std::string& title, const std::vector<PagePart>& parts);
std::string html(const std::string& title, const std::vector<PagePart>& parts);

// `command`: that makes it. `pictures`: of draw_calibration.
std::vector<PagePart> calibration_parts(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                        const std::vector<const Evaluation*>& comparable, const std::string& command,
                                        const std::vector<std::string>& pictures);
// Before the end of the calibration: the sets known so far.
std::vector<PagePart> so_far_parts(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                   const std::vector<const Evaluation*>& comparable, const std::string& command);
// Conflicts of targets among these sets, as sentences and a table of pairs.
PagePart conflicts_part(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets);

// Distance from the target [tolerances]; of a curve the root mean square.
double distance(const TargetResult& result);
// Every set of every stage in the order of the search: stage, parameters, misfit, targets.
Table path_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome);
// Writes misfit.csv, parameters.csv and targets.csv into `folder` and draws them. Throws InputError when gnuplot is missing
// or fails.
std::vector<std::string> draw_calibration(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                          const std::string& folder);

}  // namespace footfall
