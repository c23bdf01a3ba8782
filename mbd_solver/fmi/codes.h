#pragma once
// Codes of the messages of fmi/ (E0740 to E0749). The comment above a code says what it means and what to do.

#include "coupler/base/errors.h"

namespace footfall::code {

// The library or program of an FMU is missing beside footfall. Start ./footfall fmu in a checkout, which builds them.
inline constexpr MessageCode kFmuParts{"E0740", "fmu-parts"};
// A scene on grains cannot be an FMU. Give it another ground.
inline constexpr MessageCode kFmuOfGrains{"E0741", "fmu-of-grains"};
// A scene that runs programs of the user cannot be an FMU. Remove them.
inline constexpr MessageCode kFmuOfForeign{"E0742", "fmu-of-foreign-code"};
// The FMU cannot be written. Choose another place with --out.
inline constexpr MessageCode kFmuNotWritten{"E0743", "fmu-not-written"};

// An input of an exported FMU answers motion like a stiff spring: steps are too long for an explicit exchange. Shorten them.
inline constexpr MessageCode kFmuOmegaH{"W0740", "fmu-omega-h"};

}  // namespace footfall::code
