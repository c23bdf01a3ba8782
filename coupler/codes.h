#pragma once
// Codes of the messages of coupler/: E0402 to E0423. (coupler/base has E0400, E0401 and E0424 to E0429, mbd_solver/base E0430 to E0449.)

#include "coupler/base/errors.h"

namespace footfall::code {

// A file of a checkpoint is damaged, or belongs to another scene or version. Resume from another checkpoint.
inline constexpr MessageCode kCheckpointDamaged{"E0402", "checkpoint-damaged"};
// mpirun started more than two programs. Start one LIGGGHTS and one mechanism.
inline constexpr MessageCode kTooManyPrograms{"E0403", "too-many-programs"};
// An MPI call failed; the message quotes MPI. Check the network and the MPI installation.
inline constexpr MessageCode kMpiCallFailed{"E0404", "mpi-call-failed"};
// The programs speak different protocol versions. Build both from the same footfall.
inline constexpr MessageCode kProtocolsDiffer{"E0405", "protocols-differ"};
// The programs are different footfall versions. Build both from the same footfall.
inline constexpr MessageCode kVersionsDiffer{"E0406", "versions-differ"};
// A message between the programs has a wrong shape or length. Build both programs from the same footfall.
inline constexpr MessageCode kMessageDamaged{"E0407", "message-damaged"};
// A message arrived where another kind was expected. Build both programs from the same footfall.
inline constexpr MessageCode kMessageUnexpected{"E0408", "message-unexpected"};
// A message is larger than MPI can send. Use coarser boundaries or fewer bodies.
inline constexpr MessageCode kMessageTooLarge{"E0409", "message-too-large"};
// A message holds a number that is infinite or not a number. Check the scene's values at the place that is named.
inline constexpr MessageCode kMessageNotFinite{"E0410", "message-not-finite"};
// The partner program stopped without giving a reason with a code. Look at its own output.
inline constexpr MessageCode kPartnerStopped{"E0411", "partner-stopped"};
// The partner program closed the coupling before the last window. Look at its own output.
inline constexpr MessageCode kPartnerClosedEarly{"E0412", "partner-closed-early"};
// The partner program was stopped by a signal. Resume the run from its checkpoint.
inline constexpr MessageCode kPartnerInterrupted{"E0413", "partner-interrupted"};
// The partner program has ended without closing the coupling. Look at its own output and at the system's log.
inline constexpr MessageCode kPartnerGone{"E0414", "partner-gone"};
// The partner sent nothing within the time limit. Raise coupling.timeout (or `patience`) if its work takes longer.
inline constexpr MessageCode kPartnerSilent{"E0415", "partner-silent"};
// The partner does not receive messages. It is stopped or hangs: look at its own output.
inline constexpr MessageCode kPartnerNotReceiving{"E0416", "partner-not-receiving"};
// A signal stopped this program while it waited for its partner. Resume the run from its checkpoint.
inline constexpr MessageCode kInterruptedWaiting{"E0417", "interrupted-waiting"};
// The LIGGGHTS script and the scene have different gravity. Make them equal, or write `gravity script`.
inline constexpr MessageCode kGravityDiffers{"E0418", "gravity-differs"};
// The boundary of a body is inconsistent (nodes, triangles, segments or shapes). Correct the body's geometry.
inline constexpr MessageCode kBoundaryInvalid{"E0419", "boundary-invalid"};
// The scene names an unknown coupling scheme. Choose one of those listed.
inline constexpr MessageCode kUnknownScheme{"E0420", "unknown-scheme"};
// A word of `fix couple/mbd` is unknown or missing. Follow the syntax in the message.
inline constexpr MessageCode kCoupleMbdSyntax{"E0421", "couple-mbd-syntax"};
// A value of a keyword of `fix couple/mbd` is wrong. Give a value as the message says.
inline constexpr MessageCode kCoupleMbdValue{"E0422", "couple-mbd-value"};
// `fix couple/mbd` names a mesh twice. Name each mesh once.
inline constexpr MessageCode kMeshNamedTwice{"E0423", "mesh-named-twice"};

}  // namespace footfall::code
