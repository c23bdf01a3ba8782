#pragma once
// A file read or written in one go. What is written is there whole or not at all: written beside the target,
// synced and renamed, so that neither a reader, a kill nor a full disk leaves half of it.

#include <cstdint>
#include <optional>
#include <string>

namespace footfall {

// Byte by byte as it stands; nothing when the file cannot be read.
std::optional<std::string> read_whole_file(const std::string& path);

// Throws InputError that ends with the advice when the file cannot be written; what stood there before is then kept.
void write_whole_file(const std::string& path, const std::string& text,
                      const std::string& advice = "choose another folder with --out");

// The same without waiting for the disk, for files of which a run writes hundreds while the grains wait: whole for every
// reader and after a kill, but a power cut may take the last ones.
void write_whole_file_unsynced(const std::string& path, const std::string& text,
                               const std::string& advice = "choose another folder with --out");

// When a file (or a link itself) last changed or was put where it is [ns since 1970]; nobody can set that. 0: it is not
// there.
std::int64_t file_changed(const std::string& path);

}  // namespace footfall
