#pragma once
// Codes of the messages of mbd_solver/bed: E0550 to E0562, E0570 to E0573, W1550 to W1556.

#include "coupler/base/errors.h"

namespace footfall::code {

// --- Beds.

// LIGGGHTS stopped the script of a bed. Correct the command that the message names.
inline constexpr MessageCode kBedScriptFailed{"E0550", "bed-script-failed"};
// LIGGGHTS ended while it made a bed, without a message of its own. Its output follows.
inline constexpr MessageCode kBedProgramEnded{"E0551", "bed-program-ended"};
// The script of a bed wrote no restart file. Add the command: write_restart ${bed}
inline constexpr MessageCode kBedWithoutRestart{"E0552", "bed-without-restart"};
// A bed cannot be stored in the cache. Free space on the disk, or set FOOTFALL_CACHE to another folder.
inline constexpr MessageCode kBedNotStored{"E0553", "bed-not-stored"};
// A signal ended the program while it made a bed; nothing of the bed is stored. Start the run again.
inline constexpr MessageCode kBedInterrupted{"E0554", "bed-interrupted"};
// A body reaches out of the simulation box of [particles.box]. Enlarge the box, or move the body.
inline constexpr MessageCode kOutsideBox{"E0555", "outside-box"};
// A file that belongs to footfall is missing. Install footfall again.
inline constexpr MessageCode kShippedFileMissing{"E0556", "shipped-file-missing"};
// There is no folder for beds: HOME is not set. Set FOOTFALL_CACHE to a folder of your own.
inline constexpr MessageCode kNoCacheFolder{"E0557", "no-cache-folder"};
// A bed in the cache belongs to another user, or is a link. Set FOOTFALL_CACHE to a folder of your own.
inline constexpr MessageCode kBedOfAnother{"E0558", "foreign-bed"};
// A bed in the cache is damaged. It is made again; nothing is to be done.
inline constexpr MessageCode kBedDamaged{"W1550", "bed-damaged"};
// The bed was made of another material than the run has. Give both scripts the same constants unless this is meant.
inline constexpr MessageCode kBedMaterialDiffers{"W1551", "bed-material-differs"};
// Grains of the bed at rest overlap more than their contact law allows. Raise material.young.
inline constexpr MessageCode kBedOverlaps{"W1552", "bed-overlaps"};
// A body may pass a side wall of the bed before the end of the scene. Make the bed larger, or end the scene earlier.
inline constexpr MessageCode kMayLeaveBed{"W1555", "may-leave-bed"};
// LIGGGHTS has so few grains per rank that more ranks cost time. Use the number of ranks that the message gives.
inline constexpr MessageCode kFewGrainsPerRank{"W1556", "few-grains-per-rank"};

// --- LIGGGHTS.

// LIGGGHTS stopped with an error; the message names the command of the script. Correct it.
inline constexpr MessageCode kLiggghtsStopped{"E0560", "liggghts-stopped"};
// LIGGGHTS reads a restart file without end: the file is damaged. Make it again.
inline constexpr MessageCode kRestartDamaged{"E0561", "restart-damaged"};
// A script runs a program or writes outside the folder of results. Change it, or trust it with --trust-script.
inline constexpr MessageCode kUnsafeScript{"E0562", "unsafe-script"};
// A run has more LIGGGHTS processes than this machine has cores. Use fewer ranks.
inline constexpr MessageCode kRanksBeyondCores{"W1553", "ranks-beyond-cores"};

// --- Dumps of grains.

// A dump of grains cannot be read. Check path, permissions and format.
inline constexpr MessageCode kDumpNotReadable{"E0570", "dump-not-readable"};
// A dump of grains lacks a column. Dump id x y z vx vy vz radius.
inline constexpr MessageCode kDumpColumnMissing{"E0571", "dump-column-missing"};
// A run has no dumps of its grains. Set particles.box.frame_interval, or dump id x y z radius in the script.
inline constexpr MessageCode kNoDumps{"E0572", "no-dumps"};
// The DEM part of a checkpoint is damaged. Resume from another checkpoint.
inline constexpr MessageCode kGrainsCheckpointDamaged{"E0573", "grains-checkpoint-damaged"};

}  // namespace footfall::code
