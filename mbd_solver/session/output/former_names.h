#pragma once
// Columns of history.csv and keys of summary.json that had another name in earlier versions. Files with the former names are
// read as if they had the present ones, and scenes, studies and commands may use either.

#include <string>

namespace footfall {

// The present name of a column or key; other names stay as they are.
const std::string& present_name(const std::string& name);

}  // namespace footfall
