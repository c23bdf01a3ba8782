#pragma once
// Targets and what runs say of them, as pages have it.

#include <string>
#include <vector>

#include "mbd_solver/studies/calibration_run.h"
#include "mbd_solver/studies/determination.h"
#include "mbd_solver/studies/evaluations.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

// "0.9 to 1.1", "at least 2", "0.5".
std::string wanted(const TargetSpec& target);
// In tolerances; of a curve the root mean square.
double distance(const TargetResult& result);
// The value with its spread over the seeds; "failed".
std::string value_text(const TargetSpec& target, const TargetResult& result);
int seeds_that_meet(const TargetSpec& target, const TargetResult& result);

// What a calibration found, as a page: once as Markdown, once as HTML; and as tables for programs.

// `command`: that makes it again. `pictures`: what draw_calibration made.
std::vector<PagePart> calibration_parts(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                        const std::vector<const Evaluation*>& comparable, const std::string& command,
                                        const std::vector<std::string>& pictures);
std::string markdown(const std::string& title, const std::vector<PagePart>& parts);
std::string html(const std::string& title, const std::vector<PagePart>& parts);

// While it goes: sets that are known by now, with the start as each stage runs it (calibration_so_far.cpp).
std::vector<PagePart> so_far_parts(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                   const std::vector<const Evaluation*>& comparable, const std::string& command);

// Every set of every stage in the order of the search: stage, parameters, misfit, targets.
Table way_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome);
// Shares of the ranges: best, interval.
Table parameter_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome);
// Misfit of each target at the start and at the best set [tolerances].
Table target_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome);

// Draws misfit.png, parameters.png and targets.png in `folder` from misfit.csv, parameters.csv and targets.csv, which
// it writes. Throws InputError when gnuplot is missing or fails.
std::vector<std::string> draw_calibration(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                          const std::string& folder);

}  // namespace footfall
