#pragma once
// A run owns its folder: nobody else may run into it meanwhile.

#include <string>

#include "coupler/base/file_lock.h"

namespace footfall {

inline constexpr const char* kLockFile = ".footfall.lock";  // in the folder

// Makes the folder and holds it. Refuses at once what another run holds; where only programs that a dead one started
// are still ending, waits some seconds for them. Throws InputError.
FileLock lock_folder(const std::string& folder);

// A program that we start for this folder runs into it under our lock: NAME=VALUE of its environment.
inline constexpr const char* kLockedFolder = "FOOTFALL_LOCKED_FOLDER";
// The folder's full path, as the variable holds it.
std::string locked_name(const std::string& folder);
// The front door that started us holds the folder.
bool folder_is_held_for_us(const std::string& folder);

}  // namespace footfall
