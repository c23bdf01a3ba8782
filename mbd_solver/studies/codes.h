#pragma once
// Codes of the messages of mbd_solver/studies: E0580 to E0629. Faults of single keys have the codes of scene/codes.h.

#include "coupler/base/errors.h"

namespace footfall::code {

// --- Sweep and calibration files.

// The file is a scene, where a sweep file or a calibration file is expected. Run it, or name the other file.
inline constexpr MessageCode kSceneGiven{"E0580", "scene-given"};
// A sweep file is given to calibrate, or a calibration file to sweep. Run it by the command that the message names.
inline constexpr MessageCode kOtherStudy{"E0589", "other-study"};
// A metric is not one of [[figures]] of the file. Correct its name, or define it.
inline constexpr MessageCode kUnknownMetric{"E0581", "unknown-metric"};
// A parameter is not one of [[parameters]] of the file, or has no such value. Correct the name or the value.
inline constexpr MessageCode kUnknownParameter{"E0582", "unknown-parameter"};
// There is no such curve or case in the sweep. Correct its name.
inline constexpr MessageCode kUnknownCurve{"E0583", "unknown-curve"};
// A value that is listed for a curve or parameter is not one of its values. Correct it.
inline constexpr MessageCode kNotAValue{"E0584", "not-a-value"};
// A formula cannot be read or evaluated. Correct it.
inline constexpr MessageCode kStudyFormula{"E0585", "study-formula"};
// There is no such scene in [[scenes]]. Correct its name.
inline constexpr MessageCode kUnknownSceneName{"E0586", "unknown-scene-name"};
// The sweep has more runs than can be planned. Give fewer values, or use several files.
inline constexpr MessageCode kTooManyRuns{"E0587", "too-many-runs"};
// Two runs have the same name, or a name is too long for a folder. Rename parameters or choices.
inline constexpr MessageCode kRunName{"E0588", "run-name"};

// --- Runs and results.

// A run has no such number in summary.json, or no such column in history.csv. Correct the metric.
inline constexpr MessageCode kMetricMissing{"E0590", "metric-missing"};
// The run with which others are compared has failed. Its message follows.
inline constexpr MessageCode kReferenceFailed{"E0591", "reference-failed"};
// There is no run of this number. --list lists all.
inline constexpr MessageCode kNoSuchRun{"E0592", "no-such-run"};
// A run has no rows to compare. Look at its log.
inline constexpr MessageCode kRunWithoutRows{"E0593", "run-without-rows"};
// Signals ended the study. The same command resumes with the remaining runs.
inline constexpr MessageCode kStudyInterrupted{"E0594", "study-interrupted"};
// A power law cannot be fitted: too few runs, numbers that are not positive, or dependent factors.
inline constexpr MessageCode kPowerLaw{"E0595", "power-law"};
// A name cannot be written into a Slurm script. Rename the file or folder.
inline constexpr MessageCode kSlurmName{"E0596", "slurm-name"};

// --- Calibration.

// The runs of the start have failed. The message of the run follows; correct the scene or the start.
inline constexpr MessageCode kStartFailed{"E0600", "start-failed"};
// Nothing can be reported yet: the runs of the start are not done. Try again later.
inline constexpr MessageCode kStartNotDone{"E0601", "start-not-done"};
// The file of recorded runs has a damaged line. Remove the line.
inline constexpr MessageCode kRecordsDamaged{"E0602", "records-damaged"};
// NLopt refused the search. Look at ranges and evaluations of the stage.
inline constexpr MessageCode kSearchRefused{"E0603", "search-refused"};
// A signal from outside ended a run. Start the same command again.
inline constexpr MessageCode kRunEndedFromOutside{"E0604", "run-ended-from-outside"};

// --- Rigs.

// There is no such rig. `footfall rig --help` lists all.
inline constexpr MessageCode kUnknownRig{"E0610", "unknown-rig"};
// The scene lacks something that the rig requires. Start from a copy of the rig's own scene.
inline constexpr MessageCode kRigScene{"E0611", "rig-scene"};
// The runs do not match the rig. Start from a copy of the rig's own file.
inline constexpr MessageCode kRigRuns{"E0612", "rig-runs"};
// The value of --gravity is not valid. Give earth, moon, mars or a number.
inline constexpr MessageCode kRigGravity{"E0613", "rig-gravity"};
// A check of the rig is not possible with this scene. Run it without --checks.
inline constexpr MessageCode kRigCheck{"E0614", "rig-check"};

// --- Campaigns: sweeps with drawn runs.

// No process can be started that carries out the runs. The message has the reason.
inline constexpr MessageCode kNoWorker{"E0620", "no-worker"};
// The program for drawn runs is missing: it needs OpenTURNS. ./footfall builds it; or install its package.
inline constexpr MessageCode kNoCampaignProgram{"E0621", "no-campaign-program"};
// A repeated run has other numbers than its row in the table. Programs or files have changed since: start again in another folder.
inline constexpr MessageCode kRowDiffers{"E0622", "row-differs"};
// Rows of the table are not done yet. Carry out the remaining elements of the job array.
inline constexpr MessageCode kRowsMissing{"E0623", "rows-missing"};

// Rows of the table have no result, or a metric without a number. The page lists the causes; probabilities and percentiles are bounded as if
// these rows had any value.
inline constexpr MessageCode kRowsUnknown{"E0625", "rows-unknown"};

// A statement of a campaign cannot be shown with so few runs, whatever happens in them. Raise runs to the number in the message.
inline constexpr MessageCode kTooFewRuns{"E0626", "too-few-runs"};

// The command does not carry out such a file. Use the command that the message names.
inline constexpr MessageCode kWrongSweep{"E0624", "wrong-sweep"};

// --- Soils without grains.

// The runs do not determine a soil. Give 5 to 20 runs of one pad that reach the bed.
inline constexpr MessageCode kGroundFit{"E0628", "ground-fit"};
// The fitted law does not describe the grains well. Try the other law, or fit the range that matters.
inline constexpr MessageCode kPoorGroundFit{"W1628", "poor-ground-fit"};

}  // namespace footfall::code
