#pragma once
// Codes of the messages of fmi/ (E0740 to E0749; E0744 to E0747 are reserved). The comment above a code gives its meaning and remedy.

#include "coupler/base/errors.h"

namespace footfall::code {

// The library or program of an FMU is missing in the folder of footfall. Start ./footfall fmu in a checkout, which builds them.
inline constexpr MessageCode kFmuParts{"E0740", "fmu-parts"};
// The FMU cannot be written. Choose another place with --out.
inline constexpr MessageCode kFmuNotWritten{"E0743", "fmu-not-written"};
// An input of an exported FMU depends on motion like a stiff spring: steps are too long for an explicit exchange. Shorten them.
inline constexpr MessageCode kFmuOmegaH{"W1740", "fmu-omega-h"};

}  // namespace footfall::code
