#pragma once
// Codes of the messages of integrator/: E0360 to E0379, W1360 to W0379.

#include "coupler/base/errors.h"

namespace footfall::code {

// A tolerance of the integrator is not positive. Give rtol and atol above 0.
inline constexpr MessageCode kTolerances{"E0360", "tolerances"};
// The integrator is unknown. Use "one_step" or "ida".
inline constexpr MessageCode kUnknownIntegrator{"E0361", "unknown-integrator"};
// The step size fell below its minimum. Check the body or joint that is named; increase rtol near singular positions.
inline constexpr MessageCode kStepTooSmall{"E0362", "step-too-small"};
// A window would take too many steps. Check for very different masses and for jammed positions.
inline constexpr MessageCode kNoProgress{"E0363", "no-progress"};
// SUNDIALS reports an error. Check the body or joint that is named, or use "one_step".
inline constexpr MessageCode kSundials{"E0364", "sundials"};
// A singular position was passed with a larger error than the tolerance. Compare with solver.rtol = 1e-7.
inline constexpr MessageCode kSingularPassed{"W1360", "singular-position-passed"};
// Errors of single steps of "ida" have accumulated. Compare with "one_step", or reduce solver.rtol.
inline constexpr MessageCode kErrorsAccumulated{"W1361", "errors-accumulated"};

}  // namespace footfall::code
