#pragma once
// Codes of the messages of coupling/: E0640 to E0659, W1640 to W0659.

#include "coupler/base/errors.h"

namespace footfall::code {

// The script has a time step that is not positive, or a negative `every`. Correct `timestep` or `fix couple/mbd`.
inline constexpr MessageCode kCouplingInterval{"E0640", "coupling-interval"};
// The time step of the script is larger than the scene allows. Reduce `timestep`, or raise particles.max_time_step.
inline constexpr MessageCode kTimeStepTooLarge{"E0641", "time-step-too-large"};
// Scene and script give different values of dt or every. Make them equal, or remove the variable from the scene.
inline constexpr MessageCode kScriptDiffers{"E0642", "script-differs"};
// `fix couple/mbd` names a body without a boundary. Name one of those listed, or give the body [[boundaries]].
inline constexpr MessageCode kBodyWithoutBoundary{"E0643", "body-without-boundary"};
// A message belongs to another coupling interval. Build both programs from the same footfall.
inline constexpr MessageCode kWrongInterval{"E0644", "wrong-interval"};
// The load of the grains is not finite: the bed has become unstable. Reduce the time step of the script.
inline constexpr MessageCode kGrainLoadNotFinite{"E0645", "grain-load-not-finite"};
// The coupling added energy to the mechanism beyond coupling.max_energy_residual. Use a shorter coupling interval.
inline constexpr MessageCode kEnergyCreated{"E0646", "energy-created"};
// At the end of the run the mechanism has received work that the grains have not done. Use a shorter coupling interval.
inline constexpr MessageCode kEnergyUnbalanced{"E0647", "energy-unbalanced"};
// The contact force on a body alternates from interval to interval. Use a shorter coupling interval.
inline constexpr MessageCode kChatter{"E0648", "chatter"};
// The LIGGGHTS script does not use SI units. Write `units si`.
inline constexpr MessageCode kScriptUnits{"E0649", "script-units"};

// Loads of the grains have triggered an event up to a coupling interval late. Use the coupling interval in the message.
inline constexpr MessageCode kEventLate{"W1640", "event-late"};
// A bed that follows a body holds another mass than at the start: the body carries or has left grains. Make the bed longer.
inline constexpr MessageCode kBedMass{"W1641", "bed-mass"};
// The coupling interval is too long for the stiffness of the contacts. Use the value of `every` in the message.
inline constexpr MessageCode kIntervalTooLong{"W0650", "coupling-interval-too-long"};
// The coupling added spurious energy. Use a shorter coupling interval.
inline constexpr MessageCode kCouplingCreates{"W0651", "coupling-creates-energy"};
// The coupling dissipated energy. Use a shorter coupling interval.
inline constexpr MessageCode kCouplingDissipates{"W0652", "coupling-dissipates-energy"};
// Contacts began and ended within one coupling interval; the rebound is not resolved. Use a shorter coupling interval.
inline constexpr MessageCode kContactNotResolved{"W0653", "contact-not-resolved"};
// Scheme `tangent` gave a body more impulse than the grains. Use coupling.scheme = "css-trapezoid".
inline constexpr MessageCode kTangentImpulse{"W0654", "tangent-impulse"};
// A grain overlaps a surface by more than 5 % of its radius: the first peak is underestimated. Increase Young's modulus.
inline constexpr MessageCode kLargeOverlap{"W0655", "large-overlap"};
// A body overlaps the bed at the start. Raise it: initial.clearance, positions of bodies, [initial.joints].
inline constexpr MessageCode kStartsInBed{"W0656", "starts-in-bed"};
// Contacts larger than facets act several times under `surface facets`. Remove `surface facets` from the script.
inline constexpr MessageCode kFacetsTooSmall{"W0657", "facets-too-small"};
// The script has no gravity, the scene has. Add `fix gravity` to the script, or write `gravity script`.
inline constexpr MessageCode kGrainsWithoutGravity{"W0658", "grains-without-gravity"};
// Within a coupling interval the force changes too much: its peaks are averaged, or the mechanism leaves its predicted path.
// Use the coupling interval in the message.
inline constexpr MessageCode kForceNotResolved{"W0659", "force-not-resolved"};

}  // namespace footfall::code
