#pragma once
// Codes of the messages of fmi/ (E0740 to E0749). The comment above a code gives its meaning and remedy.

#include "coupler/base/errors.h"

namespace footfall::code {

// The library or program of an FMU is missing in the folder of footfall. Start ./footfall fmu in a checkout, which builds them.
inline constexpr MessageCode kFmuParts{"E0740", "fmu-parts"};
// The FMU cannot be written. Choose another place with --out.
inline constexpr MessageCode kFmuNotWritten{"E0743", "fmu-not-written"};
// The programs of a controlled coupled pair ended without a message. Look for a lack of memory or a command that ended them.
inline constexpr MessageCode kPairGone{"E0744", "pair-gone"};
// The temporary folder of a coupled pair cannot be made. Name another one in TMPDIR.
inline constexpr MessageCode kPairFolder{"E0745", "pair-folder"};
// A coupled pair was ended because no program controls it any more.
inline constexpr MessageCode kPairInterrupted{"E0746", "pair-interrupted"};
// The state of grains remains in LIGGGHTS: it can be neither read nor set. Use a ground without grains where states are needed.
inline constexpr MessageCode kPairState{"E0747", "pair-state"};

// An input of an exported FMU depends on motion like a stiff spring: steps are too long for an explicit exchange. Shorten them.
inline constexpr MessageCode kFmuOmegaH{"W1740", "fmu-omega-h"};

}  // namespace footfall::code
