#pragma once
// Codes of the messages of coupler/base: E0400, E0401, E0424 to E0429, and E0438.

#include "coupler/base/errors.h"

namespace footfall::code {

// A folder cannot be created. Check its parent's permissions and free space, or choose another folder.
inline constexpr MessageCode kFolderNotCreated{"E0400", "folder-not-created"};
// A file cannot be written; its previous content is unchanged. Free space on the disk or choose another folder.
inline constexpr MessageCode kFileNotWritten{"E0401", "file-not-written"};
// A pipe or a device is named where a file is read. Name a regular file.
inline constexpr MessageCode kNotRegularFile{"E0424", "not-a-regular-file"};
// A file is implausibly large. Name the right file.
inline constexpr MessageCode kFileTooLarge{"E0425", "file-too-large"};
// The current folder is gone or may not be entered. Change to another folder.
inline constexpr MessageCode kCurrentFolder{"E0426", "current-folder"};
// A path is not UTF-8 text. Rename the file or folder.
inline constexpr MessageCode kNotUtf8{"E0427", "not-utf8"};
// The script of a scene writes a file outside the folder of results. Write ${out}/NAME, or allow it with --trust-script.
inline constexpr MessageCode kScriptWritesElsewhere{"E0428", "script-writes-elsewhere"};
// The kernel does not confine a program to the files of its script. Read the script, and allow it with --trust-script.
inline constexpr MessageCode kNotConfined{"E0429", "not-confined"};
// A file or folder cannot be inspected, mostly because a permission is missing. Check that it exists, and all permissions.
inline constexpr MessageCode kFileSystem{"E0438", "file-system"};

}  // namespace footfall::code
