#pragma once
// Files that give a law of a strut or a fuzzy system. Both throw InputError "file:line: ..." for anything else.

#include <filesystem>

#include "mbd_solver/model/control/fuzzy.h"
#include "mbd_solver/model/laws/table_law.h"

namespace footfall {

// File: comma-separated numbers, SI units; # starts a comment. First line: any label, then the rates [m/s],
// rising, 0 among them. Every further line: a stroke [m], rising, then the forces [N] (compression positive)
// at these rates.
//
//   stroke, -1.0,  -0.1,    0,  0.1,  1.0
//   0.00,   -900,  -400,    0,  600, 2000
//   0.10,   -500,     0,  400, 1000, 2400
TableLawParameters read_table_law(const std::filesystem::path& file);

// A FuzzyLite file (.fll): no line without a colon or outside a block, no unknown key, no variable or term twice.
FllText read_fll(const std::filesystem::path& file);

}  // namespace footfall
