#pragma once
// Codes of the messages of mbd_solver/app: E0500 to E0549, W1500 to W0549.

#include "coupler/base/errors.h"

namespace footfall::code {

// --- Command line.

// The command line cannot be read: an option or a value is wrong or missing. `footfall COMMAND --help` lists all.
inline constexpr MessageCode kWrongOption{"E0500", "wrong-option"};
// There is no such command. `footfall --help` lists all.
inline constexpr MessageCode kUnknownCommand{"E0501", "unknown-command"};
// The command has become an option of another one. Use the line that the message gives.
inline constexpr MessageCode kRenamedCommand{"E0502", "renamed-command"};
// This program comes without tests. Run ./footfall test in a checkout.
inline constexpr MessageCode kNoTests{"E0503", "no-tests"};

// --- Folders and cases.

// The folder holds an earlier run. Choose another folder with --out, or replace the run with --force.
inline constexpr MessageCode kFolderHasRun{"E0504", "folder-has-run"};
// A file in the folder is no part of a run, and the run would overwrite it. Move it, or choose another folder.
inline constexpr MessageCode kFileInTheWay{"E0505", "file-in-the-way"};
// The folder holds no run, or too little of one for this command. Name a folder of results.
inline constexpr MessageCode kNoRun{"E0506", "no-run"};
// A path has characters at which LIGGGHTS would split its scripts. Use letters, digits and _ - . / only.
inline constexpr MessageCode kPathWithBlanks{"E0507", "path-with-blanks"};
// There is no such example. `footfall new --list` lists all.
inline constexpr MessageCode kUnknownCase{"E0508", "unknown-case"};
// The name of a new folder cannot be used, or the folder exists. Choose another name.
inline constexpr MessageCode kNameNotUsable{"E0509", "name-not-usable"};
// A temporary folder cannot be created. Set TMPDIR to a folder that can be written.
inline constexpr MessageCode kNoTemporaryFolder{"E0510", "no-temporary-folder"};

// --- Runs.

// No run has a checkpoint to resume from. Name its folder: --resume DIR
inline constexpr MessageCode kNoCheckpoint{"E0511", "no-checkpoint"};
// The script of this run does not allow to resume it. The message names the command.
inline constexpr MessageCode kNotResumable{"E0512", "not-resumable"};
// A program of the run was killed by a signal. Look for a lack of memory, or resume the run from its checkpoint.
inline constexpr MessageCode kProgramKilled{"E0513", "program-killed"};
// The run ended with an exit code that no program of footfall gives. Look at the output of the programs.
inline constexpr MessageCode kUnknownExitCode{"E0514", "unknown-exit-code"};
// The trial of `check --time` failed. The output of the programs says why.
inline constexpr MessageCode kTrialFailed{"E0515", "trial-failed"};
// The run was interrupted before it had results. Start it again.
inline constexpr MessageCode kInterruptedEarly{"E0516", "interrupted-early"};
// mpirun crashed after both programs had ended. The results are complete; nothing is to be done.
inline constexpr MessageCode kLauncherCrashed{"W1500", "launcher-crashed"};

// The run is done, but a requirement of its scene is missed or could not be computed. The message names them.
inline constexpr MessageCode kRequirementsMissed{"E0517", "requirements-missed"};
// --until is later than the end of the scene, which ends the run. Set end_time for a longer run.
inline constexpr MessageCode kUntilAfterEnd{"W0518", "until-after-end"};
// The standard output cannot be written: its disk is full. Free space, or send it elsewhere.
inline constexpr MessageCode kOutputNotWritten{"E0519", "output-not-written"};

// --- After a run.

// Files of a run are damaged. Run the scene again.
inline constexpr MessageCode kRunDamaged{"E0520", "run-damaged"};
// No column of the history matches. `footfall plot DIR` lists all.
inline constexpr MessageCode kUnknownColumn{"E0521", "unknown-column"};
// gnuplot failed on a script; its log says why.
inline constexpr MessageCode kGnuplotFailed{"E0522", "gnuplot-failed"};
// The scene has no fuzzy controller, and so no control surface.
inline constexpr MessageCode kNoSurfaces{"E0523", "no-surfaces"};
// A coupled run is required: the folder has no recorded motion of its bodies, or its script no coupling.
inline constexpr MessageCode kNotCoupled{"E0524", "not-coupled"};
// The two runs cannot be compared. The message names what differs.
inline constexpr MessageCode kNotComparable{"E0525", "not-comparable"};
// Stock LIGGGHTS failed on the replay. Its log says why.
inline constexpr MessageCode kReplayFailed{"E0526", "replay-failed"};
// There is nothing to draw: the run has neither dumps of grains nor drawn bodies. Set output.vtk or dump the grains.
inline constexpr MessageCode kNothingToDraw{"E0527", "nothing-to-draw"};
// A value of an option lies outside of the data of the run. The message gives the range.
inline constexpr MessageCode kOutOfData{"E0528", "out-of-data"};
// A picture cannot be read for a page. Draw it again.
inline constexpr MessageCode kPictureNotReadable{"E0529", "picture-not-readable"};
// The files of an audit are missing or damaged. Run the scene again with --audit.
inline constexpr MessageCode kAuditDamaged{"E0530", "audit-damaged"};
// A program that draws pictures of pages or makes videos is not installed. Install the Debian package that the message names.
inline constexpr MessageCode kProgramMissing{"E0540", "program-missing"};
// The browser drew no picture of the page. The message says why; open the page in a browser with a screen instead.
inline constexpr MessageCode kPageFailed{"E0541", "page-failed"};
// ffmpeg wrote no video. The message has its words.
inline constexpr MessageCode kVideoFailed{"E0542", "video-failed"};
// The page of a run in progress cannot be served on 127.0.0.1. Run without --view; `footfall view DIR` plays the run afterwards.
inline constexpr MessageCode kNoServer{"E0543", "no-server"};
// `check` does not know whether the mechanism comes to rest at the start (initial.settle); the run finds out.
inline constexpr MessageCode kRestNotKnown{"W1502", "rest-not-known"};
// A resumed run begins with fresh tangential springs: LIGGGHTS stores no contact histories of pair_style hybrid.
inline constexpr MessageCode kHistoriesNotStored{"W1503", "histories-not-stored"};
// Energies, plots, or files for ParaView could not be made. The results of the run itself are complete.
inline constexpr MessageCode kNoExtraFiles{"W1501", "no-extra-files"};

}  // namespace footfall::code
