#pragma once
// Codes of the messages of mbd_solver/base: E0430 to E0449, E0250 to E0252 for tables, E0565 to E0567 for programs.

#include "coupler/base/errors.h"

namespace footfall::code {

// The lock file of a folder cannot be created. Check the folder's permissions.
inline constexpr MessageCode kLockNotCreated{"E0430", "lock-not-created"};
// Another run writes to this folder. Wait until it has ended, or choose another folder with --out.
inline constexpr MessageCode kFolderInUse{"E0431", "folder-in-use"};
// A path names a folder where a file is expected. Name the file.
inline constexpr MessageCode kPathIsFolder{"E0432", "path-is-folder"};
// A file does not exist. Correct its path.
inline constexpr MessageCode kNoSuchFile{"E0433", "no-such-file"};
// A parameter of a law or controller is outside its range. Give a value in the range of the message.
inline constexpr MessageCode kParameterOutOfRange{"E0434", "parameter-out-of-range"};
// A file of an earlier run cannot be removed. Check the folder's permissions.
inline constexpr MessageCode kFileNotRemoved{"E0435", "file-not-removed"};
// A file that is read during a run has changed. Do not change it until the run has ended.
inline constexpr MessageCode kFileChanged{"E0436", "file-changed"};
// A file exceeds a limit of its reader: unpacked bytes, parts within parts, included files. Make it smaller as the message says.
inline constexpr MessageCode kReadLimit{"E0437", "read-limit"};

// A table cannot be opened. Check path and permissions.
inline constexpr MessageCode kTableNotReadable{"E0250", "table-not-readable"};
// A cell of a table is not a finite number. Correct the line that is named.
inline constexpr MessageCode kTableCell{"E0251", "table-cell"};
// A line of a table has another number of cells than expected. Correct the line that is named.
inline constexpr MessageCode kTableWidth{"E0252", "table-width"};

// A program cannot be started. Install it, or free memory and processes.
inline constexpr MessageCode kProgramNotStarted{"E0565", "program-not-started"};
// A program of the run has been suspended (SIGSTOP) for longer than the time limit. Resume the run from its checkpoint.
inline constexpr MessageCode kProgramSuspended{"E0566", "program-suspended"};
// A word of a command line has a line end or another control character. Rename the file, or correct the value.
inline constexpr MessageCode kControlCharacter{"E0567", "control-character"};

}  // namespace footfall::code
