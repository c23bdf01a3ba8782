#pragma once
// Whole files and folders. A file is written next to its target, synced and renamed: readers, a kill or a full disk
// never see half of it.

#include <cstdint>
#include <optional>
#include <string>

namespace footfall {

// Creates the folder and its parents where they are missing. Throws InputError; the message ends with `advice`.
void make_folder(const std::string& folder, const std::string& advice = "choose another folder with --out");

// The bytes of the file; nothing when it cannot be read.
std::optional<std::string> read_whole_file(const std::string& path);

// Throws InputError, whose message ends with `advice`, when the file cannot be written; the previous content is then
// unchanged.
void write_whole_file(const std::string& path, const std::string& text,
                      const std::string& advice = "choose another folder with --out");

// The same without waiting for the disk, for hundreds of files written while the grains wait. Readers never see half a
// file, but a power cut may lose the last ones.
void write_whole_file_unsynced(const std::string& path, const std::string& text,
                               const std::string& advice = "choose another folder with --out");

// From now on this process writes files in place and does not wait for the disk: another program reads them at once, and no one
// before they are complete. New files cost more than a short run does.
void write_all_files_in_place();

// Time of the last change of the file (of the link itself, if it is one) or of its move to this place [ns since 1970].
// Users cannot set this time. 0: there is no such file.
std::int64_t file_changed(const std::string& path);

}  // namespace footfall
