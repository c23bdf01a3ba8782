#pragma once
// footfall as a program, in a folder of a test.

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/run_folder.h"

namespace footfall::app {

// `text` as one word of a shell.
std::string quoted(const std::string& text);

// `footfall WORDS...` in the folder.
test::Outcome footfall(const test::RunFolder& folder, const std::vector<std::string>& words, int limit_seconds = 60);

// Processes that work in this folder or below: "12 mbd_solver, 13 liggghts_mbd".
std::string processes_in(const std::filesystem::path& folder);

}  // namespace footfall::app
