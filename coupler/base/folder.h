#pragma once
// Folders for what is written.

#include <string>

namespace footfall {

// The folder is there afterwards, with those around it. Throws InputError that ends with the advice.
void make_folder(const std::string& folder, const std::string& advice = "choose another folder with --out");

}  // namespace footfall
